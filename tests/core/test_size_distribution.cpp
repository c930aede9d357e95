// Drawn sizes against the distributions' closed forms.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/scene.hpp"
#include "core/size_distribution.hpp"
#include "tests/sample_scene.hpp"

using namespace packstone;
using Catch::Matchers::Contains;

namespace {

constexpr std::int64_t many = 20000;

std::vector<double> sorted_radii(const SizeSpec& spec, std::int64_t count = many) {
  auto radii = drawn_radii(spec, count, 7, 0);
  std::sort(radii.begin(), radii.end());
  return radii;
}

double quantile(const std::vector<double>& sorted, double q) {
  return sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size()))];
}

/// Radius below which a share of the mass is.
double mass_quantile(const std::vector<double>& sorted, double q) {
  double total = 0, sum = 0;
  for (const double r : sorted) total += r * r * r;
  for (const double r : sorted) {
    sum += r * r * r;
    if (sum >= q * total) return r;
  }
  return sorted.back();
}

SizeSpec spec_of(Distribution distribution) {
  SizeSpec s;
  s.present = true;
  s.distribution = distribution;
  return s;
}

/// small_scene with the light group's radius replaced.
std::string error_of(const std::string& radius) {
  try {
    parse_scene(testing::small_scene_with("radius = \"20 mm\"", "radius = " + radius), "s.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("uniform sizes, by number and by mass") {
  SizeSpec s = spec_of(Distribution::uniform);
  s.min = 1e-3;
  s.max = 3e-3;
  const auto by_number = sorted_radii(s);
  CHECK(quantile(by_number, 0.25) == Approx(1.5e-3).epsilon(1e-3));
  CHECK(quantile(by_number, 0.5) == Approx(2e-3).epsilon(1e-3));
  CHECK(by_number.front() >= 1e-3);
  CHECK(by_number.back() <= 3e-3);
  s.by = SharesBy::mass;
  const auto by_mass = sorted_radii(s);
  CHECK(mass_quantile(by_mass, 0.25) == Approx(1.5e-3).epsilon(1e-3));
  CHECK(mass_quantile(by_mass, 0.75) == Approx(2.5e-3).epsilon(1e-3));
}

TEST_CASE("normal, lognormal and weibull sizes have their quantiles") {
  SizeSpec normal = spec_of(Distribution::normal);
  normal.mean = 5e-3;
  normal.deviation = 1e-3;
  // Cut off at three deviations, 0.27 % of the distribution.
  CHECK(quantile(sorted_radii(normal), 0.8413) == Approx(6e-3).epsilon(2e-3));
  CHECK(quantile(sorted_radii(normal), 0.5) == Approx(5e-3).epsilon(1e-3));
  SizeSpec lognormal = spec_of(Distribution::lognormal);
  lognormal.median = 20e-6;
  lognormal.spread = 1.5;
  CHECK(quantile(sorted_radii(lognormal), 0.5) == Approx(20e-6).epsilon(1e-3));
  CHECK(quantile(sorted_radii(lognormal), 0.8413) == Approx(30e-6).epsilon(3e-3));
  // By mass, the median by mass is the number's times exp(3 ln^2 spread) (Hatch & Choate); given by mass it is itself.
  CHECK(mass_quantile(sorted_radii(lognormal), 0.5) ==
        Approx(20e-6 * std::exp(3 * std::log(1.5) * std::log(1.5))).epsilon(0.03));
  lognormal.by = SharesBy::mass;
  CHECK(mass_quantile(sorted_radii(lognormal), 0.5) == Approx(20e-6).epsilon(2e-3));
  SizeSpec weibull = spec_of(Distribution::weibull);
  weibull.scale = 2e-3;
  weibull.shape = 3;
  CHECK(quantile(sorted_radii(weibull), 1 - std::exp(-1.0)) == Approx(2e-3).epsilon(2e-3));
  CHECK(quantile(sorted_radii(weibull), 0.5) == Approx(2e-3 * std::cbrt(std::log(2.0))).epsilon(2e-3));
}

TEST_CASE("a list has whole particles of each size, as near to the shares as can be") {
  SizeSpec s = spec_of(Distribution::list);
  s.radii = {1e-3, 2e-3, 4e-3};
  const auto count = [&](double radius, std::int64_t particles) {
    const auto radii = sorted_radii(s, particles);
    REQUIRE(static_cast<std::int64_t>(radii.size()) == particles);
    return std::count(radii.begin(), radii.end(), radius);
  };
  CHECK(count(2e-3, 300) == 100);
  s.shares = {5, 3, 2};
  CHECK(count(1e-3, 10) == 5);
  CHECK(count(1e-3, 7) == 4);  // 3.5, 2.1, 1.4
  CHECK(count(4e-3, 7) == 1);
  s.shares = {1, 1, 1};
  s.by = SharesBy::mass;
  CHECK(count(1e-3, 73) == 64);
  CHECK(count(4e-3, 73) == 1);
}

TEST_CASE("a table's classes hold their shares of the mass, as a sieve analysis says") {
  SizeSpec s = spec_of(Distribution::table);
  s.radii = {1e-3, 2e-3, 3e-3, 6e-3};
  s.shares = {20, 30, 50};
  s.by = SharesBy::mass;
  const auto radii = sorted_radii(s);
  CHECK(mass_quantile(radii, 0.2) == Approx(2e-3).epsilon(2e-3));
  CHECK(mass_quantile(radii, 0.5) == Approx(3e-3).epsilon(2e-3));
  CHECK(mass_quantile(radii, 0.75) == Approx(4.5e-3).epsilon(5e-3));
}

TEST_CASE("even a few particles have the spread asked for, in random order, the same for the same seed") {
  SizeSpec s = spec_of(Distribution::uniform);
  s.min = 1;
  s.max = 2;
  const auto radii = drawn_radii(s, 10, 3, 0);
  CHECK(radii == drawn_radii(s, 10, 3, 0));
  CHECK(radii != drawn_radii(s, 10, 4, 0));
  CHECK(radii != drawn_radii(s, 10, 3, 1));
  CHECK_FALSE(std::is_sorted(radii.begin(), radii.end()));
  for (int tenth = 0; tenth < 10; ++tenth) {
    CHECK(std::count_if(radii.begin(), radii.end(), [&](double r) { return std::floor((r - 1) * 10) == tenth; }) == 1);
  }
}

TEST_CASE("a scene takes sizes as a table, writes them and reads them back") {
  const std::string text = testing::small_scene_with(
      "radius = \"20 mm\"",
      "radius = { distribution = \"lognormal\", median = \"15 mm\", spread = 1.2, by = \"mass\" }");
  const Scene scene = parse_scene(text, "s.toml");
  REQUIRE(scene.particles[0].sizes.present);
  CHECK(*scene.particles[0].sizes.median == Approx(0.015));
  const std::string written = to_toml(scene);
  CHECK(to_toml(parse_scene(written, "again.toml")) == written);
  double volume = 0;
  for (const std::size_t g : {0, 1}) {
    for (const double r : scene.radii(g)) volume += 4.0 / 3 * M_PI * r * r * r;
  }
  CHECK(scene.solid_volume() == Approx(volume));
}

TEST_CASE("sizes that make no sense are refused") {
  CHECK_THAT(error_of("{ distribution = \"uniform\", min = 0.01 }"),
             Contains("particles[0].radius: needs max for distribution = \"uniform\""));
  CHECK_THAT(error_of("{ distribution = \"uniform\", min = 0.02, max = 0.01 }"),
             Contains("particles[0].radius.max") && Contains("does not lie above"));
  CHECK_THAT(error_of("{ distribution = \"normal\", mean = 0.01, deviation = 0.005 }"),
             Contains("particles[0].radius.min") && Contains("reaches down to -0.005 m"));
  CHECK_THAT(error_of("{ distribution = \"list\", radii = [0.02, 0.01] }"), Contains("must ascend"));
  CHECK_THAT(error_of("{ distribution = \"list\", radii = [] }"), Contains("needs one radius"));
  CHECK_THAT(error_of("{ distribution = \"table\", radii = [0.01, 0.02], shares = [1, 2] }"),
             Contains("has 2 entries; 2 radii take 1"));
  CHECK_THAT(error_of("{ distribution = \"list\", radii = [0.01], shares = [0] }"), Contains("are all 0"));
  CHECK_THAT(error_of("{ distribution = \"sieve\" }"), Contains("expected one of"));
  CHECK_THAT(error_of("{ distribution = \"uniform\", min = 0.01, max = 0.02, mode = 3 }"), Contains("unknown key"));
  CHECK_THAT(error_of("[1, 2]"), Contains("expected a number"));
}
