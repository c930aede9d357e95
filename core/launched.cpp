#include "core/launched.hpp"

#include <charconv>
#include <cstdlib>
#include <string_view>

namespace packstone {

namespace {

struct Variables {
  const char* rank;
  const char* ranks;
};

constexpr Variables launchers[] = {{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},  // Open MPI's mpirun
                                   {"PMI_RANK", "PMI_SIZE"},                          // MPICH, Intel MPI, Slurm's PMI
                                   {"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}};            // Slurm's PMIx

std::optional<int> number_in(const char* variable) {
  const char* text = std::getenv(variable);
  if (text == nullptr) return std::nullopt;
  const std::string_view word(text);
  int number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return number;
}

bool works_together = false;

}  // namespace

std::optional<Launched> launched() {
  for (const Variables& variables : launchers) {
    const auto rank = number_in(variables.rank), ranks = number_in(variables.ranks);
    if (rank && ranks && *rank >= 0 && *rank < *ranks) return Launched{*rank, *ranks};
  }
  return std::nullopt;
}

void join_launch() { works_together = true; }

bool speaks_for_all() {
  const auto process = works_together ? launched() : std::nullopt;
  return !process || process->rank == 0;
}

}  // namespace packstone
