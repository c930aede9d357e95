// Kernels against quadrature; fields against the mass, the momentum and the weight that make them.
#include <cmath>
#include <functional>
#include <numbers>

#include <catch2/catch.hpp>

#include "analysis/forces/coarse_fields.hpp"
#include "core/error.hpp"
#include "tests/analysis/force_fixtures.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

namespace {

/// Composite Simpson; the integrands here are polynomials or analytic on the interval.
double integral(const std::function<double(double)>& f, double from, double to, int steps = 4000) {
  const double h = (to - from) / steps;
  double sum = f(from) + f(to);
  for (int k = 1; k < steps; ++k) sum += (k % 2 ? 4 : 2) * f(from + h * k);
  return sum * h / 3;
}

struct Profile {
  Layers layers;
  std::vector<CoarseCell> cells;
  double area = 0;
};

Profile profile_of(const Snapshot& s, Kernel kind, double width, double thickness) {
  const CoarseKernel kernel(kind, width);
  const BedFrame frame = bed_frame(s);
  Profile profile{coarse_layers(frame, s.radius, kernel, width, thickness), {}, frame.area};
  profile.cells = coarse_profile(s, frame, force_network(s), kernel, profile.layers);
  return profile;
}

double total_mass(const Snapshot& s) {
  double mass = 0;
  for (std::size_t i = 0; i < s.size(); ++i) mass += s.mass(i);
  return mass;
}

}  // namespace

TEST_CASE("kernels integrate to one, and their plane means are their integrals") {
  const double width = 0.7;
  for (const Kernel kind : {Kernel::lucy, Kernel::gaussian}) {
    const CoarseKernel kernel(kind, width);
    const double range = kernel.range(), pi = std::numbers::pi;
    // Up to the range itself, where the Gaussian jumps to 0.
    const auto phi = [&](double r) { return kernel.density(std::min(r, range * (1 - 1e-15))); };
    CHECK(integral([&](double r) { return 4 * pi * r * r * phi(r); }, 0, range) == Approx(1).epsilon(1e-11));
    if (kind == Kernel::lucy) {
      const double variance = integral([&](double r) { return 4 * pi / 3 * r * r * r * r * phi(r); }, 0, range);
      CHECK(std::sqrt(variance) == Approx(width).epsilon(1e-11));
    }
    // Share below h: spheres' areas below the plane, 2 pi r (r + h) for r > |h|.
    for (const double h : {-0.9, -0.4, -0.05, 0.0, 0.3, 0.8}) {
      const double plane = h * range;
      const double outer =
          integral([&](double r) { return 2 * pi * r * (r + plane) * phi(r); }, std::abs(plane), range);
      const double inner = h > 0 ? integral([&](double r) { return 4 * pi * r * r * phi(r); }, 0, plane) : 0;
      CHECK(kernel.below(plane) == Approx(outer + inner).epsilon(1e-10));
      CHECK(kernel.below_integral(plane) ==
            Approx(integral([&](double z) { return kernel.below(z); }, -range, plane)).epsilon(1e-10).margin(1e-14));
    }
    CHECK(kernel.below(range) == 1);
    CHECK(kernel.below(-range) == 0);
    CHECK(kernel.below_integral(-2 * range) == 0);
    CHECK(kernel.below_integral(3 * range) == 3 * range);
    CHECK(kernel.density(range) == 0);
  }
}

TEST_CASE("mass and momentum are conserved to rounding, also round a periodic side") {
  const bool periodic = GENERATE(false, true);
  const Kernel kind = GENERATE(Kernel::lucy, Kernel::gaussian);
  Random random(5, RandomStream::filling_position, 2);
  Snapshot s = empty_box(Vec3(10, 10, 10), {true, true, periodic});
  std::vector<double> velocity;
  Vec3 momentum = Vec3::Zero();
  for (int i = 0; i < 200; ++i) {
    const auto side = [&] { return random.uniform(0, 10); };
    add_particle(s, Vec3(side(), side(), side()), random.uniform(0.1, 0.6), i % 2);
    const Vec3 v(random.uniform(), random.uniform(), random.uniform());
    for (int k = 0; k < 3; ++k) velocity.push_back(v[k]);
    momentum += s.mass(static_cast<std::size_t>(i)) * v;
  }
  s.fields["velocity"] = {3, "m/s", velocity};
  s.contacts = Contacts{};
  const Profile profile = profile_of(s, kind, 1.1, 0.4);
  const double volume = profile.area * profile.layers.thickness;
  double mass = 0;
  Vec3 sum = Vec3::Zero();
  for (const auto& cell : profile.cells) {
    CHECK(cell.density >= 0);
    CHECK(pressure(cell.kinetic) >= -1e-12 * cell.density);
    mass += cell.density * volume;
    sum += cell.momentum * volume;
  }
  CHECK(mass == Approx(total_mass(s)).epsilon(1e-13));
  CHECK((sum - momentum).norm() < 1e-12 * momentum.norm());
}

TEST_CASE("the density of one particle is the kernel's mean over each layer") {
  Snapshot s = empty_box(Vec3(2, 3, 20), {true, true, false});
  add_particle(s, Vec3(1, 1, 10), 0.5);
  const CoarseKernel kernel(Kernel::lucy, 1.0);
  const Profile profile = profile_of(s, Kernel::lucy, 1.0, 0.5);
  for (std::size_t k = 0; k < profile.layers.count; ++k) {
    const double lower = profile.layers.lower(k) - 10, upper = profile.layers.upper(k) - 10;
    const double share = integral(
        [&](double z) {
          const double range = kernel.range();
          if (std::abs(z) >= range) return 0.0;
          return integral([&](double r) { return 2 * std::numbers::pi * r * kernel.density(r); }, std::abs(z), range,
                          200);
        },
        lower, upper, 200);
    CHECK(profile.cells[k].density * 6 * 0.5 == Approx(s.mass(0) * share).epsilon(1e-7).margin(1e-9));
  }
}

TEST_CASE("the stress of a column at rest carries its weight") {
  // Force balance of the smoothed fields: d(zz)/dz = -density g + wall_force. Differences of neighbouring layers are
  // second order in their thickness: (thickness / width)^2 / 12 of the curvature, below 1 % here.
  const Kernel kind = GENERATE(Kernel::lucy, Kernel::gaussian);
  const int n = 12;
  const Snapshot s = column(n, 3e4);
  const double width = 2, h = 0.5, g = 9.8;
  const Profile profile = profile_of(s, kind, width, h);
  REQUIRE(profile.layers.thickness == h);
  double largest = 0, worst = 0, force = 0;
  for (std::size_t k = 1; k + 1 < profile.cells.size(); ++k) {
    const auto& cell = profile.cells[k];
    const double slope = (profile.cells[k + 1].contact(2, 2) - profile.cells[k - 1].contact(2, 2)) / (2 * h);
    worst = std::max(worst, std::abs(slope + cell.density * g - cell.wall_force.z()));
    largest = std::max({largest, cell.density * g, std::abs(cell.wall_force.z())});
  }
  for (const auto& cell : profile.cells) force += cell.wall_force.z() * profile.area * h;
  CHECK(worst < 0.02 * largest);
  CHECK(force == Approx(total_mass(s) * g).epsilon(1e-9));
  // Integral of the stress: that of all contacts.
  double moment = 0, expected = 0;
  const ForceNetwork network = force_network(s);
  for (const auto& cell : profile.cells) moment += cell.contact(2, 2) * profile.area * h;
  for (std::size_t k = 0; k < network.size(); ++k) {
    expected += s.contacts->force[k].z() * network.contacts[k].branch.z();
  }
  CHECK(moment == Approx(expected).epsilon(1e-12));
  // Deep in the column: one weight each 2 m of height, halfway between floor and top, over the area of 16 m2.
  const double weight = s.mass(0) * g;
  const auto middle = static_cast<std::size_t>((n - profile.layers.bottom) / h);
  const double zz = 0.5 * (profile.cells[middle].contact(2, 2) + profile.cells[middle - 1].contact(2, 2));
  CHECK(zz == Approx((3e4 + weight * n / 2) / 16).epsilon(1e-3));
}

TEST_CASE("level contacts are not lost, and nearly level ones agree with them") {
  const auto stress = [](double rise) {
    Snapshot s = empty_box(Vec3(8, 8, 8), {true, true, true});
    add_particle(s, Vec3(3, 4, 4), 1);
    add_particle(s, Vec3(5, 4, 4 + rise), 1);
    press(s, 0, 1, 7);
    double sum = 0;
    std::vector<double> values;
    for (const auto& cell : profile_of(s, Kernel::lucy, 1, 0.5).cells) {
      values.push_back(cell.contact(0, 0));
      sum += cell.contact(0, 0) * 64 * 0.5;
    }
    CHECK(sum == Approx(28 / std::hypot(2, rise)).epsilon(1e-11));
    return values;
  };
  const auto level = stress(0);
  for (const double rise : {1e-7, 2e-5, 1e-4}) {  // about the rise where the formula changes
    const auto other = stress(rise);
    for (std::size_t k = 0; k < level.size(); ++k) CHECK(other[k] == Approx(level[k]).margin(2 * rise));
  }
}

TEST_CASE("fields without forces, without velocity, without extent") {
  Snapshot s = cubic_bed(3, 3, 3);
  const auto result = measured(s, "forces");
  CHECK(fixtures::value(result, "kernel_width") == Approx(1 + 5e-7));
  for (const double d : table_column(result, "coarse_profile", "density")) CHECK(std::isfinite(d));
  for (const double v : table_column(result, "coarse_profile", "velocity_z")) CHECK(std::isnan(v));
  for (const double p : table_column(result, "coarse_profile", "zz")) CHECK(std::isnan(p));
  CHECK_THROWS_AS(measured(s, "forces", {.forces = {.kernel_width = 7}}), InputError);  // periodic sides of 6 m
  std::fill(s.radius.begin(), s.radius.end(), 0.0);
  CHECK_FALSE(measured(s, "forces").quantity("kernel_width")->value);
  CHECK(measured(s, "forces").table("coarse_profile")->rows.empty());
  // Small periodic boxes have a kernel too.
  CHECK(fixtures::value(measured(lattice(simple_cubic, 1, 1, 1, 1.0, 1.6), "forces"), "kernel_width") == 1);
}
