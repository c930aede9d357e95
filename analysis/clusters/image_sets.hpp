// Disjoint sets in a periodic box, which know when a set meets its own image.
#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace packstone::analysis {

/// Periods along x, y, z.
using Image = std::array<std::int32_t, 3>;

inline Image operator+(const Image& a, const Image& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Image operator-(const Image& a, const Image& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Sets of {0 .. n-1}, joined step by step; each member knows which of its images belongs to the set's root, so that a
/// set that closes on itself round the box is seen (Newman & Ziff, Phys. Rev. E 64 (2001) 016706, section V.B, after
/// Machta et al.).
class ImageSets {
 public:
  explicit ImageSets(std::size_t n) : parent_(n), size_(n, 1), image_(n, Image{0, 0, 0}), wraps_(n, 0) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  struct Member {
    std::uint32_t root;
    Image image;  ///< periods to add to the member's position to stand beside the root
  };

  Member find(std::uint32_t i) {
    Member found{i, {0, 0, 0}};
    while (parent_[found.root] != found.root) {
      const std::uint32_t above = parent_[found.root];
      image_[found.root] = image_[found.root] + image_[above];  // a root's is 0
      parent_[found.root] = parent_[above];
      found = {parent_[found.root], found.image + image_[found.root]};
    }
    return found;
  }

  /// image: periods to add to b's position to stand beside a.
  void join(std::uint32_t a, std::uint32_t b, const Image& image) {
    const Member one = find(a), other = find(b);
    const Image between = one.image + image - other.image;  // of b's root beside a's
    if (one.root == other.root) {
      for (int k = 0; k < 3; ++k) wraps_[one.root] |= static_cast<std::uint8_t>((between[k] != 0) << k);
      return;
    }
    const bool swapped = size_[one.root] < size_[other.root];
    const std::uint32_t root = swapped ? other.root : one.root, child = swapped ? one.root : other.root;
    parent_[child] = root;
    image_[child] = swapped ? Image{0, 0, 0} - between : between;
    size_[root] += size_[child];
    wraps_[root] |= wraps_[child];
  }

  /// Members of the set whose root this is.
  std::uint32_t size(std::uint32_t root) const { return size_[root]; }
  /// Whether the set whose root this is meets its own image along an axis.
  bool wraps(std::uint32_t root, int axis) const { return wraps_[root] >> axis & 1; }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> size_;
  std::vector<Image> image_;
  std::vector<std::uint8_t> wraps_;  ///< a bit an axis
};

}  // namespace packstone::analysis
