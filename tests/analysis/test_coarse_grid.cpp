// Coarse-grained fields on a grid: against the kernel's own integrals, against what makes them, and in balance.
#include <cmath>
#include <cstring>
#include <numeric>

#include <catch2/catch.hpp>
#include <omp.h>

#include "analysis/forces/coarse_grid.hpp"
#include "analysis/forces/kernel_shares.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "tests/analysis/force_fixtures.hpp"
#include "tests/analysis/random_packings.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;
using Catch::Matchers::Contains;
using packstone::testing::TemporaryFolder;

namespace {

CoarseGrid grid_of(const Snapshot& s, const ForceOptions& options) {
  return coarse_grid(s, make_context(s, {.forces = options}), force_network(s));
}

/// Particles of many sizes with velocities and forces of any direction, between each other, over periodic sides, and at
/// a floor where there is one.
Snapshot loaded_gas(std::array<bool, 3> periodic) {
  Snapshot s = ideal_gas(150, Vec3(7, 6, 5), periodic, 11);
  Random random(4, RandomStream::filling_position, 3);
  std::vector<double> velocity;
  for (double& r : s.radius) r = random.uniform(0.1, 0.8);
  for (std::size_t k = 0; k < 3 * s.size(); ++k) velocity.push_back(random.uniform(-2, 3));
  s.fields["velocity"] = {3, "m/s", velocity};
  s.fields["velocity"].values[7] = 40;
  if (!periodic[2]) add_floor(s);
  const ContactNetwork network = contact_network(s);
  const auto contact = [&](std::size_t first, std::int64_t second, const Vec3& normal, double overlap) {
    add_contact(s, first, second, normal, random.uniform(-1, 5), 0.7 * random_direction(random));
    s.contacts->overlap.back() = overlap;
  };
  for (const NearPair& pair : network.pairs) {
    const Vec3 apart = s.domain.separation(s.position[pair.first], s.position[pair.second]);
    contact(pair.first, pair.second, apart.normalized(), pair.overlap);
  }
  for (const WallContact& wall : network.walls) contact(wall.row, -1, Vec3::UnitZ(), wall.overlap);
  return s;
}

/// Layers of square lattices of touching spheres of radius 1, each on the four below it, at rest on a floor under their
/// own weight: an inclined force at every contact. Periodic sideways.
Snapshot square_pyramids(int side, int layers) {
  const double rise = std::sqrt(2.0);
  Snapshot s = empty_box(Vec3(2 * side, 2 * side, rise * layers + 2), {true, true, false});
  for (int z = 0; z < layers; ++z) {
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) add_particle(s, Vec3(2 * x + 0.5 + z % 2, 2 * y + 0.5 + z % 2, 1 + rise * z), 1);
    }
  }
  add_floor(s);
  const double weight = s.mass(0) * 9.8;
  const auto row = [&](int x, int y, int z) {
    return static_cast<std::size_t>((z * side + (y + side) % side) * side + (x + side) % side);
  };
  for (int z = 0; z < layers; ++z) {
    const double carried = weight * (layers - z);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        if (z == 0) {
          add_contact(s, row(x, y, z), -1, Vec3::UnitZ(), carried);
          continue;
        }
        const int back = z % 2 ? 0 : 1;  // odd layers stand half a cell ahead of even ones
        for (int k = 0; k < 4; ++k) {
          press(s, row(x, y, z), row(x - back + k % 2, y - back + k / 2, z - 1), carried / 4 / (rise / 2));
        }
      }
    }
  }
  return s;
}

struct Totals {
  double solid = 0, mass = 0;
  Vec3 momentum = Vec3::Zero(), wall_force = Vec3::Zero();
  Mat3 contact = Mat3::Zero(), motion = Mat3::Zero();
};

Totals over_cells(const CoarseGrid& grid) {
  Totals t;
  for (std::size_t k = 0; k < grid.cells(); ++k) {
    const CoarseCell cell = grid.at(k);
    t.solid += cell.solid_fraction * grid.cell_volume();
    t.mass += cell.density * grid.cell_volume();
    t.momentum += cell.momentum * grid.cell_volume();
    t.wall_force += cell.wall_force * grid.cell_volume();
    t.contact += cell.contact * grid.cell_volume();
    if (cell.density == 0) continue;
    const Mat3 mean_motion = cell.momentum * cell.momentum.transpose() / cell.density;
    t.motion += (cell.kinetic + mean_motion) * grid.cell_volume();
  }
  return t;
}

/// By Love's and Weber's sums, from the snapshot itself.
Totals over_particles(const Snapshot& s) {
  Totals t;
  const auto& velocity = s.fields.at("velocity").values;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Vec3 v(velocity[3 * i], velocity[3 * i + 1], velocity[3 * i + 2]);
    t.solid += 4.0 / 3 * EIGEN_PI * std::pow(s.radius[i], 3);
    t.mass += s.mass(i);
    t.momentum += s.mass(i) * v;
    t.motion += s.mass(i) * v * v.transpose();
  }
  const auto rows = s.rows_by_id();
  for (std::size_t k = 0; k < s.contacts->size(); ++k) {
    const std::size_t first = rows.at(s.contacts->first[k]);
    const Vec3& force = s.contacts->force[k];
    if (s.contacts->second[k] >= 0) {
      const std::size_t second = rows.at(s.contacts->second[k]);
      t.contact += force * s.domain.separation(s.position[first], s.position[second]).transpose();
    } else {
      t.contact += force * Vec3(0, 0, s.position[first].z()).transpose();  // from the floor
      t.wall_force += force;
    }
  }
  return t;
}

std::size_t index(const CoarseGrid& grid, std::size_t x, std::size_t y, std::size_t z) {
  return (z * grid.count[1] + y) * grid.count[0] + x;
}

/// Largest and root mean square of |div(stress) - density gravity - wall_force|, by central differences, over the
/// largest density gravity.
struct Imbalance {
  double worst = 0, mean = 0;
};

Imbalance imbalance(const CoarseGrid& grid, const Snapshot& s) {
  double worst = 0, squares = 0, largest = 0, cells = 0;
  for (std::size_t z = 1; z + 1 < grid.count[2]; ++z) {
    for (std::size_t y = 0; y < grid.count[1]; ++y) {
      for (std::size_t x = 0; x < grid.count[0]; ++x) {
        const auto step = [&](std::size_t at, int axis, std::size_t by) {
          return (at + by) % grid.count[static_cast<std::size_t>(axis)];
        };
        Vec3 divergence = Vec3::Zero();
        for (int axis = 0; axis < 3; ++axis) {
          const std::size_t back = grid.count[static_cast<std::size_t>(axis)] - 1;
          const auto at = [&](std::size_t by) {
            return grid.at(index(grid, axis == 0 ? step(x, 0, by) : x, axis == 1 ? step(y, 1, by) : y,
                                 axis == 2 ? step(z, 2, by) : z));
          };
          divergence += (at(1).contact - at(back).contact).col(axis) / (2 * grid.spacing[axis]);
        }
        const CoarseCell here = grid.at(index(grid, x, y, z));
        const double off = (divergence - here.density * s.gravity - here.wall_force).norm();
        worst = std::max(worst, off);
        squares += off * off;
        largest = std::max(largest, (here.density * s.gravity).norm());
        ++cells;
      }
    }
  }
  return {worst / largest, std::sqrt(squares / cells) / largest};
}

}  // namespace

TEST_CASE("a kernel's shares add up to one, and are the kernel at the cells' middles within the stated error") {
  const Kernel kind = GENERATE(Kernel::lucy, Kernel::gaussian);
  const double width = 0.8;
  const CoarseKernel kernel(kind, width);
  const RegularGrid grid{.origin = Vec3(-4, -4, -4), .spacing = Vec3::Constant(width), .count = {10, 10, 10}};
  KernelShares shares(grid, {false, false, false}, kernel);
  Random random(2, RandomStream::filling_position, 0);
  double worst = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 at(random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8));
    shares.spread(at);
    double sum = 0;
    shares.for_each([&](std::size_t cell, double share) {
      const auto box = grid.cell(cell % 10, cell / 10 % 10, cell / 100);
      const double expected = kernel.density((0.5 * (box.min + box.max) - at).norm()) * grid.cell_volume();
      worst = std::max(worst, std::abs(share / expected - 1));
      sum += share;
    });
    CHECK(sum == Approx(1).epsilon(1e-14));
  }
  CHECK(worst < (kind == Kernel::lucy ? 3e-4 : 7e-3));
}

TEST_CASE("the kernel's mean along a line is that of many points on it") {
  const Kernel kind = GENERATE(Kernel::lucy, Kernel::gaussian);
  const CoarseKernel kernel(kind, 1);
  const RegularGrid grid{.origin = Vec3::Constant(-8), .spacing = Vec3::Constant(0.8), .count = {20, 20, 20}};
  KernelShares shares(grid, {false, false, false}, kernel);
  for (const Vec3& to : {Vec3(2, 0, 0), Vec3(1, 1.2, 0.9), Vec3(-3, 2, 1)}) {
    const Vec3 from(0.3, -0.1, 0.2);
    shares.spread(from, to);
    const double peak = kernel.density(0) * grid.cell_volume();
    double worst = 0;
    shares.for_each([&](std::size_t cell, double share) {
      const auto box = grid.cell(cell % 20, cell / 20 % 20, cell / 400);
      const Vec3 middle = 0.5 * (box.min + box.max);
      double mean = 0;
      const int points = 2000;
      for (int k = 0; k < points; ++k) {
        mean += kernel.density((from + (k + 0.5) / points * (to - from) - middle).norm()) / points;
      }
      worst = std::max(worst, std::abs(share - mean * grid.cell_volume()) / peak);
    });
    CHECK(worst < (kind == Kernel::lucy ? 1.2e-3 : 6e-3));
    CHECK(worst > 0);
  }
}

TEST_CASE("the cells hold all mass, momentum, motion and stress, to rounding") {
  const std::array<bool, 3> periodic =
      GENERATE(std::array<bool, 3>{false, false, false}, std::array<bool, 3>{true, false, false},
               std::array<bool, 3>{true, true, true});
  const Kernel kind = GENERATE(Kernel::lucy, Kernel::gaussian);
  // Widths below the particles' size, above it, and so large that images of a kernel overlap itself.
  const double width = GENERATE(0.21, 0.6, 1.7);
  const double cell = GENERATE(0.5, 1.3, 9.0);
  const Snapshot s = loaded_gas(periodic);
  REQUIRE(s.contacts->size() > 50);
  const Totals cells = over_cells(grid_of(s, {.kernel = kind, .kernel_width = width, .coarse_cell = cell}));
  const Totals sums = over_particles(s);
  CHECK(cells.solid == Approx(sums.solid).epsilon(1e-13));
  CHECK(cells.mass == Approx(sums.mass).epsilon(1e-13));
  CHECK((cells.momentum - sums.momentum).norm() < 1e-12 * sums.momentum.norm());
  CHECK((cells.motion - sums.motion).norm() < 1e-12 * sums.motion.norm());
  CHECK((cells.contact - sums.contact).norm() < 1e-12 * sums.contact.norm());
  CHECK((cells.wall_force - sums.wall_force).norm() <= 1e-12 * sums.wall_force.norm());
}

TEST_CASE("the mean over level cells is the vertical profile") {
  const Snapshot s = square_pyramids(3, 6);
  const ForceOptions options{.kernel_width = 1, .coarse_cell = 0.25};
  const CoarseGrid grid = grid_of(s, options);
  const BedFrame frame = bed_frame(s);
  const Layers layers{
      .bottom = grid.origin.z(), .thickness = grid.spacing.z(), .count = grid.count[2], .periodic = false};
  const auto profile = coarse_profile(s, frame, force_network(s), CoarseKernel(Kernel::lucy, 1), layers);
  double density = 0, stress = 0, largest_density = 0, largest_stress = 0;
  for (std::size_t z = 0; z < grid.count[2]; ++z) {
    CoarseCell mean;
    const double cells = static_cast<double>(grid.count[0] * grid.count[1]);
    for (std::size_t k = 0; k < grid.count[0] * grid.count[1]; ++k) {
      const CoarseCell cell = grid.at(z * grid.count[0] * grid.count[1] + k);
      mean.density += cell.density / cells;
      mean.contact += cell.contact / cells;
    }
    density = std::max(density, std::abs(mean.density - profile[z].density));
    stress = std::max(stress, (mean.contact - profile[z].contact).norm());
    largest_density = std::max(largest_density, profile[z].density);
    largest_stress = std::max(largest_stress, profile[z].contact.norm());
  }
  // A sample in the middle for the mean over a cell is off by cell^2 / 24 of the curvature.
  CHECK(density < 3e-3 * largest_density);
  CHECK(stress < 3e-3 * largest_stress);
}

TEST_CASE("in a bed at rest the stress carries the weight, better with finer cells") {
  const Snapshot s = square_pyramids(2, 5);
  const auto with_cells = [&](double cell) {
    return imbalance(grid_of(s, {.kernel_width = 1, .coarse_cell = cell}), s);
  };
  const Imbalance coarse = with_cells(0.5), fine = with_cells(0.25);
  CHECK(coarse.worst < 0.15);
  CHECK(coarse.mean < 0.04);
  CHECK(fine.worst < 0.05);
  CHECK(coarse.mean / fine.mean > 3.5);  // central differences are second order
  CHECK(coarse.mean / fine.mean < 4.5);
  Snapshot unbalanced = s;
  for (Vec3& force : unbalanced.contacts->force) force *= 1.2;
  CHECK(imbalance(grid_of(unbalanced, {.kernel_width = 1, .coarse_cell = 0.25}), unbalanced).mean > 10 * fine.mean);
}

TEST_CASE("a gas at one velocity has no temperature, opposite ones have theirs") {
  Snapshot s = ideal_gas(2000, Vec3(8, 8, 8), {true, true, true}, 7, 0.3);
  std::vector<double> same, opposite;
  for (std::size_t i = 0; i < s.size(); ++i) {
    for (int k = 0; k < 3; ++k) same.push_back(k + 1.5);
    for (int k = 0; k < 3; ++k) opposite.push_back(k == 0 ? (i % 2 ? 3.0 : -3.0) : 0);
  }
  for (std::size_t i = 0; i < s.size(); ++i) s.type[i] = 0;
  s.fields["velocity"] = {3, "m/s", same};
  const ForceOptions options{.kernel_width = 2, .coarse_cell = 2};
  const CoarseGrid still = grid_of(s, options);
  for (std::size_t k = 0; k < still.cells(); ++k) {
    CHECK(pressure(still.at(k).kinetic) / still.at(k).density == Approx(0).margin(1e-12));
    CHECK((still.at(k).momentum / still.at(k).density - Vec3(1.5, 2.5, 3.5)).norm() < 1e-12);
  }
  s.fields["velocity"].values = opposite;
  const CoarseGrid hot = grid_of(s, options);
  for (std::size_t k = 0; k < hot.cells(); ++k) {
    const CoarseCell cell = hot.at(k);
    const double drift = cell.momentum.x() / cell.density;
    CHECK(pressure(cell.kinetic) / cell.density == Approx((9 - drift * drift) / 3).epsilon(1e-12));
  }
}

TEST_CASE("the fields on a grid are the same for any number of threads") {
  const Snapshot s =
      loaded_gas(GENERATE(std::array<bool, 3>{false, false, false}, std::array<bool, 3>{true, true, true}));
  const ForceOptions options{.kernel_width = 0.15, .coarse_cell = 0.15};
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const CoarseGrid one = grid_of(s, options);
  omp_set_num_threads(3);
  const CoarseGrid three = grid_of(s, options);
  omp_set_num_threads(before);
  CHECK(one.sums == three.sums);
}

TEST_CASE("every band of items is filled once, and none beside its neighbour") {
  const std::size_t cells = GENERATE(1, 2, 7, 40, 41, 1000);
  const std::ptrdiff_t longest = GENERATE(1, 3, 12);
  const auto span = [&](std::size_t k) {
    const auto first = static_cast<std::ptrdiff_t>(k * 7919 % (3 * cells)) - static_cast<std::ptrdiff_t>(cells);
    return CellSpan{first, first + static_cast<std::ptrdiff_t>(k) % longest};
  };
  std::vector<std::vector<std::uint32_t>> order(cells);  // items in the order in which they come to each cell
  const auto run = [&](int threads) {
    std::vector<std::vector<std::uint32_t>> visits(cells);
    omp_set_num_threads(threads);
    add_in_bands(
        500, cells, span, [] { return 0; },
        [&](int&, std::size_t item) {
          for (std::ptrdiff_t c = span(item).first; c <= span(item).last; ++c) {
            const auto count = static_cast<std::ptrdiff_t>(cells);
            visits[static_cast<std::size_t>(((c % count) + count) % count)].push_back(static_cast<std::uint32_t>(item));
          }
        });
    return visits;
  };
  const int before = omp_get_max_threads();
  const auto one = run(1), four = run(4);
  omp_set_num_threads(before);
  CHECK(one == four);
  std::size_t visits = 0, expected = 0;
  for (const auto& cell : one) visits += cell.size();
  for (std::size_t k = 0; k < 500; ++k) expected += static_cast<std::size_t>(span(k).last - span(k).first) + 1;
  CHECK(visits == expected);
}

TEST_CASE("the default grid has no more cells than particles, and a width asked for is bounded") {
  const Snapshot s = cubic_bed(20, 20, 20);
  const CoarseGrid grid = grid_of(s, {});
  CHECK(grid.cells() <= 8800);  // rounded to whole cells along each axis
  CHECK(grid.cells() > 4000);
  CHECK_THROWS_WITH(grid_of(s, {.coarse_cell = 0.01}), Contains("at most 5e+06"));
  CHECK_THROWS_WITH(grid_of(s, {.coarse_cell = -1}), Contains("cells"));
  CHECK_THROWS_WITH(grid_of(s, {.kernel_width = 100}), Contains("periodic side"));
  Snapshot stray = cubic_bed(4, 4, 4, {false, false, false});
  add_particle(stray, Vec3(1e7, 0, 0), 1);
  CHECK(grid_of(stray, {}).cells() < 1000000);
}

TEST_CASE("the fields that a snapshot has are written as VTK image data") {
  const TemporaryFolder folder;
  Snapshot s = square_pyramids(2, 3);
  const Options options{.forces = {.kernel_width = 1, .coarse_cell = 1}};
  write_coarse_fields(folder / "still.vti", s, options);
  const std::string still = read_text_file(folder / "still.vti");
  for (const char* name : {"solid_fraction", "density", "stress", "pressure", "contact_stress", "wall_force"}) {
    CHECK_THAT(still, Contains(std::string("Name=\"") + name + "\""));
  }
  CHECK_THAT(still, !Contains("velocity") && Contains("NumberOfComponents=\"6\" ComponentName0=\"xx\"") &&
                        Contains("ComponentName4=\"yz\""));
  // The arrays stand one after the other, each behind its length.
  const CoarseGrid grid = coarse_grid(s, make_context(s, options), force_network(s));
  const std::size_t first = still.find("\n_") + 2, cells = grid.cells();
  const auto number = [&](std::size_t array_offset, std::size_t k) {
    double value = 0;
    std::memcpy(&value, &still[first + array_offset + sizeof(std::uint64_t) + k * sizeof value], sizeof value);
    return value;
  };
  const std::size_t scalar = sizeof(std::uint64_t) + cells * sizeof(double);
  for (std::size_t k = 0; k < cells; ++k) {
    CHECK(number(0, k) == grid.at(k).solid_fraction);
    CHECK(number(scalar, k) == grid.at(k).density);
    CHECK(number(2 * scalar, 6 * k + 2) == grid.at(k).contact(2, 2));
  }
  CHECK(still.size() == first + 3 * scalar + 2 * (scalar + 5 * cells * sizeof(double)) + scalar +
                            2 * cells * sizeof(double) + std::strlen("\n  </AppendedData>\n</VTKFile>\n"));

  s.contacts.reset();
  s.fields["velocity"] = {3, "m/s", std::vector<double>(3 * s.size(), 0.5)};
  write_coarse_fields(folder / "moving.vti", s, options);
  CHECK_THAT(read_text_file(folder / "moving.vti"),
             Contains("\"velocity\"") && Contains("\"granular_temperature\"") && !Contains("stress"));
  s.groups[0].density = 0;
  write_coarse_fields(folder / "spheres.vti", s, options);
  CHECK_THAT(read_text_file(folder / "spheres.vti"), Contains("\"solid_fraction\"") && !Contains("\"density\""));

  CHECK_THROWS_WITH(write_coarse_fields("fields.vtk", s, options), Contains("must end in .vti"));
  CHECK_THROWS_WITH(write_coarse_fields("fields.vti", empty_box(Vec3(1, 1, 1)), options), Contains("no particles"));
  std::fill(s.radius.begin(), s.radius.end(), 0.0);
  CHECK_THROWS_WITH(write_coarse_fields("fields.vti", s, {}), Contains("all radii are 0"));
}
