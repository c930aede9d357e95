#include "core/scene_checks.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "core/boundary_options.hpp"
#include "core/text.hpp"

namespace packstone {

const ChoiceNames axes = {"x", "y", "z"};
const ChoiceNames faces = {"x-", "x+", "y-", "y+", "z-", "z+"};

namespace {

void check_names(const Scene& s) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < s.materials.size(); ++k) {
    if (!names.insert(s.materials[k].name).second) {
      s.fail(fmt::format("material[{}].name", k),
             fmt::format("\"{}\" is taken; give each material its own name", s.materials[k].name));
    }
  }
  const std::vector<std::string> known(names.begin(), names.end());
  const auto check = [&](const std::string& path, const std::string& name) {
    if (names.count(name)) return;
    const auto near = nearest_name(name, known);
    s.fail(path, fmt::format("no material \"{}\"; {}", name,
                             near ? fmt::format("did you mean \"{}\"?", *near) : "there are: " + joined(known)));
  };
  for (std::size_t k = 0; k < s.particles.size(); ++k) {
    check(fmt::format("particles[{}].material", k), s.particles[k].material);
  }
  for (std::size_t k = 0; k < s.boundaries.size(); ++k) {
    check(fmt::format("boundary[{}].material", k), s.boundaries[k].material);
  }
}

void refuse_given(const Scene& s, const std::string& path, bool given, const std::string& why) {
  if (given) s.fail(path, "is given beside filling.kind = " + why);
}

void check_group_sizes(const Scene& s) {
  for (std::size_t k = 0; k < s.particles.size(); ++k) {
    const std::string path = fmt::format("particles[{}]", k);
    const GroupSpec& group = s.particles[k];
    if (!group.count) s.fail(path, "needs count, the number of particles");
    if (!group.radius && !group.sizes.present) s.fail(path, "needs radius [m]");
    if (!group.sizes.present) continue;
    if (const auto fault = fault_of(group.sizes)) {
      s.fail(path + ".radius" + (fault->key.empty() ? "" : "." + fault->key), fault->what);
    }
  }
}

/// Keys of the fillings that place particles of given sizes.
void check_placing_keys(const Scene& s) {
  const FillingSpec& f = s.filling;
  const std::string kind = f.kind == FillingKind::growth    ? "\"growth\""
                           : f.kind == FillingKind::lattice ? "\"lattice\""
                                                            : "\"random\"";
  if (f.kind == FillingKind::growth && !f.duration) {
    s.fail("filling", "needs duration, the time the growth takes [s], with kind = \"growth\"");
  }
  if (f.kind != FillingKind::growth) {
    refuse_given(s, "filling.duration", f.duration.has_value(),
                 kind + ", whose particles are there at once; leave it out");
  }
  if (f.kind != FillingKind::lattice) {
    refuse_given(s, "filling.spacing", f.spacing.has_value(), kind + "; it goes with \"lattice\"");
  }
  refuse_given(s, "filling.path", f.path.has_value(), kind + "; take kind = \"file\", or leave it out");
  check_group_sizes(s);
}

void check_file_keys(const Scene& s) {
  const FillingSpec& f = s.filling;
  if (!f.path) s.fail("filling", "needs path, the file that holds the particles, with kind = \"file\"");
  const std::string nothing_grows = "\"file\", whose particles have their place and full size at once; leave it out";
  refuse_given(s, "filling.duration", f.duration.has_value(), nothing_grows);
  refuse_given(s, "filling.spacing", f.spacing.has_value(), nothing_grows);
  refuse_given(s, "filling.region_min", f.region_min.has_value(), nothing_grows);
  refuse_given(s, "filling.region_max", f.region_max.has_value(), nothing_grows);
  refuse_given(s, "domain.volume_factor", s.domain.volume_factor.has_value(),
               "\"file\", whose particles have their places in a box of their own; give min and max");
  for (std::size_t k = 0; k < s.particles.size(); ++k) {
    const std::string path = fmt::format("particles[{}]", k);
    const std::string file_has_it =
        "\"file\": the file says how many particles there are and of what radius; leave it out";
    refuse_given(s, path + ".count", s.particles[k].count.has_value(), file_has_it);
    refuse_given(s, path + ".radius", s.particles[k].radius.has_value() || s.particles[k].sizes.present, file_has_it);
  }
}

void check_filling(const Scene& s) { s.filling.kind == FillingKind::file ? check_file_keys(s) : check_placing_keys(s); }

void check_domain(const Scene& s) {
  const DomainSpec& d = s.domain;
  if (d.volume_factor ? (d.min || d.max || !d.aspect) : (!d.min || !d.max || d.aspect)) {
    s.fail("domain", "needs either min and max, or volume_factor and aspect");
  }
  const Domain box = s.box();
  for (int k = 0; k < 3; ++k) {
    if (!(box.max[k] > box.min[k])) s.fail("domain.max", "must lie above domain.min along every axis");
  }
  for (int face : d.open) {
    if (box.periodic[face / 2]) s.fail("domain.open", fmt::format("\"{}\" is a periodic side", faces[face]));
  }
  const Vec3 low = s.filling.region_min.value_or(box.min), high = s.filling.region_max.value_or(box.max);
  if ((low.array() < box.min.array()).any()) s.fail("filling.region_min", "lies outside the domain");
  if ((high.array() > box.max.array()).any()) s.fail("filling.region_max", "lies outside the domain");
  if ((high.array() <= low.array()).any()) s.fail("filling.region_max", "must lie above filling.region_min");
}

}  // namespace

void check(const Scene& scene) {
  check_names(scene);
  check_materials(scene);
  check_filling(scene);
  check_domain(scene);
  check_boundaries(scene);
}

}  // namespace packstone
