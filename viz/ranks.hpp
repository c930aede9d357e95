// The processes that mpirun or srun starts, on one machine or several, sharing units of work.
#pragma once

#include <functional>
#include <memory>

#include "viz/workers.hpp"

namespace packstone::viz {

/// The processes of one launch, of which this one has its rank; a single one where nothing launched it.
class Ranks {
 public:
  /// This process alone, which does units by workers of its own.
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  /// The process that takes results and writes files; the others write and say nothing.
  bool first() const;
  int count() const;

  /// As viz::do_units where there is one rank. Otherwise each rank is one worker, whatever workers says; all ranks call
  /// this with the same work, and take is called in the first. Throws what any of them throws, in the first.
  void do_units(const WorkInUnits& work, int workers);

 private:
  friend void with_ranks(const std::function<void(Ranks&)>& work);

  struct Link;
  std::unique_ptr<Link> link_;
};

/// Joins the other processes where mpirun or srun started this one, and does the work in all of them. What it throws in
/// any of them comes out of the first, and returns quietly from the others. Throws InputError where there are several
/// processes and this build has no MPI, and RunError where they do not find each other.
void with_ranks(const std::function<void(Ranks&)>& work);

}  // namespace packstone::viz
