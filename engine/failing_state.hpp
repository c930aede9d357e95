// The state in which a run is stopped: who touches the offenders, and a snapshot in which they are marked.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/run_verdict.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "engine/boundary/boundaries.hpp"
#include "engine/dynamics/particles.hpp"

namespace packstone::engine {

struct FailingState {
  const Scene& scene;
  const Domain& domain;
  const Particles& particles;
  const Boundaries& boundaries;
  double scale;       ///< of growing radii
  bool two_instants;  ///< Particles::next holds the instant a step before or after: of Newtonian motion

  /// Adds the particles and boundaries that the verdict's particles touch, now or at the other instant, and the place
  /// of the first where it is not known.
  void name_contacts(RunVerdict& verdict) const;

  /// Marks the verdict's particles in a snapshot of this instant, whose rows are by id, by offender_field, and adds
  /// velocities as contacts see them. One whose position is not a number is put where it was at the other instant or,
  /// if that is none either, left out; notes say so.
  void mark(Snapshot& snapshot, const RunVerdict& verdict) const;

 private:
  /// A position that is a number: now or, failing that, at the other instant.
  std::optional<Vec3> place(std::size_t slot) const;
  /// Of energies that are none, whose motion made them so.
  void name_next_no_numbers(RunVerdict& verdict) const;
  /// Says so where an offender that is no number shared its place with another particle.
  void blame_same_place(RunVerdict& verdict, const std::vector<std::size_t>& offenders) const;
  bool touch(std::size_t a, std::size_t b) const;
  bool touches(std::size_t slot, const Boundaries::Body& body) const;
  NamedParticle named(std::size_t slot) const;
  const Row* other_instant(std::size_t slot) const;
};

}  // namespace packstone::engine
