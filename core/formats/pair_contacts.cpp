#include "core/formats/pair_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <unordered_map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/formats/number_rows.hpp"

namespace packstone::formats {

namespace {

constexpr double centre_tolerance = 1e-3;  ///< of the radius: what programs lose when they print few digits
constexpr double most_cells = 1e6;         ///< along an axis

[[noreturn]] void fail(const PairForces& pairs, std::size_t k, const std::string& what) {
  if (pairs.first_line > 0) fail_at(pairs.source, pairs.first_line + static_cast<std::int64_t>(k), what);
  throw InputError(fmt::format("{}: pair {}: {}", pairs.source, k, what));
}

/// Finds particles by id, or by their centres.
class Finder {
 public:
  Finder(const Snapshot& s, bool by_centre) : s_(s) {
    if (by_centre) {
      double largest = 0;
      for (double r : s.radius) largest = std::max(largest, r);
      cell_ = std::max({2 * centre_tolerance * largest, s.domain.size().maxCoeff() / most_cells, 1e-300});
    }
    row_of_.reserve(s.size());
    for (std::size_t i = 0; i < s.size(); ++i) row_of_.emplace(by_centre ? cell_of(s.position[i]) : s.id[i], i);
  }

  std::optional<std::size_t> by_id(std::int64_t id) const {
    const auto found = row_of_.find(id);
    return found == row_of_.end() ? std::nullopt : std::optional(found->second);
  }

  /// Looks into the cells within the tolerance: up to eight.
  std::optional<std::size_t> by_centre(const Vec3& outside) const {
    const Vec3 centre = s_.domain.wrapped(outside);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 shift(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
      const auto [first, last] = row_of_.equal_range(cell_of(s_.domain.wrapped(centre + cell_ * shift)));
      for (auto it = first; it != last; ++it) {
        const std::size_t row = it->second;
        if (s_.domain.separation(centre, s_.position[row]).norm() <= centre_tolerance * s_.radius[row]) return row;
      }
    }
    return std::nullopt;
  }

 private:
  std::int64_t cell_of(const Vec3& p) const {
    const Vec3 cell = (p - s_.domain.min) / cell_;
    const auto index = [&](int k) {
      return static_cast<std::int64_t>(std::clamp(std::floor(cell[k]), -1.0, most_cells + 1));
    };
    constexpr std::int64_t stride = std::int64_t{1} << 21;  // above most_cells: cells do not share a number
    return (index(0) * stride + index(1)) * stride + index(2);
  }

  const Snapshot& s_;
  double cell_ = 1;
  std::unordered_multimap<std::int64_t, std::size_t> row_of_;
};

using RowPair = std::array<std::size_t, 2>;

std::optional<RowPair> rows_of(const Finder& finder, const PairForces& pairs, std::size_t k) {
  RowPair rows{};
  for (std::size_t side = 0; side < 2; ++side) {
    const auto row = pairs.ids.empty() ? finder.by_centre(pairs.centres[k][side]) : finder.by_id(pairs.ids[k][side]);
    if (!row && pairs.ids.empty()) return std::nullopt;
    if (!row) {
      fail(pairs, k,
           fmt::format("particle {} is not among those of the packing; do the columns mean what they are "
                       "taken for (--contact-columns)?",
                       pairs.ids[k][side]));
    }
    rows[side] = *row;
  }
  return rows;
}

void add_contact(Contacts& contacts, const Snapshot& s, const RowPair& rows, const Vec3& apart, double overlap,
                 const Vec3& force) {
  const Vec3 normal = apart.norm() > 0 ? apart.normalized() : Vec3::UnitZ();
  contacts.first.push_back(s.id[rows[0]]);
  contacts.second.push_back(s.id[rows[1]]);
  contacts.force.push_back(force);
  contacts.normal.push_back(normal);
  contacts.overlap.push_back(overlap);
  contacts.point.push_back(s.domain.wrapped(s.position[rows[1]] + (s.radius[rows[1]] - 0.5 * overlap) * normal));
}

}  // namespace

Contacts contacts_of_pairs(const Snapshot& s, const PairForces& pairs) {
  const Finder finder(s, pairs.ids.empty());
  std::set<RowPair> seen;
  Contacts contacts;
  for (std::size_t k = 0; k < pairs.force.size(); ++k) {
    const auto rows = rows_of(finder, pairs, k);
    if (!rows) continue;
    const auto [a, b] = *rows;
    if (a == b) fail(pairs, k, fmt::format("particle {} touches itself", s.id[a]));
    const Vec3 apart = s.domain.separation(s.position[a], s.position[b]);
    const double reach = s.radius[a] + s.radius[b], overlap = reach - apart.norm();
    if (overlap < -reach) {
      fail(pairs, k,
           fmt::format("particles {} and {} are {:g} m apart, their radii {:g} m together; do the columns "
                       "mean what they are taken for (--contact-columns)?",
                       s.id[a], s.id[b], apart.norm(), reach));
    }
    if (overlap <= 0 && pairs.force[k].isZero(0)) continue;
    if (!seen.insert({std::min(a, b), std::max(a, b)}).second) continue;
    add_contact(contacts, s, *rows, apart, overlap, pairs.force[k]);
  }
  return contacts;
}

}  // namespace packstone::formats
