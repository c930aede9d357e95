#include "analysis/structure/rattlers.hpp"

#include <cstdint>

namespace packstone::analysis {

std::vector<char> rattlers(const Adjacency& near, const std::vector<int>& contacts) {
  std::vector<int> left(contacts);
  std::vector<char> removed(contacts.size(), 0);
  std::vector<std::uint32_t> queue;
  const auto remove_if_loose = [&](std::size_t i) {
    if (removed[i] || left[i] >= fewest_to_be_stable) return;
    removed[i] = 1;
    queue.push_back(static_cast<std::uint32_t>(i));
  };
  for (std::size_t i = 0; i < contacts.size(); ++i) remove_if_loose(i);
  while (!queue.empty()) {
    const std::uint32_t i = queue.back();
    queue.pop_back();
    for (const std::uint32_t other : near.of(i)) {
      --left[other];
      remove_if_loose(other);
    }
  }
  return removed;
}

}  // namespace packstone::analysis
