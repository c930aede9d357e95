#include "core/scene_checks.hpp"

#include <algorithm>
#include <cmath>
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

void check_pouring_keys(const Scene& s) {
  const FillingSpec& f = s.filling;
  if (!f.region_min || !f.region_max) {
    s.fail("filling", "needs region_min and region_max, where particles come in, with kind = \"pour\"");
  }
  if (f.rate.has_value() == f.portions.has_value()) {
    s.fail("filling", "needs either rate, in particles a second, or portions with kind = \"pour\"");
  }
  const bool overdamped = s.dynamics.overdamped();
  const auto& rest = overdamped ? f.rest_force : f.rest_speed;
  if (f.portions.has_value() != rest.has_value()) {
    s.fail(overdamped ? "filling.rest_force" : "filling.rest_speed", "goes with portions, and portions with it");
  }
}

void refuse_pouring_keys(const Scene& s) {
  const FillingSpec& f = s.filling;
  for (const auto& [key, given] : {std::pair{"rate", f.rate.has_value()},
                                   {"portions", f.portions.has_value()},
                                   {"rest_speed", f.rest_speed.has_value()},
                                   {"rest_force", f.rest_force.has_value()},
                                   {"velocity", !f.velocity.isZero(0)},
                                   {"most_mass", f.most_mass.has_value()},
                                   {"fill_height", f.fill_height.has_value()}}) {
    if (given) s.fail(std::string("filling.") + key, "goes with kind = \"pour\"; leave it out");
  }
}

/// Keys of the fillings that place particles of given sizes.
void check_placing_keys(const Scene& s) {
  const FillingSpec& f = s.filling;
  const std::string kind = f.kind == FillingKind::growth    ? "\"growth\""
                           : f.kind == FillingKind::pour    ? "\"pour\""
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
  if (f.kind == FillingKind::pour) check_pouring_keys(s);
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

void check_filling(const Scene& s) {
  if (s.filling.kind != FillingKind::pour) refuse_pouring_keys(s);
  s.filling.kind == FillingKind::file ? check_file_keys(s) : check_placing_keys(s);
}

void check_stages(const Scene& s) {
  double total = 0;
  std::set<std::string> names;
  for (std::size_t k = 0; k < s.stages.size(); ++k) {
    total += s.stages[k].duration;
    if (names.insert(s.stages[k].name).second) continue;
    s.fail(fmt::format("stage[{}].name", k),
           fmt::format("\"{}\" is taken; give each stage its own name", s.stages[k].name));
  }
  if (s.dynamics.duration == 0) s.fail("dynamics", "needs duration [s], or [[stage]] tables with one each");
  if (s.stages.empty()) return;
  constexpr double rounding = 1e-9;
  if (std::abs(s.dynamics.duration - total) > rounding * total) {
    s.fail("dynamics.duration",
           fmt::format("{:g} s is not the stages' sum, {:g} s; leave it out", s.dynamics.duration, total));
  }
  if (s.dynamics.rest_speed) s.fail("dynamics.rest_speed", "goes into the [[stage]] that it is to end");
  if (s.dynamics.rest_force) s.fail("dynamics.rest_force", "goes into the [[stage]] that it is to end");
}

void check_gravity(const Scene& s) {
  const GravitySpec& g = s.gravity;
  if (g.end && *g.end <= g.start) s.fail("gravity.end", "must lie after start");
  if (!g.formula.empty() && g.formula.size() != 3) {
    s.fail("gravity.formula", fmt::format("has {} formulas; three are needed, along x, y, z", g.formula.size()));
  }
}

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
  check_motion_kind(scene);
  check_materials(scene);
  check_filling(scene);
  check_domain(scene);
  check_stages(scene);
  check_gravity(scene);
  check_boundaries(scene);
}

}  // namespace packstone
