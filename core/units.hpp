// Quantities as people write them: "20 mm", "50 us", "7.8 g/cm3". Everything is SI inside.
#pragma once

#include <optional>
#include <string>

#include "core/vec3.hpp"

namespace packstone {

/// Powers of metre, kilogram, second; angles count as pure numbers.
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;

  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// A dimension with the SI unit as it is written in docs and messages.
struct Unit {
  Dimension dimension;
  const char* symbol;
};

namespace unit {
inline constexpr Unit none{{}, ""};
inline constexpr Unit metre{{1, 0, 0}, "m"};
inline constexpr Unit second{{0, 0, 1}, "s"};
inline constexpr Unit frequency{{0, 0, -1}, "1/s"};
inline constexpr Unit density{{-3, 1, 0}, "kg/m3"};
inline constexpr Unit mass{{0, 1, 0}, "kg"};
inline constexpr Unit acceleration{{1, 0, -2}, "m/s2"};
inline constexpr Unit speed{{1, 0, -1}, "m/s"};
inline constexpr Unit stiffness{{0, 1, -2}, "N/m"};
inline constexpr Unit damping{{0, 1, -1}, "N s/m"};
inline constexpr Unit pressure{{-1, 1, -2}, "Pa"};
inline constexpr Unit viscosity{{-1, 1, -1}, "Pa s"};
inline constexpr Unit energy{{2, 1, -2}, "J"};
}  // namespace unit

/// Value in SI of text such as "20 mm", "9.8 m/s2", "1e-3" (already SI), "30 deg".
/// Throws InputError when the text is no number with a unit of the wanted dimension; the message names the unit.
double parse_quantity(const std::string& text, const Unit& wanted);

/// Three of them with commas between, "0.1,20 mm,0"; nothing where there are not three. Throws as parse_quantity.
std::optional<Vec3> parse_vector(const std::string& text, const Unit& wanted);

}  // namespace packstone
