#include "engine/run.hpp"

#include <fstream>

#include <omp.h>

#include "core/error.hpp"
#include "core/processor_time.hpp"
#include "core/version.hpp"
#include "engine/rest/rest_run.hpp"
#include "engine/simulation.hpp"
#include "engine/stopwatch.hpp"

namespace packstone::engine {

namespace {

/// Name of the processor.
std::string machine() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

/// Run: Simulation or RestRun.
template <class Run>
RunRecord run_recorded(const Scene& scene, const std::filesystem::path& folder, const RunControl& control) {
  const Stopwatch clock;
  const double processor_before = processor_seconds();
  Run simulation(scene);
  std::size_t warned = 0;
  const auto pass_on_warnings = [&] {
    for (; warned < simulation.warnings().size(); ++warned) {
      if (control.warn) control.warn(simulation.warnings()[warned]);
    }
  };
  pass_on_warnings();

  RunWriter writer(folder, control.overwrite);
  RunRecord record;
  record.title = scene.title;
  record.version = version();
  record.git_revision = git_revision();
  record.compiler = compiler();
  record.machine = machine();
  record.scene_hash = scene_hash(simulation.scene());
  record.filling_hash = simulation.filling_hash();
  record.seed = static_cast<std::uint64_t>(scene.seed);
  record.threads = omp_get_max_threads();
  record.warnings = simulation.warnings();
  record.particles = simulation.particle_count();
  writer.write_scene(to_toml(simulation.scene()));
  writer.write_record(record);

  SimulationEvents events;
  events.snapshot = [&](const Snapshot& snapshot) { writer.write_snapshot(snapshot); };
  events.history = [&](const auto& columns, const auto& row) { writer.append_history(columns, row); };
  events.failure = [&](const Snapshot& snapshot) {
    try {
      writer.write_failing_state(snapshot);
    } catch (const RunError& error) {
      if (control.warn) control.warn(error.what());  // why the run was stopped says more
    }
  };
  events.progress = control.progress;
  events.should_stop = control.should_stop;

  const auto finish = [&](RunStatus status, const std::string& reason) {
    record.particles = simulation.present_count();
    record.steps = simulation.steps_done();
    record.status = status;
    record.reason = reason;
    record.warnings = simulation.warnings();
    record.doubts = simulation.doubts();
    record.wall_seconds = clock.seconds();
    record.processor_seconds = processor_seconds() - processor_before;
    record.loop_seconds = simulation.loop_seconds();
    record.list_seconds = simulation.list_seconds();
    record.list_builds = simulation.list_builds();
    record.integrator_steps = simulation.work().steps;
    record.ending = simulation.ending();
    writer.write_record(record);
  };
  try {
    simulation.run(events);
  } catch (const std::exception& end) {
    const bool interrupted = dynamic_cast<const Interrupted*>(&end) != nullptr;
    if (const auto* failure = dynamic_cast<const RunFailure*>(&end)) record.failure = failure->verdict();
    try {
      finish(interrupted ? RunStatus::interrupted : RunStatus::failed, end.what());
    } catch (const RunError&) {
      // A full disk is often what ended the run; its message is the one to pass on.
    }
    throw;
  }
  finish(RunStatus::finished, "");
  pass_on_warnings();
  return record;
}

}  // namespace

RunRecord run_scene(const Scene& scene, const std::filesystem::path& folder, const RunControl& control) {
  omp_set_num_threads(control.threads > 0 ? control.threads : omp_get_num_procs());
  return scene.dynamics.goal == Goal::rest ? run_recorded<RestRun>(scene, folder, control)
                                           : run_recorded<Simulation>(scene, folder, control);
}

}  // namespace packstone::engine
