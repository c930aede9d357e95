// Where particles side by side touch boundaries: the geometry, before any force.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/detection/wall_list.hpp"
#include "engine/dynamics/contact_forces.hpp"
#include "engine/dynamics/contact_history.hpp"
#include "engine/dynamics/motion.hpp"

namespace packstone::engine {

/// The normals of contacts with boundaries, which turn as the pieces' shapes and motions say.
template <class L>
struct TurnsAlong {
  using Vector = simd::Vector<typename L::Real>;
  Vector rate;  ///< [1/s]

  [[gnu::always_inline]] Vector before(double lag, const Vector& /*across*/, const Vector& n) const {
    using Real = typename L::Real;
    return fused(Real(-lag), rate, n);
  }
};

/// A number a lane of motion; narrower lanes use the first.
template <class Lanes>
using LaneNumbers = std::array<double, Lanes::width>;

template <class Lanes>
struct LaneVectors {
  alignas(64) LaneNumbers<Lanes> x, y, z;

  void set(int lane, const Vec3& v) {
    x[lane] = v[0];
    y[lane] = v[1];
    z[lane] = v[2];
  }
  Vec3 get(int lane) const { return {x[lane], y[lane], z[lane]}; }
  template <class L>
  simd::Vector<typename L::Real> load() const {
    return {L::load(x.data()), L::load(y.data()), L::load(z.data())};
  }
  template <class L>
  void store(const simd::Vector<typename L::Real>& v) {
    L::store(x.data(), v.x);
    L::store(y.data(), v.y);
    L::store(z.data(), v.z);
  }
};

/// What boundaries do to particles side by side.
template <class Lanes>
struct WallLoads {
  bool any;                          ///< else force and torque are whatever they were
  LaneVectors<Lanes> force, torque;  ///< [N, N m]
};

/// One row of the wall list at an instant.
template <class Lanes>
struct WallRow {
  std::uint32_t touching = 0, near = 0;    ///< bits of lanes
  LaneVectors<Lanes> normal;               ///< unit vectors to the particles
  alignas(64) LaneNumbers<Lanes> overlap;  ///< [m]
  LaneVectors<Lanes> velocity;             ///< of the boundary at the contact [m/s]
  LaneVectors<Lanes> turning;              ///< of the normal [1/s]
};

/// Finds the contacts of a seat. One for each thread, which keeps its memory from step to step.
template <class Lanes>
class WallContacts {
 public:
  /// Contacts of a particle whose normals are nearer to each other than this cosine, 25 degrees, are one, the deepest:
  /// facets of a curved surface, plates that lie edge to edge.
  static constexpr double same_contact = 0.9;

  const WallRow<Lanes>& row(int k) const { return rows_[k]; }
  /// Whether any row has a contact.
  bool any_near() const { return any_near_; }

  /// moved: how far from where the list was built [m]. turns: whether the normals' turning is wanted. range: of
  /// attraction [m].
  template <class L>
  void find(const Boundaries& boundaries, WallList& list, const WallSeat& seat, std::uint32_t lanes,
            const Bodies<L>& self, const simd::Vector<typename L::Real>& moved, double scale, double range,
            bool turns) {
    if (list.plane(seat.first_row + seat.rows - 1) < 0) {  // planes come first
      find_free_way<L>(self, squared_length(moved), list.travelled(), scale);
    }
    if (rows_.size() < static_cast<std::size_t>(seat.rows)) rows_.resize(seat.rows);
    std::uint32_t once = 0, twice = 0;  // lanes near to one piece, to several
    for (int k = 0; k < seat.rows; ++k) {
      WallRow<Lanes>& row = rows_[k];
      row.touching = row.near = 0;
      const std::int32_t plane = list.plane(seat.first_row + k);
      if (plane < 0) {
        find_pieces<L>(boundaries, list.row(seat.first_row + k), lanes, self, scale, range, turns, row);
      } else if (boundaries[plane].present) {
        find_plane<L>(boundaries[plane], lanes, self, scale, range, row);
      }
      twice |= once & row.near;
      once |= row.near;
    }
    any_near_ = once != 0;
    for (; twice != 0; twice &= twice - 1) keep_deepest(seat.rows, std::countr_zero(twice));
  }

  /// What a contact has kept follows it from one piece of a boundary to the next, but not round a corner.
  template <int most_kept, class Number>
  void pass_on(const WallList& list, const WallSeat& seat, std::uint32_t lanes, int count,
               ContactMemory<Number>& memory) const {
    for (; lanes != 0; lanes &= lanes - 1) {
      const int lane = std::countr_zero(lanes);
      const auto touches = [&](int k) { return (rows_[k].touching >> lane & 1u) != 0; };
      for (int k = 0; k < seat.rows; ++k) {
        if (!touches(k) || memory.touched(seat.first_row + k, lane)) continue;
        for (int from = 0; from < seat.rows; ++from) {
          if (touches(from) || !memory.touched(seat.first_row + from, lane)) continue;
          const WallEntry &old_one = list.row(seat.first_row + from)[lane],
                          &new_one = list.row(seat.first_row + k)[lane];
          if (old_one.body != new_one.body) continue;
          if (old_one.last_normal().dot(rows_[k].normal.get(lane)) < same_contact) continue;
          std::array<double, most_kept> kept;
          memory.get(seat.first_row + from, lane, count, kept.data());
          memory.set(seat.first_row + k, lane, count, kept.data());
          memory.forget(seat.first_row + from, lane);
          break;
        }
      }
    }
  }

 private:
  /// Pieces that were farther off than a particle can have come since need no look. One that has come far gets all of
  /// them: it may have gone round an edge.
  template <class L>
  void find_free_way(const Bodies<L>& self, const typename L::Real& squared, double travelled, double scale) {
    constexpr double far = 0.5;  // radii
    for (int lane = 0; lane < L::width; ++lane) {
      const double moved = std::sqrt(L::lane(squared, lane)) + travelled;
      const bool is_far = !(moved < far * scale * L::lane(self.radius, lane));
      moved_[lane] = is_far ? std::numeric_limits<double>::infinity() : moved;
    }
  }

  template <class L>
  void find_plane(const Boundaries::Body& body, std::uint32_t lanes, const Bodies<L>& self, double scale, double range,
                  WallRow<Lanes>& row) const {
    using simd::bits;
    using Real = typename L::Real;
    const auto& plane = std::get<PlanePiece>(body.shape.pieces.front());
    const Vec3 n = body.moves ? Vec3(body.pose.turn * plane.normal) : plane.normal;
    const Vec3 point = body.moves ? body.pose(plane.height * plane.normal) : Vec3(plane.height * plane.normal);
    const simd::Vector<Real> normal{Real(n[0]), Real(n[1]), Real(n[2])};
    const Real distance = dot(normal, self.position) - Real(n.dot(point));
    const Real overlap = Real(scale) * self.radius - distance;
    row.touching = bits(Real(0.0) < overlap) & lanes;
    row.near = bits(Real(-range) < overlap) & lanes;
    if (row.near == 0) return;
    L::store(row.overlap.data(), overlap);
    for (int lane = 0; lane < L::width; ++lane) {
      row.normal.set(lane, n);
      if (!body.moves) {
        row.velocity.set(lane, Vec3::Zero());
        row.turning.set(lane, Vec3::Zero());
        continue;
      }
      const Vec3 at = lane_of<L>(self.position, lane) - L::lane(distance, lane) * n;
      row.velocity.set(lane, body.rate.at(at, body.pose));
      row.turning.set(lane, body.rate.angular_velocity.cross(n));
    }
  }

  template <class L>
  void find_pieces(const Boundaries& boundaries, WallEntry* entries, std::uint32_t lanes, const Bodies<L>& self,
                   double scale, double range, bool turns, WallRow<Lanes>& row) const {
    for (int lane = 0; lane < L::width; ++lane) {
      row.overlap[lane] = 0;  // every lane goes through the laws, whatever it holds
      row.normal.set(lane, Vec3::UnitZ());
      row.velocity.set(lane, Vec3::Zero());
      row.turning.set(lane, Vec3::Zero());
      WallEntry& entry = entries[lane];
      if (!entry.there() || entry.gap > moved_[lane] || (lanes >> lane & 1u) == 0) continue;
      const Boundaries::Body& body = boundaries[entry.body];
      if (!body.present) continue;
      const Vec3 position = lane_of<L>(self.position, lane);
      const Vec3 image = position - boundaries.shift_vector(entry.shift);
      const double radius = scale * L::lane(self.radius, lane);
      Touch touch;
      if (!body.shape.touch(entry.piece, body.inside(image), radius + range, entry.side, touch)) continue;
      const double overlap = radius - touch.distance;
      if (overlap <= -range) continue;
      row.near |= 1u << lane;
      if (overlap > 0) row.touching |= 1u << lane;
      row.overlap[lane] = overlap;
      if (body.moves) {
        touch.normal = body.pose.turn * touch.normal;
        touch.direction = body.pose.turn * touch.direction;
        row.velocity.set(lane, body.rate.at(image - touch.distance * touch.normal, body.pose));
      }
      row.normal.set(lane, touch.normal);
      if (overlap > 0) entry.set_normal(touch.normal);
      if (turns) row.turning.set(lane, turning(body, touch, lane_of<L>(self.velocity, lane) - row.velocity.get(lane)));
    }
  }

  static Vec3 turning(const Boundaries::Body& body, const Touch& touch, const Vec3& relative) {
    const Vec3 across = relative - relative.dot(touch.normal) * touch.normal;
    return touch.turning * across + touch.turning_along * across.dot(touch.direction) * touch.direction +
           body.rate.angular_velocity.cross(touch.normal);
  }

  void keep_deepest(int rows, int lane) {
    const std::uint32_t bit = 1u << lane;
    for (int a = 0; a < rows; ++a) {
      for (int b = a + 1; b < rows && (rows_[a].near & bit) != 0; ++b) {
        if ((rows_[b].near & bit) == 0) continue;
        if (rows_[a].normal.get(lane).dot(rows_[b].normal.get(lane)) < same_contact) continue;
        WallRow<Lanes>& shallower = rows_[a].overlap[lane] < rows_[b].overlap[lane] ? rows_[a] : rows_[b];
        shallower.near &= ~bit;
        shallower.touching &= ~bit;
      }
    }
  }

  std::vector<WallRow<Lanes>> rows_;
  bool any_near_ = false;
  LaneNumbers<Lanes> moved_;  ///< since the list was built [m]
};

}  // namespace packstone::engine
