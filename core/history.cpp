#include "core/history.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/text.hpp"

namespace packstone {

namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) result.push_back(cell);
  return result;
}

}  // namespace

bool History::has(const std::string& name) const {
  return std::find(columns.begin(), columns.end(), name) != columns.end();
}

const std::vector<double>& History::column(const std::string& name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) {
    throw InputError(fmt::format("history.csv has no column \"{}\"; there are: {}", name, joined(columns)));
  }
  return values[static_cast<std::size_t>(found - columns.begin())];
}

History read_history(const std::filesystem::path& path) {
  std::istringstream lines(read_text_file(path));
  std::string line;
  History history;
  if (std::getline(lines, line)) history.columns = cells(line);
  history.values.resize(history.columns.size());
  for (int number = 2; std::getline(lines, line) && !lines.eof(); ++number) {  // a row cut short by a kill has no end
    const auto row = cells(line);
    if (row.size() != history.columns.size()) {
      throw InputError(fmt::format("{}:{}: {} values, but the header names {}", path.string(), number, row.size(),
                                   history.columns.size()));
    }
    for (std::size_t k = 0; k < row.size(); ++k) {
      double value = 0;
      const auto [end, error] = std::from_chars(row[k].data(), row[k].data() + row[k].size(), value);
      if (error != std::errc() || *end != '\0') {
        throw InputError(fmt::format("{}:{}: \"{}\" is not a number", path.string(), number, row[k]));
      }
      history.values[k].push_back(value);
    }
  }
  return history;
}

}  // namespace packstone
