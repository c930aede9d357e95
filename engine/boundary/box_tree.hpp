// A tree of boxes that stand along the axes: which of many things are near a point.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/vec3.hpp"

namespace packstone::engine {

/// A box that stands along the axes [m].
struct Extent {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  void add(const Extent& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  bool empty() const { return low.x() > high.x(); }
  double distance(const Vec3& p) const { return (p.cwiseMax(low).cwiseMin(high) - p).norm(); }
};

class BoxTree {
 public:
  void build(const std::vector<Extent>& extents);

  const Extent& extent() const { return whole_; }

  /// visit(index) for all whose boxes are no farther from p than reach [m]; ascending within a leaf only.
  template <class Visit>
  void for_each_near(const Vec3& p, double reach, const Visit& visit) const {
    descend([&](const Extent& box) { return box.distance(p) <= reach; }, visit);
  }

  /// visit(index) for all below p, within a column that is one rounding wide.
  template <class Visit>
  void for_each_below(const Vec3& p, const Visit& visit) const {
    descend(
        [&](const Extent& box) {
          return box.low.x() <= p.x() && p.x() <= box.high.x() && box.low.y() <= p.y() && p.y() <= box.high.y() &&
                 box.low.z() <= p.z();
        },
        visit);
  }

 private:
  struct Node {
    Extent box;
    std::int32_t first, last;  ///< of order_ in a leaf
    std::int32_t right;        ///< child; the left one follows its parent; 0 in a leaf
  };

  static constexpr int deepest = 64;  ///< halvings of fewer than 2^31 things, and to spare

  template <class Enter, class Visit>
  void descend(const Enter& enter, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::int32_t waiting[deepest];
    int count = 0;
    waiting[count++] = 0;
    while (count > 0) {
      const std::int32_t at = waiting[--count];
      const Node& node = nodes_[at];
      if (!enter(node.box)) continue;
      if (node.right == 0) {
        for (std::int32_t k = node.first; k < node.last; ++k) visit(order_[k]);
      } else {
        waiting[count++] = node.right;
        waiting[count++] = at + 1;
      }
    }
  }

  void split(const std::vector<Extent>& extents, std::int32_t first, std::int32_t last);

  Extent whole_;
  std::vector<Node> nodes_;
  std::vector<std::int32_t> order_;
};

}  // namespace packstone::engine
