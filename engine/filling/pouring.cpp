#include "engine/filling/pouring.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "core/geometry.hpp"
#include "core/random.hpp"
#include "engine/filling/placed_spheres.hpp"
#include "engine/filling/placing.hpp"

namespace packstone::engine {

namespace {

constexpr double looks_apart = 50;  ///< steps between two looks for room: each that finds some builds the lists anew
constexpr double settled_share = 0.99;  ///< of the particles that are carried: a few may be carried by one that flies
constexpr int most_trials = 200;        ///< for one particle in one look

}  // namespace

Pouring::Pouring(const Scene& scene) : scene_(scene), domain_(scene.box()) {
  const StartingState groups = unplaced_particles(scene);
  std::vector<std::size_t> order(groups.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random random(static_cast<std::uint64_t>(scene.seed), RandomStream::filling_order, 0);
  shuffle(order, random);
  for (const std::size_t k : order) {
    const GroupSpec& group = scene.particles[groups.type[k]];
    all_.radius.push_back(groups.radius[k]);
    all_.type.push_back(groups.type[k]);
    mass_.push_back(scene.materials[scene.material_index(group.material)].density * sphere_volume(groups.radius[k]));
  }
  all_.position.assign(order.size(), Vec3::Zero());
  all_.velocity.assign(order.size(), scene.filling.velocity);
  all_.angular_velocity.assign(order.size(), Vec3::Zero());
  const bool ends_early = scene.filling.most_mass || scene.filling.fill_height;
  if (scene.filling.rate && !ends_early) {
    const double most = 1 + std::floor(*scene.filling.rate * scene.dynamics.duration);
    if (most < static_cast<double>(all_.size())) {
      scene.fail("filling.rate",
                 fmt::format("{:g} particles a second are {:.0f} in the run's {:g} s, and {} are asked for; raise it, "
                             "run longer, or take fewer",
                             *scene.filling.rate, most, scene.dynamics.duration, all_.size()));
    }
  }
}

std::size_t Pouring::due(double time) const {
  if (scene_.filling.portions) return portion_end_;
  return std::min(all_.size(), 1 + static_cast<std::size_t>(*scene_.filling.rate * time));
}

void Pouring::begin_portion() {
  const auto portions = static_cast<std::size_t>(*scene_.filling.portions);
  portion_end_ = std::min(all_.size(), portion_end_ + (all_.size() + portions - 1) / portions);
}

double Pouring::settled_height(const Bed& bed) const {
  std::vector<double> tops;
  for (std::size_t i = 0; i < bed.radius.size(); ++i) {
    const double slow = std::sqrt(bed.gravity.norm() * bed.radius[i]);
    const Vec3 weight = mass_[i] * bed.gravity;
    const bool is_carried = (bed.force[i] - weight).norm() > 0.5 * weight.norm();
    if (is_carried && bed.velocity[i].norm() < slow) tops.push_back(bed.frame.height[i] + bed.radius[i]);
  }
  if (tops.empty()) return 0;
  const auto at = tops.begin() + static_cast<std::ptrdiff_t>(settled_share * static_cast<double>(tops.size() - 1));
  std::nth_element(tops.begin(), at, tops.end());
  return *at;
}

void Pouring::see(const Bed& bed, double unrest) {
  const FillingSpec& f = scene_.filling;
  if (f.fill_height && settled_height(bed) >= *f.fill_height) over_ = true;
  if (!f.portions || poured_ != portion_end_) return;
  if (unrest < (scene_.dynamics.overdamped() ? *f.rest_force : *f.rest_speed)) begin_portion();
}

StartingState Pouring::take(double time, double dt, const Particles& particles, const Boundaries& boundaries) {
  StartingState more;
  if (poured_ == 0 && scene_.filling.portions) begin_portion();
  if (over() || time < next_time_) return more;
  next_time_ = time + looks_apart * dt;
  const std::size_t end = due(time);
  if (end <= poured_) return more;

  const Region region = region_of(scene_, domain_);
  const double largest = *std::max_element(all_.radius.begin(), all_.radius.end());
  PlacedSpheres placed(domain_, largest);
  for (std::size_t slot = 0; slot < particles.slots(); ++slot) {
    if (!particles.is_particle(slot)) continue;
    const Row& row = particles.now.rows[slot];
    const Vec3 p = domain_.wrapped(row.position);
    const double reach = row.radius + 2 * largest;
    if ((p.array() < region.min.array() - reach).any() || (p.array() > region.max.array() + reach).any()) continue;
    placed.add(p, row.radius);
  }
  for (; poured_ < end; ++poured_) {
    if (scene_.filling.most_mass && poured_mass_ + mass_[poured_] > *scene_.filling.most_mass) {
      over_ = true;
      break;
    }
    const double radius = all_.radius[poured_];
    Random random(static_cast<std::uint64_t>(scene_.seed), RandomStream::filling_position, draws_++);
    bool found = false;
    Vec3 p;
    for (int trial = 0; trial < most_trials && !found; ++trial) {
      for (int axis = 0; axis < 3; ++axis) p[axis] = random.uniform(region.min[axis], region.max[axis]);
      found = placed.touches_none(p, radius) && has_room(p, radius, region, domain_, boundaries);
    }
    if (!found) break;  // until there is room
    placed.add(p, radius);
    poured_mass_ += mass_[poured_];
    more.position.push_back(p);
    more.velocity.push_back(all_.velocity[poured_]);
    more.angular_velocity.push_back(Vec3::Zero());
    more.radius.push_back(radius);
    more.type.push_back(all_.type[poured_]);
  }
  return more;
}

}  // namespace packstone::engine
