#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "engine/dynamics/make_particles.hpp"
#include "engine/dynamics/step.hpp"
#include "engine/filling/growth.hpp"
#include "tests/sample_scene.hpp"

using namespace packstone;
using namespace packstone::engine;
using Catch::Matchers::Contains;
using packstone::testing::small_scene;

TEST_CASE("particles asked for are particles delivered, at random, in the region, in front of the floor") {
  const Scene scene = parse_scene(small_scene, "s.toml", {"boundary[0].point=[0, 0, 0.1]"});
  const Domain domain = scene.box();
  const StartingState p = grown_particles(scene, domain, Boundaries(scene, domain));
  REQUIRE(p.size() == 120);
  CHECK(std::count(p.type.begin(), p.type.end(), 0) == 60);
  CHECK(p.radius[119] == 0.02);
  CHECK(make_particles(scene, p).mass[119] == Approx(7800 * 4.0 / 3.0 * M_PI * 8e-6));
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3 x = p.position[i];
    CHECK(x.z() > 0.1);
    CHECK(((x - domain.min).array() >= 0).all());
    CHECK(((domain.max - x).array() >= 0).all());
    mean += x / 120.0;
  }
  // Four standard errors of a uniform distribution's mean.
  CHECK(mean.x() == Approx(0.1).margin(4 * 0.2 / std::sqrt(12.0 * 120)));
  CHECK(mean.z() == Approx(0.25).margin(4 * 0.3 / std::sqrt(12.0 * 120)));
}

TEST_CASE("the seed decides the positions, and a particle's place does not depend on the others") {
  const auto first = [](const std::vector<std::string>& set) {
    const Scene scene = parse_scene(small_scene, "s.toml", set);
    return grown_particles(scene, scene.box(), Boundaries(scene, scene.box())).position[5];
  };
  CHECK(first({}) == first({}));
  CHECK(first({}) == first({"particles[1].count=3"}));
  CHECK(first({}) != first({"seed=4"}));
}

TEST_CASE("radii grow in proportion to time and then stay") {
  const Scene scene = parse_scene(small_scene, "s.toml");
  CHECK(growth_at(scene, 0).scale == 0);
  CHECK(growth_at(scene, 20e-3).scale == Approx(0.5));
  CHECK(growth_at(scene, 20e-3).rate == Approx(25));
  CHECK(growth_at(scene, 40e-3).scale == 1);
  CHECK(growth_at(scene, 40e-3).rate == 0);
}

TEST_CASE("more volume than a random packing holds is refused before the run") {
  const auto refused = [](const std::vector<std::string>& set) {
    const Scene scene = parse_scene(small_scene, "s.toml", set);
    check_growth_volume(scene, scene.box());
  };
  CHECK_NOTHROW(refused({"particles[0].count=240"}));
  CHECK_THROWS_WITH(refused({"particles[0].count=260"}), Contains("do not fit") && Contains("0.64"));
  // Small spheres fill gaps.
  CHECK_NOTHROW(refused({"particles[0].count=240", "particles[1].count=8000", "particles[1].radius=0.003"}));
}

TEST_CASE("a floor that faces the wrong way is named") {
  const Scene scene =
      parse_scene(small_scene, "s.toml", {"boundary[0].point=[0, 0, 0]", "boundary[0].normal=[0, 0, -1]"});
  CHECK_THROWS_WITH(grown_particles(scene, scene.box(), Boundaries(scene, scene.box())),
                    Contains("direction of its normal"));
}
