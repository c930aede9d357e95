#include "analysis/forces/force_chains.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "analysis/forces/stress.hpp"
#include "analysis/union_find.hpp"
#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

constexpr std::uint32_t shortest_chain = 3;
constexpr std::uint32_t fewest_links_of_a_branch = 3;
constexpr double rounding_slack = 1e-9;  // relative: equal stresses are not above their mean, 45 degrees is within 45

struct StressedParticles {
  std::vector<double> stress;   // (N) largest principal [Pa]
  std::vector<Vec3> direction;  // (N) of it
  double mean = 0;              // over loaded particles [Pa]
};

StressedParticles stressed_particles(const Snapshot& snapshot, const ForceNetwork& network) {
  const std::size_t n = snapshot.size();
  StressedParticles particles{std::vector<double>(n, 0.0), std::vector<Vec3>(n, Vec3::Zero())};
  std::vector<char> loaded(n, 0);
  for (const ForceContact& contact : network.contacts) {
    loaded[contact.first] = 1;
    if (!contact.at_wall()) loaded[contact.second] = 1;
  }
  const auto moments = particle_force_moments(snapshot, network);
#pragma omp parallel for
  for (std::size_t i = 0; i < n; ++i) {
    const double volume = sphere_volume(snapshot.radius[i]);
    if (!loaded[i] || !(volume > 0)) continue;
    const PrincipalStress axes = principal(moments[i]);
    particles.stress[i] = axes.value[0] / volume;
    particles.direction[i] = axes.direction.col(0);
  }
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    sum += particles.stress[i];
    count += loaded[i];
  }
  particles.mean = count > 0 ? sum / count : 0;
  return particles;
}

/// The contacts along which particles are linked, chain yet to be named.
std::vector<ChainLink> links_of(const Snapshot& snapshot, const ForceNetwork& network,
                                const StressedParticles& particles, const ForceOptions& options) {
  const double least = options.chain_threshold * particles.mean * (1 + rounding_slack);
  const double cosine = std::cos(options.chain_angle * std::numbers::pi / 180) - rounding_slack;
  std::vector<ChainLink> links;
  for (std::size_t k = 0; k < network.size(); ++k) {
    const ForceContact& contact = network.contacts[k];
    if (contact.at_wall() || !(normal_force(*snapshot.contacts, k) > 0)) continue;
    const double length = contact.branch.norm();
    const auto carries_on = [&](std::uint32_t row) {
      return particles.stress[row] > least && std::abs(particles.direction[row].dot(contact.branch)) >= cosine * length;
    };
    if (length > 0 && carries_on(contact.first) && carries_on(contact.second)) {
      links.push_back({no_chain, contact.first, contact.second, static_cast<std::uint32_t>(k)});
    }
  }
  return links;
}

/// Chain of every particle, numbered by the lowest id in it.
std::vector<std::uint32_t> chain_of_particles(const Snapshot& snapshot, const std::vector<ChainLink>& links,
                                              std::vector<std::uint32_t>& length) {
  UnionFind sets(snapshot.size());
  for (const ChainLink& link : links) sets.join(link.first, link.second);
  std::vector<std::uint32_t> members;
  for (std::uint32_t i = 0; i < snapshot.size(); ++i) {
    if (sets.size(sets.root(i)) >= shortest_chain) members.push_back(i);
  }
  std::sort(members.begin(), members.end(),
            [&](std::uint32_t a, std::uint32_t b) { return snapshot.id[a] < snapshot.id[b]; });
  std::vector<std::uint32_t> chain(snapshot.size(), no_chain);
  for (const std::uint32_t i : members) {
    const std::uint32_t root = sets.root(i);
    if (chain[root] == no_chain) {
      chain[root] = static_cast<std::uint32_t>(length.size());
      length.push_back(sets.size(root));
    }
    chain[i] = chain[root];
  }
  return chain;
}

}  // namespace

ForceChains force_chains(const Snapshot& snapshot, const ForceNetwork& network, const ForceOptions& options) {
  ForceChains chains;
  const StressedParticles particles = stressed_particles(snapshot, network);
  chains.links = links_of(snapshot, network, particles, options);
  chains.of_particle = chain_of_particles(snapshot, chains.links, chains.length);
  const auto& chain = chains.of_particle;
  std::erase_if(chains.links, [&](const ChainLink& link) { return chain[link.first] == no_chain; });
  std::vector<std::uint32_t> ends(snapshot.size(), 0);
  for (ChainLink& link : chains.links) {
    link.chain = chain[link.first];
    ++ends[link.first];
    ++ends[link.second];
  }
  std::stable_sort(chains.links.begin(), chains.links.end(),
                   [](const ChainLink& a, const ChainLink& b) { return a.chain < b.chain; });
  for (const std::uint32_t links : ends) chains.branch_points += links >= fewest_links_of_a_branch;
  chains.particles = std::accumulate(chains.length.begin(), chains.length.end(), std::size_t{0});
  return chains;
}

}  // namespace packstone::analysis
