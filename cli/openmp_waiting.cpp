// How long OpenMP's threads spin before they sleep. libgomp's default spins for milliseconds, which on a machine that
// others use too keeps the very thread it waits for off the processor: eight times slower, measured. A few microseconds
// are enough for a time step. libgomp reads its environment when it is loaded, so this runs before any library's start.

#include <cstdlib>

namespace {

void limit_spinning(int, char**, char**) {
  if (!std::getenv("OMP_WAIT_POLICY")) setenv("GOMP_SPINCOUNT", "2000", 0);
}

}  // namespace

[[gnu::used, gnu::section(".preinit_array")]] void (*const packstone_limit_spinning)(int, char**,
                                                                                     char**) = limit_spinning;
