// What GLEW asks the X server for, answered without one.
#pragma once

namespace packstone::viz {

/// How OpenGL's functions are found by name.
using GlFunction = void (*)();
void find_gl_functions_by(GlFunction (*find)(const char* name));

/// True when this program's OpenGL calls, and GLEW's questions, end at OSMesa and at the shims, not at the X server's
/// libraries. Calling it also makes the linker keep the shims.
bool glx_shims_in_place();

}  // namespace packstone::viz
