// packstone run: a scene into a run folder.

#include "engine/run.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/scene.hpp"
#include "core/text.hpp"
#include "engine/earlier_run.hpp"

namespace packstone::cli {

namespace {

struct RunOptions {
  std::filesystem::path scene;
  std::filesystem::path folder;
  std::vector<std::string> overrides;
  int threads = 0;
  bool overwrite = false;
  bool resume = false;
  bool quiet = false;
};

void run(const RunOptions& options) {
  std::filesystem::path folder = options.folder;
  if (options.scene.empty() && (!options.resume || folder.empty())) {
    throw InputError("run: name a scene, or with --resume and -o the folder of a run to go on with");
  }
  if (folder.empty())
    folder = std::filesystem::path("runs") /
             std::filesystem::absolute(options.scene).lexically_normal().parent_path().filename();
  const Scene scene = options.scene.empty() ? engine::scene_of_earlier_run(folder, options.overrides)
                                            : read_scene(options.scene, options.overrides);

  catch_interrupts();
  engine::RunControl control;
  control.threads = options.threads;
  control.overwrite = options.overwrite;
  control.resume = options.resume;
  control.should_stop = interrupted;
  control.warn = [](const std::string& text) { fmt::print(stderr, "packstone: warning: {}\n", text); };
  control.note = [](const std::string& text) { fmt::print(stderr, "packstone: {}\n", text); };
  RunRecord record;
  {
    Progress progress("steps", options.quiet);
    control.progress = [&](std::int64_t step, std::int64_t steps, double time) {
      progress.update(step, steps, fmt::format("t = {:.3f} s", time));
    };
    try {
      record = engine::run_scene(scene, folder, control);
    } catch (const Interrupted& stop) {
      throw Interrupted(
          fmt::format("{}; go on with: packstone run --resume -o {}", stop.what(), shell_word(folder.string())));
    }
  }
  if (options.quiet) return;
  fmt::print("{} particles, {} steps in {:.1f} s ({:.1f} million particle-steps a second)\n{}\n", record.particles,
             record.steps, record.wall_seconds,
             1e-6 * static_cast<double>(record.particles * record.steps) / record.loop_seconds, folder.string());
}

}  // namespace

void add_run(Program& program) {
  auto options = std::make_shared<RunOptions>();
  Verb verb = program.add_verb("run", "Simulate a scene into a run folder");
  verb.add("scene", options->scene, "Scene file (TOML); with --resume it may be left out");
  verb.add("-o,--output", options->folder, "Run folder [runs/NAME of the scene's folder]");
  verb.add("--set", options->overrides, "Override a key of the scene, KEY=VALUE; may be repeated").one_at_a_time();
  verb.add("--threads", options->threads, "Threads [all cores]; the result does not depend on it").between(1, 1024);
  auto overwrite = verb.add_flag("--overwrite", options->overwrite, "Replace an earlier run in the folder");
  verb.add_flag("--resume", options->resume, "Go on with a run that was stopped or killed, from its last checkpoint")
      .not_with(overwrite);
  verb.add_flag("--quiet", options->quiet, "No progress");
  verb.set_footer("Keys of the scene, to be set in the file or by --set:\n\n" + scene_reference_text());
  verb.set_action([options] { run(*options); });
}

}  // namespace packstone::cli
