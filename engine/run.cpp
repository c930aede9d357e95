#include "engine/run.hpp"

#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <omp.h>
#include <sys/utsname.h>
#include <unistd.h>

#include "core/checkpoints.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/processor_time.hpp"
#include "core/version.hpp"
#include "engine/earlier_run.hpp"
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

std::string host_name() {
  utsname name{};
  return uname(&name) == 0 ? name.nodename : "unknown";
}

constexpr const char* files_part = "files";

/// Wall time between two checkpoints over what one takes, at least: they cost a run a percent at most.
constexpr double times_between = 100;

void tell(const std::function<void(const std::string&)>& to, const std::string& text) {
  if (to) to(text);
}

/// Run: Simulation or RestRun.
template <class Run>
class RecordedRun {
 public:
  RecordedRun(const Scene& scene, const std::filesystem::path& folder, const RunControl& control,
              const EarlierRun& earlier)
      : control_(control),
        saved_(earlier.checkpoint ? std::make_unique<CheckpointReader>(earlier.checkpoint->file) : nullptr),
        run_(saved_ ? Run(scene, *saved_) : Run(scene)),
        given_(to_toml(scene)),
        checkpoints_(folder) {
    pass_on_warnings();
    const std::string scene_text = to_toml(run_.scene());
    const std::filesystem::path scene_file = folder / "scene.toml";
    if (control.resume && std::filesystem::exists(scene_file)) {
      refuse_other_scene(scene_text, read_text_file(scene_file), folder);
    }
    writer_.emplace(folder, control.resume      ? FolderUse::go_on
                            : control.overwrite ? FolderUse::replace
                                                : FolderUse::refuse);
    record_ = about(scene);
    if (saved_) {
      before_ = earlier.record;
      saved_->begin(files_part);
      writer_->archive(*saved_);
      checkpoints_.keep(*earlier.checkpoint);
      saved_.reset();
    }
    if (control.resume) writer_->cut_history();
    write_record(RunStatus::running, "", earlier.checkpoint ? earlier.checkpoint->head.moment.step : 0);
    writer_->write_scene(scene_text);
  }

  /// checkpoint_interval: of wall time [s]; none: the default, or longer where checkpoints take long.
  RunRecord go(std::optional<double> checkpoint_interval) {
    SimulationEvents events;
    events.snapshot = [&](const Snapshot& snapshot) { writer_->write_snapshot(snapshot); };
    events.history = [&](const auto& columns, const auto& row) { writer_->append_history(columns, row); };
    events.failure = [&](const Snapshot& snapshot) {
      try {
        writer_->write_failing_state(snapshot);
      } catch (const RunError& error) {
        tell(control_.warn, error.what());  // why the run was stopped says more
      }
    };
    events.progress = control_.progress;
    events.should_stop = control_.should_stop;
    if (control_.checkpoints) {
      events.save_is_due = [&, checkpoint_interval] {
        return since_saved_.seconds() >=
               checkpoint_interval.value_or(std::max(OutputSpec::default_checkpoint_interval, times_between * saving_));
      };
      events.save = [&](const RunMoment& moment, const auto& state) { save(moment, state); };
    }
    try {
      run_.run(events);
    } catch (const std::exception& end) {
      const bool interrupted = dynamic_cast<const Interrupted*>(&end) != nullptr;
      if (const auto* failure = dynamic_cast<const RunFailure*>(&end)) record_.failure = failure->verdict();
      try {
        write_record(interrupted ? RunStatus::interrupted : RunStatus::failed, end.what(), run_.steps_done());
      } catch (const RunError&) {
        // A full disk is often what ended the run; its message is the one to pass on.
      }
      throw;
    }
    write_record(RunStatus::finished, "", run_.steps_done());
    pass_on_warnings();
    return record_;
  }

 private:
  RunRecord about(const Scene& scene) const {
    RunRecord record;
    record.title = scene.title;
    record.version = version();
    record.git_revision = git_revision();
    record.compiler = compiler();
    record.machine = machine();
    record.scene_hash = scene_hash(run_.scene());
    record.filling_hash = run_.filling_hash();
    record.seed = static_cast<std::uint64_t>(scene.seed);
    record.threads = omp_get_max_threads();
    record.process = getpid();
    record.host = host_name();
    return record;
  }

  void pass_on_warnings() {
    for (; warned_ < run_.warnings().size(); ++warned_) tell(control_.warn, run_.warnings()[warned_]);
  }

  void save(const RunMoment& moment, const std::function<void(Archive&)>& state) {
    const Stopwatch clock;
    writer_->sync();
    checkpoints_.write({moment, program_fingerprint(), given_}, [&](Archive& a) {
      a.begin(files_part);
      writer_->archive(a);
      state(a);
    });
    write_record(RunStatus::running, "", moment.step);
    saving_ = clock.seconds();
    since_saved_ = {};
  }

  void write_record(RunStatus status, const std::string& reason, std::int64_t steps) {
    record_.status = status;
    record_.reason = reason;
    record_.warnings = run_.warnings();
    record_.doubts = run_.doubts();
    record_.particles = status == RunStatus::running ? run_.particle_count() : run_.present_count();
    record_.steps = steps;
    record_.wall_seconds = before_.wall_seconds + clock_.seconds();
    record_.processor_seconds = before_.processor_seconds + processor_seconds() - processor_before_;
    record_.loop_seconds = before_.loop_seconds + run_.loop_seconds();
    record_.list_seconds = before_.list_seconds + run_.list_seconds();
    record_.list_builds = run_.list_builds();
    record_.integrator_steps = run_.work().steps;
    record_.ending = run_.ending();
    writer_->write_record(record_);
  }

  const RunControl& control_;
  Stopwatch clock_, since_saved_;
  double processor_before_ = processor_seconds();
  double saving_ = 0;  ///< that the last checkpoint took [s]
  std::unique_ptr<CheckpointReader> saved_;
  Run run_;
  std::string given_;  ///< scene
  std::optional<RunWriter> writer_;
  Checkpoints checkpoints_;
  RunRecord before_;  ///< of what went before, where the run goes on
  RunRecord record_;
  std::size_t warned_ = 0;
};

template <class Run>
RunRecord run_recorded(const Scene& scene, const std::filesystem::path& folder, const RunControl& control,
                       const EarlierRun& earlier, std::optional<double> checkpoint_interval) {
  return RecordedRun<Run>(scene, folder, control, earlier).go(checkpoint_interval);
}

}  // namespace

RunRecord run_scene(const Scene& given, const std::filesystem::path& folder, const RunControl& control) {
  omp_set_num_threads(control.threads > 0 ? control.threads : omp_get_num_procs());
  Scene scene = given;
  scene.output.checkpoint_interval.reset();  // how often a run is kept is no part of it
  const std::optional<double> checkpoint_interval = given.output.checkpoint_interval;
  EarlierRun earlier;
  if (control.resume) {
    earlier = find_earlier_run(scene, folder);
    if (earlier.finished) {
      tell(control.note, folder.string() + ": the run is finished; there is nothing to go on with");
      return earlier.record;
    }
    tell(control.note,
         earlier.checkpoint
             ? fmt::format("goes on from {}, t = {:.6g} s, step {}", earlier.checkpoint->file.filename().string(),
                           earlier.checkpoint->head.moment.time, earlier.checkpoint->head.moment.step)
             : folder.string() + ": holds no checkpoint; the run begins at its beginning");
  }
  return scene.dynamics.goal == Goal::rest
             ? run_recorded<RestRun>(scene, folder, control, earlier, checkpoint_interval)
             : run_recorded<Simulation>(scene, folder, control, earlier, checkpoint_interval);
}

}  // namespace packstone::engine
