#include "core/formats/pair_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/formats/number_rows.hpp"

namespace packstone::formats {

namespace {

constexpr double centre_tolerance = 1e-3;  ///< of the radius: what programs lose when they print few digits
constexpr double most_cells = 1e6;         ///< along an axis
constexpr double least_overlap = 1e-12;    ///< of the radius, of a contact that presses

constexpr const char* pair_option = "--contact-columns";
constexpr const char* wall_option = "--wall-columns";
constexpr const char* doubt = "do the columns mean what they are taken for";

/// What presses touches, also where the few digits of a file leave no overlap.
double touching(double overlap, double push, double radius) {
  const bool lost = overlap <= 0 && push > 0 && overlap > -centre_tolerance * radius;
  return lost ? least_overlap * radius : overlap;
}

/// The k-th contact of a file, for messages.
template <class Forces>
[[noreturn]] void fail(const Forces& forces, std::size_t k, const std::string& what) {
  if (forces.first_line > 0) fail_at(forces.source, forces.first_line + static_cast<std::int64_t>(k), what);
  throw InputError(fmt::format("{}: contact {}: {}", forces.source, k, what));
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

template <class Forces>
std::size_t row_of_id(const Finder& finder, const Forces& forces, std::size_t k, std::int64_t id, const char* option) {
  const auto row = finder.by_id(id);
  if (row) return *row;
  fail(forces, k, fmt::format("particle {} is not among those of the packing; {} ({})?", id, doubt, option));
}

/// A contact of the file with the rows of its particles.
struct FoundPair {
  std::size_t first, second;  ///< rows
  std::size_t k;              ///< in the file

  std::array<std::size_t, 2> ascending() const { return {std::min(first, second), std::max(first, second)}; }
};

std::optional<FoundPair> rows_of(const Finder& finder, const PairForces& pairs, std::size_t k) {
  if (!pairs.ids.empty()) {
    const auto [first, second] = pairs.ids[k];
    return FoundPair{row_of_id(finder, pairs, k, first, pair_option), row_of_id(finder, pairs, k, second, pair_option),
                     k};
  }
  const auto first = finder.by_centre(pairs.centres[k][0]), second = finder.by_centre(pairs.centres[k][1]);
  if (!first || !second) return std::nullopt;
  return FoundPair{*first, *second, k};
}

/// Along the rows, each pair once.
std::vector<FoundPair> found_pairs(const Snapshot& s, const PairForces& pairs) {
  const Finder finder(s, pairs.ids.empty());
  std::vector<FoundPair> found;
  found.reserve(pairs.force.size());
  for (std::size_t k = 0; k < pairs.force.size(); ++k) {
    const auto pair = rows_of(finder, pairs, k);
    if (pair) found.push_back(*pair);
  }
  const auto before = [](const FoundPair& a, const FoundPair& b) {
    return a.ascending() != b.ascending() ? a.ascending() < b.ascending() : a.k < b.k;
  };
  const auto same = [](const FoundPair& a, const FoundPair& b) { return a.ascending() == b.ascending(); };
  std::sort(found.begin(), found.end(), before);
  found.erase(std::unique(found.begin(), found.end(), same), found.end());
  return found;
}

void add(Contacts& contacts, std::int64_t first, std::int64_t second, const Vec3& force, const Vec3& normal,
         double overlap, const Vec3& point) {
  contacts.first.push_back(first);
  contacts.second.push_back(second);
  contacts.force.push_back(force);
  contacts.normal.push_back(normal);
  contacts.overlap.push_back(overlap);
  contacts.point.push_back(point);
}

}  // namespace

Contacts contacts_of_pairs(const Snapshot& s, const PairForces& pairs) {
  Contacts contacts;
  for (const auto& [a, b, k] : found_pairs(s, pairs)) {
    if (a == b) fail(pairs, k, fmt::format("particle {} touches itself", s.id[a]));
    const Vec3 apart = s.domain.separation(s.position[a], s.position[b]);
    const Vec3 normal = apart.norm() > 0 ? apart.normalized() : Vec3::UnitZ();
    const double reach = s.radius[a] + s.radius[b];
    const double overlap = touching(reach - apart.norm(), pairs.force[k].dot(normal), reach);
    if (!(overlap >= -reach) || !std::isfinite(overlap)) {
      fail(pairs, k,
           fmt::format("particles {} and {} are {:g} m apart, their radii {:g} m together; {} ({})?", s.id[a], s.id[b],
                       apart.norm(), reach, doubt, pair_option));
    }
    if (overlap <= 0 && pairs.force[k].isZero(0)) continue;
    add(contacts, s.id[a], s.id[b], pairs.force[k], normal, overlap,
        s.domain.wrapped(s.position[b] + (s.radius[b] - 0.5 * overlap) * normal));
  }
  return contacts;
}

Contacts contacts_with_walls(const Snapshot& s, const WallForces& walls) {
  const Finder finder(s, walls.id.empty());
  std::vector<std::size_t> row(walls.force.size()), order(walls.force.size());
  for (std::size_t k = 0; k < row.size(); ++k) {
    order[k] = k;
    if (!walls.id.empty()) {
      row[k] = row_of_id(finder, walls, k, walls.id[k], wall_option);
      continue;
    }
    const auto found = finder.by_centre(walls.centre[k]);
    if (!found) fail(walls, k, fmt::format("no particle's centre lies there; {} ({})?", doubt, wall_option));
    row[k] = *found;
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return row[a] < row[b]; });
  Contacts contacts;
  for (const std::size_t k : order) {
    const std::size_t i = row[k];
    const Vec3 apart = s.domain.separation(s.position[i], walls.point[k]);
    const Vec3 normal = apart.normalized();
    const double overlap = touching(s.radius[i] - apart.norm(), walls.force[k].dot(normal), s.radius[i]);
    if (!(overlap >= -s.radius[i]) || !(apart.norm() > 0)) {
      fail(walls, k,
           fmt::format(
               "the point of contact lies {:g} m from the centre of particle {}, whose radius is {:g} m; {} ({})?",
               apart.norm(), s.id[i], s.radius[i], doubt, wall_option));
    }
    if (overlap <= 0 && walls.force[k].isZero(0)) continue;
    add(contacts, s.id[i], -1 - std::int64_t{walls.wall[k]}, walls.force[k], normal, overlap,
        s.domain.wrapped(walls.point[k]));
  }
  return contacts;
}

}  // namespace packstone::formats
