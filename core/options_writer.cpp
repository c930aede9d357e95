#include "core/options_writer.hpp"

#include <fmt/format.h>

#include "core/text.hpp"

namespace packstone {

namespace {

/// A TOML basic string.
std::string toml_text(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += {'\\', c};
    } else if (code < 0x20 || code == 0x7f) {
      result += fmt::format("\\u{:04x}", code);
    } else {
      result += c;
    }
  }
  return result + "\"";
}

/// The fewest digits that bring the number back; -0 is one, which TOML takes for the whole number 0.
std::string number_text(double value) {
  const std::string text = fmt::format("{}", value);
  return text == "-0" ? "-0.0" : text;
}

std::string vector_text(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", number_text(v[0]), number_text(v[1]), number_text(v[2]));
}

}  // namespace

void OptionWriter::line(const OptionInfo& info, const std::string& value) {
  text_ +=
      fmt::format("{} = {}{}\n", info.key, value, *info.unit.symbol ? fmt::format("  # {}", info.unit.symbol) : "");
}

void OptionWriter::number(const OptionInfo& info, double& value, Presence) { line(info, number_text(value)); }

void OptionWriter::number(const OptionInfo& info, std::optional<double>& value) {
  if (value) line(info, number_text(*value));
}

void OptionWriter::integer(const OptionInfo& info, std::int64_t& value, Presence) {
  line(info, fmt::format("{}", value));
}

void OptionWriter::integer(const OptionInfo& info, std::optional<std::int64_t>& value) {
  if (value) line(info, fmt::format("{}", *value));
}

void OptionWriter::boolean(const OptionInfo& info, bool& value) { line(info, value ? "true" : "false"); }

void OptionWriter::text(const OptionInfo& info, std::string& value, Presence) { line(info, toml_text(value)); }

void OptionWriter::text(const OptionInfo& info, std::optional<std::string>& value) {
  if (value) line(info, toml_text(*value));
}

void OptionWriter::vector(const OptionInfo& info, Vec3& value, Presence) { line(info, vector_text(value)); }

void OptionWriter::vector(const OptionInfo& info, std::optional<Vec3>& value) {
  if (value) line(info, vector_text(*value));
}

void OptionWriter::number_or(const OptionInfo& info, const char* word, std::optional<double>& value) {
  line(info, value ? number_text(*value) : toml_text(word));
}

void OptionWriter::numbers(const OptionInfo& info, std::vector<double>& value) {
  if (value.empty()) return;
  std::vector<std::string> words;
  for (const double number : value) words.push_back(number_text(number));
  line(info, "[" + joined(words) + "]");
}

void OptionWriter::texts(const OptionInfo& info, std::vector<std::string>& value) {
  std::vector<std::string> all;
  for (const std::string& text : value) all.push_back(toml_text(text));
  if (!all.empty()) line(info, "[" + joined(all) + "]");
}

void OptionWriter::polygons(const OptionInfo& info, std::vector<std::vector<Vec3>>& value) {
  std::vector<std::string> all;
  for (const auto& polygon : value) {
    std::vector<std::string> corners;
    for (const Vec3& corner : polygon) corners.push_back(vector_text(corner));
    all.push_back("[" + joined(corners) + "]");
  }
  if (!all.empty()) line(info, "[" + joined(all) + "]");
}

void OptionWriter::number_or_table(const OptionInfo& info, std::optional<double>& value, bool& is_table,
                                   const std::function<void()>& describe) {
  if (is_table) {
    table(info, Presence::has_default, describe);
  } else {
    number(info, value);
  }
}

void OptionWriter::choices(const OptionInfo& info, const ChoiceNames& names, std::vector<int>& value) {
  std::vector<std::string> words;
  for (int index : value) words.push_back(toml_text(names[index]));
  line(info, "[" + joined(words) + "]");
}

void OptionWriter::choice_index(const OptionInfo& info, const ChoiceNames& names, int& index, Presence) {
  line(info, toml_text(names[index]));
}

void OptionWriter::table(const OptionInfo& info, Presence, const std::function<void()>& describe) {
  const std::string outer = path_;
  path_ += (outer.empty() ? "" : ".") + std::string(info.key);
  text_ += fmt::format("\n[{}]\n", path_);
  describe();
  path_ = outer;
}

void OptionWriter::optional_table(const OptionInfo& info, bool& present, const std::function<void()>& describe) {
  if (present) table(info, Presence::has_default, describe);
}

std::size_t OptionWriter::begin_tables(const OptionInfo&, std::size_t, std::size_t held) { return held; }

void OptionWriter::begin_entry(const OptionInfo& info, std::size_t) {
  path_ = info.key;
  text_ += fmt::format("\n[[{}]]\n", path_);
}

void OptionWriter::end_entry() { path_.clear(); }

void OptionWriter::end_tables() {}

}  // namespace packstone
