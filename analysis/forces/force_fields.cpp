// Stress, chain and core of every particle.
#include <array>

#include "analysis/forces/cores.hpp"
#include "analysis/forces/force_chains.hpp"
#include "analysis/forces/stress.hpp"
#include "analysis/measures.hpp"
#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

const std::string of_stress =
    " of the stress sigma_i = (1/V_i) sum_c f_c (x) l_c of the particle's contacts, as for particle_pressure_mean; "
    "compression positive";

ParticleField pascals(const std::string& name, const std::string& definition) {
  return {.name = name, .unit = "Pa", .definition = definition + of_stress};
}

/// Components of a symmetric tensor, in the order of the fields.
struct TensorPart {
  const char* name;
  int row, column;
};
constexpr std::array tensor_parts = {TensorPart{"xx", 0, 0}, TensorPart{"yy", 1, 1}, TensorPart{"zz", 2, 2},
                                     TensorPart{"xy", 0, 1}, TensorPart{"xz", 0, 2}, TensorPart{"yz", 1, 2}};

struct StressFields {
  ParticleField pressure = pascals("pressure", "a third of the trace");
  ParticleField deviator = pascals("stress_deviator", "von Mises' sqrt(3/2 s:s), s the deviator of the symmetric part");
  ParticleField major = pascals("stress_major", "largest principal value");
  ParticleField direction{.name = "stress_major_direction",
                          .definition = "unit vector of stress_major, either way; none without stress",
                          .components = 3};
  std::vector<ParticleField> tensor;

  explicit StressFields() {
    for (const TensorPart& part : tensor_parts) {
      tensor.push_back(pascals(std::string("stress_") + part.name, std::string(part.name) + " of the symmetric part"));
    }
  }

  void compute(const Snapshot& snapshot, const ForceNetwork& network) {
    const std::size_t n = snapshot.size();
    for (ParticleField* each : {&pressure, &deviator, &major}) each->values.assign(n, no_value);
    for (ParticleField& each : tensor) each.values.assign(n, no_value);
    direction.values.assign(3 * n, no_value);
    const auto moments = particle_force_moments(snapshot, network);
#pragma omp parallel for
    for (std::size_t i = 0; i < n; ++i) {
      if (const double volume = sphere_volume(snapshot.radius[i]); volume > 0) set(i, symmetric(moments[i]) / volume);
    }
  }

  std::vector<ParticleField> all() && {
    std::vector<ParticleField> fields;
    for (ParticleField* each : {&pressure, &deviator, &major, &direction}) fields.push_back(std::move(*each));
    for (ParticleField& each : tensor) fields.push_back(std::move(each));
    return fields;
  }

 private:
  void set(std::size_t i, const Mat3& stress) {
    const PrincipalStress axes = principal(stress);
    pressure.values[i] = analysis::pressure(stress);
    deviator.values[i] = analysis::deviator(stress);
    major.values[i] = axes.value[0];
    for (std::size_t k = 0; k < tensor.size(); ++k) {
      tensor[k].values[i] = stress(tensor_parts[k].row, tensor_parts[k].column);
    }
    if (stress.isZero(0)) return;
    for (std::size_t k = 0; k < 3; ++k) direction.values[3 * i + k] = axes.direction(static_cast<int>(k), 0);
  }
};

std::vector<double> chain_numbers(const ForceChains& chains) {
  std::vector<double> numbers;
  for (const std::uint32_t chain : chains.of_particle) numbers.push_back(chain == no_chain ? no_value : chain);
  return numbers;
}

}  // namespace

std::vector<ParticleField> force_fields(const Snapshot& snapshot, const Context& context) {
  const ForceNetwork network = force_network(snapshot);
  StressFields stress;
  ParticleField chain{.name = "chain",
                      .definition = "number of its force chain in table chain_links; none outside of chains"};
  if (network.missing.empty()) {
    stress.compute(snapshot, network);
    chain.values = chain_numbers(force_chains(snapshot, network, context.options.forces));
  }
  std::vector<ParticleField> fields = std::move(stress).all();
  fields.push_back(std::move(chain));
  if (!network.missing.empty()) fields = without_values(std::move(fields), network.missing);
  fields.push_back({.name = "core",
                    .definition = "largest k of a k-core of the contacts between particles that holds the particle",
                    .values = as_values(core_numbers(adjacency(context.contacts.pairs, snapshot.size())))});
  return fields;
}

}  // namespace packstone::analysis
