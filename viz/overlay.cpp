#include "viz/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace packstone::viz {

namespace {

std::vector<std::string> vector_names(const Snapshot& snapshot) {
  std::vector<std::string> names;
  for (const auto& [name, field] : snapshot.fields) {
    if (field.components == 3) names.push_back(name);
  }
  if (snapshot.fields.contains("force") && snapshot.has_masses()) names.emplace_back("acceleration");
  return names;
}

[[noreturn]] void refuse_arrows(const Snapshot& snapshot, const std::string& name) {
  const std::vector<std::string> names = vector_names(snapshot);
  throw InputError(
      names.empty()
          ? fmt::format("the snapshot has no '{}' to draw arrows of, nor other vectors; ask the run for "
                        "them with fields = [\"velocity\", \"force\"] of [output]",
                        name)
          : fmt::format("the snapshot has no vectors '{}' to draw arrows of; there are {}", name, joined(names)));
}

}  // namespace

double SegmentSet::quantile(double share) const {
  if (segments.empty()) return 0;
  std::vector<double> values;
  values.reserve(segments.size());
  for (const Segment& segment : segments) values.push_back(segment.value);
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size()))) - 1;
  const auto place = values.begin() + std::max<std::ptrdiff_t>(0, rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

SegmentSet contact_links(const Snapshot& snapshot) {
  if (!snapshot.contacts) {
    throw InputError("the snapshot has no contacts to draw; ask the run for them with contacts = true of [output]");
  }
  std::unordered_map<std::int64_t, std::size_t> rows;
  rows.reserve(snapshot.size());
  for (std::size_t row = 0; row < snapshot.size(); ++row) rows.emplace(snapshot.id[row], row);
  const Contacts& contacts = *snapshot.contacts;
  SegmentSet links{"contact force [N]", {}};
  links.segments.reserve(contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto first = rows.find(contacts.first[k]), second = rows.find(contacts.second[k]);
    const bool at_wall = contacts.second[k] < 0;
    const double force = contacts.force[k].norm();
    if (first == rows.end() || (!at_wall && second == rows.end()) || !std::isfinite(force)) continue;
    const Vec3& from = snapshot.position[first->second];
    const Vec3& to = at_wall ? contacts.point[k] : snapshot.position[second->second];
    links.segments.push_back({from, snapshot.domain.separation(to, from), force});
  }
  return links;
}

SegmentSet arrows_of(const Snapshot& snapshot, const std::string& name) {
  const bool derived = name == "acceleration" && !snapshot.fields.contains(name);
  const auto found = snapshot.fields.find(derived ? "force" : name);
  if (found == snapshot.fields.end() || found->second.components != 3 || (derived && !snapshot.has_masses())) {
    refuse_arrows(snapshot, name);
  }
  const std::string unit = derived ? "m/s2" : found->second.unit;
  SegmentSet arrows{unit.empty() ? name : fmt::format("{} [{}]", name, unit), {}};
  for (std::size_t row = 0; row < snapshot.size(); ++row) {
    Vec3 vector = Eigen::Map<const Vec3>(&found->second.values[3 * row]);
    if (derived) vector /= snapshot.mass(row);
    if (vector.allFinite()) arrows.segments.push_back({snapshot.position[row], vector, vector.norm()});
  }
  return arrows;
}

std::vector<std::pair<Vec3, Vec3>> pieces_inside(const Domain& domain, const Vec3& from, const Vec3& way) {
  std::vector<std::pair<Vec3, Vec3>> pieces;
  Vec3 start = from, left = way;
  constexpr std::size_t most_sides = 16;  // crossed: no way of a picture has more
  while (pieces.size() < most_sides) {
    double share = 1;
    int side = -1;
    for (int k = 0; k < 3; ++k) {
      if (!domain.periodic[k] || left[k] == 0) continue;
      const double to_side = ((left[k] > 0 ? domain.max : domain.min)[k] - start[k]) / left[k];
      if (to_side < share) {
        share = std::max(0.0, to_side);
        side = k;
      }
    }
    const Vec3 stop = start + share * left;
    if (share > 0) pieces.emplace_back(start, stop);
    if (side < 0) break;
    start = stop;
    start[side] = left[side] > 0 ? domain.min[side] : domain.max[side];
    left *= 1 - share;
  }
  return pieces;
}

}  // namespace packstone::viz
