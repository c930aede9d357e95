// Central forces at an instant, and how they change with the particles' positions, for motion that is not a step's.
#pragma once

#include <memory>
#include <vector>

#include "core/scene.hpp"
#include "engine/detection/neighbour_list.hpp"
#include "engine/detection/wall_list.hpp"
#include "engine/dynamics/contact_matrix.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine {

class ForceField {
 public:
  virtual ~ForceField() = default;

  /// As Dynamics::rebuild. least_share: of its radius, that each particle may move at least.
  virtual void rebuild(Particles& particles, const Growth& growth, double dt, double least_share) = 0;

  /// Of contacts, into particles.force. Sums are as Dynamics::advance makes them, apart from motion.
  virtual StepSums find(Particles& particles, const StepInput& input, Recorder* recorder) = 0;

  /// How the forces of contacts change, where the particles are.
  virtual void linearise(const Particles& particles, double scale, ContactMatrix& matrix) = 0;

  /// As Dynamics::archive.
  virtual void archive(Archive& a, Particles& particles) = 0;

  virtual NeighbourList& neighbours() = 0;
  virtual const WallList& walls() = 0;
  virtual const std::vector<WallLoad>& wall_loads() const = 0;
};

/// The boundaries must outlive it. Of linear and of Hertz' contacts.
std::unique_ptr<ForceField> make_linear_forces(const Scene& scene, const Domain& domain, const Boundaries& boundaries);
std::unique_ptr<ForceField> make_hertz_forces(const Scene& scene, const Domain& domain, const Boundaries& boundaries);

}  // namespace packstone::engine
