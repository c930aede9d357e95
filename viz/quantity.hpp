// Numbers and lengths as people read them.
#pragma once

#include <string>
#include <vector>

namespace packstone::viz {

/// A unit with its prefix: 1 of it is scale SI units.
struct ReadableUnit {
  std::string name;
  double scale = 1;
};

/// The metre, millimetre, micrometre or nanometre in which a length has few digits before and after the point.
ReadableUnit length_unit(double length);

/// "0.586 m", "20 mm"
std::string length_text(double length, int digits = 3);

/// "t = 1.250 s"; milli- and microseconds for short times. The decimals are fixed, so the text of a movie stays put.
std::string time_text(double seconds);

/// The largest 1, 2 or 5 times a power of ten that is not above the value (> 0).
double round_below(double value);

/// "10⁻⁵"
std::string power_of_ten(int exponent);

/// Where an axis has its ticks, and what stands there.
struct Ticks {
  std::vector<double> values;
  std::vector<std::string> labels;
  int exponent = 0;  ///< the labels are in units of 10^exponent, which then belongs into the axis title
};

/// Round values in [low, high], about count of them; low < high.
Ticks linear_ticks(double low, double high, int count);

/// Powers of ten in [low, high], thinned to about count; 0 < low < high.
Ticks logarithmic_ticks(double low, double high, int count);

/// "Kinetic energy [J]", with the common factor of ticks: "Kinetic energy [10⁻⁵ J]".
std::string with_exponent(const std::string& title, int exponent);

}  // namespace packstone::viz
