// The eight impact tests of Chung & Ooi, Granular Matter 13 (2011) 643, with Hertz and Mindlin-Deresiewicz contacts:
// against closed forms, their published curves (tests/data/chung_ooi) and exact symmetries.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <catch2/catch.hpp>

#include "core/geometry.hpp"
#include "hand_made.hpp"

using namespace packstone;
using namespace packstone::engine;
using engine::testing::HandMade;
using engine::testing::Sphere;

namespace {

struct Body {
  double radius, density, young, poisson;
};
constexpr Body glass{0.01, 2800, 4.8e10, 0.2}, limestone{0.01, 2500, 2e10, 0.25};
constexpr Body aluminium_alloy{0.1, 2700, 7e10, 0.33}, magnesium_alloy{0.1, 1800, 4e10, 0.35};
constexpr Body aluminium_oxide{2.5e-3, 4000, 3.8e11, 0.23}, cast_iron{2.5e-3, 7000, 1.0e11, 0.25};
constexpr Body copper{0.1, 8900, 1.2e11, 0.35}, steel{1e-5, 7850, 2.08e11, 0.3};

/// One body, with a rigid floor where wanted.
Scene impact_scene(const Body& body, double restitution, double friction, bool floor) {
  std::ostringstream text;
  text.precision(17);
  const auto material = [&](const char* name, double young) {
    text << "[[material]]\nname = \"" << name << "\"\ndensity = " << body.density << "\nyoung_modulus = " << young
         << "\npoisson_ratio = " << body.poisson << "\nrestitution = " << restitution << "\nfriction = " << friction
         << "\n";
  };
  text << "[dynamics]\nduration = 1\n[domain]\nmin = [-10, -10, -10]\nmax = [10, 10, 10]\n[contact]\n"
          "normal = \"hertz\"\ntangential = \"mindlin-deresiewicz\"\n";
  // Ended with the force, friction has no pull to rub against; a restitution below exp(-2) needs the other end.
  if (restitution > 0.14) text << "release = \"zero-force\"\n";
  text << "[filling]\nkind = \"growth\"\nduration = 0.1\n[output]\ninterval = 0.1\n"
          "[[particles]]\nmaterial = \"body\"\ncount = 1\nradius = 0.1\n";
  if (floor) {
    text << "[[boundary]]\nname = \"wall\"\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\nmaterial = "
            "\"rigid\"\n";
  }
  material("body", body.young);
  material("rigid", 1e30);
  return parse_scene(text.str(), "impact");
}

double mass_of(const Body& b) { return b.density * sphere_volume(b.radius); }
double plane_modulus(const Body& b) { return b.young / (1 - b.poisson * b.poisson); }

/// Hertz' contact time, overlap and force for an effective mass, radius and modulus.
struct Hertzian {
  double duration, overlap, force;
};
Hertzian hertzian(double mass, double radius, double modulus, double speed) {
  const double K = 4.0 / 3.0 * std::sqrt(radius) * modulus;
  const double overlap = std::pow(1.25 * mass * speed * speed / K, 0.4);
  return {3.21803 * std::pow(mass / K, 0.4) * std::pow(speed, -0.2), overlap, K * std::pow(overlap, 1.5)};
}

struct After {
  double normal, tangential;  ///< velocity of the centre [m/s]
  double spin;                ///< about y [rad/s]
  double contact_tangential;  ///< velocity of the contact point [m/s]
};

/// A sphere meets the floor with a tangential velocity along x and a spin about y.
After against_wall(const Body& body, double restitution, double friction, double normal, double tangential,
                   double spin) {
  const Hertzian h = hertzian(mass_of(body), body.radius, plane_modulus(body), normal);
  const double dt = h.duration / 4000;
  HandMade ball(impact_scene(body, restitution, friction, true),
                {{Vec3(0, 0, body.radius), Vec3(tangential, 0, -normal), body.radius}}, dt);
  ball.set_spin(0, Vec3(0, spin, 0));
  for (int n = 0; n < 20 || (n < 100000 && ball.position(0).z() < body.radius); ++n) ball.step();
  const Vec3 v = ball.velocity(0), w = ball.angular_velocity(0);
  return {v.z(), v.x(), w.y(), v.x() - body.radius * w.y()};
}

/// Scaled spin after an elastic impact with a rigid plane, from eqs [10] and [19]-[21] of Zhong et al. (2009) along one
/// line, written out apart from the engine's: plain steps, one number for the force.
double spin_by_printed_equations(const Body& body, double mu, double normal, double scaled_speed) {
  constexpr int steps = 20000;
  const double m = mass_of(body), shear = body.young / (2 * (1 + body.poisson)), G = shear / (2 - body.poisson);
  const double K = 4.0 / 3.0 * std::sqrt(body.radius) * plane_modulus(body);
  const double dt = hertzian(m, body.radius, plane_modulus(body), normal).duration / steps;
  double overlap = 0, v = normal, u = scaled_speed * mu * normal, w = 0, T = 0, limit = 0, up = 0, down = 0, sign = 1;
  int k = 0;
  for (;;) {
    overlap += v * dt;
    if (overlap <= 0) return -body.radius * w / (mu * normal);
    const double N = K * std::pow(overlap, 1.5), stiffness = 8 * G * std::sqrt(body.radius * overlap);
    const double ds = sign * (u - body.radius * w) * dt, change = mu * N - limit;
    limit = mu * N;
    if (ds < 0 && k != 1) {
      if (k == 0) down = -T;
      up = T;
      k = 1;
    } else if (ds > 0 && k == 1) {
      down = T;
      k = 2;
    }
    const double cube = k == 0   ? 1 - (T + change) / limit
                        : k == 1 ? 1 - (up - T + 2 * change) / (2 * limit)
                                 : 1 - (T - down + 2 * change) / (2 * limit);
    const double theta = stiffness * std::abs(ds) < change ? 1 : std::cbrt(std::clamp(cube, 0.0, 1.0));
    T += stiffness * theta * ds + (k == 1 ? -1 : 1) * (1 - theta) * change;
    up += change;
    down -= change;
    T = std::clamp(T, -limit, limit);
    if (T < 0) {
      sign = -sign;
      T = -T;
      const double before = up;
      up = -down;
      down = -before;
      k = k == 0 ? 0 : 3 - k;
    }
    if (k == 2 && T > up) k = 0;
    v -= N / m * dt;
    u -= sign * T / m * dt;
    w += sign * T * body.radius / (0.4 * m * body.radius * body.radius) * dt;
  }
}

std::vector<std::vector<double>> published(const std::string& file) {
  std::ifstream in(PACKSTONE_SOURCE_DIR "/tests/data/chung_ooi/" + file);
  std::vector<std::vector<double>> rows;
  std::string line;
  while (std::getline(in, line)) {
    if (line.empty() || line[0] == '#' || std::isalpha(static_cast<unsigned char>(line[0]))) continue;
    std::vector<double> row;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) row.push_back(std::stod(field));
    rows.push_back(row);
  }
  return rows;
}

constexpr double degree = std::numbers::pi / 180;

}  // namespace

TEST_CASE("Chung and Ooi 1: two identical elastic spheres, force over overlap and time") {
  const Body body = GENERATE(glass, limestone);
  const Hertzian h = hertzian(mass_of(body) / 2, body.radius / 2, plane_modulus(body) / 2, 20);
  const double dt = h.duration / 2000;
  HandMade pair(impact_scene(body, 1, 0.35, false),
                {{Vec3(-body.radius, 0, 0), Vec3(10, 0, 0), body.radius},
                 {Vec3(body.radius, 0, 0), Vec3(-10, 0, 0), body.radius}},
                dt);
  Recorder recorder;
  recorder.velocity.resize(2);
  recorder.force.resize(2);
  recorder.angular_velocity.resize(2);
  recorder.want_contacts = true;
  const double K = 4.0 / 3.0 * std::sqrt(body.radius / 2) * plane_modulus(body) / 2;
  double largest_force = 0, time = 0;
  for (int n = 0; n < 2500; ++n) {
    recorder.contacts = {};
    pair.step(&recorder);
    if (recorder.contacts.size() == 0) continue;
    const double force = std::abs(recorder.contacts.force.front().x());
    REQUIRE(force == Approx(K * std::pow(recorder.contacts.overlap.front(), 1.5)).epsilon(1e-12));
    largest_force = std::max(largest_force, force);
    time += dt;
  }
  CHECK(largest_force == Approx(h.force).epsilon(1e-5));
  CHECK(time == Approx(h.duration).epsilon(1e-3));
  CHECK(pair.velocity(0).x() == Approx(-10).epsilon(1e-6));
}

TEST_CASE("Chung and Ooi 2: an elastic sphere on a rigid plane") {
  const Body body = GENERATE(aluminium_alloy, magnesium_alloy);
  const Hertzian h = hertzian(mass_of(body), body.radius, plane_modulus(body), 0.2);
  const double dt = h.duration / 2000;
  HandMade ball(impact_scene(body, 1, 0.35, true), {{Vec3(0, 0, body.radius), Vec3(0, 0, -0.2), body.radius}}, dt);
  double lowest = body.radius, time = 0;
  for (int n = 0; n < 2500; ++n) {
    ball.step();
    lowest = std::min(lowest, ball.position(0).z());
    if (ball.position(0).z() < body.radius) time += dt;
  }
  CHECK(body.radius - lowest == Approx(h.overlap).epsilon(1e-5));
  CHECK(time == Approx(h.duration).epsilon(1e-3));
  CHECK(ball.velocity(0).z() == Approx(0.2).epsilon(1e-6));
}

TEST_CASE("Chung and Ooi 3: the restitution that comes out is the one that was given") {
  const Body body = GENERATE(aluminium_oxide, cast_iron);
  const double e = GENERATE(0.1, 0.3, 0.5, 0.7, 0.9, 1.0);
  CHECK(against_wall(body, e, 0.3, 3.9, 0, 0).normal == Approx(3.9 * e).epsilon(1e-3));
}

TEST_CASE("Chung and Ooi 4: oblique impact over the angle, beside their curves") {
  // Their curves are of contacts that stick as a whole or slide as a whole; slip from the edge inwards differs by 3 %
  // of the restitution and 5 % of the largest spin between 20 and 25 degrees (docs/physics.md). Below 12 degrees the
  // contact's vibration decides, and there even published calculations differ by half.
  for (const auto& row : published("test4.csv")) {
    REQUIRE(row.size() == 6);
    const auto at = [&](double angle) {
      return against_wall(aluminium_oxide, 0.98, 0.092, 3.9 * std::cos(angle * degree), 3.9 * std::sin(angle * degree),
                          0);
    };
    INFO(row[0] << " degrees");
    const After a = at(row[4]);
    CHECK(std::atan(a.contact_tangential / a.normal) / degree == Approx(row[5]).margin(3));
    if (row[0] < 12) continue;
    CHECK(at(row[0]).tangential / (3.9 * std::sin(row[0] * degree)) == Approx(row[1]).margin(0.035));
    // A sphere that moves along +x starts to turn about +y; they count the other way round.
    CHECK(-at(row[2]).spin == Approx(row[3]).margin(0.055 * 617));
  }
}

TEST_CASE("Chung and Ooi 5: constant normal speed, rising tangential speed, in scaled form") {
  const double mu = 0.3, normal = 5;
  const auto scaled_spin = [&](double scaled_speed) {
    return -steel.radius * against_wall(steel, 1, mu, normal, scaled_speed * mu * normal, 0).spin / (mu * normal);
  };
  for (const auto& row : published("test5_fem.csv")) {
    INFO("finite elements, v_s / (mu v_n) = " << row.at(0));
    CHECK(scaled_spin(row[0]) == Approx(row.at(1)).margin(0.22));
    CHECK(scaled_spin(row[0]) == Approx(spin_by_printed_equations(steel, mu, normal, row[0])).margin(2e-3));
  }
  for (const auto& row : published("test5_steel.csv")) {
    if (row.at(0) < 5.5) continue;  // where the contact slides throughout
    INFO("theory, v_s / (mu v_n) = " << row[0]);
    CHECK(scaled_spin(row[0]) == Approx(row.at(1)).epsilon(5e-3));
  }
  CHECK(scaled_spin(12) == Approx(-5).epsilon(1e-3));
}

TEST_CASE("Chung and Ooi 6: a spinning sphere on a plane slides off at mu (1+e) v_n, or as a sliding one does") {
  const Body body = GENERATE(aluminium_alloy, copper);
  const double e = 0.5, mu = 0.4, normal = 0.2;
  const double scaled_spin = GENERATE(0.5, 2.0, 4.0, 10.0);  // R w / (mu v_n)
  const double spin = -scaled_spin * mu * normal / body.radius;
  const After spinning = against_wall(body, e, mu, normal, 0, spin);
  CHECK(spinning.normal == Approx(e * normal).epsilon(1e-3));
  // What the contact sees is the velocity there: a sphere that slides with it ends with the same one.
  const After sliding = against_wall(body, e, mu, normal, -body.radius * spin, 0);
  CHECK(spinning.contact_tangential == Approx(sliding.contact_tangential).epsilon(1e-9));
  CHECK(spinning.tangential == Approx(sliding.tangential + body.radius * spin).epsilon(1e-9));
  if (scaled_spin > 3.5 * (1 + e)) {
    // 1.4 % less: the dashpot's force jumps up at first, and the contact sticks while it does.
    CHECK(spinning.tangential == Approx(-mu * (1 + e) * normal).epsilon(0.02));
    CHECK(spinning.spin == Approx(spin + 2.5 * mu * (1 + e) * normal / body.radius).epsilon(0.01));
  }
}

TEST_CASE("Chung and Ooi 7: two identical spheres that spin the same way meet as each meets a rigid plane") {
  const Body body = GENERATE(aluminium_alloy, copper);
  const double e = 0.5, mu = 0.4, normal = 0.2;
  const double spin = GENERATE(0.5, 2.0, 10.0) * mu * normal / body.radius;
  const Hertzian h = hertzian(mass_of(body), body.radius, plane_modulus(body), normal);
  HandMade pair(impact_scene(body, e, mu, false),
                {{Vec3(0, 0, body.radius), Vec3(0, 0, -normal), body.radius},
                 {Vec3(0, 0, -body.radius), Vec3(0, 0, normal), body.radius}},
                h.duration / 4000);
  for (int id : {0, 1}) pair.set_spin(id, Vec3(0, spin, 0));
  for (int n = 0; n < 20 || pair.position(0).z() < body.radius; ++n) pair.step();
  const After alone = against_wall(body, e, mu, normal, 0, spin);
  // The line of centres turns a little while they touch, which a plane does not.
  CHECK(pair.velocity(0).z() == Approx(alone.normal).epsilon(1e-3));
  CHECK(pair.velocity(0).x() == Approx(alone.tangential).epsilon(1e-3));
  CHECK(pair.angular_velocity(0).y() == Approx(alone.spin).margin(1e-3 * spin));
  CHECK(pair.velocity(1).x() == Approx(-pair.velocity(0).x()).epsilon(1e-12));
  CHECK(pair.angular_velocity(1).y() == Approx(pair.angular_velocity(0).y()).epsilon(1e-12));
}

TEST_CASE("Chung and Ooi 8: spheres of different sizes meet as one of their effective mass and radius meets a plane") {
  const double mu = 0.4, e = 0.5, normal = 0.2;
  const double scaled = GENERATE(0.5, 2.0, 10.0);
  Body large = aluminium_alloy;
  large.radius = 0.5;
  const double m = mass_of(aluminium_alloy), M = mass_of(large), effective = m * M / (m + M);
  const double radius = 0.1 * 0.5 / 0.6;
  const Hertzian h = hertzian(effective, radius, plane_modulus(aluminium_alloy) / 2, normal);
  HandMade pair(impact_scene(aluminium_alloy, e, mu, false),
                {{Vec3(0, 0, 0.1), Vec3(0, 0, -normal), 0.1}, {Vec3(0, 0, -0.5), Vec3::Zero(), 0.5}},
                h.duration / 4000);
  const double spin = -scaled * mu * normal / 0.1;
  pair.set_spin(0, Vec3(0, spin, 0));
  for (int n = 0; n < 20 || (pair.position(0) - pair.position(1)).norm() < 0.6; ++n) pair.step();
  // The impulses over the effective mass are those of the equivalent sphere: of half its modulus, so that it is as soft
  // against a rigid plane, and of the same speed at the contact.
  Body equal{radius, effective / sphere_volume(radius), aluminium_alloy.young / 2, aluminium_alloy.poisson};
  const After alone = against_wall(equal, e, mu, normal, scaled * mu * normal, 0);
  const double normal_impulse = m * (pair.velocity(0).z() + normal), impulse = m * pair.velocity(0).x();
  // The line of centres turns here too.
  CHECK(normal_impulse / effective == Approx(alone.normal + normal).epsilon(1e-4));
  CHECK(impulse / effective == Approx(alone.tangential - scaled * mu * normal).epsilon(1e-3));
  CHECK(pair.angular_velocity(0).y() == Approx(spin - impulse * 2.5 / (m * 0.1)).margin(2e-4 * std::abs(spin)));
  CHECK(pair.angular_velocity(1).y() == Approx(-impulse * 2.5 / (M * 0.5)).epsilon(2e-3));
  CHECK((pair.momentum() - Vec3(0, 0, -m * normal)).norm() < 1e-12 * m * normal);
}
