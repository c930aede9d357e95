#include "core/formats/lammps_data.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <unordered_map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/formats/text_output.hpp"
#include "core/geometry.hpp"
#include "core/text_lines.hpp"

namespace packstone::formats {

namespace {

constexpr int most_header_lines = 20;
constexpr std::array atom_columns = {"id", "type", "diameter", "density", "x", "y", "z"};
constexpr std::size_t image_flags = 3;
constexpr std::array velocity_columns = {"id", "vx", "vy", "vz", "wx", "wy", "wz"};
constexpr std::array bound_names = {"xlo", "xhi", "ylo", "yhi", "zlo", "zhi"};

using Fields = std::vector<std::string_view>;

class DataReader {
 public:
  DataReader(std::string_view text, const std::string& source) : lines_(text, source) {
    columns_.source = source;
    columns_.first_type = 1;
    check_units(text.substr(0, text.find('\n')));
  }

  ParticleColumns read() {
    while (lines_.next()) {
      if (lines_.number() == 1) continue;  // a title, whatever it says
      if (std::isupper(static_cast<unsigned char>(lines_.line().front()))) {
        begin_section();
      } else if (section_ == "Atoms") {
        add_atom(words(lines_.line()));
      } else if (section_ == "Velocities") {
        add_velocity(words(lines_.line()));
      } else if (section_.empty()) {
        read_header();
      }
    }
    check_count();
    return columns();
  }

 private:
  /// The title says in which units newer versions wrote the file; older ones do not say.
  void check_units(std::string_view title) const {
    const std::string_view key = "units = ";
    const std::size_t at = title.find(key);
    if (at == std::string_view::npos) return;
    const Fields rest = words(title.substr(at + key.size()));
    const std::string_view units = rest.empty() ? "" : rest[0].substr(0, rest[0].find(','));
    if (units == "si") return;
    throw InputError(fmt::format("{}:1: the file is in units {}; only units si is read", lines_.source_name(), units));
  }

  void begin_section() {
    section_ = lines_.line();
    if (section_ != "Atoms") return;
    const std::string_view style = lines_.comment();
    if (style.empty() || style == "sphere") return;
    lines_.fail(fmt::format("Atoms: atom_style {} has no radius for each atom; only atom_style sphere is read", style));
  }

  void read_header() {
    const Fields parts = words(lines_.line());
    if (parts.size() == 2 && parts[1] == "atoms") expected_ = parsed_integer(parts[0]).value_or(-1);
    for (std::size_t k = 0; k < 3; ++k) {
      if (parts.size() == 4 && parts[2] == bound_names[2 * k] && parts[3] == bound_names[2 * k + 1])
        read_bounds(k, parts);
    }
    if (!parts.empty() && parts.back() == "yz") tilted_ = true;
  }

  void read_bounds(std::size_t axis, const Fields& parts) {
    const double low = number(bound_names[2 * axis], parts[0]), high = number(bound_names[2 * axis + 1], parts[1]);
    if (!(low < high)) {
      lines_.fail(fmt::format("the box along {} goes from {:g} to {:g}; the lower bound must be below the upper",
                              axis_names[axis], low, high));
    }
    box_.min[axis] = low;
    box_.max[axis] = high;
    ++bounded_axes_;
  }

  double number(const char* column, std::string_view field) const {
    const auto value = parsed_number(field);
    if (!value || !std::isfinite(*value)) {
      lines_.fail(fmt::format("{}: \"{}\" is not a finite number", column, field));
    }
    return *value;
  }

  std::int64_t integer(const char* column, std::string_view field) const {
    const auto value = parsed_integer(field);
    if (!value) lines_.fail(fmt::format("{}: \"{}\" is not a whole number", column, field));
    return *value;
  }

  void add_atom(const Fields& fields) {
    const std::size_t plain = atom_columns.size();
    if (fields.size() != plain && fields.size() != plain + image_flags) {
      lines_.fail(
          fmt::format("Atoms: the row has {} fields; atom_style sphere has {}: id type diameter density x y z, "
                      "or {} with image flags",
                      fields.size(), plain, plain + image_flags));
    }
    const std::int64_t id = integer("id", fields[0]);
    atoms_[0].push_back(static_cast<double>(id));
    atoms_[1].push_back(static_cast<double>(integer("type", fields[1])));
    for (std::size_t k = 2; k < plain; ++k) atoms_[k].push_back(number(atom_columns[k], fields[k]));
    if (const double diameter = atoms_[2].back(); !(diameter > 0)) {
      lines_.fail(fmt::format("diameter: {:g} m is out of range; it must be greater than 0", diameter));
    }
    if (!row_of_id_.emplace(id, row_of_id_.size()).second) {
      lines_.fail(fmt::format("id: {} occurs twice; each atom needs its own", id));
    }
    columns_.line.push_back(lines_.number());
  }

  void check_count() const {
    if (static_cast<std::int64_t>(row_of_id_.size()) == expected_) return;
    throw InputError(fmt::format("{}: the section Atoms holds {} atoms, the header says {}; is the file cut short?",
                                 lines_.source_name(), row_of_id_.size(), expected_));
  }

  /// Velocities follow the Atoms, as LAMMPS itself demands.
  void add_velocity(const Fields& fields) {
    if (fields.size() != velocity_columns.size()) {
      lines_.fail(fmt::format("Velocities: the row has {} fields; atom_style sphere has {}: id vx vy vz wx wy wz",
                              fields.size(), velocity_columns.size()));
    }
    const auto found = row_of_id_.find(integer("id", fields[0]));
    if (found == row_of_id_.end()) {
      lines_.fail(fmt::format("id: {} has a velocity but is not among the Atoms above", fields[0]));
    }
    for (std::size_t k = 1; k < fields.size(); ++k) {
      std::vector<double>& column = columns_.values[velocity_columns[k]];
      column.resize(row_of_id_.size(), 0.0);
      column[found->second] = number(velocity_columns[k], fields[k]);
    }
  }

  ParticleColumns columns() {
    if (tilted_) throw InputError(lines_.source_name() + ": the box is triclinic; only boxes along the axes are read");
    columns_.count = row_of_id_.size();
    for (std::size_t k = 0; k < atom_columns.size(); ++k) add_column(columns_, atom_columns[k], std::move(atoms_[k]));
    if (bounded_axes_ == 3) columns_.domain = box_;
    columns_.notes.emplace_back(note_no_periodicity);
    return std::move(columns_);
  }

  TextLines lines_;
  ParticleColumns columns_;
  std::array<std::vector<double>, atom_columns.size()> atoms_;
  std::string section_;
  std::int64_t expected_ = 0;
  Domain box_;
  int bounded_axes_ = 0;
  bool tilted_ = false;
  std::unordered_map<std::int64_t, std::size_t> row_of_id_;
};

void check_writable(const std::filesystem::path& path, const Snapshot& s) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (!(s.radius[i] > 0)) {
      throw InputError(
          fmt::format("{}: particle {} has radius 0, which LAMMPS takes for a point; choose an instant "
                      "after the growth",
                      path.string(), s.id[i]));
    }
    if (!(mass_of(s, i) > 0)) {
      throw InputError(
          fmt::format("{}: the density of particle {} is not known, and a LAMMPS data file needs it; give "
                      "the materials with --like SCENE",
                      path.string(), s.id[i]));
    }
  }
}

/// The group's density as it is written in the scene, unless the particle has a mass of its own.
double density_of(const Snapshot& s, std::size_t i) {
  const double group = s.groups[static_cast<std::size_t>(s.type[i])].density;
  const double own = mass_of(s, i) / sphere_volume(s.radius[i]);
  constexpr double rounding = 1e-12;  // of a product of few factors
  return std::abs(own - group) <= rounding * own ? group : own;
}

}  // namespace

bool is_lammps_data(std::string_view text) {
  TextLines lines(text, "");
  for (int k = 0; k < most_header_lines && lines.next(); ++k) {
    const auto parts = words(lines.line());
    if (parts.size() == 2 && parts[1] == "atoms" && parsed_integer(parts[0])) return true;
  }
  return false;
}

ParticleColumns read_lammps_data(std::string_view text, const std::string& source) {
  return DataReader(text, source).read();
}

void write_lammps_data(const std::filesystem::path& path, const Snapshot& s) {
  check_writable(path, s);
  const std::int64_t first_id = std::find(s.id.begin(), s.id.end(), 0) == s.id.end() ? 0 : 1;
  TextOutput out(path);
  out.print("LAMMPS data file written by packstone, timestep = {}, units = si\n\n{} atoms\n{} atom types\n\n", s.step,
            s.size(), s.groups.size());
  for (std::size_t k = 0; k < 3; ++k) {
    out.print("{} {} {} {}\n", s.domain.min[k], s.domain.max[k], bound_names[2 * k], bound_names[2 * k + 1]);
  }
  out.print("\nAtoms # sphere\n\n");
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Vec3& p = s.position[i];
    out.print("{} {} {} {} {} {} {}\n", s.id[i] + first_id, s.type[i] + 1, 2 * s.radius[i], density_of(s, i), p.x(),
              p.y(), p.z());
  }
  const auto motion = vector_columns(s, {"vx", "vy", "vz"}, {"wx", "wy", "wz"});
  const auto component = [&](const char* name) {
    const auto found = std::find_if(motion.begin(), motion.end(), [&](const auto& c) { return c.name == name; });
    return found == motion.end() ? nullptr : &*found;
  };
  if (component("vx") || component("wx")) {
    out.print("\nVelocities\n\n");
    for (std::size_t i = 0; i < s.size(); ++i) {
      out.print("{}", s.id[i] + first_id);
      for (std::size_t k = 1; k < velocity_columns.size(); ++k) {
        const OutputColumn* column = component(velocity_columns[k]);
        out.print(" {}", column ? column->value(i) : 0.0);
      }
      out.print("\n");
    }
  }
  out.finish();
}

}  // namespace packstone::formats
