#include "analysis/adjacency.hpp"

namespace packstone::analysis {

Adjacency adjacency(std::span<const NearPair> pairs, std::size_t particles) {
  Adjacency list;
  list.begin.assign(particles + 1, 0);
  for (const NearPair& pair : pairs) {
    ++list.begin[pair.first + 1];
    ++list.begin[pair.second + 1];
  }
  for (std::size_t i = 0; i < particles; ++i) list.begin[i + 1] += list.begin[i];
  list.neighbour.resize(2 * pairs.size());
  list.pair.resize(2 * pairs.size());
  std::vector<std::size_t> next(list.begin.begin(), list.begin.end() - 1);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto add = [&](std::uint32_t one, std::uint32_t other) {
      list.pair[next[one]] = static_cast<std::uint32_t>(k);
      list.neighbour[next[one]++] = other;
    };
    add(pairs[k].first, pairs[k].second);
    add(pairs[k].second, pairs[k].first);
  }
  return list;
}

}  // namespace packstone::analysis
