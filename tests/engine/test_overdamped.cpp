// Overdamped motion against what is known of it exactly.
#include <Eigen/Eigenvalues>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <omp.h>

#include "core/error.hpp"
#include "engine/dynamics/make_particles.hpp"
#include "engine/dynamics/overdamped.hpp"
#include "engine/simulation.hpp"

using namespace packstone;
using namespace packstone::engine;
using Catch::Contains;

namespace {

constexpr double radius = 0.02, density = 1200, resistance_of_each = 3.7, stiffness = 1e4;
const double full_mass = density * 4 / 3 * std::numbers::pi * radius * radius * radius;
const double weight = full_mass * 9.8;

const std::string floor_plane =
    "[[boundary]]\nname = \"floor\"\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";

/// dynamics: further keys of that table; further: other tables.
Scene scene_of(const std::string& dynamics, const std::string& further = "", const std::string& contact = "") {
  return parse_scene("[dynamics]\nkind = \"overdamped\"\nduration = 1\n" + dynamics + R"(
[domain]
min = [0, 0, 0]
max = [1, 1, 1]
[contact]
)" + (contact.empty() ? "normal = \"linear\"\n" : contact) +
                         R"(
[[material]]
name = "m"
density = 1200
normal_stiffness = 1e4
young_modulus = 1e6
poisson_ratio = 0.3
[[particles]]
material = "m"
count = 1
radius = 0.02
[filling]
kind = "random"
[gravity]
acceleration = [0, 0, -9.8]
[output]
interval = 0.1
)" + further,
                     "overdamped");
}

Scene with_constant(const std::string& integrator, double time_step, const std::string& further = "",
                    const std::string& contact = "") {
  return scene_of("viscosity = 3.7\ntolerance = 1e-6\nintegrator = \"" + integrator +
                      fmt::format("\"\ntime_step = {}\n", time_step),
                  further, contact);
}

/// Spheres placed by hand, moved for a time.
class ByHand {
 public:
  ByHand(const Scene& scene, const std::vector<Vec3>& positions) : scene_(scene), boundaries_(scene, scene.box()) {
    StartingState start;
    start.position = positions;
    start.velocity.assign(positions.size(), Vec3::Zero());
    start.angular_velocity = start.velocity;
    start.radius.assign(positions.size(), radius);
    start.type.assign(positions.size(), 0);
    particles_ = make_particles(scene, start);
    const double bed_rate = 10 * stiffness / resistance_of_each;
    dynamics_ = make_overdamped(scene_, scene.box(), boundaries_, scene.dynamics.integrator, bed_rate);
  }

  void go_on(double duration) {
    StepInput input{duration, {}, Vec3(0, 0, -9.8), 0.5, 0.0};
    boundaries_.go_to(time_, duration, 0);
    if (dynamics_->outdated({})) dynamics_->rebuild(particles_, {}, duration);
    dynamics_->advance(particles_, input, nullptr);
    passed = *dynamics_->go_on(particles_, input, time_);
    time_ += duration;
  }

  Vec3 position(std::int32_t id) const {
    const auto at = std::find(particles_.id.begin(), particles_.id.end(), id) - particles_.id.begin();
    return particles_.now.rows[static_cast<std::size_t>(at)].position;
  }
  IntegratorWork work() const { return dynamics_->work(); }

  StepSums passed;

 private:
  Scene scene_;
  Boundaries boundaries_;
  Particles particles_;
  std::unique_ptr<Dynamics> dynamics_;
  double time_ = 0;
};

/// Heights of a chain of equal spheres on a floor, every contact closed, a time after they were at z0: what
/// mu dz/dt = -K z + b gives, from K's eigenvectors.
Eigen::VectorXd chain_after(const Eigen::VectorXd& z0, double time) {
  const auto n = z0.size();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd b = Eigen::VectorXd::Constant(n, -weight);
  K(0, 0) += stiffness;
  b(0) += stiffness * radius;
  for (Eigen::Index i = 0; i + 1 < n; ++i) {
    K.block(i, i, 2, 2) += stiffness * (Eigen::Matrix2d() << 1, -1, -1, 1).finished();
    b(i) -= stiffness * 2 * radius;
    b(i + 1) += stiffness * 2 * radius;
  }
  const Eigen::VectorXd rest = K.ldlt().solve(b);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(K);
  const Eigen::VectorXd decay = (-time / resistance_of_each * modes.eigenvalues()).array().exp();
  return rest + modes.eigenvectors() * decay.asDiagonal() * modes.eigenvectors().transpose() * (z0 - rest);
}

Eigen::VectorXd chain_at_start() {
  Eigen::VectorXd z(5);
  z << 0.99, 2.965, 4.94, 6.93, 8.9;  // radii: pressed, unevenly
  return radius * z;
}

double chain_error(const std::string& integrator, double time_step) {
  constexpr double time = 4e-3;  // 11 mu/k
  const Eigen::VectorXd z0 = chain_at_start();
  std::vector<Vec3> positions;
  for (const double z : z0) positions.emplace_back(0.5, 0.5, z);
  ByHand chain(with_constant(integrator, time_step, floor_plane), positions);
  chain.go_on(time);
  const Eigen::VectorXd exact = chain_after(z0, time);
  double error = 0;
  for (Eigen::Index i = 0; i < z0.size(); ++i) {
    error = std::max(error, std::abs(chain.position(static_cast<std::int32_t>(i)).z() - exact(i)));
  }
  return error / radius;
}

struct BedRun {
  Snapshot last;
  std::vector<std::map<std::string, double>> history;
  std::string ending;
  std::vector<std::string> warnings;
};

BedRun run_bed(const Scene& scene) {
  Simulation simulation(scene);
  BedRun ran;
  SimulationEvents events;
  events.snapshot = [&](const Snapshot& s) { ran.last = s; };
  events.history = [&](const auto& columns, const auto& row) {
    ran.history.emplace_back();
    for (std::size_t k = 0; k < row.size(); ++k) ran.history.back()[columns[k]] = row[k];
  };
  simulation.run(events);
  ran.ending = simulation.ending();
  ran.warnings = simulation.warnings();
  return ran;
}

}  // namespace

TEST_CASE("a sphere sinks at its weight over its resistance, constant or Stokes'") {
  const double stokes = 6 * std::numbers::pi * radius * 0.5;
  for (const std::string integrator : {"euler", "rkc", "implicit"}) {
    for (const auto& [key, resistance] : {std::pair{"viscosity = 3.7", 3.7}, {"stokes_viscosity = 0.5", stokes}}) {
      ByHand one(scene_of(key + std::string("\nintegrator = \"") + integrator + "\"\n"), {Vec3(0.5, 0.5, 0.9)});
      const double time = 0.3;
      one.go_on(time);
      CHECK(0.9 - one.position(0).z() == Approx(time * weight / resistance).epsilon(1e-10));
      // All that gravity gives goes into the fluid.
      CHECK(one.passed.dissipated_resistance == Approx(one.passed.gravity_work).epsilon(1e-10));
    }
  }
}

TEST_CASE("a group's own resistance comes before the scene's") {
  const Scene scene = scene_of("viscosity = 3.7\n");
  Scene own = scene;
  own.particles[0].resistance.fluid_viscosity = 2;
  CHECK(resistance(scene, 0, radius) == 3.7);
  CHECK(resistance(own, 0, radius) == Approx(12 * std::numbers::pi * radius));
}

TEST_CASE("a pressed pair relaxes as an exponential") {
  for (const std::string integrator : {"euler", "rkc", "implicit"}) {
    const double overlap = 0.02 * radius, time = 5e-4, rate = 2 * stiffness / resistance_of_each;
    Scene scene = with_constant(integrator, integrator == "rkc" ? 1e-5 : 1e-7);
    scene.gravity.present = false;
    ByHand pair(scene, {Vec3(0.5, 0.5, 0.5), Vec3(0.5 + 2 * radius - overlap, 0.5, 0.5)});
    pair.go_on(time);
    const double left = 2 * radius - (pair.position(1) - pair.position(0)).norm();
    CHECK(left == Approx(overlap * std::exp(-rate * time)).epsilon(2e-3));
  }
}

TEST_CASE("a chain on a floor relaxes as the linear system's exponential, each integrator with its order") {
  const auto order = [](const std::string& integrator, double step) {
    return std::log2(chain_error(integrator, step) / chain_error(integrator, 0.5 * step));
  };
  CHECK(order("euler", 5e-5) == Approx(1).margin(0.1));
  CHECK(order("implicit", 5e-5) == Approx(1).margin(0.1));
  CHECK(order("rkc", 6.25e-5) == Approx(2).margin(0.1));  // of two stages; more of them have another error's factor
  CHECK(chain_error("euler", 1e-5) < 1e-4);
  CHECK(chain_error("rkc", 1e-4) < 1e-4);
  CHECK(chain_error("implicit", 1e-5) < 1e-4);
}

TEST_CASE("steps chosen by tolerance bring the chain to rest, long ones where the method can") {
  std::map<std::string, std::int64_t> steps;
  for (const std::string integrator : {"euler", "rkc", "implicit"}) {
    std::vector<Vec3> positions;
    for (const double z : chain_at_start()) positions.emplace_back(0.5, 0.5, z);
    ByHand chain(scene_of("viscosity = 3.7\nintegrator = \"" + integrator + "\"\n", floor_plane), positions);
    chain.go_on(1.0);
    const Eigen::VectorXd rest = chain_after(chain_at_start(), 1.0);
    for (int i = 0; i < 5; ++i) CHECK(std::abs(chain.position(i).z() - rest(i)) < 1e-5 * radius);
    steps[integrator] = chain.work().steps;
  }
  CHECK(steps["euler"] > 2000);
  CHECK(steps["rkc"] < 200);
  CHECK(steps["implicit"] < 50);
}

TEST_CASE("a Hertzian sphere on a floor comes to rest under its weight") {
  for (const std::string integrator : {"euler", "rkc", "implicit"}) {
    ByHand one(scene_of("viscosity = 3.7\nintegrator = \"" + integrator + "\"\n", floor_plane, "normal = \"hertz\"\n"),
               {Vec3(0.5, 0.5, 0.999 * radius)});
    one.go_on(2.0);
    const double effective = 1e6 / (2 * (1 - 0.09));
    const double overlap = std::pow(weight / (4.0 / 3 * std::sqrt(radius) * effective), 2.0 / 3);
    CHECK(radius - one.position(0).z() == Approx(overlap).epsilon(1e-3));
  }
}

namespace {

/// Spheres falling onto a floor between periodic sides.
Scene bed_scene(const std::string& dynamics, int count, const std::string& filling = "kind = \"random\"",
                const std::string& particles = "radius = 0.01", const std::string& gravity = "") {
  return parse_scene(fmt::format(R"(
[dynamics]
kind = "overdamped"
viscosity = 3.7
{}
[domain]
min = [0, 0, 0]
max = [0.12, 0.12, 0.5]
periodic = ["x", "y"]
open = ["z+"]
[gravity]
{}
[contact]
normal = "linear"
[[material]]
name = "m"
density = 2500
normal_stiffness = 1e4
young_modulus = 1e6
poisson_ratio = 0.3
[[particles]]
material = "m"
count = {}
{}
[filling]
{}
{}
[output]
interval = 10
history_interval = 0.1
)",
                                 dynamics, gravity, count, particles, filling, floor_plane),
                     "bed");
}

}  // namespace

TEST_CASE("overdamped motion has the same bits for any number of threads") {
  const int threads = omp_get_max_threads();
  for (const std::string integrator : {"euler", "rkc", "implicit"}) {
    std::vector<std::vector<Vec3>> ends;
    for (const int count : {1, 2}) {
      omp_set_num_threads(count);
      ends.push_back(run_bed(bed_scene("duration = 0.05\nintegrator = \"" + integrator + "\"", 1000,
                                       "kind = \"lattice\"\nlattice = \"bcc\"", "radius = 0.0095"))
                         .last.position);
    }
    CHECK(ends[0] == ends[1]);
  }
  omp_set_num_threads(threads);
}

TEST_CASE("a bed ends at rest by the balance of forces") {
  const BedRun ran = run_bed(bed_scene("duration = 60\nrest_force = 1e-3\nintegrator = \"rkc\"", 150));
  const auto& last = ran.history.back();
  CHECK_THAT(ran.ending, Contains("at rest") && !Contains("not at rest"));
  CHECK(last.at("time") < 59);
  CHECK(last.at("unbalanced_force") < 1e-3);
  CHECK(last.at("kinetic_translational") == 0);
  // The floor carries all of them.
  const double bed_weight = 150 * 2500 * 4.0 / 3 * std::numbers::pi * 1e-6 * 9.8;
  CHECK(-last.at("floor.force_z") == Approx(bed_weight).epsilon(1e-4));
  CHECK(last.at("dissipated") == Approx(last.at("gravity_work") - last.at("elastic")).epsilon(1e-2));
  CHECK_THAT(run_bed(bed_scene("rest_force = 1e-3\nduration = 0.2", 20)).ending, Contains("not at rest"));
}

TEST_CASE("backward Euler takes spheres that just touch for what they are") {
  // A gap that rounds to nothing although the squares say that they overlap.
  const double reach = radius + radius;
  Vec3 apart(reach, 0, 0);
  for (int k = 1; k < 100000; ++k) {
    apart.y() = 1e-9 * k;
    apart.x() = std::sqrt(reach * reach - apart.y() * apart.y());
    if (apart.squaredNorm() < reach * reach && apart.norm() == reach) break;
  }
  REQUIRE(apart.squaredNorm() < reach * reach);
  REQUIRE(apart.norm() == reach);
  const Vec3 first(0.5, 0.5, radius);
  ByHand two(scene_of("viscosity = 3.7\nintegrator = \"implicit\"\n", floor_plane), {first, first + apart});
  two.go_on(1.0);
  const double overlap = weight / stiffness;
  for (int i = 0; i < 2; ++i) CHECK(radius - two.position(i).z() == Approx(overlap).epsilon(1e-2));
  CHECK(two.work().steps < 50);
}

TEST_CASE("backward Euler lets no sphere into the floor and ends in the bed of the others") {
  constexpr int seeds = 5;
  std::map<std::string, double> fraction, coordination;
  for (const std::string integrator : {"rkc", "implicit"}) {
    for (int seed = 1; seed <= seeds; ++seed) {
      Scene scene = bed_scene("duration = 60\nrest_force = 3e-2\nintegrator = \"" + integrator + "\"", 100);
      scene.seed = seed;
      const BedRun ran = run_bed(scene);
      CAPTURE(integrator, seed);
      CHECK_THAT(ran.ending, !Contains("not at rest"));
      double deepest = 0;
      for (const auto& row : ran.history) deepest = std::max(deepest, row.at("max_overlap"));
      CHECK(deepest < 0.03);  // the bed's weight presses by 0.01
      if (integrator == "implicit") CHECK(ran.history.back().at("force_evaluations") < 10000);
      fraction[integrator] += ran.history.back().at("packing_fraction") / seeds;
      coordination[integrator] += ran.history.back().at("coordination") / seeds;
    }
  }
  // So few spheres differ much from seed to seed; docs/overdamped.md has closer figures of larger beds.
  CHECK(fraction["implicit"] == Approx(fraction["rkc"]).margin(0.015));
  CHECK(coordination["implicit"] == Approx(coordination["rkc"]).margin(0.4));
}

TEST_CASE("overdamped spheres grow into a bed, with an account that closes") {
  const auto [integrator, law] = GENERATE(table<std::string, NormalModel>({{"euler", NormalModel::linear},
                                                                           {"rkc", NormalModel::linear},
                                                                           {"rkc", NormalModel::hertz},
                                                                           {"implicit", NormalModel::linear},
                                                                           {"implicit", NormalModel::hertz}}));
  Scene scene = bed_scene("duration = 6\nintegrator = \"" + integrator + "\"", 100,
                          "kind = \"growth\"\nduration = 2\nregion_min = [0, 0, 0]\nregion_max = [0.12, 0.12, 0.06]",
                          "radius = 0.01", "start = 2");
  scene.contact.normal = law;
  scene.materials[0].young_modulus = 1e7;
  const BedRun ran = run_bed(scene);
  CAPTURE(integrator, law);
  const auto& last = ran.history.back();
  CHECK(last.at("growth_work") > 0);
  CHECK(std::abs(last.at("energy_error")) < 0.05 * (last.at("growth_work") + last.at("gravity_work")));
  CHECK(last.at("max_overlap") < 0.03);
  CHECK(last.at("packing_fraction") == Approx(0.64).margin(0.04));
}

TEST_CASE("an explicit step beyond what a bed allows is refused, warned of, or stopped in plain words") {
  CHECK_THROWS_WITH(run_bed(bed_scene("duration = 60\nintegrator = \"euler\"\ntime_step = 5e-4", 50)),
                    Contains("beyond explicit Euler's limit, 0.00037 s") && Contains("t_0 = mu/k = 0.00037 s"));
  Scene scene = bed_scene("integrator = \"euler\"\ntime_step = 3.6e-4\nduration = 20", 150);
  scene.monitor.overlap_limit = 0.9;
  CHECK_THROWS_WITH(run_bed(scene), Contains("t = ") && Contains("explicit"));
  CHECK(Simulation(scene).warnings().size() == 1);
}

TEST_CASE("what does not go with overdamped motion is refused, and the other way round") {
  const auto refused = [](const std::string& dynamics, const std::string& further, const std::string& contact) {
    try {
      scene_of(dynamics, further, contact);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("taken");
  };
  const std::string mu = "viscosity = 3.7\n";
  CHECK_THAT(refused("", "", ""), Contains("needs viscosity"));
  CHECK_THAT(refused(mu + "stokes_viscosity = 1\n", "", ""), Contains("keep one of the two"));
  CHECK_THAT(refused(mu, "", "normal = \"hysteretic\"\n"),
             Contains("contact.normal: does not go with") && Contains("take that"));
  CHECK_THAT(refused(mu, "", "normal = \"kuwabara-kono\"\n"), Contains("is \"hertz\""));
  CHECK_THAT(refused(mu, "", "normal = \"walton-braun\"\n"), Contains("largest overlap"));
  CHECK_THAT(refused(mu, "", "normal = \"linear\"\ntangential = \"coulomb\"\n"), Contains("neither turn nor rub"));
  CHECK_THAT(refused(mu, "", "normal = \"linear\"\n[contact.van_der_waals]\nhamaker = 1e-19\n"),
             Contains("only repel"));
  CHECK_THAT(refused(mu + "rest_speed = 1\n", "", ""), Contains("take rest_force"));
  CHECK_THAT(refused(mu + "precision = \"mixed\"\n", "", ""), Contains("double precision"));
  CHECK_THAT(refused(mu + "contact_velocity = \"step\"\n", "", ""), Contains("see no velocity"));
  CHECK_THAT(refused(mu + "time_step = 1e-5\n", "", ""), Contains("name the integrator"));
  CHECK_THAT(refused(mu, "[[material]]\nname = \"n\"\ndensity = 1\nnormal_stiffness = 1\nrestitution = 0.5\n", ""),
             Contains("material[1].restitution: does not go with"));
  CHECK_THAT(refused(mu, "[[material]]\nname = \"n\"\ndensity = 1\nnormal_stiffness = 1\nfriction = 0.5\n", ""),
             Contains("forces are central"));
  const Scene scene = scene_of(mu);
  CHECK(to_toml(parse_scene(to_toml(scene), "again")) == to_toml(scene));
  std::string newtonian = to_toml(scene);
  newtonian.replace(newtonian.find("overdamped"), 10, "newtonian");
  CHECK_THROWS_WITH(parse_scene(newtonian, "n"), Contains("goes with dynamics.kind = \"overdamped\""));
}

TEST_CASE("portions come when the forces on the one before balance") {
  const BedRun ran = run_bed(bed_scene("duration = 60\nrest_force = 1e-2", 90,
                                       "kind = \"pour\"\nportions = 3\nrest_force = 1e-2\nregion_min = [0, 0, 0.25]\n"
                                       "region_max = [0.12, 0.12, 0.5]"));
  double before = 0;
  for (std::size_t k = 1; k < ran.history.size(); ++k) {
    const double now = ran.history[k].at("particles");
    CHECK((now == 30 || now == 60 || now == 90));
    if (now > before && before > 0) CHECK(ran.history[k - 1].at("unbalanced_force") < 1e-2);
    before = now;
  }
  CHECK(before == 90);
}

TEST_CASE("a moving wall presses an overdamped sphere against the floor") {
  const auto pressed = [](double speed) {
    Scene scene =
        scene_of("viscosity = 3.7\n", floor_plane +
                                          "[[boundary]]\nname = \"lid\"\nkind = \"plane\"\npoint = [0, 0, 0.1]\n"
                                          "normal = [0, 0, -1]\n[boundary.motion]\ndisplacement = [\"0\", \"0\", \"" +
                                          fmt::format("{}*t", -speed) + "\"]\n");
    scene.filling.region_min = Vec3(0.4, 0.4, 0);
    scene.filling.region_max = Vec3(0.6, 0.6, 0.1);
    return run_bed(scene).history.back();
  };
  // A lid that comes down to 1.98 radii above the floor presses with the stiffness times half of what is too little.
  const auto end = pressed(0.1 - 1.98 * radius);
  CHECK(end.at("lid.force_z") == Approx(stiffness * 0.01 * radius).epsilon(0.2));
}
