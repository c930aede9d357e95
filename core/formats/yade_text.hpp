// Spheres as Yade exports them to text: yade.export.text and textExt,
// https://yade-dem.org/doc/yade.export.html.
#pragma once

#include <string>
#include <string_view>

#include "core/formats/particle_columns.hpp"

namespace packstone::formats {

/// Whether the text says its #format, or its first line is of four numbers or more and nothing else.
bool is_yade_text(std::string_view text);

/// Rows of x y z r, or as a line "#format id_x_y_z_r_matId" above them says; matId numbers the types from 0. Further
/// columns (attrs) have the names of the last comment above the rows where it has as many words as a row has fields,
/// "# x y z r vx vy vz mass"; else they are not used. SI units; the file has no box.
/// Throws InputError "SOURCE:LINE: column: what; what would be right".
ParticleColumns read_yade_text(std::string_view text, const std::string& source);

}  // namespace packstone::formats
