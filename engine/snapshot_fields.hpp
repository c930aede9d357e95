// The particle quantities that output.fields asks for.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/bed_frame.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "engine/dynamics/particles.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine {

/// What fields are made of, at one instant.
struct FieldSources {
  const Particles& particles;
  const Recorder& recorder;
  const Snapshot& geometry;  ///< positions and radii by id, gravity
  bool gravity_acts;
};

/// Adds one field, rows by id.
void add_field(std::map<std::string, Field>& fields, OutputField which, const FieldSources& sources);

/// -m g . x by id [J], x from the floor and the domain's lower corner; 0 before gravity acts.
std::vector<double> gravitational_energies(const Particles& particles, const Snapshot& geometry, const BedFrame& frame,
                                           bool gravity_acts);

}  // namespace packstone::engine
