// Which pieces of boundaries each particle may touch, in rows beside those of the neighbour list.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/archive.hpp"
#include "engine/boundary/boundaries.hpp"
#include "engine/detection/neighbour_list.hpp"
#include "engine/dynamics/particles.hpp"

namespace packstone::engine {

/// A piece of a boundary that a particle may touch.
struct WallEntry {
  static constexpr std::int32_t none = -1;
  static constexpr bool solid = true;

  std::int32_t piece = none;  ///< of the body's shape
  std::int16_t body = 0;
  std::int8_t shift = Boundaries::no_shift;  ///< image of the body
  std::int8_t side = 1;                      ///< of the piece that the particle is on; changes as it goes round an edge
  std::array<float, 3> normal = {};          ///< when they last faced each other; 0: never
  float gap = 0;  ///< between surfaces when the list was built, ranges of attraction taken off [m]

  bool there() const { return piece != none; }
  void set_normal(const Vec3& n) {
    for (int k = 0; k < 3; ++k) normal[k] = static_cast<float>(n[k]);
  }
  Vec3 last_normal() const { return {normal[0], normal[1], normal[2]}; }
};

/// Some particles side by side, one a lane, as motion takes them: a group of the neighbour list or a part of one.
struct WallSeat {
  std::int32_t first_row = 0, rows = 0;
};

class WallList {
 public:
  /// width: lanes of motion.
  WallList(const Boundaries& boundaries, int width);

  /// For the groups of a list that has just been built. dt: of the last step [s].
  void build(const NeighbourList& list, const Particles& particles, double dt);

  /// Whether a contact could be missing.
  bool outdated(const NeighbourList& list) const;

  void archive(Archive& a) { a(parts_, margin_, travelled_, seats_, entries_, planes_); }

  int width() const { return width_; }
  /// Of a group, whose lanes are divided into parts as wide as lanes of motion.
  const WallSeat& seat(std::size_t group, int part) const { return seats_[group * parts_ + part]; }
  /// How far boundaries and the particles' mean may have gone together, at most [m].
  double margin() const { return margin_; }
  /// How far any boundary has gone since the list was built, at most [m].
  double travelled() const;
  std::int64_t rows() const { return static_cast<std::int64_t>(planes_.size()); }
  WallEntry* row(std::int64_t row) { return entries_.data() + row * width_; }
  const WallEntry* row(std::int64_t row) const { return entries_.data() + row * width_; }
  /// The body if all of a row's entries are its only piece, a plane; -1 otherwise.
  std::int32_t plane(std::int64_t row) const { return planes_[row]; }
  /// Of an entry's piece, whatever the list and the image: that changes as particles are wrapped into the box.
  std::int64_t key(const WallEntry& entry) const { return first_piece_[entry.body] + entry.piece; }

 private:
  /// What is found for one block of groups.
  struct Found {
    std::vector<WallSeat> seats;
    std::vector<WallEntry> entries;
    std::vector<std::int32_t> planes;
    std::vector<std::vector<WallEntry>> lanes;  ///< scratch
  };

  void find(const NeighbourList& list, const Particles& p, double dt, std::size_t group, int part, Found& found) const;
  /// before: where the particle was a step ago; on which side of a piece, decides: it may have gone through since.
  /// touching: distance at which it touches a piece, reach: up to which pieces are listed [m].
  void find_pieces(const Boundaries::Body& body, std::int16_t number, const Vec3& p, const Vec3& before, double reach,
                   double touching, std::vector<WallEntry>& entries) const;

  const Boundaries& boundaries_;
  int width_;
  int parts_ = 1;
  double margin_ = 0;                      ///< for the motion that all particles share and that of boundaries [m]
  std::vector<std::int64_t> first_piece_;  ///< of each body, counted through
  std::vector<double> travelled_;          ///< by each body when the list was built [m]
  std::vector<WallSeat> seats_;
  std::vector<WallEntry> entries_;
  std::vector<std::int32_t> planes_;
  std::vector<Found> found_;
};

}  // namespace packstone::engine
