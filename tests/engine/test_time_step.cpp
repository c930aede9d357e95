#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "engine/filling/growth.hpp"
#include "engine/time_step.hpp"
#include "tests/sample_scene.hpp"

using namespace packstone;
using namespace packstone::engine;
using Catch::Matchers::Contains;

namespace {

const double light_mass = 1200 * 4.0 / 3.0 * std::numbers::pi * std::pow(0.02, 3);

Scene scene_with_step(const std::string& step) {
  return parse_scene(packstone::testing::small_scene, "s.toml", {"dynamics.time_step=" + step});
}

StepLimit limit_of(const Scene& scene) {
  return step_limit(scene, population_of(scene, grown_particles(scene, scene.box(), Boundaries(scene, scene.box()))));
}

double checked_step(const Scene& scene, std::vector<std::string>& warnings) {
  return checked_time_step(scene, limit_of(scene), warnings);
}

}  // namespace

TEST_CASE("the limit is 2/omega of the stiffest contact of the lightest pair") {
  const StepLimit limit = limit_of(scene_with_step("1 us"));
  // Hysteretic loading is on k (1 + g).
  CHECK(limit.limit == Approx(2 * std::sqrt(0.5 * light_mass / (1e6 * 1.7))));
  CHECK(limit.contact_time == Approx(std::numbers::pi * std::sqrt(0.5 * light_mass / 1e6)));
  CHECK(limit.recommended == Approx(0.17 * std::sqrt(light_mass / 1e6)));
  CHECK(limit.pair == "light - light");
}

TEST_CASE("a step beyond the limit is refused, one beyond the recommended one warned of, a good one passes") {
  std::vector<std::string> warnings;
  CHECK_THROWS_WITH(checked_step(scene_with_step("400 us"), warnings),
                    Contains("dynamics.time_step") && Contains("(2/omega)") && Contains("light - light"));
  CHECK(warnings.empty());
  CHECK(checked_step(scene_with_step("100 us"), warnings) == Approx(1e-4));
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Contains("34.1 us or less is recommended"));
  warnings.clear();
  CHECK(checked_step(scene_with_step("30 us"), warnings) == Approx(3e-5));
  CHECK(warnings.empty());
}

TEST_CASE("a stiff tangential spring and a strong dashpot lower the limit") {
  const auto limit_with = [](const std::vector<std::string>& set) {
    return limit_of(parse_scene(packstone::testing::small_scene, "s.toml", set));
  };
  const std::vector<std::string> friction = {
      "contact.tangential=cundall-strack", "material[0].tangential_stiffness=1e6",
      "material[1].tangential_stiffness=1e6", "material[0].friction=0.3", "material[1].friction=0.3"};
  CHECK(limit_with(friction).limit == Approx(2 * std::sqrt(0.5 * light_mass / 3.5e6)));
  const std::vector<std::string> dashpot = {"contact.normal=linear", "material[0].normal_damping=2000",
                                            "material[1].normal_damping=2000"};
  CHECK(limit_with(dashpot).limit == Approx(0.5 * light_mass / 2000));
  CHECK(limit_with(dashpot).recommended == Approx(0.25 * light_mass / 2000));
}

TEST_CASE("laws whose stiffness grows with the overlap are taken where the monitor stops") {
  std::string text = packstone::testing::small_scene;
  for (std::size_t at; (at = text.find("normal_damping = 0.7")) != std::string::npos;) {
    text.replace(at, 20, "restitution = 1\nyoung_modulus = 1e8\npoisson_ratio = 0.3");
  }
  const auto limit_at = [&](const std::string& overlap) {
    return limit_of(parse_scene(text, "s.toml", {"contact.normal=hertz", "monitor.overlap_limit=" + overlap})).limit;
  };
  const double modulus = 1e8 / (2 * 0.91), slope = 2 * std::sqrt(0.01) * modulus * std::sqrt(0.05 * 0.02);
  CHECK(limit_at("0.05") == Approx(2 * std::sqrt(0.5 * light_mass / slope)));
  CHECK(limit_at("0.0125") == Approx(std::sqrt(2.0) * limit_at("0.05")));
}

TEST_CASE("auto takes the recommended step") {
  std::vector<std::string> warnings;
  const Scene scene = scene_with_step("auto");
  CHECK(checked_step(scene, warnings) == limit_of(scene).recommended);
}
