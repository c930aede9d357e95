// Contacts in dumps of style local, of LAMMPS (compute property/local and pair/local) and of LIGGGHTS (compute
// pair/gran/local).
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

}  // namespace packstone::formats
