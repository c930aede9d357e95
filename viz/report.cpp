#include "viz/report.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/files.hpp"
#include "viz/svg.hpp"

namespace packstone::viz {

namespace {

// A page of paper: one column of text, tables ruled as in journals, figures with their captions below.
constexpr const char* style_sheet = R"(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 3rem 1.5rem 5rem; max-width: 54rem; background: #fff; color: #1f1f1f;
  font: 1rem/1.55 "Source Serif 4", "Noto Serif", Charter, Georgia, "DejaVu Serif", serif; }
header { border-bottom: 2px solid #1f1f1f; margin-bottom: 2.2rem; padding-bottom: 1.1rem; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .4rem; }
header p { color: #555; margin: 0; }
h2 { font-size: 1.3rem; line-height: 1.3; margin: 2.6rem 0 .8rem; padding-bottom: .25rem; border-bottom: 1px solid #ccc; }
nav ol { columns: 2; margin: 0; padding-left: 1.4rem; font-size: .95rem; }
nav a, nav a:visited { color: #0b5a8a; text-decoration: none; }
nav a:hover { text-decoration: underline; }
p { margin: .7rem 0; text-align: justify; hyphens: auto; }
.table { overflow-x: auto; margin: 1.3rem 0; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; line-height: 1.4;
  border-top: 1.5px solid #1f1f1f; border-bottom: 1.5px solid #1f1f1f; font-variant-numeric: tabular-nums lining-nums; }
caption, figcaption { text-align: left; font-size: .9rem; line-height: 1.45; color: #333; }
caption { padding-bottom: .45rem; }
caption b, figcaption b { font-weight: 700; margin-right: .35em; }
th { text-align: left; font-weight: 700; vertical-align: bottom; border-bottom: 1px solid #1f1f1f; }
th, td { padding: .32rem 1rem .32rem 0; }
th:last-child, td:last-child { padding-right: 0; }
td { vertical-align: top; }
tbody tr + tr td { border-top: 1px solid #ececec; }
.number { text-align: right; white-space: nowrap; }
figure { margin: 1.6rem 0; break-inside: avoid; }
figure img { display: block; max-width: 100%; max-height: 46rem; margin: 0 auto .6rem; }
details { margin: 1.2rem 0; border: 1px solid #ddd; border-radius: 4px; }
summary { cursor: pointer; padding: .5rem .8rem; font-size: .9rem; color: #333; }
pre { margin: 0; padding: .8rem; overflow-x: auto; background: #f7f7f5; border-top: 1px solid #ddd;
  font: .8rem/1.45 "DejaVu Sans Mono", Menlo, Consolas, monospace; }
@media (max-width: 40rem) { body { padding: 1.5rem 1rem; } nav ol { columns: 1; } p { text-align: left; } }
@media print { body { max-width: none; padding: 0; font-size: 10pt; } h2 { break-after: avoid; } nav { display: none; }
  tr { break-inside: avoid; } details, pre { border: 0; } pre { white-space: pre-wrap; } }
)";

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// True for "1.25", "-3e-5", "0.61 ± 0.02", "12 %": text that begins like a number and is not a sentence.
bool is_number(const std::string& text) {
  const std::size_t first = text.find_first_not_of("+-−<> ");
  if (first == std::string::npos) return text == "-" || text == "−";
  constexpr std::size_t longest = 40;
  const bool digit = std::isdigit(static_cast<unsigned char>(text[first])) != 0;
  return text.size() <= longest && (digit || text == "nan" || text == "inf");
}

/// A column is one of numbers when all its filled cells are.
std::vector<bool> number_columns(const ReportTable& table) {
  std::vector<bool> result(table.columns.size());
  for (std::size_t column = 0; column < result.size(); ++column) {
    bool any = false;
    bool all = true;
    for (const auto& row : table.rows) {
      if (column >= row.size() || row[column].empty() || row[column] == "–") continue;
      any = true;
      all = all && is_number(row[column]);
    }
    result[column] = any && all;
  }
  return result;
}

/// Writes the page, counting tables and figures.
class Page {
 public:
  explicit Page(const Report& report) {
    add("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\">\n<title>{}</title>\n<style>{}</style>\n"
        "</head>\n<body>\n<header>\n<h1>{}</h1>\n",
        escaped(report.title), style_sheet, escaped(report.title));
    if (!report.subtitle.empty()) add("<p>{}</p>\n", escaped(report.subtitle));
    add("</header>\n");
    contents(report);
    for (std::size_t i = 0; i < report.sections.size(); ++i) section(report.sections[i], i + 1);
    add("</body>\n</html>\n");
  }

  const std::string& text() const { return text_; }

 private:
  template <typename... Arguments>
  void add(fmt::format_string<Arguments...> form, Arguments&&... arguments) {
    text_ += fmt::format(form, std::forward<Arguments>(arguments)...);
  }

  void contents(const Report& report) {
    constexpr std::size_t fewest = 3;
    if (report.sections.size() < fewest) return;
    add("<nav><ol>\n");
    for (std::size_t i = 0; i < report.sections.size(); ++i) {
      add("<li><a href=\"#s{}\">{}</a></li>\n", i + 1, escaped(report.sections[i].title));
    }
    add("</ol></nav>\n");
  }

  void section(const ReportSection& section, std::size_t number) {
    add("<section id=\"s{0}\">\n<h2>{0}. {1}</h2>\n", number, escaped(section.title));
    for (const std::string& paragraph : section.paragraphs) add("<p>{}</p>\n", escaped(paragraph));
    for (const ReportTable& t : section.tables) table(t);
    for (const ReportImage& image : section.images) figure(image);
    if (!section.preformatted.empty()) {
      add("<details><summary>Show the text</summary><pre>{}</pre></details>\n", escaped(section.preformatted));
    }
    add("</section>\n");
  }

  void table(const ReportTable& table) {
    const std::vector<bool> numbers = number_columns(table);
    const auto kind = [&](std::size_t column) {
      return column < numbers.size() && numbers[column] ? " class=\"number\"" : "";
    };
    add("<div class=\"table\"><table>\n<caption><b>Table {}.</b>{}</caption>\n<thead><tr>", ++tables_,
        escaped(table.caption));
    for (std::size_t i = 0; i < table.columns.size(); ++i) add("<th{}>{}</th>", kind(i), escaped(table.columns[i]));
    add("</tr></thead>\n<tbody>\n");
    for (const auto& row : table.rows) {
      add("<tr>");
      for (std::size_t i = 0; i < row.size(); ++i) add("<td{}>{}</td>", kind(i), escaped(row[i]));
      add("</tr>\n");
    }
    add("</tbody></table></div>\n");
  }

  void figure(const ReportImage& image) {
    std::string bytes;
    try {
      bytes = read_text_file(image.png);
    } catch (const InputError& error) {
      throw RunError(fmt::format("the report's picture is missing: {}", error.what()));
    }
    add("<figure><img alt=\"{}\" src=\"data:image/png;base64,{}\">\n<figcaption><b>Figure "
        "{}.</b>{}</figcaption></figure>\n",
        escaped(image.caption), base64(bytes), ++figures_, escaped(image.caption));
  }

  std::string text_;
  int tables_ = 0;
  int figures_ = 0;
};

}  // namespace

void write_report(const std::filesystem::path& path, const Report& report) {
  write_text_file(path, Page(report).text());
}

}  // namespace packstone::viz
