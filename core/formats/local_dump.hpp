// Contacts in dumps of style local, of LAMMPS (compute property/local and pair/local) and of LIGGGHTS (compute
// pair/gran/local and wall/gran/local).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/formats/pair_contacts.hpp"

namespace packstone::formats {

/// Reads the frame of the given step. The file seldom says what its columns are; column_names does, in their order:
/// id1 id2 (particles) or x1 y1 z1 x2 y2 z2 (their centres), fx fy fz (force on the first), ftx fty ftz (a further
/// part of it, as LAMMPS' p1 p2 p3), - for one that is not used. Empty: the names in the file where it has them, else
/// by the number of columns: 5: id1 id2 fx fy fz; 6: LIGGGHTS' "id force"; 9: its "pos force"; 12: its "pos id force".
/// Throws InputError "FILE:LINE: what; what would be right".
PairForces read_local_dump(const std::filesystem::path& path, std::int64_t step,
                           const std::vector<std::string>& column_names);

/// The same for contacts with walls, as LIGGGHTS' compute wall/gran/local writes them for walls of triangles. Columns:
/// px py pz (point of contact), id (particle) or x y z (its centre), wall (number of the mesh, from 0; without it all
/// are of wall 0), fx fy fz (force on the particle), ftx fty ftz, -. By number: 9: "pos force", 12: "pos id force".
WallForces read_wall_dump(const std::filesystem::path& path, std::int64_t step,
                          const std::vector<std::string>& column_names);

}  // namespace packstone::formats
