#include "cli/comparison.hpp"

#include <fmt/format.h>

#include "analysis/writers.hpp"
#include "core/text.hpp"

namespace packstone::cli {

Comparison compare(const std::vector<std::string>& labels,
                   const std::vector<std::vector<analysis::MeasureResult>>& results) {
  Comparison comparison;
  comparison.columns = {"quantity"};
  comparison.columns.insert(comparison.columns.end(), labels.begin(), labels.end());
  for (std::size_t m = 0; m < results.front().size(); ++m) {
    const analysis::MeasureResult& measure = results.front()[m];
    for (std::size_t q = 0; q < measure.quantities.size(); ++q) {
      const analysis::Quantity& quantity = measure.quantities[q];
      std::vector<std::string> row = {fmt::format("{}: {}{}", measure.name, quantity.label,
                                                  quantity.unit.empty() ? "" : " [" + quantity.unit + "]")};
      for (const auto& run : results) row.push_back(analysis::value_text(run[m].quantities[q]));
      comparison.rows.push_back(row);
    }
  }
  return comparison;
}

std::string to_markdown(const Comparison& comparison) {
  std::string text = "| " + joined(comparison.columns, " | ") + " |\n|";
  for (std::size_t k = 0; k < comparison.columns.size(); ++k) text += "---|";
  for (const auto& row : comparison.rows) text += "\n| " + joined(row, " | ") + " |";
  return text + "\n";
}

}  // namespace packstone::cli
