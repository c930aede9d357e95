#include "analysis/series.hpp"

#include <algorithm>
#include <exception>
#include <mutex>

#include "analysis/measures.hpp"
#include "analysis/time/course.hpp"
#include "core/error.hpp"

namespace packstone::analysis {

namespace {

/// The course is measured apart, one snapshot after the other.
MeasureResult course_of(const RunReader& run, std::span<const std::size_t> indices, const SeriesOptions& options) {
  Course course(options.trajectories);
  for (const std::size_t index : indices) course.add(run.snapshot(index, {.region = {}, .contacts = false}));
  if (!run.is_folder()) return course.result(nullptr);
  const History history = run.history();
  return course.result(&history);
}

/// HDF5 as Debian builds it is for one thread at a time.
Snapshot read_alone(const RunReader& run, std::size_t index) {
  static std::mutex reading;
  const std::lock_guard lock(reading);
  return run.snapshot(index);
}

}  // namespace

std::vector<TimedResults> analyze_series(const RunReader& run, std::span<const std::size_t> indices,
                                         const SeriesOptions& options) {
  std::vector<std::string> only = options.only;
  const auto named = std::find(only.begin(), only.end(), course_name);
  const bool course_named = named != only.end();
  const bool course_wanted = (options.only.empty() || course_named) && indices.size() > 1;
  if (course_named && !course_wanted) {
    throw InputError("the measure 'course' needs several snapshots; --at all takes them");
  }
  if (!options.trajectories.empty() && !course_wanted) {
    throw InputError("trajectories need the measure 'course' and several snapshots; --at all takes them");
  }
  if (course_named) only.erase(named);
  const bool measures_wanted = options.only.empty() || !only.empty();

  std::vector<TimedResults> series(indices.size());
  std::vector<std::exception_ptr> failures(indices.size());
  std::size_t done = 0;
  const auto count = static_cast<std::ptrdiff_t>(indices.size());
  // Within a thread of this loop the measures' own loops run on it alone.
#pragma omp parallel for schedule(dynamic) if (count > 1)
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    try {
      const Snapshot snapshot = read_alone(run, indices[k]);
      series[k] = {snapshot.time, snapshot.step, {}, snapshot.notes};
      if (measures_wanted) series[k].results = analyze(snapshot, only, options.measure);
    } catch (...) {
      failures[k] = std::current_exception();
    }
#pragma omp critical(series_progress)
    try {
      if (options.progress) options.progress(++done);
    } catch (...) {
      if (!failures[k]) failures[k] = std::current_exception();
    }
  }
  for (const auto& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  if (course_wanted) series.back().results.push_back(course_of(run, indices, options));
  return series;
}

}  // namespace packstone::analysis
