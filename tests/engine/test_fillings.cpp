// Lattices and random places: where particles are, how many fit, and what is said when they do not.
#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/geometry.hpp"
#include "engine/dynamics/step.hpp"
#include "engine/filling/filling.hpp"
#include "engine/simulation.hpp"

using namespace packstone;
using namespace packstone::engine;
using Catch::Matchers::Contains;

namespace {

Scene filled_scene(const std::string& filling, const std::string& count, const std::string& radius,
                   const std::string& domain = "periodic = [\"x\", \"y\", \"z\"]", const std::string& further = "") {
  return parse_scene(
      "[dynamics]\nduration = 0.01\n[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n" + domain +
          "\n[contact]\nnormal = \"linear\"\n[[material]]\nname = \"m\"\ndensity = 1000\nnormal_stiffness = 1e6\n"
          "restitution = 0.5\n[[particles]]\nmaterial = \"m\"\ncount = " +
          count + "\nradius = " + radius + "\n[filling]\n" + filling + "\n[output]\ninterval = 0.01\n" + further,
      "s.toml");
}

StartingState filled(const Scene& scene) { return fill(scene, scene.box(), Boundaries(scene, scene.box())); }

/// Smallest gap between two surfaces, over periodic images [m].
double smallest_gap(const Scene& scene, const StartingState& s) {
  double gap = std::numeric_limits<double>::infinity();
  const Domain box = scene.box();
  for (std::size_t i = 0; i < s.size(); ++i) {
    for (std::size_t j = i + 1; j < s.size(); ++j) {
      gap = std::min(gap, box.separation(s.position[i], s.position[j]).norm() - s.radius[i] - s.radius[j]);
    }
  }
  return gap;
}

double solid(const StartingState& s) {
  double volume = 0;
  for (const double r : s.radius) volume += sphere_volume(r);
  return volume;
}

}  // namespace

TEST_CASE("a full lattice has its textbook density and touching neighbours") {
  struct Kind {
    std::string name;
    double density;
    int cells_of_a_box;  ///< sites in a box of 10 cells a side
    double spacing;      ///< of a box of 1 m with 10 cells a side
  };
  const Kind kind =
      GENERATE(Kind{"cubic", M_PI / 6, 1000, 0.1}, Kind{"bcc", M_PI * std::sqrt(3.0) / 8, 2000, 0.0866025},
               Kind{"fcc", M_PI / std::sqrt(18.0), 4000, 0.0707106});
  const Scene scene = filled_scene("kind = \"lattice\"\nlattice = \"" + kind.name + "\"",
                                   std::to_string(kind.cells_of_a_box), std::to_string(kind.spacing / 2));
  const StartingState s = filled(scene);
  REQUIRE(static_cast<int>(s.size()) == kind.cells_of_a_box);
  CHECK(solid(s) == Approx(kind.density).epsilon(1e-4));
  CHECK(smallest_gap(scene, s) >= -1e-9);
  CHECK(smallest_gap(scene, s) < 1e-5);
}

TEST_CASE("hexagonal close packing is stretched to periodic sides, and no neighbour is nearer than the spacing") {
  const Scene scene = filled_scene("kind = \"lattice\"\nlattice = \"hcp\"\nspacing = 0.1", "900", "0.05");
  const StartingState s = filled(scene);
  CHECK(smallest_gap(scene, s) >= -1e-12);
  CHECK(solid(s) > 0.45);
}

TEST_CASE("a lattice fills from the bottom, inside walls, with groups mixed") {
  const std::string walls =
      "[gravity]\n[[boundary]]\nname = \"floor\"\nkind = \"plane\"\npoint = [0, 0, 0.2]\nnormal = [0, 0, 1]\n"
      "[[particles]]\nname = \"other\"\nmaterial = \"m\"\ncount = 40\nradius = 0.03\n";
  const Scene scene = filled_scene("kind = \"lattice\"", "60", "0.05", "", walls);
  const StartingState s = filled(scene);
  double top = 0, others = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    CHECK(s.position[i].z() >= 0.25 - 1e-9);
    CHECK(s.position[i].x() >= 0.05 - 1e-9);
    CHECK(s.position[i].x() <= 0.95 + 1e-9);
    top = std::max(top, s.position[i].z());
    if (i >= 60) others += s.position[i].z() / 40;
  }
  // 100 sites in a layer of 10 x 10, so the second layer is not begun.
  CHECK(top == Approx(0.25).margin(0.051));
  CHECK(smallest_gap(scene, s) >= -1e-9);
  const auto first_others =
      std::count_if(s.position.begin() + 60, s.position.end(), [](const Vec3& p) { return p.x() < 0.5; });
  CHECK(first_others > 8);
  CHECK(first_others < 32);
}

TEST_CASE("a lattice that has not enough sites says how many there are") {
  CHECK_THROWS_WITH(filled(filled_scene("kind = \"lattice\"", "1001", "0.05")),
                    Contains("1001 particles are asked for, the lattice has 1000 sites"));
  CHECK_THROWS_WITH(filled(filled_scene("kind = \"lattice\"\nspacing = 0.09", "10", "0.05")),
                    Contains("filling.spacing") && Contains("would overlap"));
}

TEST_CASE("random places do not overlap, at any sizes, in periodic boxes and between walls") {
  const std::string domain = GENERATE("periodic = [\"x\", \"y\"]", "periodic = [\"x\"]", "");
  const std::string sizes = GENERATE("0.03", "{ distribution = \"uniform\", min = 0.004, max = 0.06 }",
                                     "{ distribution = \"list\", radii = [0.006, 0.12], shares = [300, 1] }");
  const std::string floor =
      "[[boundary]]\nname = \"wall\"\nkind = \"plane\"\npoint = [0, 0, 0.1]\nnormal = [0, 0, 1]\n";
  const Scene scene = filled_scene("kind = \"random\"", "900", sizes, domain, floor);
  const StartingState s = filled(scene);
  REQUIRE(s.size() == 900);
  CHECK(smallest_gap(scene, s) >= 0);
  for (std::size_t i = 0; i < s.size(); ++i) {
    CHECK(s.position[i].z() >= 0.1 + s.radius[i] * (1 - 1e-9));
    if (domain.empty()) CHECK(s.position[i].x() + s.radius[i] <= 1 + 1e-9);
  }
  const StartingState again = filled(scene);
  CHECK(std::equal(s.position.begin(), s.position.end(), again.position.begin()));
}

TEST_CASE("random places that run out say how many were found") {
  try {
    filled(filled_scene("kind = \"random\"", "2000", "0.05"));
    FAIL("no error");
  } catch (const InputError& error) {
    CHECK_THAT(error.what(), Contains("of 2000 particles found a place"));
    // The saturation of random sequential addition is 0.384; a search that gives up is somewhat below.
    const std::string text = error.what();
    const double fraction = std::stod(text.substr(text.find("fraction of ") + 12));
    CHECK(fraction > 0.33);
    CHECK(fraction < 0.385);
  }
}

TEST_CASE("a bed from a lattice and one from random places run, with every field that can be asked for") {
  const std::string filling = GENERATE("kind = \"lattice\"", "kind = \"random\"");
  const std::string further =
      "fields = [\"velocity\", \"angular_velocity\", \"force\", \"acceleration\", \"angular_acceleration\", \"mass\", "
      "\"full_radius\", \"moment_of_inertia\", \"kinetic_translational\", \"kinetic_rotational\", \"elastic\", "
      "\"gravitational\"]\n[gravity]\n"
      "[[boundary]]\nname = \"floor\"\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";
  Scene scene = filled_scene(filling, "200", "0.05", "periodic = [\"x\", \"y\"]", further);
  scene.dynamics.duration = 0.3;
  scene.output.interval = 0.1;
  scene.contact.tangential = TangentialModel::coulomb;
  scene.materials[0].friction = 0.4;
  Simulation simulation(scene);
  std::vector<double> row;
  std::vector<std::string> names;
  SimulationEvents events;
  events.history = [&](const auto& columns, const auto& values) {
    names = columns;
    row = values;
  };
  int snapshots = 0;
  events.snapshot = [&](const Snapshot& s) {
    ++snapshots;
    const auto total = [&](const std::string& name) {
      const auto& values = s.fields.at(name).values;
      REQUIRE(values.size() == 200);
      double sum = 0;
      for (const double v : values) sum += v;
      return sum;
    };
    const auto history = [&](const std::string& name) {
      return row.at(static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()));
    };
    REQUIRE(s.fields.size() == 12);
    for (const char* energy : {"kinetic_translational", "kinetic_rotational", "elastic", "gravitational"}) {
      INFO(energy << " at " << s.time << " s");
      CHECK(total(energy) == Approx(history(energy)).epsilon(1e-9).margin(1e-12));
    }
    CHECK(total("mass") == Approx(200 * 1000 * sphere_volume(0.05)));
    CHECK(total("moment_of_inertia") == Approx(200 * 0.4 * 1000 * sphere_volume(0.05) * 0.0025));
    CHECK(s.fields.at("acceleration").values[3] * s.fields.at("mass").values[1] ==
          Approx(s.fields.at("force").values[3]).margin(1e-12));
    CHECK(s.fields.at("angular_acceleration").values.size() == 600);
  };
  simulation.run(events);
  CHECK(snapshots == 4);
}
