#include "core/snapshot.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "core/geometry.hpp"
#include "core/reordered.hpp"

namespace packstone {

namespace {

constexpr int morton_bits = 21;  // a coordinate; three of them fill 63 bits

/// Spreads the low 21 bits so that two zero bits follow each.
std::uint64_t spread_bits(std::uint64_t v) {
  v &= (1u << morton_bits) - 1;
  v = (v | v << 32) & 0x001f00000000ffffull;
  v = (v | v << 16) & 0x001f0000ff0000ffull;
  v = (v | v << 8) & 0x100f00f00f00f00full;
  v = (v | v << 4) & 0x10c30c30c30c30c3ull;
  return (v | v << 2) & 0x1249249249249249ull;
}

/// Every particle's place on the curve, by row.
std::vector<std::uint64_t> morton_codes(const Snapshot& s) {
  std::vector<std::uint64_t> code(s.size());
  if (s.size() < 2) return code;
  Vec3 low = s.position.front(), high = low;
  for (const auto& p : s.position) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double cells = static_cast<double>((1u << morton_bits) - 1) / std::max((high - low).maxCoeff(), 1e-300);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Vec3 q = (s.position[i] - low) * cells;
    for (int k = 0; k < 3; ++k) code[i] |= spread_bits(static_cast<std::uint64_t>(q[k])) << k;
  }
  return code;
}

/// The rows by ascending keys, ties by id.
template <class Key>
std::vector<std::size_t> sorted_rows(const std::vector<Key>& keys, const std::vector<std::int64_t>& id) {
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto before = [&](std::size_t a, std::size_t b) {
    return keys[a] != keys[b] ? keys[a] < keys[b] : id[a] < id[b];
  };
  if (!std::is_sorted(order.begin(), order.end(), before)) std::sort(order.begin(), order.end(), before);
  return order;
}

}  // namespace

void Contacts::append(const Contacts& more) {
  const auto extend = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  extend(first, more.first);
  extend(second, more.second);
  extend(force, more.force);
  extend(normal, more.normal);
  extend(overlap, more.overlap);
  extend(point, more.point);
  extend(sliding, more.sliding);
}

double Snapshot::mass(std::size_t row) const { return groups[type[row]].density * sphere_volume(radius[row]); }

bool Snapshot::has_masses() const {
  return std::all_of(type.begin(), type.end(), [&](std::int32_t t) { return groups[t].density > 0; });
}

std::map<std::int64_t, std::size_t> Snapshot::rows_by_id() const {
  std::map<std::int64_t, std::size_t> rows;
  for (std::size_t i = 0; i < size(); ++i) rows.emplace(id[i], i);
  return rows;
}

std::vector<std::size_t> space_filling_order(const Snapshot& snapshot) {
  return sorted_rows(morton_codes(snapshot), snapshot.id);
}

std::vector<std::size_t> id_order(const Snapshot& snapshot) { return sorted_rows(snapshot.id, snapshot.id); }

Snapshot with_rows(const Snapshot& snapshot, const std::vector<std::size_t>& rows) {
  Snapshot result = snapshot;
  result.position = reordered(snapshot.position, rows);
  result.radius = reordered(snapshot.radius, rows);
  result.id = reordered(snapshot.id, rows);
  result.type = reordered(snapshot.type, rows);
  result.material = reordered(snapshot.material, rows);
  for (auto& [name, field] : result.fields) field = reordered(snapshot.fields.at(name), rows);
  return result;
}

Snapshot restricted(const Snapshot& snapshot, const Region& region) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    const Vec3 nearest = snapshot.position[i].cwiseMax(region.min).cwiseMin(region.max);
    if ((nearest - snapshot.position[i]).squaredNorm() <= snapshot.radius[i] * snapshot.radius[i]) kept.push_back(i);
  }
  return with_rows(snapshot, kept);
}

}  // namespace packstone
