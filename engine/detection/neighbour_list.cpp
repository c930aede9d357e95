#include "engine/detection/neighbour_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/threads.hpp"

namespace packstone::engine {

namespace {

/// Margin between surfaces as a share of the largest radius: wider lists are built less often and read longer.
constexpr double margin_share = 0.3;

/// Number of an image whose shift is (a, b, c) box lengths, each -1, 0 or 1.
std::int32_t image_number(int a, int b, int c) { return (c + 1) * 9 + (b + 1) * 3 + (a + 1); }

}  // namespace

NeighbourList::NeighbourList(const Domain& domain, double largest_radius)
    : domain_(domain), largest_radius_(largest_radius), margin_(margin_share * largest_radius) {
  for (int c = -1; c <= 1; ++c) {
    for (int b = -1; b <= 1; ++b) {
      for (int a = -1; a <= 1; ++a) shifts_.push_back(domain.size().cwiseProduct(Vec3(a, b, c)));
    }
  }
}

double NeighbourList::least_periodic_side(double largest_radius) {
  return 2 * (2 * largest_radius + margin_share * largest_radius);
}

void NeighbourList::append_neighbours(const Particles& particles, std::size_t i, double scale,
                                      std::vector<Neighbour>& row) const {
  const Vec3 here = particles.now.position.get(i);
  const Vec3 side = domain_.size();
  const double farthest = scale * (particles.radius[i] + largest_radius_) + margin_;
  grid_.for_each_near(here, [&](std::int32_t j, const Vec3& there) {
    Vec3 d = here - there;
    std::array<int, 3> image = {0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      if (!domain_.periodic[axis] || std::abs(d[axis]) <= 0.5 * side[axis]) continue;
      image[axis] = d[axis] > 0 ? 1 : -1;
      d[axis] -= image[axis] * side[axis];
    }
    const double squared = d.squaredNorm();
    if (squared >= farthest * farthest || static_cast<std::size_t>(j) == i) return;
    const double reach = scale * (particles.radius[i] + particles.radius[j]) + margin_;
    if (squared < reach * reach) row.push_back({j, image_number(image[0], image[1], image[2])});
  });
}

void NeighbourList::build(Particles& particles, const Growth& growth) {
  const std::size_t n = particles.size();
  for (std::size_t i = 0; i < n; ++i) particles.now.position.set(i, domain_.wrapped(particles.now.position.get(i)));
  reference_ = particles.now.position;
  built_scale_ = growth.scale;
  ++builds_;
  grid_.build(domain_, reference_, n, 2 * growth.scale * largest_radius_ + margin_);

  // Rows of a block are found into the block's own store, then all are laid end to end: the same list for any threads.
  const auto blocks = static_cast<std::ptrdiff_t>((n + particles_per_block - 1) / particles_per_block);
  found_.resize(static_cast<std::size_t>(blocks));
  first_.assign(n + 1, 0);
#pragma omp parallel for schedule(static) num_threads(useful_threads(n))
  for (std::ptrdiff_t b = 0; b < blocks; ++b) {
    found_[b].clear();
    for (std::size_t i = b * particles_per_block; i < std::min<std::size_t>((b + 1) * particles_per_block, n); ++i) {
      append_neighbours(particles, i, growth.scale, found_[b]);
      first_[i + 1] = found_[b].size();
    }
  }
  std::size_t before = 0;
  for (std::size_t i = 0; i < n; ++i) {
    first_[i + 1] += before;
    if ((i + 1) % particles_per_block == 0) before = first_[i + 1];
  }
  entries_.resize(first_.back());
#pragma omp parallel for schedule(static) num_threads(useful_threads(n))
  for (std::ptrdiff_t b = 0; b < blocks; ++b) {
    std::copy(found_[b].begin(), found_[b].end(),
              entries_.begin() + static_cast<std::ptrdiff_t>(first_[b * particles_per_block]));
  }
}

bool NeighbourList::outdated(double largest_displacement_squared, const Growth& growth) const {
  const double approach =
      2 * std::sqrt(largest_displacement_squared) + 2 * largest_radius_ * (growth.scale - built_scale_);
  return !(approach < margin_);
}

}  // namespace packstone::engine
