// Packings whose measures are known by hand.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "analysis/measures.hpp"
#include "core/random.hpp"
#include "core/snapshot.hpp"

namespace packstone::fixtures {

/// A box without particles: gravity along -z, two groups "light" (1200 kg/m3) and "heavy" (7800 kg/m3).
inline Snapshot empty_box(const Vec3& size, std::array<bool, 3> periodic = {true, true, false}) {
  Snapshot s;
  s.domain.min = Vec3::Zero();
  s.domain.max = size;
  s.domain.periodic = periodic;
  s.gravity = Vec3(0, 0, -9.8);
  s.groups = {{"light", "light", 1200}, {"heavy", "heavy", 7800}};
  s.material_names = {"light", "heavy"};
  return s;
}

inline void add_particle(Snapshot& s, const Vec3& position, double radius, int type = 0) {
  s.id.push_back(static_cast<std::int64_t>(1000 + 7 * s.size()));  // unlike the row number
  s.position.push_back(position);
  s.radius.push_back(radius);
  s.type.push_back(type);
  s.material.push_back(type);
}

/// Cells of edge a with spheres at the basis points (in units of a), from the lower corner of the box.
inline Snapshot lattice(const std::vector<Vec3>& basis, int nx, int ny, int nz, double a, double radius,
                        std::array<bool, 3> periodic = {true, true, true}) {
  Snapshot s = empty_box(Vec3(nx, ny, nz) * a, periodic);
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      for (int k = 0; k < nz; ++k) {
        for (const auto& b : basis) add_particle(s, (Vec3(i, j, k) + b) * a, radius);
      }
    }
  }
  return s;
}

inline const std::vector<Vec3> simple_cubic = {Vec3(0.5, 0.5, 0.5)};
inline const std::vector<Vec3> body_centred = {Vec3(0.25, 0.25, 0.25), Vec3(0.75, 0.75, 0.75)};
inline const std::vector<Vec3> face_centred = {Vec3(0.25, 0.25, 0.25), Vec3(0.25, 0.75, 0.75), Vec3(0.75, 0.25, 0.75),
                                               Vec3(0.75, 0.75, 0.25)};

/// Touching spheres of radius 1 on a simple cubic lattice, standing on z = 0; overlaps of 1e-6 make the contacts.
inline Snapshot cubic_bed(int nx, int ny, int nz, std::array<bool, 3> periodic = {true, true, false}) {
  return lattice(simple_cubic, nx, ny, nz, 2.0, 1 + 5e-7, periodic);
}

/// Sets the types by lattice coordinates (cells of edge 2).
inline void label(Snapshot& s, const std::function<int(int, int, int)>& type) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    const auto cell = [&](int k) { return static_cast<int>(s.position[i][k] / 2.0); };
    s.type[i] = type(cell(0), cell(1), cell(2));
  }
}

/// Half of the particles, drawn at random, become type 1.
inline void label_at_random(Snapshot& s, std::uint64_t seed) {
  for (std::size_t i = 0; i < s.size(); ++i) s.type[i] = i < s.size() / 2 ? 0 : 1;
  Random random(seed, RandomStream::filling_position, 0);
  for (std::size_t i = s.size(); i > 1; --i) {
    std::swap(s.type[i - 1], s.type[random.below(static_cast<std::uint32_t>(i))]);
  }
}

inline analysis::MeasureResult measured(const Snapshot& s, const std::string& measure,
                                        const analysis::Options& options = {}) {
  return analysis::analyze(s, {measure}, options).front();
}

/// Value of a quantity that must have one.
inline double value(const analysis::MeasureResult& result, const std::string& key) {
  return result.quantity(key)->value.value();
}

}  // namespace packstone::fixtures
