// Spheres in files of VTK: .vtu and .vtp (XML) and .vtk (legacy), as Yade, LIGGGHTS, ParaView and packstone write them.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/formats/pair_contacts.hpp"
#include "core/formats/particle_columns.hpp"
#include "core/snapshot.hpp"

namespace packstone::formats {

/// Whether the text begins as a legacy file or an XML file of VTK does.
bool is_vtk_file(std::string_view text);

/// The points with their data: radii as radius, radii, diameter; vectors velocity (linVelVec, v), angular_velocity
/// (angVelVec, omega), force (f); other scalars by their names. Time and box where packstone wrote them.
/// Throws InputError that names the file; also in a build without VTK.
ParticleColumns read_vtk_file(const std::filesystem::path& path);

/// Interactions as Yade's VTKRecorder (NAME-intrs.NUMBER.vtp) and export.VTKExporter (NAME-intrs-NUMBER.vtk) write
/// them: a line from the first centre to the second, with forceN, the normal force, or with the vectors normalForce and
/// shearForce (i.phys.normalForce, i.phys.shearForce), which Yade lets act on the second. Throws InputError as above.
PairForces read_yade_interactions(const std::filesystem::path& path);

/// Writes an unstructured grid (.vtu) or poly data (.vtp) of one vertex a particle, XML with appended raw data in
/// double precision, with all fields. Throws RunError when the disk refuses.
void write_vtk_file(const std::filesystem::path& path, const Snapshot& snapshot);

/// Names of the data beside the particles that packstone writes, as VTK's field data.
inline constexpr const char* vtk_time_name = "TimeValue";
inline constexpr const char* vtk_step_name = "step";
inline constexpr const char* vtk_domain_name = "domain";      ///< (6) lower and upper corner [m]
inline constexpr const char* vtk_periodic_name = "periodic";  ///< (3)

}  // namespace packstone::formats
