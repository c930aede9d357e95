// Runs that go wrong stop with the cause in physical terms.
#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "engine/dynamics/make_particles.hpp"
#include "engine/monitor.hpp"
#include "engine/simulation.hpp"
#include "tests/sample_scene.hpp"

using namespace packstone;
using namespace packstone::engine;
using Catch::Matchers::Contains;
using packstone::testing::small_scene;

namespace {

std::string failure_of(const std::vector<std::string>& set) {
  Simulation simulation(parse_scene(small_scene, "s.toml", set));
  try {
    simulation.run({});
  } catch (const RunError& error) {
    return error.what();
  }
  return "no failure";
}

}  // namespace

TEST_CASE("a sound run is left alone") { CHECK(failure_of({}) == "no failure"); }

TEST_CASE("energy that nothing puts in stops the run") {
  // An undamped bed just below the limit of a single contact: its contacts together are beyond theirs.
  const std::string what = failure_of({"contact.normal=linear", "material[0].normal_damping=0",
                                       "material[1].normal_damping=0", "dynamics.time_step=275 us",
                                       "particles[0].count=120", "particles[1].count=120", "dynamics.duration=2 s",
                                       "output.interval=0.1 s", "filling.duration=50 ms", "monitor.overlap_limit=1"});
  CHECK_THAT(what, Contains("the energy grows") && Contains("t = ") && Contains("recommended is 34.1 us"));
}

TEST_CASE("too much overlap is reported with both particles, place and limit") {
  const std::string what = failure_of({"material[0].normal_stiffness=100", "material[1].normal_stiffness=100",
                                       "particles[0].count=200", "dynamics.duration=1 s", "output.interval=0.1 s"});
  CHECK_THAT(what, Contains("particle ") && Contains("overlap by") && Contains("monitor.overlap_limit = 5 %") &&
                       Contains("(light)"));
}

TEST_CASE("a particle that leaves through a closed face is named with the face") {
  const std::string what =
      failure_of({"domain.open=[]", "boundary[0].normal=[0, 0, 1]", "gravity.acceleration=[0, 0, 9.8]",
                  "dynamics.duration=1 s", "output.interval=0.1 s"});
  CHECK_THAT(what, Contains("particle ") && Contains("left the domain through the face z+") && Contains("domain.open"));
}

TEST_CASE("a particle gone for good through an open face is named") {
  const std::string what =
      failure_of({"gravity.acceleration=[0, 0, 500]", "dynamics.duration=1 s", "output.interval=0.1 s"});
  CHECK_THAT(what, Contains("nothing pulls it back"));
}

TEST_CASE("a particle thrown high above an open lid comes back when gravity pulls it") {
  const auto high = [](const std::vector<std::string>& set) {
    const Scene scene = parse_scene(small_scene, "s.toml", set);
    const Domain box = scene.box();
    const Vec3 above(0.1, 0.1, box.max[2] + 3 * box.size()[2]);
    const Particles p = make_particles(scene, {{above}, {Vec3::Zero()}, {Vec3::Zero()}, {0.02}, {0}, ""});
    Monitor(scene, box, 1e-5, 1e-5, 0).check_positions(p, 0.5);
  };
  CHECK_NOTHROW(high({}));
  CHECK_THROWS_WITH(high({"gravity.acceleration=[9.8, 0, 0]"}), Contains("nothing pulls it back"));
}

TEST_CASE("a position or an energy that is not a number is reported") {
  const Scene scene = parse_scene(small_scene, "s.toml");
  Monitor monitor(scene, scene.box(), 1e-5, 1e-5, 0);
  const Particles p = make_particles(scene, {{Vec3(0.1, 0.1, 0.1), Vec3(0.1, std::nan(""), 0.1)},
                                             {Vec3::Zero(), Vec3::Zero()},
                                             {Vec3::Zero(), Vec3::Zero()},
                                             {0.02, 0.02},
                                             {0, 1},
                                             ""});
  CHECK_THROWS_WITH(monitor.check_positions(p, 0.5), Contains("t = 0.5 s") && Contains("particle 1 (heavy)"));
  EnergyAccount account;
  account.kinetic = std::nan("");
  CHECK_THROWS_WITH(monitor.check_energy(account, p, 0.5), Contains("not a number"));
}
