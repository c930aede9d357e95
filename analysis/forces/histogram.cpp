#include "analysis/forces/histogram.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace packstone::analysis {

Table histogram(Table table, std::span<const double> values, double mean) {
  table.caption +=
      ": bins from lower to upper (means), count, probability density; what lies beyond 20 means either way counts in "
      "the outermost bins";
  table.columns = {{"lower"}, {"upper"}, {"count", "", ColumnFormat::integer}, {"density"}};
  if (values.empty() || !(mean > 0)) return table;
  std::array<double, 2 * histogram_bins> count{};
  for (const double value : values) {
    const double bin = std::floor(value / mean / histogram_bin) + histogram_bins;
    ++count[static_cast<std::size_t>(std::clamp(bin, 0.0, 2.0 * histogram_bins - 1))];
  }
  const auto filled = [](double c) { return c > 0; };
  const auto first = std::find_if(count.begin(), count.end(), filled) - count.begin();
  const auto end = count.rend() - std::find_if(count.rbegin(), count.rend(), filled);
  const double n = static_cast<double>(values.size());
  for (auto bin = first; bin < end; ++bin) {
    const double lower = static_cast<double>(bin - histogram_bins);
    const double in_bin = count[static_cast<std::size_t>(bin)];
    table.rows.push_back({lower * histogram_bin, (lower + 1) * histogram_bin, in_bin, in_bin / (n * histogram_bin)});
  }
  return table;
}

}  // namespace packstone::analysis
