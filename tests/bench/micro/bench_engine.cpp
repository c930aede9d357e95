// Micro-benchmarks of detection and of the step, on beds made by geometry: spheres on a simple cubic lattice, each
// pressed lightly against its six neighbours, in a periodic box.
#include <algorithm>
#include <cmath>
#include <random>

#include <benchmark/benchmark.h>

#include "core/geometry.hpp"
#include "engine/dynamics/make_particles.hpp"
#include "engine/dynamics/newtonian_step.hpp"
#include "engine/simd/lanes.hpp"

using namespace packstone;
using namespace packstone::engine;

namespace {

constexpr double radius = 0.005;    // [m]
constexpr double pressed = 1e-5;    // overlap over the radius
constexpr double time_step = 1e-6;  // [s]

struct Bed {
  Scene scene;
  StartingState start;
};

/// About count spheres, in random order; a large one of this ratio of radii in the middle takes the place of those it
/// covers.
Bed lattice(std::int64_t count, double ratio, double friction) {
  const auto edge = static_cast<int>(std::lround(std::cbrt(static_cast<double>(count))));
  const double spacing = 2 * radius * (1 - pressed), side = edge * spacing;
  Bed bed;
  MaterialSpec steel;
  steel.name = "steel";
  steel.density = 7800;
  steel.normal_stiffness = steel.tangential_stiffness = 1e7;
  steel.restitution = 0.42;
  steel.friction = friction;
  bed.scene.materials.push_back(steel);
  bed.scene.contact.normal = NormalModel::linear;
  if (friction > 0) bed.scene.contact.tangential = TangentialModel::cundall_strack;
  GroupSpec group;
  group.name = group.material = "steel";
  bed.scene.particles.push_back(group);
  bed.scene.domain.min = Vec3::Zero();
  bed.scene.domain.max = Vec3::Constant(side);
  bed.scene.domain.periodic = {0, 1, 2};
  const Vec3 middle = Vec3::Constant(side / 2);
  const auto add = [&](const Vec3& p, double r) {
    bed.start.position.push_back(p);
    bed.start.radius.push_back(r);
  };
  if (ratio > 1) add(middle, ratio * radius);
  for (int c = 0; c < edge; ++c) {
    for (int b = 0; b < edge; ++b) {
      for (int a = 0; a < edge; ++a) {
        const Vec3 p = spacing * Vec3(a + 0.5, b + 0.5, c + 0.5);
        if (ratio == 1 || (p - middle).norm() > (1 + ratio) * radius) add(p, radius);
      }
    }
  }
  std::mt19937 random(1);
  std::vector<std::size_t> order(bed.start.position.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), random);
  StartingState shuffled;
  for (const std::size_t i : order) {
    shuffled.position.push_back(bed.start.position[i]);
    shuffled.radius.push_back(bed.start.radius[i]);
    shuffled.velocity.push_back(Vec3::Zero());
    shuffled.angular_velocity.push_back(Vec3::Zero());
    shuffled.type.push_back(0);
  }
  bed.start = shuffled;
  return bed;
}

void build_list(benchmark::State& state) {
  const Bed bed = lattice(state.range(0), static_cast<double>(state.range(1)), 0);
  Particles particles = make_particles(bed.scene, bed.start);
  NeighbourList list(bed.scene.box(), simd::Widest::width);
  list.build(particles, Growth{}, time_step);  // brings the particles into their order, as every build but the first
  for (auto _ : state) list.build(particles, Growth{}, time_step);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(particles.size()));
  state.counters["neighbours"] = static_cast<double>(list.pairs()) / static_cast<double>(particles.size());
}

template <class Precision, class Tangential>
void step(benchmark::State& state) {
  const Bed bed = lattice(state.range(0), 1, Tangential::active ? 0.5 : 0.0);
  Particles particles = make_particles(bed.scene, bed.start);
  const Boundaries none(bed.scene, bed.scene.box());
  NewtonianStep<Precision, Linear<Release::zero_overlap>, Tangential> dynamics(bed.scene, bed.scene.box(), none);
  StepInput input;
  input.dt = time_step;
  input.overlap_limit = 1;
  dynamics.rebuild(particles, input.growth, input.dt);
  for (auto _ : state) {
    dynamics.advance(particles, input, nullptr);
    std::swap(particles.now, particles.next);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(particles.size()));
  state.SetLabel(Precision::PairLanes::name);
}

void numbers_and_ratios(benchmark::internal::Benchmark* b) {
  for (const std::int64_t number : {10000, 100000, 1000000}) b->Args({number, 1});
  for (const std::int64_t ratio : {2, 5, 10, 20}) b->Args({100000, ratio});
}

}  // namespace

BENCHMARK(build_list)->Apply(numbers_and_ratios)->UseRealTime()->Unit(benchmark::kMillisecond);
#define STEP_IN(lanes, law)            \
  BENCHMARK_TEMPLATE(step, lanes, law) \
      ->Arg(10000)                     \
      ->Arg(100000)                    \
      ->Arg(1000000)                   \
      ->UseRealTime()                  \
      ->Unit(benchmark::kMillisecond)
STEP_IN(DoublePrecision<simd::Scalar>, Frictionless);
STEP_IN(MixedPrecision<simd::ScalarSingle>, Frictionless);
STEP_IN(DoublePrecision<simd::Scalar>, CundallStrack);
STEP_IN(MixedPrecision<simd::ScalarSingle>, CundallStrack);
#ifdef PACKSTONE_AVX2
STEP_IN(DoublePrecision<simd::Avx2>, Frictionless);
STEP_IN(MixedPrecision<simd::Avx2Single>, Frictionless);
STEP_IN(DoublePrecision<simd::Avx2>, CundallStrack);
STEP_IN(MixedPrecision<simd::Avx2Single>, CundallStrack);
#endif
#ifdef PACKSTONE_AVX512
STEP_IN(DoublePrecision<simd::Avx512>, Frictionless);
STEP_IN(MixedPrecision<simd::Avx512Single>, Frictionless);
STEP_IN(DoublePrecision<simd::Avx512>, CundallStrack);
STEP_IN(MixedPrecision<simd::Avx512Single>, CundallStrack);
#endif
BENCHMARK_MAIN();
