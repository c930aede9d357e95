// What mpirun, mpiexec and srun tell the processes that they start.
#pragma once

#include <optional>

namespace packstone {

/// A process among those of one launch.
struct Launched {
  int rank = 0;
  int ranks = 1;
};

/// From the environment that Open MPI, MPICH, Intel MPI and Slurm's PMIx set; nothing where none of them started this
/// process.
std::optional<Launched> launched();

/// False in all processes of a launch but the first: one message is enough.
bool speaks_for_all();

}  // namespace packstone
