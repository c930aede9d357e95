// What packstone check tells, against closed forms.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "core/geometry.hpp"
#include "engine/contact/collision.hpp"
#include "engine/scene_check.hpp"
#include "tests/sample_scene.hpp"

using namespace packstone;
using namespace packstone::engine;
using Catch::Matchers::Contains;

namespace {

SceneCheck checked(const std::vector<std::string>& set = {},
                   const std::string& text = packstone::testing::small_scene) {
  return check_scene(parse_scene(text, "s.toml", set));
}

/// The simplification of a key, if there is one.
const Simplification* of_key(const SceneCheck& check, const std::string& key) {
  for (const Simplification& s : check.simplifications) {
    if (s.key == key) return &s;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("check knows the particles, the steps and the cost") {
  const SceneCheck c = checked();
  CHECK(c.particles == 120);
  CHECK(c.solid_volume == Approx(120 * sphere_volume(0.02)));
  CHECK(c.mass == Approx(60 * 9000 * sphere_volume(0.02)));
  CHECK(c.steps == 4000);
  CHECK(c.snapshots == 5);
  CHECK(c.memory == Approx(120 * 550));
  CHECK(c.reference_speed == Approx(std::sqrt(2 * 9.8 * 0.4)));
  CHECK(c.pairs.size() == 5);  // three of groups, two with the floor
}

TEST_CASE("check's impacts have the law's restitution, contact time and overlap") {
  const SceneCheck c = checked();
  const double light = 1200 * sphere_volume(0.02), root = std::sqrt(0.5 * light / 1e6);
  const double e = hysteretic_restitution(0.7);
  const PairCheck& pair = c.pairs.front();
  CHECK(pair.pair == "light - light");
  CHECK(pair.effective_mass == Approx(0.5 * light));
  CHECK(pair.impact.restitution == Approx(e).epsilon(2e-3));
  const double duration = 0.5 * std::numbers::pi * root * (1 / std::sqrt(1.7) + 1 / std::sqrt(0.3));
  CHECK(pair.impact.duration == Approx(duration).epsilon(2e-3));
  CHECK(pair.overlap_share * 0.02 == Approx(c.reference_speed * root / std::sqrt(1.7)).epsilon(1e-3));
  CHECK(pair.steps == Approx(duration / 20e-6).epsilon(2e-3));
}

TEST_CASE("check's impacts follow every law") {
  MaterialSpec m;
  m.normal_stiffness = 1e6;
  m.unloading_stiffness = 4e6;
  m.young_modulus = 1e8;
  m.poisson_ratio = 0.3;
  m.dissipation_time = 0;
  const PairSize<double> size{2 / 0.03, 0.01};
  Scene scene = parse_scene(packstone::testing::small_scene, "s.toml");
  scene.contact.normal = NormalModel::walton_braun;
  CHECK(impact_of(scene, m, m, size, 1.0).restitution == Approx(0.5).epsilon(2e-3));
  scene.contact.normal = NormalModel::kuwabara_kono;
  const double K = 4.0 / 3 * std::sqrt(0.01) * 1e8 / (2 * 0.91);
  const Impact elastic = impact_of(scene, m, m, size, 1.0);
  CHECK(elastic.restitution == Approx(1).epsilon(1e-4));
  CHECK(elastic.duration == Approx(3.2180 * std::pow(0.015 / K, 0.4)).epsilon(2e-3));
  m.dissipation_time = 1e-4;
  CHECK(impact_of(scene, m, m, size, 1.0).restitution < 0.9);
}

TEST_CASE("check tells the overlap at rest, and what a softer contact would save") {
  const SceneCheck c =
      checked({"material[0].normal_stiffness=1e9", "material[1].normal_stiffness=1e9", "dynamics.time_step=0.5 us"});
  // A column of the bed on one heavy sphere.
  const double bed = c.solid_volume / (0.6 * 0.04), heavy = 7800 * sphere_volume(0.02);
  CHECK(c.resting_overlap.value() == Approx(std::max(1.0, bed / 0.04) * heavy * 9.8 / 1e9 / 0.02));
  REQUIRE(of_key(c, "normal_stiffness"));
  CHECK_FALSE(of_key(checked(), "normal_stiffness"));
  Scene softer = parse_scene(
      packstone::testing::small_scene, "s.toml",
      {"material[0].normal_stiffness=1e9", "material[1].normal_stiffness=1e9", "dynamics.time_step=0.5 us"});
  of_key(c, "normal_stiffness")->apply(softer);
  const SceneCheck after = check_scene(softer);
  double deepest = *after.resting_overlap;
  for (const PairCheck& pair : after.pairs) deepest = std::max(deepest, pair.overlap_share);
  CHECK(deepest == Approx(0.005).epsilon(2e-3));
  CHECK(after.pairs.front().impact.restitution == Approx(c.pairs.front().impact.restitution).epsilon(2e-3));
  CHECK(after.pairs.front().steps == Approx(c.pairs.front().steps).epsilon(2e-3));
  const SceneCheck slow = checked({"dynamics.time_step=1 us"});
  REQUIRE(of_key(slow, "dynamics.time_step"));
  CHECK_THAT(of_key(slow, "dynamics.time_step")->why, Contains("34.1 us"));
}

TEST_CASE("check tells the Bond number, and when attraction may be left out") {
  const std::string attraction = "normal = \"hysteretic\"\n[contact.van_der_waals]\nhamaker = ";
  const auto with = [&](const std::string& hamaker) {
    return checked({}, packstone::testing::small_scene_with("normal = \"hysteretic\"", attraction + hamaker));
  };
  const SceneCheck weak = with("1e-19");
  const double light = 1200 * sphere_volume(0.02);
  CHECK(weak.bond_number.value() == Approx(1e-19 * 0.01 / 6e-18 / (light * 9.8)));
  CHECK(of_key(weak, "contact.van_der_waals"));
  CHECK_FALSE(of_key(with("1e-13"), "contact.van_der_waals"));
  CHECK_FALSE(checked().bond_number.has_value());
}

TEST_CASE("check says what has no effect, and passes warnings on") {
  const SceneCheck c = checked({"contact.tangential=coulomb"});
  CHECK(of_key(c, "contact.tangential"));
  const SceneCheck rough =
      checked({"contact.tangential=coulomb", "material[0].friction=0.5", "material[1].friction=0.5"});
  CHECK_FALSE(of_key(rough, "contact.tangential"));
  REQUIRE(rough.warnings.size() == 1);
  CHECK_THAT(rough.warnings[0], Contains("no static friction"));
}

TEST_CASE("A run that is to end at rest may be one to rest, unless something depends on the way") {
  const std::string rest = "dynamics.rest_speed=0.001";
  CHECK(of_key(checked({rest}), "dynamics.goal"));
  CHECK_FALSE(of_key(checked(), "dynamics.goal"));
  CHECK_FALSE(of_key(checked({rest, "gravity.end=1"}), "dynamics.goal"));
  CHECK_FALSE(
      of_key(checked({rest, "contact.tangential=coulomb", "material[0].friction=0.5", "material[1].friction=0.5"}),
             "dynamics.goal"));
}

TEST_CASE("A simplified scene is one that can be read back and run, and keeps what it is told to keep") {
  const std::vector<std::string> keys = {"dynamics.rest_speed=0.001", "dynamics.time_step=1 us",
                                         "contact.tangential=coulomb"};
  const Scene scene = parse_scene(packstone::testing::small_scene, "s.toml", keys);
  const SceneCheck c = checked(keys);
  const Scene simple = simplified(scene, c.simplifications, {"dynamics.time_step"});
  CHECK(simple.dynamics.goal == Goal::rest);
  CHECK(simple.dynamics.time_step == 1e-6);
  CHECK(simple.contact.tangential == TangentialModel::none);
  CHECK(to_toml(parse_scene(to_toml(simple), "simple")) == to_toml(simple));
}

TEST_CASE("Single precision is offered where it rounds next to nothing of a weight") {
  CHECK_FALSE(of_key(
      checked({"material[0].normal_stiffness=1e8", "material[1].normal_stiffness=1e8", "dynamics.time_step=2 us"}),
      "dynamics.precision"));
  const SceneCheck soft = checked({"material[0].normal_stiffness=1e4", "material[1].normal_stiffness=1e4"});
  CHECK(of_key(soft, "dynamics.precision"));
}
