#include "engine/detection/neighbour_list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/block_sum.hpp"
#include "engine/simd/lanes.hpp"
#include "engine/simd/vector.hpp"
#include "engine/threads.hpp"

namespace packstone::engine {

namespace {

/// Margins that a periodic side must leave room for, as a share of the largest radius.
constexpr double least_margin_share = 0.3;
/// Growth that a list allows for, in times of its planned life.
constexpr double growth_lives = 2;
/// Particles searched in one go by a thread.
constexpr std::size_t search_block = 256;
/// Particles among which those of similar numbers of neighbours are brought together in groups.
constexpr std::size_t sorting_window = 256;
/// A particle with more neighbours than this many rows would hold has its lanes to itself.
constexpr std::int32_t longest_common_row = 32;
/// Rows of a block of groups: enough work to be worth fetching.
constexpr std::int32_t rows_per_block = 256;

std::uint32_t entry(std::int32_t slot) { return static_cast<std::uint32_t>(slot) * Row::doubles; }

std::int32_t rows_for(std::int32_t entries, int width) { return (entries + width - 1) / width; }

}  // namespace

double NeighbourList::least_periodic_side(double largest_radius, double range) {
  return 2 * (2 * largest_radius + least_margin_share * largest_radius + range);
}

void NeighbourList::choose_extents(Particles& p, const Growth& growth, double dt, double least_share) {
  slot_before_.clear();
  for (std::size_t s = 0; s < p.slots(); ++s) {
    if (p.is_particle(s)) slot_before_.push_back(static_cast<std::int32_t>(s));
  }
  const std::size_t n = slot_before_.size();
  position_.resize(n);
  extent_.resize(n);
  margin_.resize(n);
  const auto row = [&](std::size_t k) -> Row& { return p.now.rows[slot_before_[k]]; };
  const Vec3 mean = sum_in_blocks<Vec3>(n, Vec3::Zero(), [&](std::size_t k) { return row(k).velocity; }) /
                    static_cast<double>(std::max<std::size_t>(n, 1));
  const auto speed = [&](std::size_t k) { return (row(k).velocity - mean).norm(); };
  const double mean_speed = sum_in_blocks<double>(n, 0.0, [&](std::size_t k) { return speed(k) / row(k).radius; }) /
                            static_cast<double>(std::max<std::size_t>(n, 1));
  displacement_.setZero();
  displacement_before_ = -dt * mean;
  common_ = dt * mean.norm();
  const Margins margins = policy_.next(dt, mean_speed);
  mean_velocity_ = mean;
  mean_radius_ = sum_in_blocks<double>(n, 0.0, [&](std::size_t k) { return row(k).radius; }) /
                 static_cast<double>(std::max<std::size_t>(n, 1));
  life_ = margins.life;
  largest_scale_ = std::min(1.0, growth.scale + growth_lives * margins.life * growth.rate);
  double shortest_side = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (domain_.periodic[axis]) shortest_side = std::min(shortest_side, domain_.size()[axis]);
  }
  const auto count = static_cast<std::ptrdiff_t>(n);
#pragma omp parallel for schedule(static) num_threads(useful_threads(n))
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    Row& own = row(k);
    own.position = domain_.wrapped(own.position);
    position_.set(k, own.position);
    // Two extents never reach across half the box: then only one image of a neighbour can come into contact.
    const double least = largest_scale_ * own.radius + 0.5 * range_;
    const double room = shortest_side / 4 - least;
    const double wanted = margins.size_share * own.radius + Margins::flight_allowance * margins.life * speed(k);
    margin_[k] = std::min(std::max(wanted, least_share * own.radius), room);
    extent_[k] = least + margin_[k];
  }
}

bool NeighbourList::image_across(const Vec3& point, double reach) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (!domain_.periodic[axis]) continue;
    if (point[axis] - reach < domain_.min[axis] || point[axis] + reach > domain_.max[axis]) return true;
  }
  return false;
}

void NeighbourList::search_one(std::size_t place, Found& found) const {
  using simd::absolute, simd::any, simd::fused, simd::nearest_integer;
  using Lanes = simd::WidestSingle;
  using Real = Lanes::Real;
  const HierarchicalGrid::Spheres& spheres = grid_.spheres();
  const Vec3 side = domain_.size();
  const Vec3 here = spheres.position(place);
  const double own_extent = spheres.extent[place];
  const simd::Vector<Real> point{Real(here[0]), Real(here[1]), Real(here[2])};
  const bool images = image_across(here + grid_.middle(), own_extent + grid_.largest_extent());
  const auto component = [&](int axis, const AlignedVector<float>& coordinate, std::size_t k, const Real& x,
                             Lanes::Mask& across) __attribute__((always_inline)) {
    const Real d = x - Lanes::load(&coordinate[k]);
    if (!images || !domain_.periodic[axis]) return d;
    const Real boxes = nearest_integer(d * Real(1 / side[axis]));
    across = across | (Real(0.0) < absolute(boxes));
    return fused(-boxes, Real(side[axis]), d);
  };
  bool any_across = false;
  const auto self = static_cast<std::int32_t>(place);
  grid_.for_each_range(
      here, own_extent, [&](std::int32_t begin, std::int32_t end) __attribute__((always_inline)) {
        const std::size_t most = found.used + static_cast<std::size_t>(end - begin) + Lanes::width;
        if (found.neighbours.size() < most) found.neighbours.resize(2 * most);
        std::int32_t* to = found.neighbours.data() + found.used;
        for (std::int32_t k = begin; k < end; k += Lanes::width) {
          std::uint32_t considered = end - k < Lanes::width ? (1u << (end - k)) - 1 : (1u << Lanes::width) - 1;
          if (self >= k && self < k + Lanes::width) considered &= ~(1u << (self - k));
          auto across = Lanes::mask(0);
          const simd::Vector<Real> d{component(0, spheres.x, k, point.x, across),
                                     component(1, spheres.y, k, point.y, across),
                                     component(2, spheres.z, k, point.z, across)};
          const Real reach = Real(own_extent) + Lanes::load(&spheres.extent[k]);
          const Lanes::Mask near = (squared_length(d) < reach * reach) & Lanes::mask(considered);
          to += Lanes::write_indices(near, k, to);
          any_across = any_across || any(near & across);
        }
        found.used = static_cast<std::size_t>(to - found.neighbours.data());
      });
  found.end.push_back(static_cast<std::int32_t>(found.used));
  found.images.push_back(any_across);
}

void NeighbourList::search() {
  const std::size_t n = grid_.order().size();
  found_.resize((n + search_block - 1) / search_block);
  const auto blocks = static_cast<std::ptrdiff_t>(found_.size());
#pragma omp parallel for schedule(dynamic) num_threads(useful_threads(n))
  for (std::ptrdiff_t b = 0; b < blocks; ++b) {
    Found& found = found_[b];
    found.used = 0;
    found.end.clear();
    found.images.clear();
    const std::size_t begin = b * search_block;
    for (std::size_t k = begin; k < std::min(begin + search_block, n); ++k) search_one(k, found);
  }
}

void NeighbourList::assign_slots() {
  // Particles of few neighbours first, in windows along the grid's order; within one those are brought together that
  // have neighbours across a periodic side, and then those of as many neighbours.
  struct Candidate {
    std::int32_t place, neighbours;
    bool images;
  };
  const std::size_t n = grid_.order().size();
  std::vector<Candidate> common, alone;
  common.reserve(n);
  pairs_ = 0;
  for (std::size_t b = 0; b < found_.size(); ++b) {
    std::int32_t begin = 0;
    for (std::size_t k = 0; k < found_[b].end.size(); ++k) {
      const Candidate c{static_cast<std::int32_t>(b * search_block + k), found_[b].end[k] - begin,
                        found_[b].images[k] != 0};
      begin = found_[b].end[k];
      pairs_ += c.neighbours;
      (c.neighbours > longest_common_row ? alone : common).push_back(c);
    }
  }
  const auto windows = static_cast<std::ptrdiff_t>((common.size() + sorting_window - 1) / sorting_window);
#pragma omp parallel for schedule(static) num_threads(useful_threads(n))
  for (std::ptrdiff_t w = 0; w < windows; ++w) {
    const auto begin = common.begin() + w * static_cast<std::ptrdiff_t>(sorting_window);
    std::stable_sort(begin, std::min(begin + sorting_window, common.end()), [](const Candidate& a, const Candidate& b) {
      return a.images != b.images ? b.images : a.neighbours < b.neighbours;
    });
  }

  const auto width = static_cast<std::size_t>(width_);
  const std::size_t common_groups = (common.size() + width - 1) / width;
  groups_.clear();
  place_of_.assign(common_groups * width + alone.size() + 1, Particles::no_particle);
  slot_of_.resize(n);
  std::int64_t row = 0;
  const auto add_group = [&](std::size_t slot, const Candidate* first, std::size_t count, bool shared) {
    NeighbourGroup group{static_cast<std::int32_t>(slot), 0, row, (1u << count) - 1, shared, false};
    for (std::size_t k = 0; k < count; ++k) {
      place_of_[slot + k] = first[k].place;
      slot_of_[first[k].place] = static_cast<std::int32_t>(slot + k);
      group.rows = std::max(group.rows, shared ? rows_for(first[k].neighbours, width_) : first[k].neighbours);
      group.images = group.images || first[k].images;
    }
    row += group.rows;
    groups_.push_back(group);
  };
  for (std::size_t g = 0; g < common_groups; ++g) {
    add_group(g * width, &common[g * width], std::min(width, common.size() - g * width), false);
  }
  for (std::size_t k = 0; k < alone.size(); ++k) add_group(common_groups * width + k, &alone[k], 1, true);
  entries_.resize(static_cast<std::size_t>(row) * width);
}

void NeighbourList::fill_rows(std::int32_t nobody) {
  const auto groups = static_cast<std::ptrdiff_t>(groups_.size());
#pragma omp parallel for schedule(dynamic, 64) num_threads(useful_threads(particles_))
  for (std::ptrdiff_t g = 0; g < groups; ++g) {
    const NeighbourGroup& group = groups_[g];
    std::uint32_t* rows = entries_.data() + group.first_row * width_;
    std::fill_n(rows, static_cast<std::ptrdiff_t>(group.rows) * width_, entry(nobody));
    for (int lane = 0; lane < width_ && (group.lanes >> lane & 1u) != 0; ++lane) {
      const auto place = static_cast<std::size_t>(place_of_[group.slot + lane]);
      const Found& found = found_[place / search_block];
      const std::size_t k = place % search_block;
      const std::int32_t begin = k == 0 ? 0 : found.end[k - 1];
      const int stride = group.shared ? 1 : width_;
      for (std::int32_t e = begin; e < found.end[k]; ++e) {
        rows[lane + static_cast<std::ptrdiff_t>(e - begin) * stride] = entry(slot_of_[found.neighbours[e]]);
      }
    }
  }
}

void NeighbourList::make_blocks() {
  blocks_.clear();
  std::int32_t rows = 0, first = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    rows += groups_[g].rows + 1;
    if (rows < rows_per_block && g + 1 < groups_.size()) continue;
    blocks_.push_back({first, static_cast<std::int32_t>(g) + 1});
    first = static_cast<std::int32_t>(g) + 1;
    rows = 0;
  }
}

void NeighbourList::build(Particles& particles, const Growth& growth, double dt, double least_share) {
  policy_.learn(std::sqrt(used_squared_), steps_, dt);
  choose_extents(particles, growth, dt, least_share);
  particles_ = slot_before_.size();
  grid_.build(domain_, position_, extent_);
  search();
  assign_slots();

  std::vector<std::int32_t> from(place_of_.size(), Particles::no_particle);
  reference_.resize(place_of_.size());
  inverse_margin_squared_.assign(place_of_.size(), 0.0);
  const auto slots = static_cast<std::ptrdiff_t>(place_of_.size());
#pragma omp parallel for schedule(static) num_threads(useful_threads(particles_))
  for (std::ptrdiff_t s = 0; s < slots; ++s) {
    if (place_of_[s] == Particles::no_particle) continue;
    const std::int32_t k = grid_.order()[place_of_[s]];
    from[s] = slot_before_[k];
    reference_.set(s, position_.get(k));
    inverse_margin_squared_[s] = 1 / (margin_[k] * margin_[k]);
  }
  particles.reorder(from);
  fill_rows(particles.nobody());
  make_blocks();

  ++builds_;
  steps_ = 0;
  used_squared_ = 0;
  dt_ = dt;
}

void NeighbourList::moved(double largest_share_squared, const Vec3& displacement_sum, double dt) {
  ++steps_;
  dt_ = dt;
  used_squared_ = largest_share_squared;
  const double expected = expected_displacement().norm();
  displacement_before_ = displacement_;
  displacement_ = displacement_sum / static_cast<double>(std::max<std::size_t>(particles_, 1));
  common_ = std::max(expected, expected_displacement().norm());
}

void NeighbourList::archive(Archive& a) {
  a(policy_, groups_, blocks_, entries_, reference_, inverse_margin_squared_, builds_, pairs_);
  a(steps_, largest_scale_, used_squared_, dt_, particles_, displacement_, displacement_before_, common_, life_,
    mean_radius_, mean_velocity_);
}

bool NeighbourList::outdated(const Growth& growth) const {
  if (builds_ == 0 || !(used_squared_ < 1) || growth.scale > largest_scale_) return true;
  return policy_.worth_renewing(std::sqrt(used_squared_), steps_, dt_);
}

}  // namespace packstone::engine
