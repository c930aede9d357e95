#include "core/particle_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packstone {

Region box_of(std::span<const Vec3> centres, std::span<const double> radii) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (std::size_t row = 0; row < centres.size(); ++row) {
    low = low.cwiseMin((centres[row].array() - radii[row]).matrix());
    high = high.cwiseMax((centres[row].array() + radii[row]).matrix());
  }
  return {low, high};
}

ParticleView::ParticleView(const Snapshot& whole)
    : snapshot(&whole), position(whole.position), radius(whole.radius), type(whole.type), material(whole.material) {
  for (const auto& [name, field] : whole.fields) {
    fields.emplace(name, FieldColumn{field.components, field.unit, field.values});
  }
}

std::vector<RowChunk> chunks_of(std::span<const Vec3> centres, std::span<const double> radii) {
  std::vector<RowChunk> chunks;
  for (std::size_t first = 0; first < centres.size(); first += rows_a_chunk) {
    const std::size_t rows = std::min(rows_a_chunk, centres.size() - first);
    chunks.push_back({first, first + rows, box_of(centres.subspan(first, rows), radii.subspan(first, rows))});
  }
  return chunks;
}

std::vector<RowChunk> chunks_of(const ParticleView& particles) {
  return particles.chunks.empty() ? chunks_of(particles.position, particles.radius) : particles.chunks;
}

namespace {

/// Whether all spheres of a chunk are finite and in its box, in sums and maxima that vectors can make.
bool all_inside(const ParticleView& particles, const RowChunk& chunk) {
  const double* const place = particles.position[chunk.first].data();
  const double* const radius = &particles.radius[chunk.first];
  const Vec3 low = chunk.box.min, high = chunk.box.max;
  const auto larger = [](double a, double b) { return a < b ? b : a; };
  double beyond = 0, poison = 0;  // the latter is 0, or not a number where anything is not finite
#pragma omp simd reduction(max : beyond) reduction(+ : poison)
  for (std::size_t k = 0; k < chunk.last - chunk.first; ++k) {
    const double x = place[3 * k], y = place[3 * k + 1], z = place[3 * k + 2], r = radius[k];
    const double below = larger(larger(low.x() - (x - r), low.y() - (y - r)), low.z() - (z - r));
    const double above = larger(larger(x + r - high.x(), y + r - high.y()), z + r - high.z());
    beyond = larger(beyond, larger(larger(below, above), -r));
    poison += 0 * (x + y + z + r);
  }
  return beyond <= 0 && poison == 0;
}

bool all_below(std::span<const std::int32_t> values, std::size_t count) {
  bool good = true;
#pragma omp simd reduction(& : good)
  for (std::size_t k = 0; k < values.size(); ++k) good &= static_cast<std::uint32_t>(values[k]) < count;
  return good;
}

}  // namespace

void check_rows(const ParticleView& particles, const RowChunk& chunk) {
  if (particles.unchecked_file.empty()) return;
  const auto refuse = [&](const char* what) {
    throw InputError(fmt::format("{}: rows {} to {}: {}", particles.unchecked_file, chunk.first, chunk.last - 1, what));
  };
  const std::size_t rows = chunk.last - chunk.first;
  if (rows > 0 && !all_inside(particles, chunk)) {
    refuse("a position is not a number, a radius is negative, or a sphere is not in the box of its chunk");
  }
  if (!all_below(particles.type.subspan(chunk.first, rows), particles.snapshot->groups.size())) {
    refuse("PointData/type refers to a group that is not in /scene");
  }
  if (!all_below(particles.material.subspan(chunk.first, rows), particles.snapshot->material_names.size())) {
    refuse("PointData/material refers to a material that is not in /scene");
  }
}

}  // namespace packstone
