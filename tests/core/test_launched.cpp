// What launchers leave in the environment.
#include <cstdlib>

#include <catch2/catch.hpp>

#include "core/launched.hpp"

using namespace packstone;

namespace {

/// Set for a while.
struct Variable {
  const char* name;
  Variable(const char* variable, const char* value) : name(variable) { setenv(name, value, 1); }
  ~Variable() { unsetenv(name); }
};

}  // namespace

TEST_CASE("processes of a launch that work each for itself all speak") {
  const Variable rank("PMI_RANK", "2"), ranks("PMI_SIZE", "4");
  CHECK(speaks_for_all());
  join_launch();
  CHECK_FALSE(speaks_for_all());
}

TEST_CASE("a process knows its rank from any launcher, and only from a whole statement") {
  join_launch();
  CHECK_FALSE(launched());
  CHECK(speaks_for_all());
  for (const auto& [rank, ranks] : {std::pair{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                    {"PMI_RANK", "PMI_SIZE"},
                                    {"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}}) {
    INFO(rank);
    const Variable second(rank, "2");
    CHECK_FALSE(launched());
    {
      const Variable four(ranks, "4");
      REQUIRE(launched());
      CHECK(launched()->rank == 2);
      CHECK(launched()->ranks == 4);
      CHECK_FALSE(speaks_for_all());
    }
    for (const char* nonsense : {"", "two", "2", "-4", "4x"}) {
      const Variable wrong(ranks, nonsense);
      CHECK_FALSE(launched());
    }
  }
  const Variable rank("PMI_RANK", "0"), ranks("PMI_SIZE", "4");
  CHECK(speaks_for_all());
}
