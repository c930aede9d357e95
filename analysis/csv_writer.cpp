#include <cmath>
#include <map>

#include <fmt/format.h>

#include "analysis/writers.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/output_folder.hpp"

namespace packstone::analysis {

namespace {

/// A field by RFC 4180: in quotes when it holds a comma, a quote or a line break.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

std::string number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

std::string number(const std::optional<double>& value) { return value ? number(*value) : ""; }

/// Files under way: content by name.
using Files = std::map<std::string, std::string>;

void add_quantities(Files& files, const MeasureResult& result, const std::string& leading) {
  std::string& text = files.at("measures.csv");
  for (const auto& q : result.quantities) {
    text += leading + fmt::format("{},{},{},{},{},{},{}\n", quoted(result.name), quoted(q.key), number(q.value),
                                  number(q.uncertainty), quoted(q.unit), quoted(q.definition), quoted(q.note));
  }
}

void add_table(Files& files, const std::string& name, const Table& table, const std::string& leading_title,
               const std::string& leading) {
  std::string& text = files[name];
  if (text.empty()) {
    text = leading_title;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      text += (c == 0 ? "" : ",") + quoted(column_title(table.columns[c]));
    }
    text += "\n";
  }
  for (const auto& row : table.rows) {
    text += leading;
    for (std::size_t c = 0; c < row.size(); ++c) text += (c == 0 ? "" : ",") + number(row[c]);
    text += "\n";
  }
}

void add_results(Files& files, const std::vector<MeasureResult>& results, const std::string& leading_title,
                 const std::string& leading) {
  for (const auto& result : results) {
    add_quantities(files, result, leading);
    for (const auto& table : result.tables) {
      add_table(files, result.name + "_" + table.key + ".csv", table, leading_title, leading);
    }
  }
}

Files started(const std::string& leading_title) {
  return {{"measures.csv", leading_title + "measure,key,value,uncertainty,unit,definition,note\n"}};
}

void write_files(const std::filesystem::path& folder, const Files& files) {
  const OutputFolder made(folder);
  for (const auto& [name, text] : files) write_text_file(made.path() / name, text);
}

}  // namespace

void write_csv(const std::filesystem::path& folder, const std::vector<MeasureResult>& results) {
  Files files = started("");
  add_results(files, results, "", "");
  write_files(folder, files);
}

void write_csv(const std::filesystem::path& folder, const std::vector<TimedResults>& series) {
  const std::string leading_title = "time [s],";
  Files files = started(leading_title);
  for (const auto& instant : series) add_results(files, instant.results, leading_title, number(instant.time) + ",");
  write_files(folder, files);
}

}  // namespace packstone::analysis
