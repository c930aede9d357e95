// The energy account: what goes in is stored or dissipated, the better the smaller the step.
#include <cmath>

#include <catch2/catch.hpp>

#include "engine/simulation.hpp"
#include "tests/sample_scene.hpp"

using namespace packstone;
using namespace packstone::engine;
using testing::small_scene;

namespace {

struct Account {
  double input = 0, stored = 0, dissipated = 0, error = 0;
};

Account account_of(const std::vector<std::string>& set) {
  Simulation simulation(parse_scene(small_scene, "s.toml", set));
  Account account;
  SimulationEvents events;
  events.history = [&](const std::vector<std::string>& names, const std::vector<double>& row) {
    const auto value = [&](const char* name) {
      return row[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
    };
    account.input = value("growth_work") + value("gravity_work");
    account.stored = value("kinetic_translational") + value("kinetic_rotational") + value("elastic");
    account.dissipated = value("dissipated");
    account.error = value("energy_error");
    REQUIRE(account.stored + account.dissipated - account.input ==
            Approx(account.error).margin(1e-9 * std::abs(account.input)));
  };
  simulation.run(events);
  return account;
}

}  // namespace

TEST_CASE("the energy balance of growth and settling closes as the step goes to zero") {
  const std::string law = GENERATE("hysteretic", "linear");
  const std::vector<std::string> common = {"contact.normal=" + law,
                                           "contact.tangential=cundall-strack",
                                           "material[0].tangential_stiffness=1e6",
                                           "material[1].tangential_stiffness=1e6",
                                           "material[0].friction=0.3",
                                           "material[1].friction=0.3",
                                           "dynamics.duration=120 ms",
                                           "monitor.overlap_limit=0.2"};
  const auto at_step = [&](const char* step) {
    auto set = common;
    set.push_back(std::string("dynamics.time_step=") + step);
    if (law == "linear") set.insert(set.end(), {"material[0].normal_damping=15", "material[1].normal_damping=40"});
    return account_of(set);
  };
  const Account coarse = at_step("16 us"), fine = at_step("2 us");
  INFO("input " << fine.input << " J, error " << coarse.error << " J at 16 us, " << fine.error << " J at 2 us");
  CHECK(fine.input > 0);
  CHECK(fine.dissipated > 0.2 * fine.input);
  CHECK(std::abs(fine.error) < 0.002 * fine.input);
  CHECK(std::abs(fine.error) < 0.5 * std::abs(coarse.error));
}
