// The numbers of several runs side by side.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.hpp"

namespace packstone::cli {

/// One row a quantity, one column a run; the first column names measure, quantity and unit.
struct Comparison {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// results: one list of measures a run, all of the same selection.
Comparison compare(const std::vector<std::string>& labels,
                   const std::vector<std::vector<analysis::MeasureResult>>& results);

/// As a Markdown table.
std::string to_markdown(const Comparison& comparison);

}  // namespace packstone::cli
