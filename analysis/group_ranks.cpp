#include "analysis/group_ranks.hpp"

#include <algorithm>
#include <limits>

namespace packstone::analysis {

GroupRanks group_ranks(std::span<const std::uint32_t> label, std::span<const std::int64_t> id) {
  const std::size_t n = label.size();
  std::vector<std::uint32_t> size(n, 0), order, rank(n, 0);
  std::vector<std::int64_t> lowest(n, std::numeric_limits<std::int64_t>::max());
  for (std::size_t i = 0; i < n; ++i) {
    if (size[label[i]]++ == 0) order.push_back(label[i]);
    lowest[label[i]] = std::min(lowest[label[i]], id[i]);
  }
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return size[a] != size[b] ? size[a] > size[b] : lowest[a] < lowest[b];
  });
  GroupRanks ranks;
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    rank[order[k]] = k;
    ranks.size.push_back(size[order[k]]);
  }
  for (const std::uint32_t l : label) ranks.of_particle.push_back(rank[l]);
  return ranks;
}

}  // namespace packstone::analysis
