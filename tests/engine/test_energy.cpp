// The energy account: what goes in is stored or dissipated, the better the smaller the step.
#include <cmath>

#include <catch2/catch.hpp>

#include "engine/simulation.hpp"
#include "tests/sample_scene.hpp"

using namespace packstone;
using namespace packstone::engine;
using packstone::testing::small_scene;

namespace {

struct Account {
  double input = 0, stored = 0, dissipated = 0, error = 0;
};

Account account_of(const std::vector<std::string>& set, const std::string& text = small_scene) {
  Simulation simulation(parse_scene(text, "s.toml", set));
  Account account;
  SimulationEvents events;
  events.history = [&](const std::vector<std::string>& names, const std::vector<double>& row) {
    const auto value = [&](const char* name) {
      return row[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
    };
    account.input = value("growth_work") + value("gravity_work");
    account.stored =
        value("kinetic_translational") + value("kinetic_rotational") + value("elastic") + value("attractive");
    account.dissipated = value("dissipated");
    REQUIRE(account.dissipated == Approx(value("dissipated_normal") + value("dissipated_tangential")).epsilon(1e-12));
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

TEST_CASE("the energy balance closes with every other law, walls, sizes and attraction too") {
  // Contacts that end while a dashpot pulls would drop what friction holds then (docs/physics.md).
  struct Laws {
    std::string normal, damping, tangential, attraction;
  };
  const Laws laws = GENERATE(Laws{"hertz\"\nrelease = \"zero-force", "restitution = 0.5", "mindlin-deresiewicz", ""},
                             Laws{"kuwabara-kono", "dissipation_time = 2e-5", "haff-werner", ""},
                             Laws{"walton-braun", "restitution = 0.5", "walton-braun", ""},
                             Laws{"hysteretic\"\nsign_speed = \"0.05 m/s", "normal_damping = 0.7", "coulomb", ""},
                             Laws{"hertz", "restitution = 0.5", "none",
                                  "[contact.van_der_waals]\nhamaker = 1e-7\nmin_gap = 1e-4\ncutoff = 2e-3\n"});
  std::string text = small_scene;
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
      text.replace(at, from.size(), to);
    }
  };
  replace("normal = \"hysteretic\"",
          "normal = \"" + laws.normal + "\"\ntangential = \"" + laws.tangential + "\"\n" + laws.attraction);
  replace("normal_damping = 0.7", laws.damping +
                                      "\nfriction = 0.3\nyoung_modulus = 3e7\npoisson_ratio = 0.3\n"
                                      "tangential_stiffness = 1e6\ntangential_damping = 20");
  const auto at_step = [&](const char* step) {
    return account_of({"dynamics.duration=120 ms", "monitor.overlap_limit=0.2", "particles[1].radius=0.012",
                       "dynamics.time_step=" + std::string(step)},
                      text);
  };
  const Account coarse = at_step("8 us"), fine = at_step("1 us");
  INFO(laws.normal << ", " << laws.tangential << ": input " << fine.input << " J, error " << coarse.error
                   << " J at 8 us, " << fine.error << " J at 1 us");
  CHECK(fine.dissipated > 0.2 * fine.input);
  CHECK(std::abs(fine.error) < 0.002 * fine.input);
  CHECK(std::abs(fine.error) < 0.5 * std::abs(coarse.error));
}
