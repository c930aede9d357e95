// What a study changes in a scene: keys, and factors on what every scene has.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/scene.hpp"

namespace packstone::cli {

/// One way to run a scene.
struct Variant {
  std::string label;
  std::vector<std::string> settings;  ///< "KEY=VALUE", of the scene or "stiffness=F", "step=F"
};

/// The scene as it is.
inline constexpr const char* as_is = "as is";

/// "KEY=V1,V2,...": a variant a value; a comma within brackets or quotes separates none. "NAME: KEY=VALUE; KEY=VALUE":
/// one variant. Throws InputError.
std::vector<Variant> variants_of(const std::string& text);

/// Key and value of "KEY=VALUE". Throws InputError.
std::pair<std::string, std::string> setting_of(const std::string& text);

/// The value of a key that takes a number above 0. Throws InputError.
double factor_of(const std::string& key, const std::string& value);

/// What a user would first ask about: steps, softer contacts, single precision, the quick way to rest.
std::vector<Variant> usual_variants();

/// The scene that a variant runs. stiffness=F: every stiffness times F, restitutions kept. step=F: the recommended time
/// step times F. Throws InputError where the scene does not bear it.
Scene scene_of(const std::filesystem::path& file, const std::vector<std::string>& overrides, const Variant& variant,
               std::int64_t seed);

}  // namespace packstone::cli
