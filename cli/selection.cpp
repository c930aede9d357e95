#include "cli/selection.hpp"

#include <charconv>
#include <numeric>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packstone::cli {

namespace {

std::vector<std::size_t> everything(const RunReader& run) {
  std::vector<std::size_t> indices(run.snapshot_count());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

}  // namespace

std::vector<std::size_t> selected_snapshots(const RunReader& run, const std::string& at) {
  const std::size_t named = run.index_at(at == "all" ? "last" : at);  // fails on a run without snapshots
  return at == "all" ? everything(run) : std::vector<std::size_t>{named};
}

std::vector<std::size_t> frame_range(const RunReader& run, const std::string& range) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= range.size();) {
    const std::size_t end = std::min(range.find(':', begin), range.size());
    parts.push_back(range.substr(begin, end - begin));
    begin = end + 1;
  }
  if (parts.size() == 1) return {run.index_at(parts[0])};
  std::size_t stride = 1;
  if (parts.size() == 3 && !parts[2].empty()) {
    const auto [end, error] = std::from_chars(parts[2].data(), parts[2].data() + parts[2].size(), stride);
    if (error != std::errc() || *end != '\0' || stride == 0) parts.clear();
  }
  if (parts.size() < 2 || parts.size() > 3) {
    throw InputError(fmt::format("--frames {}: expected FIRST:LAST or FIRST:LAST:STRIDE, such as 0:100:2", range));
  }
  const std::size_t first = run.index_at(parts[0].empty() ? "first" : parts[0]);
  const std::size_t last = run.index_at(parts[1].empty() ? "last" : parts[1]);
  if (last < first) throw InputError(fmt::format("--frames {}: the last frame comes before the first", range));
  std::vector<std::size_t> indices;
  for (std::size_t k = first; k <= last; k += stride) indices.push_back(k);
  return indices;
}

}  // namespace packstone::cli
