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

/// From now on this process works together with the others of its launch. Without it each works for itself, as several
/// runs that srun starts side by side do.
void join_launch();

/// False in the processes that joined their launch, but the first: one message is enough.
bool speaks_for_all();

}  // namespace packstone
