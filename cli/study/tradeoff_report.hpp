// A trade-off as text, table and chart.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "cli/study/tradeoff_table.hpp"
#include "viz/chart.hpp"

namespace packstone::cli {

/// As a Markdown table of one quantity.
std::string to_markdown(const Tradeoff& tradeoff, const std::string& quantity);

/// A line for each variant that has no result, with the reason.
std::string failures(const Tradeoff& tradeoff);

/// All quantities, one row a variant and quantity.
void write_csv(const std::filesystem::path& path, const Tradeoff& tradeoff);

/// Error over cost, with the front and what noise hides.
viz::Chart tradeoff_chart(const Tradeoff& tradeoff, const std::string& quantity, const std::string& title);

/// One sentence on which variant meets the tolerances, by quantity; the next step where none does.
std::string advice(const Tradeoff& tradeoff, const std::map<std::string, double>& tolerances);

}  // namespace packstone::cli
