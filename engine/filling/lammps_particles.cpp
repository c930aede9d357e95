// LAMMPS data files, https://docs.lammps.org/read_data.html, of atom_style sphere.

#include <array>
#include <cctype>
#include <cmath>
#include <unordered_map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text_lines.hpp"
#include "engine/filling/particle_readers.hpp"

namespace packstone::engine {

namespace {

constexpr double density_tolerance = 1e-6;  ///< relative: what programs lose when they print a density
constexpr std::array atom_columns = {"id", "type", "diameter", "density", "x", "y", "z"};
constexpr std::size_t image_flags = 3;
constexpr std::array velocity_columns = {"id", "vx", "vy", "vz", "wx", "wy", "wz"};

using Fields = std::vector<std::string_view>;

class LammpsReader {
 public:
  LammpsReader(std::string_view text, const std::string& source_name, const Scene& scene)
      : lines_(text, source_name), scene_(scene) {
    check_units(text.substr(0, text.find('\n')));
  }

  std::vector<FileParticle> read() {
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
    return std::move(particles_);
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
    std::array<double, atom_columns.size()> value{};
    for (std::size_t k = 2; k < plain; ++k) value[k] = number(atom_columns[k], fields[k]);
    FileParticle p;
    p.id = integer("id", fields[0]);
    p.line = lines_.number();
    p.group = group_of(integer("type", fields[1]));
    p.radius = 0.5 * value[2];
    p.position = {value[4], value[5], value[6]};
    if (!(p.radius > 0)) {
      lines_.fail(fmt::format("diameter: {:g} m is out of range; it must be greater than 0", value[2]));
    }
    check_density(p.group, value[3]);
    if (!row_of_id_.emplace(p.id, particles_.size()).second) {
      lines_.fail(fmt::format("id: {} occurs twice; each atom needs its own", p.id));
    }
    particles_.push_back(p);
  }

  std::int64_t group_of(std::int64_t type) const {
    const auto groups = static_cast<std::int64_t>(scene_.particles.size());
    if (type < 1 || type > groups) {
      lines_.fail(
          fmt::format("type: {} has no [[particles]] entry in the scene, whose {} stand for the types from 1; "
                      "add one for each type",
                      type, groups));
    }
    return type - 1;
  }

  void check_density(std::int64_t group, double density) const {
    const GroupSpec& spec = scene_.particles[group];
    const MaterialSpec& material = scene_.materials[scene_.material_index(spec.material)];
    if (std::abs(density - material.density) <= density_tolerance * material.density) return;
    lines_.fail(
        fmt::format("density: {:.9g} kg/m3 differs from the {:.9g} kg/m3 of the scene's material \"{}\" for "
                    "particles[{}]; make them equal",
                    density, material.density, material.name, group));
  }

  void check_count() const {
    if (static_cast<std::int64_t>(particles_.size()) == expected_) return;
    throw InputError(fmt::format("{}: the section Atoms holds {} atoms, the header says {}; is the file cut short?",
                                 lines_.source_name(), particles_.size(), expected_));
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
    std::array<double, velocity_columns.size()> value{};
    for (std::size_t k = 1; k < fields.size(); ++k) value[k] = number(velocity_columns[k], fields[k]);
    particles_[found->second].velocity = {value[1], value[2], value[3]};
    particles_[found->second].angular_velocity = {value[4], value[5], value[6]};
  }

  TextLines lines_;
  const Scene& scene_;
  std::string section_;
  std::int64_t expected_ = 0;
  std::vector<FileParticle> particles_;
  std::unordered_map<std::int64_t, std::size_t> row_of_id_;
};

}  // namespace

std::vector<FileParticle> read_lammps_particles(std::string_view text, const std::string& source_name,
                                                const Scene& scene) {
  return LammpsReader(text, source_name, scene).read();
}

}  // namespace packstone::engine
