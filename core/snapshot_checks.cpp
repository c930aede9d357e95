#include "core/snapshot_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace packstone {

namespace {

/// The ids of a whole snapshot.
class KnownIds {
 public:
  KnownIds(const hdf5::Reader& file, const std::vector<std::int64_t>& ids) : sorted_(ids) {
    if (!std::is_sorted(sorted_.begin(), sorted_.end())) std::sort(sorted_.begin(), sorted_.end());
    if (!sorted_.empty() && sorted_.front() < 0) file.fail("PointData/id: an id is negative");
    const auto twice = std::adjacent_find(sorted_.begin(), sorted_.end());
    if (twice != sorted_.end()) file.fail(fmt::format("PointData/id: {} occurs twice", *twice));
  }

  /// Ids are mostly without gaps, and then their own places.
  bool has(std::int64_t id) const {
    if (id >= 0 && id < static_cast<std::int64_t>(sorted_.size()) && sorted_[static_cast<std::size_t>(id)] == id) {
      return true;
    }
    return std::binary_search(sorted_.begin(), sorted_.end(), id);
  }

 private:
  std::vector<std::int64_t> sorted_;
};

}  // namespace

bool all_finite(const std::vector<Vec3>& vectors) {
  return std::all_of(vectors.begin(), vectors.end(), [](const Vec3& v) { return v.allFinite(); });
}

void check_context(const hdf5::Reader& file, const Snapshot& s) {
  const Domain& box = s.domain;
  if (!box.min.allFinite() || !box.max.allFinite() || !(box.min.array() <= box.max.array()).all()) {
    file.fail("/packstone/domain is not a box");
  }
  if (!s.gravity.allFinite()) file.fail("/packstone/gravity is not a number");
  for (const GroupRecord& group : s.groups) {
    if (!(group.density >= 0 && group.density < HUGE_VAL)) {
      file.fail(fmt::format("/scene/group_density: {:g} kg/m3 is out of range", group.density));
    }
  }
  for (const BoundaryRecord& boundary : s.boundaries) {
    if (!boundary.point.allFinite() || !boundary.normal.allFinite() || !boundary.axis.allFinite() ||
        !(boundary.cross_section >= 0 && boundary.cross_section < HUGE_VAL)) {
      file.fail("/boundaries: where " + boundary.name + " stands is not a number");
    }
  }
}

void check_contacts(const hdf5::Reader& file, const Snapshot& s) {
  const Contacts& c = *s.contacts;
  const auto lowest = -static_cast<std::int64_t>(s.boundaries.size());
  for (std::size_t k = 0; k < c.size(); ++k) {
    if (c.first[k] < 0 || c.second[k] < lowest || c.first[k] == c.second[k]) {
      file.fail(fmt::format("/contacts/pair: {} and {} are no particle and what it touches", c.first[k], c.second[k]));
    }
  }
  const bool overlaps_finite =
      std::all_of(c.overlap.begin(), c.overlap.end(), [](double overlap) { return std::isfinite(overlap); });
  if (!overlaps_finite || !all_finite(c.force) || !all_finite(c.normal) || !all_finite(c.point)) {
    file.fail("/contacts: a force, normal, overlap or point is not a number");
  }
}

void check_ids(const hdf5::Reader& file, const Snapshot& s) {
  const KnownIds known(file, s.id);
  if (!s.contacts) return;
  for (std::size_t k = 0; k < s.contacts->size(); ++k) {
    for (const std::int64_t id : {s.contacts->first[k], s.contacts->second[k]}) {
      if (id >= 0 && !known.has(id)) file.fail(fmt::format("/contacts/pair: there is no particle {}", id));
    }
  }
}

void check_particles(const hdf5::Reader& file, const Snapshot& s) {
  const auto in_range = [](const std::vector<std::int32_t>& values, std::size_t count) {
    return std::all_of(values.begin(), values.end(),
                       [&](std::int32_t v) { return v >= 0 && static_cast<std::size_t>(v) < count; });
  };
  if (!in_range(s.type, s.groups.size())) file.fail("PointData/type refers to a group that is not in /scene");
  if (!in_range(s.material, s.material_names.size())) {
    file.fail("PointData/material refers to a material that is not in /scene");
  }
  const bool finite = all_finite(s.position) &&
                      std::all_of(s.radius.begin(), s.radius.end(), [](double r) { return r >= 0 && r < HUGE_VAL; });
  if (!finite) file.fail("a position is not a number or a radius is negative");
}

}  // namespace packstone
