#include "viz/quantity.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace packstone::viz {

namespace {

constexpr double round_off = 1e-9;  ///< of a tick step: what counts as on the end of the axis

/// Without "-0".
double clean(double value, double step) { return std::abs(value) < step * round_off ? 0 : value; }

int decimals_for(double step) { return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - round_off))); }

}  // namespace

ReadableUnit length_unit(double length) {
  constexpr double few = 0.0999;  // of the next larger unit: 100 mm is still 0.1 m
  if (length >= few) return {"m", 1};
  if (length >= few * 1e-3) return {"mm", 1e-3};
  if (length >= few * 1e-6) return {"µm", 1e-6};
  return {"nm", 1e-9};
}

std::string length_text(double length, int digits) {
  const ReadableUnit unit = length_unit(std::abs(length));
  return fmt::format("{:.{}g} {}", length / unit.scale, digits, length == 0 ? "m" : unit.name);
}

std::string time_text(double seconds) {
  constexpr double shortest_in_seconds = 0.01;
  constexpr double shortest_in_milliseconds = 1e-5;
  if (seconds == 0 || seconds >= shortest_in_seconds) return fmt::format("t = {:.3f} s", seconds);
  if (seconds >= shortest_in_milliseconds) return fmt::format("t = {:.3f} ms", seconds * 1e3);
  return fmt::format("t = {:.3f} µs", seconds * 1e6);
}

double round_below(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= value * (1 + round_off)) return step * power;
  }
  return power;
}

std::string power_of_ten(int exponent) {
  constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += raised[digit - '0'];
  return text;
}

Ticks linear_ticks(double low, double high, int count) {
  // The smallest round step that gives no more than count intervals.
  const double wanted = (high - low) / count;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = power;
  for (const double candidate : {1.0, 2.0, 5.0, 10.0}) {
    step = candidate * power;
    if (step >= wanted * (1 - round_off)) break;
  }
  Ticks ticks;
  const double largest = std::max(std::abs(low), std::abs(high));
  constexpr double plain_below = 1e5;
  constexpr double plain_above = 1e-2;
  if (largest >= plain_below || largest < plain_above)
    ticks.exponent = static_cast<int>(std::floor(std::log10(largest)));
  const double unit = std::pow(10.0, ticks.exponent);
  const int decimals = decimals_for(step / unit);
  const auto first = static_cast<long>(std::ceil(low / step - round_off));
  const auto last = static_cast<long>(std::floor(high / step + round_off));
  for (long i = first; i <= last; ++i) {
    const double value = clean(static_cast<double>(i) * step, step);
    ticks.values.push_back(value);
    ticks.labels.push_back(fmt::format("{:.{}f}", value / unit, decimals));
  }
  return ticks;
}

Ticks logarithmic_ticks(double low, double high, int count) {
  const int first = static_cast<int>(std::ceil(std::log10(low) - round_off));
  const int last = static_cast<int>(std::floor(std::log10(high) + round_off));
  const int stride = std::max(1, (last - first + count) / count);
  Ticks ticks;
  for (int exponent = first; exponent <= last; exponent += stride) {
    ticks.values.push_back(std::pow(10.0, exponent));
    ticks.labels.push_back(power_of_ten(exponent));
  }
  return ticks;
}

std::string with_exponent(const std::string& title, int exponent) {
  if (exponent == 0) return title;
  const std::string power = power_of_ten(exponent);
  const std::size_t bracket = title.rfind('[');
  if (bracket == std::string::npos) return title + " [" + power + "]";
  return title.substr(0, bracket + 1) + power + " " + title.substr(bracket + 1);
}

}  // namespace packstone::viz
