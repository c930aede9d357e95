#include "engine/filling/file_filling.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/formats/csv_table.hpp"
#include "core/formats/lammps_data.hpp"
#include "core/hash.hpp"
#include "engine/filling/particle_readers.hpp"

namespace packstone::engine {

namespace {

constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";
constexpr const char* snapshot_extension = ".vtkhdf";
constexpr const char* axis_columns[] = {"x", "y", "z"};
constexpr const char* sides[] = {"lower", "upper"};

std::vector<FileParticle> read_particles(const Scene& scene, const std::string& text) {
  const std::string& path = *scene.filling.path;
  if (text.starts_with(hdf5_signature) || std::filesystem::path(path).extension() == snapshot_extension) {
    return read_snapshot_particles(path);
  }
  return table_particles(
      formats::is_lammps_data(text) ? formats::read_lammps_data(text, path) : formats::read_csv_table(text, path),
      scene);
}

/// Holds each particle against the scene.
class FileCheck {
 public:
  FileCheck(const Scene& scene, const Domain& domain, const Boundaries& boundaries)
      : scene_(scene), domain_(domain), boundaries_(boundaries) {}

  /// Throws InputError "FILE:LINE: column: what; what would be right".
  void operator()(const FileParticle& p) const {
    if (!(p.radius > 0)) fail(p, "radius", fmt::format("{:g} m is out of range; it must be greater than 0", p.radius));
    const auto groups = static_cast<std::int64_t>(scene_.particles.size());
    if (p.group < 0 || p.group >= groups) {
      fail(p, "group",
           fmt::format("{} is not a [[particles]] entry of the scene; they go from 0 to {}", p.group, groups - 1));
    }
    for (int face = 0; face < face_count; ++face) check_face(p, face);
    if (const auto plane = boundaries_.plane_before(p.position)) {
      fail(p, "x, y, z",
           fmt::format("the centre lies behind the boundary {}; move the particle or the boundary, or turn the "
                       "boundary's normal round",
                       scene_.boundaries[*plane].name));
    }
  }

  void refuse_same_ids(const FileParticle& a, const FileParticle& b) const {
    if (a.id == b.id) fail(b, "id", fmt::format("{} occurs twice; each particle needs its own", b.id));
  }

 private:
  [[noreturn]] void fail(const FileParticle& p, const std::string& column, const std::string& what) const {
    const std::string place = p.line > 0 ? fmt::format(":{}: ", p.line) : fmt::format(": particle {}: ", p.id);
    throw InputError(*scene_.filling.path + place + column + ": " + what);
  }

  void check_face(const FileParticle& p, int face) const {
    const int axis = face / 2;
    const bool open =
        domain_.periodic[axis] || std::count(scene_.domain.open.begin(), scene_.domain.open.end(), face) > 0;
    const double limit = face % 2 ? domain_.max[axis] : domain_.min[axis];
    const double beyond = (face % 2 ? 1 : -1) * (p.position[axis] - limit);
    if (beyond <= (open ? domain_.size()[axis] : 0)) return;  // a box away or more: wrong units, more likely
    fail(p, axis_columns[axis],
         fmt::format(
             "{:g} m lies outside the domain, whose {} side is at {:g} m{}", p.position[axis], sides[face % 2], limit,
             open ? ", by more than the domain's length; move the particle or enlarge the domain (lengths are in m)"
                  : "; move the particle, enlarge the domain, or open the face in domain.open"));
  }

  const Scene& scene_;
  const Domain& domain_;
  const Boundaries& boundaries_;
};

}  // namespace

StartingState particles_from_file(const Scene& scene, const Domain& domain, const Boundaries& boundaries) {
  const std::string& path = *scene.filling.path;
  if (!std::filesystem::is_regular_file(path)) {
    scene.fail("filling.path", fmt::format("{}: {}", path,
                                           std::filesystem::exists(path) ? "not a file; name a file, such as a "
                                                                           "snapshot inside a run folder"
                                                                         : "no such file"));
  }
  const std::string text = read_text_file(path);
  std::vector<FileParticle> particles = read_particles(scene, text);
  if (particles.empty()) throw InputError(path + ": holds no particles; one at least is needed");
  std::stable_sort(particles.begin(), particles.end(), [](const auto& a, const auto& b) { return a.id < b.id; });

  const FileCheck check(scene, domain, boundaries);
  StartingState start;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const FileParticle& p = particles[i];
    check(p);
    if (i > 0) check.refuse_same_ids(particles[i - 1], p);
    start.position.push_back(domain.wrapped(p.position));
    start.velocity.push_back(p.velocity);
    start.angular_velocity.push_back(p.angular_velocity);
    start.radius.push_back(p.radius);
    start.type.push_back(static_cast<std::int32_t>(p.group));
  }
  start.source_hash = content_hash(text);
  return start;
}

}  // namespace packstone::engine
