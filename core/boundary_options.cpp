// The keys of [[boundary]], and which go with which kind.

#include "core/boundary_options.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "core/scene_checks.hpp"
#include "core/text.hpp"

namespace packstone {

namespace {

using enum Presence;

const ChoiceNames kinds = {"plane", "box", "cylinder", "cone", "funnel", "surface", "polygons", "mesh"};

void describe_motion(OptionVisitor& v, MotionSpec& m) {
  v.text({"stage",
          "Name of the [[stage]] in which it moves; it stops with the stage. start and end then count from its "
          "beginning"},
         m.stage);
  v.number({"start", "When it begins to move; t of the formulas counts from here", unit::second, Range::at_least(0)},
           m.start, has_default);
  v.number({"end", "When it stops where it then is; never unless given", unit::second, Range::positive()}, m.end);
  v.texts({"displacement", "Three formulas in t: how far it has moved along x, y, z", unit::metre}, m.displacement);
  v.optional_table({"rotation", "Turning about an axis that moves along with the boundary"}, m.rotates, [&] {
    v.vector({"axis", "Direction of the axis, right-handed; any length"}, m.rotation_axis, required);
    v.vector({"centre", "A point of the axis; the boundary's point unless given", unit::metre}, m.rotation_centre);
    v.text({"angle", "Formula in t [rad]: \"2*pi*t\" is one turn a second"}, m.angle, required);
  });
  v.optional_table(
      {"vibration", "Displacement by amplitude sin(2 pi frequency t + phase), less what it is at t = 0"}, m.vibrates,
      [&] {
        v.vector({"amplitude", "Along x, y, z", unit::metre}, m.amplitude, required);
        v.number({"frequency", "Swings a second", unit::frequency, Range::positive()}, m.frequency, required);
        v.number({"phase", "In rad"}, m.phase, has_default);
      });
  v.optional_table(
      {"free", "Free to move along an axis, as a punch or a lid: by the contacts, gravity and a force"}, m.free, [&] {
        v.vector({"axis", "Direction of the axis; any length"}, m.free_axis, required);
        v.number({"mass", "Of the moving body", unit::mass, Range::positive()}, m.mass, required);
        v.text({"force", "Formula in t [N]: along the axis, beside contacts and gravity"}, m.force, has_default);
        v.number({"limit", "How far along the axis it may go; no limit unless given", unit::metre, Range::at_least(0)},
                 m.limit);
      });
}

std::string quoted_kinds(const std::vector<BoundaryKind>& of) {
  std::vector<std::string> names;
  for (const BoundaryKind kind : of) names.push_back(fmt::format("\"{}\"", kind_name(kind)));
  return joined(names);
}

/// A key, whether it is given, and the kinds that it goes with.
struct KindKey {
  const char* key;
  bool given;
  std::vector<BoundaryKind> needed_by;
  std::vector<BoundaryKind> taken_by;
};

std::vector<KindKey> kind_keys(const BoundarySpec& b) {
  using enum BoundaryKind;
  return {{"point", b.point.has_value(), {plane, cylinder, cone, funnel}, {}},
          {"normal", b.normal.has_value(), {plane}, {}},
          {"axis", b.axis.has_value(), {}, {cylinder, cone, funnel}},
          {"radius", b.radius.has_value(), {cylinder, cone, funnel}, {}},
          {"top_radius", b.top_radius.has_value(), {cone}, {}},
          {"outlet_radius", b.outlet_radius.has_value(), {funnel}, {}},
          {"length", b.length.has_value(), {cone}, {cylinder, funnel}},
          {"cone_length", b.cone_length.has_value(), {funnel}, {}},
          {"tube_length", b.tube_length.has_value(), {}, {funnel}},
          {"closed", !b.closed.empty(), {}, {cylinder, cone, funnel}},
          {"min", b.min.has_value(), {box}, {}},
          {"max", b.max.has_value(), {box}, {}},
          {"open", !b.open.empty(), {}, {box}},
          {"formula", b.formula.has_value(), {}, {surface}},
          {"grid", b.grid.has_value(), {}, {surface}},
          {"tolerance", b.tolerance.has_value(), {}, {surface}},
          {"polygons", !b.polygons.empty(), {polygons}, {}},
          {"path", b.path.has_value(), {mesh}, {}},
          {"scale", b.scale.has_value(), {}, {mesh}},
          {"offset", b.offset.has_value(), {}, {mesh}}};
}

void check_keys(const Scene& s, const std::string& path, const BoundarySpec& b) {
  const auto in = [&](const std::vector<BoundaryKind>& of) { return std::count(of.begin(), of.end(), b.kind) > 0; };
  for (const KindKey& key : kind_keys(b)) {
    if (!key.given && in(key.needed_by)) {
      s.fail(path, fmt::format("needs {} with kind = \"{}\"", key.key, kind_name(b.kind)));
    }
    if (key.given && !in(key.needed_by) && !in(key.taken_by)) {
      std::vector<BoundaryKind> owners = key.needed_by;
      owners.insert(owners.end(), key.taken_by.begin(), key.taken_by.end());
      s.fail(path + "." + key.key, fmt::format("goes with kind = {}, not with \"{}\"; leave it out",
                                               quoted_kinds(owners), kind_name(b.kind)));
    }
  }
}

void check_round(const Scene& s, const std::string& path, const BoundarySpec& b) {
  if (b.kind == BoundaryKind::cylinder && !b.length && !b.closed.empty()) {
    s.fail(path + ".closed", "a cylinder without length has no ends to close; give length");
  }
  if (b.kind == BoundaryKind::cone && *b.radius == 0 && *b.top_radius == 0) {
    s.fail(path + ".radius", "and top_radius are both 0; one must be more");
  }
  if (b.kind == BoundaryKind::cylinder && *b.radius == 0) s.fail(path + ".radius", "must be greater than 0");
  if (b.kind == BoundaryKind::funnel && *b.outlet_radius >= *b.radius) {
    s.fail(path + ".outlet_radius",
           fmt::format("{:g} m is not less than radius, {:g} m: the funnel would be upside down or no funnel",
                       *b.outlet_radius, *b.radius));
  }
}

void check_polygons(const Scene& s, const std::string& path, const BoundarySpec& b) {
  for (std::size_t k = 0; k < b.polygons.size(); ++k) {
    if (b.polygons[k].size() < 3) {
      s.fail(path + ".polygons", fmt::format("polygon {} has {} corners and stays open; a closed one has 3 at least", k,
                                             b.polygons[k].size()));
    }
  }
}

void check_motion(const Scene& s, const std::string& path, const MotionSpec& m) {
  if (!m.present) return;
  if (m.end && *m.end <= m.start) s.fail(path + ".end", "must lie after start");
  if (!m.displacement.empty() && m.displacement.size() != 3) {
    s.fail(path + ".displacement", fmt::format("has {} formulas; three are needed, along x, y, z, such as [\"0\", "
                                               "\"0\", \"0.01*t\"]",
                                               m.displacement.size()));
  }
  if (m.rotates && m.rotation_axis.norm() == 0) s.fail(path + ".rotation.axis", "has no length");
  if (m.free && m.free_axis.norm() == 0) s.fail(path + ".free.axis", "has no length");
  if (m.free && (!m.displacement.empty() || m.vibrates)) {
    s.fail(path + ".free", "a boundary that is free to move cannot be given a displacement or vibration too");
  }
  if (m.displacement.empty() && !m.rotates && !m.vibrates && !m.free) {
    s.fail(path, "says nothing of how it moves; give displacement, rotation, vibration or free, or leave it out");
  }
}

void check_stages(const Scene& s, const std::string& path, const BoundarySpec& b) {
  const auto check = [&](const std::string& key, const std::string& name) {
    const auto is_it = [&](const StageSpec& stage) { return stage.name == name; };
    if (std::any_of(s.stages.begin(), s.stages.end(), is_it)) return;
    std::vector<std::string> known;
    for (const StageSpec& stage : s.stages) known.push_back(stage.name);
    s.fail(path + key,
           fmt::format("no stage \"{}\"; {}", name,
                       known.empty() ? "the scene has no [[stage]] tables" : "there are: " + joined(known)));
  };
  for (const std::string& name : b.stages) check(".stages", name);
  if (b.motion.stage) check(".motion.stage", *b.motion.stage);
}

/// A boundary that leans towards a periodic side, or turns its end to it, would stand elsewhere in every image.
void check_periodic(const Scene& s, const Domain& box, const std::string& path, const BoundarySpec& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!box.periodic[axis]) continue;
    const std::string advice = fmt::format("{}, which is periodic; make the axis not periodic", axes[axis]);
    if (b.kind == BoundaryKind::plane && (*b.normal)[axis] != 0) {
      s.fail(path + ".normal", fmt::format("has a component along {}, or the component 0", advice));
    }
    const auto across = [&](const Vec3& direction) { return direction.cross(Vec3::Unit(axis)).norm() > 0; };
    if (b.radius && across(b.axis.value_or(Vec3::UnitZ()))) {
      s.fail(path + ".axis", fmt::format("is not along {}, or turn the boundary's axis to it", advice));
    }
    if (b.kind != BoundaryKind::box) continue;
    for (const int face : {2 * axis, 2 * axis + 1}) {
      if (std::count(b.open.begin(), b.open.end(), face) == 0) {
        s.fail(path + ".open", fmt::format("the box is closed across {}, or list \"{}\" here", advice, faces[face]));
      }
    }
  }
}

}  // namespace

const std::string& kind_name(BoundaryKind kind) { return kinds[static_cast<std::size_t>(kind)]; }

void describe_boundary(OptionVisitor& v, BoundarySpec& b) {
  const auto length = [&](const char* key, const char* help, std::optional<double>& value,
                          Range range = Range::positive()) {
    v.number({key, help, unit::metre, range}, value);
  };
  v.text({"name", "Name in messages, tables and columns of history.csv"}, b.name, required);
  v.choice({"kind",
            "Shape. plane: without end. box: six plates. cylinder, cone, funnel: about an axis. surface: z = f(x, y) "
            "over the domain. polygons: flat convex plates. mesh: triangles from a file"},
           kinds, b.kind, required);
  v.text({"material", "Name of a [[material]]; the first one unless given"}, b.material, has_default);
  v.choice({"side",
            "Where a filling puts particles. inside of a surface is above it; polygons and meshes with an inside must "
            "be closed. auto: inside, but both of polygons and mesh. A plane has its normal instead"},
           {"auto", "inside", "outside", "both"}, b.side, has_default);
  v.number({"from", "Time since when it is there", unit::second, Range::at_least(0)}, b.from, has_default);
  v.number({"until", "Time until when; to the end unless given", unit::second, Range::positive()}, b.until);
  v.texts({"stages", "Names of the [[stage]] tables in which it is there; in all unless given"}, b.stages);
  v.vector({"point", "A point of the plane; of cylinder, cone and funnel the middle of the lower end", unit::metre},
           b.point);
  v.vector({"normal", "plane: direction from the wall to the particles' side; any length"}, b.normal);
  v.vector({"axis", "cylinder, cone, funnel: direction from the lower end to the upper; [0, 0, 1] unless given"},
           b.axis);
  length("radius", "Of a cylinder, of a cone's lower end, of a funnel above its cone", b.radius, Range::at_least(0));
  length("top_radius", "cone: of its upper end", b.top_radius, Range::at_least(0));
  length("outlet_radius", "funnel: of its outlet", b.outlet_radius);
  length("length", "Of a cylinder, without ends unless given; of a cone; of a funnel's bin above its cone", b.length);
  length("cone_length", "funnel: of its cone, along the axis", b.cone_length);
  length("tube_length", "funnel: of the tube below its cone; none unless given", b.tube_length);
  v.choices({"closed", "cylinder, cone, funnel: ends with a lid"}, {"bottom", "top"}, b.closed);
  v.vector({"min", "box: lower corner", unit::metre}, b.min);
  v.vector({"max", "box: upper corner", unit::metre}, b.max);
  v.choices({"open", "box: faces that it does not have"}, faces, b.open);
  v.text({"formula", "surface: z [m] as a formula in x and y [m], such as \"0.01*cos(50*x)\"; or give grid"},
         b.formula);
  v.text({"grid", "surface: a CSV table with the columns x, y, z, one row a point of a rectangular grid [m]"}, b.grid);
  length("tolerance",
         "surface by formula: how far its triangles may be from it; a hundredth of the smallest radius unless given",
         b.tolerance);
  v.polygons({"polygons", "polygons: a list of polygons, each a list of its corners [x, y, z] in order", unit::metre},
             b.polygons);
  v.text({"path", "mesh: an STL, OBJ, PLY or VTK file; relative to the scene file's folder"}, b.path);
  v.number({"scale", "mesh: length of the file's unit [m], such as 0.001 for millimetres; 1 unless given", unit::none,
            Range::positive()},
           b.scale);
  v.vector({"offset", "mesh: where its origin is put; [0, 0, 0] unless given", unit::metre}, b.offset);
  v.optional_table({"motion", "How it moves; at rest when left out"}, b.motion.present,
                   [&] { describe_motion(v, b.motion); });
}

void fill_defaults(BoundarySpec& b) {
  using enum BoundaryKind;
  if (b.side == Side::automatic) {
    const bool open = b.kind == plane || b.kind == polygons || b.kind == mesh;
    b.side = open ? Side::both : Side::inside;
  }
}

void check_boundaries(const Scene& s) {
  const Domain box = s.box();
  for (std::size_t k = 0; k < s.boundaries.size(); ++k) {
    const BoundarySpec& b = s.boundaries[k];
    const std::string path = fmt::format("boundary[{}]", k);
    for (std::size_t other = 0; other < k; ++other) {
      if (s.boundaries[other].name == b.name) {
        s.fail(path + ".name", fmt::format("\"{}\" is taken; give each boundary its own name", b.name));
      }
    }
    if (b.name.find_first_of(",\"\n") != std::string::npos) {
      s.fail(path + ".name", "holds a comma, quote or line break; it names columns of history.csv");
    }
    check_keys(s, path, b);
    if (b.until && *b.until <= b.from) s.fail(path + ".until", "must lie after from");
    if (b.normal && b.normal->norm() == 0) s.fail(path + ".normal", "has no length");
    if (b.axis && b.axis->norm() == 0) s.fail(path + ".axis", "has no length");
    if (b.min && (b.max->array() <= b.min->array()).any()) {
      s.fail(path + ".max", "must lie above min along every axis: the box would be inside out");
    }
    if (b.kind == BoundaryKind::surface && b.formula.has_value() == b.grid.has_value()) {
      s.fail(path, "a surface needs either formula or grid");
    }
    if (b.grid && b.tolerance) s.fail(path + ".tolerance", "goes with formula; a grid's points are joined as they are");
    check_round(s, path, b);
    check_polygons(s, path, b);
    check_motion(s, path + ".motion", b.motion);
    check_stages(s, path, b);
    check_periodic(s, box, path, b);
  }
}

}  // namespace packstone
