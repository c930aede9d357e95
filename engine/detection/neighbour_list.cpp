#include "engine/detection/neighbour_list.hpp"

#include <cmath>

#include "engine/threads.hpp"

namespace packstone::engine {

namespace {

/// Margin between surfaces as a share of the largest radius: wider lists are built less often and read longer.
constexpr double margin_share = 0.15;

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

template <class Visit>
void NeighbourList::for_each_candidate(const Particles& particles, std::size_t i, double scale, Visit&& visit) const {
  const Vec3 here = particles.now.position.get(i);
  const Vec3 side = domain_.size();
  grid_.for_each_near(here, [&](std::int32_t j) {
    if (static_cast<std::size_t>(j) == i) return;
    Vec3 d = here - particles.now.position.get(j);
    std::array<int, 3> image = {0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      if (!domain_.periodic[axis] || std::abs(d[axis]) <= 0.5 * side[axis]) continue;
      image[axis] = d[axis] > 0 ? 1 : -1;
      d[axis] -= image[axis] * side[axis];
    }
    const double reach = scale * (particles.radius[i] + particles.radius[j]) + margin_;
    if (d.squaredNorm() < reach * reach) visit(Neighbour{j, image_number(image[0], image[1], image[2])});
  });
}

void NeighbourList::build(Particles& particles, const Growth& growth) {
  const auto n = static_cast<std::ptrdiff_t>(particles.size());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    particles.now.position.set(i, domain_.wrapped(particles.now.position.get(i)));
  }
  reference_ = particles.now.position;
  built_scale_ = growth.scale;
  ++builds_;
  grid_.build(domain_, reference_, particles.size(), 2 * growth.scale * largest_radius_ + margin_);

  // The first pass counts, the second fills: no thread needs a list of its own, and the order is always the same.
  first_.assign(particles.size() + 1, 0);
#pragma omp parallel for schedule(static) num_threads(useful_threads(particles.size()))
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    std::size_t count = 0;
    for_each_candidate(particles, i, growth.scale, [&](const Neighbour&) { ++count; });
    first_[i + 1] = count;
  }
  for (std::ptrdiff_t i = 0; i < n; ++i) first_[i + 1] += first_[i];
  entries_.resize(first_.back());
#pragma omp parallel for schedule(static) num_threads(useful_threads(particles.size()))
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    std::size_t k = first_[i];
    for_each_candidate(particles, i, growth.scale, [&](const Neighbour& neighbour) { entries_[k++] = neighbour; });
  }
}

bool NeighbourList::outdated(double largest_displacement_squared, const Growth& growth) const {
  const double approach =
      2 * std::sqrt(largest_displacement_squared) + 2 * largest_radius_ * (growth.scale - built_scale_);
  return !(approach < margin_);
}

}  // namespace packstone::engine
