// The fast step, in every width of lanes that this build has, against its slow twin.
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "core/random.hpp"
#include "engine/dynamics/make_particles.hpp"
#include "engine/dynamics/newtonian_step.hpp"
#include "engine/simd/lanes.hpp"
#include "half_step.hpp"
#include "slow_twin.hpp"

using namespace packstone;
using namespace packstone::engine;
using engine::testing::half_step_turning;
using engine::testing::half_step_velocity;
using engine::testing::SlowTwin;
using engine::testing::TwinSphere;

namespace {

constexpr double step_length = 2e-6;

struct Bed {
  Scene scene;
  StartingState start;
};

/// Which spheres and walls are of the second material.
enum class Mix {
  none,        ///< there is no second one
  third,       ///< every third sphere, of another density, and the lid
  same_mass,   ///< the same, of one density
  all_spheres  ///< and not the floor
};

/// Overlapping spheres at random in a box, periodic along x and y, with a floor and a lid.
Bed bed(const std::string& contact, double friction, double largest, double smallest, std::size_t count, Mix mix,
        const std::string& further = "", bool restitution = true) {
  const bool two = mix != Mix::none;
  const std::string plane = "[[boundary]]\nkind = \"plane\"\n";
  std::string text =
      "[dynamics]\nduration = 1\n[domain]\nmin = [0, 0, 0]\nmax = [0.5, 0.5, 0.5]\n"
      "periodic = [\"x\", \"y\"]\n[filling]\nkind = \"growth\"\nduration = 0.1\n[output]\ninterval = 0.1\n[contact]\n" +
      contact;
  text += "[[material]]\nname = \"a\"\ndensity = 2000\nnormal_stiffness = 1e5\ntangential_stiffness = 8e4\n" +
          std::string(restitution ? "restitution = 0.5\n" : "") + "friction = " + std::to_string(friction) + "\n" +
          further;
  text += "[[particles]]\nmaterial = \"a\"\ncount = 1\nradius = 0.02\n";
  text += plane + "name = \"floor\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";
  text += plane + "name = \"lid\"\npoint = [0, 0, 0.5]\nnormal = [0, 0, -1]\n";
  if (two) {
    text += "material = \"b\"\n";  // the lid's
    text += "[[material]]\nname = \"b\"\nnormal_stiffness = 2e5\ntangential_stiffness = 1e5\n" +
            std::string(restitution ? "restitution = 0.7\n" : "") +
            "density = " + std::string(mix == Mix::same_mass ? "2000" : "5000") +
            "\nfriction = " + std::to_string(friction / 2) + "\n" + further;
    text += "[[particles]]\nmaterial = \"b\"\ncount = 1\nradius = 0.02\n";
  }
  Bed b{parse_scene(text, "step"), {}};
  for (std::uint64_t i = 0; i < count; ++i) {
    Random r(5, RandomStream::filling_position, i);
    const auto vector = [&](double low, double high) {
      return Vec3(r.uniform(low, high), r.uniform(low, high), r.uniform(low, high));
    };
    b.start.position.push_back(vector(0.005, 0.495));
    b.start.velocity.push_back(vector(-1, 1));
    b.start.angular_velocity.push_back(rotates(b.scene) ? vector(-20, 20) : Vec3::Zero());
    b.start.radius.push_back(i % 40 == 0 ? largest : smallest);
    b.start.type.push_back(mix == Mix::all_spheres || (two && i % 3 == 0) ? 1 : 0);
  }
  return b;
}

std::vector<TwinSphere> twins(const Bed& b, const Particles& p) {
  std::vector<TwinSphere> spheres(b.start.size());
  for (std::size_t s = 0; s < p.slots(); ++s) {
    if (!p.is_particle(s)) continue;
    const auto i = static_cast<std::size_t>(p.id[s]);
    const Vec3 v = b.start.velocity[i], w = b.start.angular_velocity[i];
    spheres[i] = {b.start.position[i], v, v, w, w, b.start.radius[i], p.mass[s], p.material[s]};
  }
  return spheres;
}

/// By how much a step may differ from its twin, times `looser`.
struct Tolerance {
  double dissipated;                ///< share
  double position, velocity, turn;  ///< after 40 steps [m, m/s, m/s at the surface]
};
constexpr Tolerance rounding = {1e-12, 1e-15, 1e-13, 1e-13};
/// Overlaps are off by some 1e-7 of a radius: 2e-9 m, times 1e5 N/m, over 0.07 kg, in 2e-6 s a step.
constexpr Tolerance single_rounding = {1e-6, 3e-10, 5e-6, 1e-6};

template <class Precision, class Normal, class Tangential>
void check_against_twin(Bed b, double lead, double looser = 1) {
  if (lead == 0) b.scene.dynamics.contact_velocity = ContactVelocity::half_step;
  Particles p = make_particles(b.scene, b.start);
  const Boundaries boundaries(b.scene, b.scene.box());
  NewtonianStep<Precision, Normal, Tangential> fast(b.scene, b.scene.box(), boundaries);
  SlowTwin slow(b.scene, twins(b, p));
  constexpr Tolerance tolerance = Precision::compact ? single_rounding : rounding;
  StepInput in;
  in.dt = step_length;
  in.gravity = Vec3(0.5, 0, -9.8);
  in.overlap_limit = 10;
  in.velocity_lead = lead * step_length;
  Recorder recorder;
  recorder.velocity.resize(p.size());
  recorder.force.resize(p.size());
  recorder.angular_velocity.resize(p.size());
  for (int n = 0; n < 40; ++n) {
    in.growth = n < 20 ? Growth{0.8 + n * 0.005, 0.005 / step_length * 0.02} : Growth{0.95, 0};
    if (fast.outdated(in.growth)) fast.rebuild(p, in.growth, in.dt);
    const bool record = n % 10 == 9;
    const StepSums sums = fast.advance(p, in, record ? &recorder : nullptr);
    slow.step(in);
    std::swap(p.now, p.next);
    REQUIRE(sums.dissipated() == Approx(slow.dissipated()).epsilon(looser * tolerance.dissipated));
    if (record) REQUIRE(sums.particle_contacts + sums.wall_contacts == slow.contacts());
  }
  CHECK(slow.contacts() > 20);
  double position = 0, velocity = 0, spin = 0;
  for (std::size_t s = 0; s < p.slots(); ++s) {
    if (!p.is_particle(s)) continue;
    const TwinSphere& twin = slow.spheres()[static_cast<std::size_t>(p.id[s])];
    position = std::max(position, b.scene.box().separation(p.now.rows[s].position, twin.position).norm());
    velocity = std::max(velocity, (half_step_velocity(p, s) - twin.half_velocity).norm());
    if (p.turns()) spin = std::max(spin, (half_step_turning(p, s) - twin.half_spin).norm() * 0.02);
  }
  CHECK(position < looser * tolerance.position);
  CHECK(velocity < looser * tolerance.velocity);
  CHECK(spin < looser * tolerance.turn);
}

template <class Precision>
void check_all() {
  INFO(Precision::PairLanes::name);
  const std::string linear = "normal = \"linear\"\n", hysteretic = "normal = \"hysteretic\"\n";
  const std::string friction = "tangential = \"cundall-strack\"\n";
  const Bed alike = bed(linear, 0, 0.02, 0.02, 300, Mix::none);
  check_against_twin<Precision, Linear<Release::zero_overlap>, Frictionless>(alike, 0.5);
  check_against_twin<Precision, Linear<Release::zero_overlap>, Frictionless>(alike, 0);
  const Bed two_materials = bed(linear, 0, 0.02, 0.02, 300, Mix::third);
  check_against_twin<Precision, Linear<Release::zero_overlap>, Frictionless>(two_materials, 0.5);
  const Bed same_mass = bed(linear, 0, 0.02, 0.02, 300, Mix::same_mass);
  check_against_twin<Precision, Linear<Release::zero_overlap>, Frictionless>(same_mass, 0.5);
  const Bed of_the_second = bed(linear + friction, 0.4, 0.02, 0.02, 300, Mix::all_spheres);
  check_against_twin<Precision, Linear<Release::zero_overlap>, CundallStrack>(of_the_second, 0.5);
  // The largest have more neighbours than a common row holds.
  const Bed two_sizes = bed(linear + friction, 0.4, 0.09, 0.014, 450, Mix::third);
  check_against_twin<Precision, Linear<Release::zero_overlap>, CundallStrack>(two_sizes, 0.5);
  const Bed rubbing = bed(linear + friction, 0.4, 0.02, 0.02, 300, Mix::none);
  check_against_twin<Precision, Linear<Release::zero_overlap>, CundallStrack>(rubbing, 0.5);
  check_against_twin<Precision, Linear<Release::zero_overlap>, CundallStrack>(rubbing, 0);
}

}  // namespace

TEST_CASE("the step agrees with its slow twin in portable code") { check_all<DoublePrecision<simd::Scalar>>(); }
#ifdef PACKSTONE_AVX2
TEST_CASE("the step agrees with its slow twin in AVX2") { check_all<DoublePrecision<simd::Avx2>>(); }
#endif
#ifdef PACKSTONE_AVX512
TEST_CASE("the step agrees with its slow twin in AVX-512") { check_all<DoublePrecision<simd::Avx512>>(); }
#endif

TEST_CASE("the step in mixed precision agrees with its slow twin in portable code") {
  check_all<MixedPrecision<simd::ScalarSingle>>();
}
#ifdef PACKSTONE_AVX2
TEST_CASE("the step in mixed precision agrees with its slow twin in AVX2") {
  check_all<MixedPrecision<simd::Avx2Single>>();
}
#endif
#ifdef PACKSTONE_AVX512
TEST_CASE("the step in mixed precision agrees with its slow twin in AVX-512") {
  check_all<MixedPrecision<simd::Avx512Single>>();
}
#endif

TEST_CASE("a list that wore out tells by how much, so that the next one can be made to last") {
  const Bed b = bed("normal = \"linear\"\n", 0, 0.02, 0.02, 300, Mix::none);
  Particles p = make_particles(b.scene, b.start);
  const Boundaries boundaries(b.scene, b.scene.box());
  NewtonianStep<DoublePrecision<simd::Widest>, Linear<Release::zero_overlap>, Frictionless> step(b.scene, b.scene.box(),
                                                                                                 boundaries);
  StepInput in;
  in.dt = step_length;
  in.overlap_limit = 10;
  for (int lists = 0; lists < 3; ++lists) {
    step.rebuild(p, in.growth, in.dt);
    double share = 0;
    while (!step.neighbours().outdated(in.growth)) {
      share = step.advance(p, in, nullptr).largest_share_squared;
      std::swap(p.now, p.next);
      REQUIRE(std::isfinite(share));
    }
    CHECK(share >= 1);
    CHECK(share < 1.5);
  }
  p.now.rows[0].position.setConstant(std::numeric_limits<double>::quiet_NaN());
  step.advance(p, in, nullptr);
  CHECK(step.neighbours().outdated(in.growth));
}

TEMPLATE_TEST_CASE("hysteretic damping and a contact that ends with its force agree with the slow twin", "",
                   DoublePrecision<simd::Widest>, MixedPrecision<simd::WidestSingle>) {
  const Bed hysteretic = bed("normal = \"hysteretic\"\n", 0, 0.09, 0.014, 450, Mix::third);
  check_against_twin<TestType, Hysteretic, Frictionless>(hysteretic, 0.5);
  const Bed released = bed("normal = \"linear\"\nrelease = \"zero-force\"\n", 0, 0.02, 0.02, 300, Mix::third);
  check_against_twin<TestType, Linear<Release::zero_force>, Frictionless>(released, 0.5);
}

TEMPLATE_TEST_CASE("every normal law with every tangential law, in lanes, agrees with the same contacts one by one", "",
                   DoublePrecision<simd::Widest>, MixedPrecision<simd::WidestSingle>) {
  const std::string elastic = "young_modulus = 2e6\npoisson_ratio = 0.3\n";
  struct NormalCase {
    std::string law, keys;
    bool restitution;
  };
  const NormalCase normals[] = {{"linear\"\nrelease = \"zero-force", "", true},
                                {"hertz", "", true},
                                {"hertz\"\nrelease = \"zero-force", "", true},
                                {"kuwabara-kono", "dissipation_time = 2e-5\n", false},
                                {"walton-braun", "", true},
                                {"hysteretic\"\nsign_speed = \"0.1 m/s", "", true}};
  const std::string attraction = "[contact.van_der_waals]\nhamaker = 1e-3\nmin_gap = 1e-3\ncutoff = 4e-3\n";
  const std::string tangentials[] = {"none",        "coulomb", "haff-werner", "cundall-strack", "mindlin-deresiewicz",
                                     "walton-braun"};
  for (const NormalCase& normal : normals) {
    for (const std::string& tangential : tangentials) {
      for (const bool attracts : {false, true}) {
        // Roots near zero, jumps of friction and turning points of its history magnify rounding.
        const double looser = tangential == "mindlin-deresiewicz" && TestType::compact ? 1e4 : 1e3;
        INFO(normal.law << ", " << tangential << (attracts ? ", van der Waals" : ""));
        const std::string contact =
            "normal = \"" + normal.law + "\"\ntangential = \"" + tangential + "\"\n" + (attracts ? attraction : "");
        Bed b = bed(contact, 0.4, 0.05, 0.02, 150, Mix::third, elastic + "tangential_damping = 20\n" + normal.keys,
                    normal.restitution);
        if (rotates(b.scene)) {
          check_against_twin<TestType, ChosenNormal, ChosenTangential>(b, 0.5, looser);
        } else {
          check_against_twin<TestType, ChosenNormal, Frictionless>(b, 0.5, looser);
        }
      }
    }
  }
}

TEST_CASE("mixed precision is as exact far from the origin") {
  Bed b = bed("normal = \"linear\"\n", 0, 0.02, 0.02, 300, Mix::none);
  const Vec3 far(-3e4, 5e4, 7e4);  // beyond 2^19 periods
  for (BoundarySpec& wall : b.scene.boundaries) *wall.point += far;
  *b.scene.domain.min += far;
  *b.scene.domain.max += far;
  for (Vec3& position : b.start.position) position += far;
  Particles in_double = make_particles(b.scene, b.start), in_mixed = in_double;
  const Boundaries boundaries(b.scene, b.scene.box());
  NewtonianStep<MixedPrecision<simd::WidestSingle>, Linear<Release::zero_overlap>, Frictionless> mixed(
      b.scene, b.scene.box(), boundaries);
  NewtonianStep<DoublePrecision<simd::Widest>, Linear<Release::zero_overlap>, Frictionless> exact(
      b.scene, b.scene.box(), boundaries);
  StepInput in;
  in.dt = step_length;
  in.overlap_limit = 10;
  mixed.rebuild(in_mixed, in.growth, in.dt);
  exact.rebuild(in_double, in.growth, in.dt);
  for (int n = 0; n < 10; ++n) {
    const double a = mixed.advance(in_mixed, in, nullptr).dissipated();
    const double c = exact.advance(in_double, in, nullptr).dissipated();
    CHECK(a == Approx(c).epsilon(1e-5));
    std::swap(in_mixed.now, in_mixed.next);
    std::swap(in_double.now, in_double.next);
  }
}
