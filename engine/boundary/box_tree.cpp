#include "engine/boundary/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace packstone::engine {

namespace {

constexpr std::int32_t leaf_size = 4;

}  // namespace

void BoxTree::build(const std::vector<Extent>& extents) {
  whole_ = {};
  nodes_.clear();
  order_.resize(extents.size());
  std::iota(order_.begin(), order_.end(), 0);
  if (!extents.empty()) split(extents, 0, static_cast<std::int32_t>(extents.size()));
  for (const Extent& extent : extents) whole_.add(extent);
}

void BoxTree::split(const std::vector<Extent>& extents, std::int32_t first, std::int32_t last) {
  Node node{{}, first, last, 0};
  for (std::int32_t k = first; k < last; ++k) node.box.add(extents[order_[k]]);
  const std::size_t at = nodes_.size();
  nodes_.push_back(node);
  if (last - first <= leaf_size) return;
  int axis = 0;
  (node.box.high - node.box.low).maxCoeff(&axis);
  const std::int32_t middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last, [&](auto a, auto b) {
    const double place_a = extents[a].low[axis] + extents[a].high[axis];
    const double place_b = extents[b].low[axis] + extents[b].high[axis];
    return place_a != place_b ? place_a < place_b : a < b;
  });
  split(extents, first, middle);
  nodes_[at].right = static_cast<std::int32_t>(nodes_.size());
  split(extents, middle, last);
}

}  // namespace packstone::engine
