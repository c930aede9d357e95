#include "engine/detection/wall_list.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/threads.hpp"

namespace packstone::engine {

namespace {

/// Of the mean radius: margin for motion that all particles share, as when a bed begins to fall.
constexpr double least_margin = 0.2;
/// Lives of the list for which its margin allows at the speeds of when it is built.
constexpr double lives = 2;
constexpr std::size_t groups_per_block = 64;

}  // namespace

WallList::WallList(const Boundaries& boundaries, int width) : boundaries_(boundaries), width_(width) {
  std::int64_t pieces = 0;
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    first_piece_.push_back(pieces);
    pieces += static_cast<std::int64_t>(boundaries[k].shape.pieces.size());
  }
}

void WallList::find_pieces(const Boundaries::Body& body, std::int16_t number, const Vec3& p, const Vec3& before,
                           double reach, double touching, std::vector<WallEntry>& entries) const {
  boundaries_.for_each_image(body, p, [&](const Vec3& image, int shift) {
    const Vec3 inside = body.inside(image), inside_before = body.inside(before + (image - p));
    body.shape.for_each_near(inside, reach, [&](std::int32_t piece) {
      WallEntry entry{piece, number, static_cast<std::int8_t>(shift), body.shape.side_of(piece, inside_before), {}, 0};
      Touch touch;
      if (body.shape.touch(piece, inside_before, reach, entry.side, touch)) {
        entry.set_normal(body.moves ? Vec3(body.pose.turn * touch.normal) : touch.normal);
      }
      // Rounded down, so that none is taken for farther than it is.
      entry.gap = std::nextafter(static_cast<float>(body.shape.distance(piece, inside) - touching), -1.0f);
      entries.push_back(entry);
    });
  });
}

void WallList::find(const NeighbourList& list, const Particles& p, double dt, std::size_t group_number, int part,
                    Found& found) const {
  const NeighbourGroup& group = list.groups()[group_number];
  const auto first_row = static_cast<std::int32_t>(found.planes.size());
  const int lanes = group.shared ? (part == 0 ? 1 : 0) : width_;
  found.lanes.resize(width_);
  for (auto& entries : found.lanes) entries.clear();
  const auto touching = [&](std::size_t slot) { return list.largest_scale() * p.now.rows[slot].radius + list.range(); };
  const auto reach_of = [&](std::size_t slot) {
    return touching(slot) + 1 / std::sqrt(list.inverse_margin_squared()[slot]) + margin_;
  };
  const auto slot_of = [&](int lane) { return static_cast<std::size_t>(group.slot + part * width_ + lane); };
  for (std::size_t k = 0; k < boundaries_.size(); ++k) {
    const Boundaries::Body& body = boundaries_[k];
    const auto number = static_cast<std::int16_t>(k);
    std::size_t row = found.entries.size();
    bool any = false;
    for (int lane = 0; lane < lanes; ++lane) {
      const std::size_t slot = slot_of(lane);
      if (!p.is_particle(slot)) continue;
      const Vec3& position = p.now.rows[slot].position;
      if (!body.shape.is_plane()) {
        const Vec3 before = position - dt * p.half_step_velocity(slot);
        find_pieces(body, number, position, before, reach_of(slot), touching(slot), found.lanes[lane]);
      } else if (body.shape.distance(0, body.inside(position)) <= reach_of(slot)) {
        if (!any) found.entries.resize(row + width_);
        any = true;
        found.entries[row + lane] = {0, number, Boundaries::no_shift, 1, {}, 0};
      }
    }
    if (any) found.planes.push_back(static_cast<std::int32_t>(k));
  }
  // The nearest first: then most rows need no look as long as particles have hardly moved.
  std::size_t longest = 0;
  for (auto& entries : found.lanes) {
    std::sort(entries.begin(), entries.end(), [](const WallEntry& a, const WallEntry& b) {
      return std::tie(a.gap, a.body, a.piece, a.shift) < std::tie(b.gap, b.body, b.piece, b.shift);
    });
    longest = std::max(longest, entries.size());
  }
  for (std::size_t k = 0; k < longest; ++k) {
    for (const auto& entries : found.lanes) found.entries.push_back(k < entries.size() ? entries[k] : WallEntry{});
    found.planes.push_back(-1);
  }
  found.seats.push_back({first_row, static_cast<std::int32_t>(found.planes.size()) - first_row});
}

void WallList::build(const NeighbourList& list, const Particles& particles, double dt) {
  parts_ = list.width() / width_;
  margin_ = least_margin * list.mean_radius() + lives * list.planned_life() * list.mean_velocity().norm();
  travelled_.clear();
  double fastest = 0;
  for (std::size_t k = 0; k < boundaries_.size(); ++k) {
    travelled_.push_back(boundaries_[k].travelled);
    fastest = std::max(fastest, boundaries_[k].speed);
  }
  margin_ += lives * list.planned_life() * fastest;

  const std::size_t groups = list.groups().size();
  found_.resize((groups + groups_per_block - 1) / groups_per_block);
  const auto blocks = static_cast<std::ptrdiff_t>(found_.size());
#pragma omp parallel for schedule(dynamic) num_threads(useful_threads(particles.size()))
  for (std::ptrdiff_t b = 0; b < blocks; ++b) {
    Found& found = found_[b];
    found.seats.clear();
    found.entries.clear();
    found.planes.clear();
    const std::size_t begin = b * groups_per_block;
    for (std::size_t g = begin; g < std::min(begin + groups_per_block, groups); ++g) {
      for (int part = 0; part < parts_; ++part) find(list, particles, dt, g, part, found);
    }
  }
  seats_.clear();
  entries_.clear();
  planes_.clear();
  for (const Found& found : found_) {
    const auto before = static_cast<std::int32_t>(planes_.size());
    for (const WallSeat& seat : found.seats) seats_.push_back({before + seat.first_row, seat.rows});
    entries_.insert(entries_.end(), found.entries.begin(), found.entries.end());
    planes_.insert(planes_.end(), found.planes.begin(), found.planes.end());
  }
}

double WallList::travelled() const {
  double farthest = 0;
  for (std::size_t k = 0; k < travelled_.size(); ++k) {
    farthest = std::max(farthest, boundaries_[k].travelled - travelled_[k]);
  }
  return farthest;
}

bool WallList::outdated(const NeighbourList& list) const {
  return !(travelled() + list.common_displacement() <= margin_);
}

}  // namespace packstone::engine
