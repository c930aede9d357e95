// A small complete scene that tests change key by key.
#pragma once

#include <cstddef>
#include <string>

namespace packstone::testing {

/// Two groups of spheres grown over a floor; line numbers matter to the tests of error messages.
inline const std::string small_scene = R"(title = "Small"
seed = 3
[dynamics]
time_step = "20 us"
duration = "80 ms"
[domain]
min = [0, 0, 0]
max = [0.2, 0.2, 0.4]
periodic = ["x", "y"]
open = ["z+"]
[gravity]
acceleration = [0, 0, -9.8]
start = "40 ms"
[contact]
normal = "hysteretic"
[[material]]
name = "light"
density = 1200
normal_stiffness = 1e6
normal_damping = 0.7
[[material]]
name = "heavy"
density = 7800
normal_stiffness = 1e6
normal_damping = 0.7
[[particles]]
material = "light"
count = 60
radius = "20 mm"
[[particles]]
material = "heavy"
count = 60
radius = "20 mm"
[filling]
kind = "growth"
duration = "40 ms"
[[boundary]]
name = "floor"
kind = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
[output]
interval = "20 ms"
fields = ["velocity", "force"]
)";

/// small_scene with the first occurrence of one text replaced.
inline std::string small_scene_with(const std::string& from, const std::string& to) {
  std::string text = small_scene;
  return text.replace(text.find(from), from.size(), to);
}

/// small_scene with its particles from a file: two groups of which only the materials are given, gravity from the
/// start.
inline std::string file_scene(const std::string& path) {
  std::string text = small_scene;
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at; (at = text.find(from)) != std::string::npos;) text.replace(at, from.size(), to);
  };
  replace("count = 60\nradius = \"20 mm\"\n", "");
  replace("kind = \"growth\"\nduration = \"40 ms\"", "kind = \"file\"\npath = \"" + path + "\"");
  replace("start = \"40 ms\"\n", "");
  return text;
}

}  // namespace packstone::testing
