// Of a build without MPI.
#include "core/error.hpp"
#include "core/launched.hpp"
#include "viz/ranks.hpp"

namespace packstone::viz {

struct Ranks::Link {};

Ranks::Ranks() = default;
Ranks::~Ranks() = default;

bool Ranks::first() const { return true; }
int Ranks::count() const { return 1; }

void Ranks::do_units(const WorkInUnits& work, int workers) { viz::do_units(work, workers); }

void with_ranks(const std::function<void(Ranks&)>& work) {
  if (const auto process = launched(); process && process->ranks > 1) {
    throw InputError(
        "this packstone was built without MPI and cannot share its work with others; start one, with "
        "--workers N");
  }
  Ranks alone;
  work(alone);
}

}  // namespace packstone::viz
