// What a snapshot file may hold. All throw InputError that names the file and what is wrong with it.
#pragma once

#include <vector>

#include "core/hdf5.hpp"
#include "core/snapshot.hpp"

namespace packstone {

bool all_finite(const std::vector<Vec3>& vectors);

/// Domain, gravity, densities and where boundaries stand are numbers, and possible ones.
void check_context(const hdf5::Reader& file, const Snapshot& snapshot);

/// Contacts are of a particle with another, or with a boundary that there is; their numbers are finite.
void check_contacts(const hdf5::Reader& file, const Snapshot& snapshot);

/// Groups and materials are there, positions and radii finite, radii not negative.
void check_particles(const hdf5::Reader& file, const Snapshot& snapshot);

/// Of a snapshot whose particles were all read: ids occur once, contacts are of particles that there are.
void check_ids(const hdf5::Reader& file, const Snapshot& snapshot);

}  // namespace packstone
