// packstone tradeoff: what each choice of model, step and method costs, in a scene's runs, in pictures and in measures
// of a packing, and what it gives.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "cli/interrupt.hpp"
#include "cli/picture_verbs.hpp"
#include "cli/pictures.hpp"
#include "cli/progress.hpp"
#include "cli/study/measure_trials.hpp"
#include "cli/study/picture_trials.hpp"
#include "cli/study/tradeoff_report.hpp"
#include "cli/study/tradeoff_table.hpp"
#include "cli/study/trials.hpp"
#include "cli/study/variants.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/formats/text_output.hpp"
#include "core/run_folder.hpp"
#include "core/text_lines.hpp"

namespace packstone::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t first_seed = 1;

struct TradeoffOptions {
  fs::path path;
  std::vector<std::string> overrides;
  std::vector<std::string> vary;
  std::vector<std::string> measures;
  bool picture = false;
  std::string picture_size = "960x540";
  std::vector<std::string> tolerances;
  std::string reference;
  int seeds = 3;
  int threads = 0;
  fs::path output = "tradeoff";
  std::string format = "png";
  FigureCall figure;
  std::string title;
  bool quiet = false;

  bool of_runs() const { return path.extension() == ".toml"; }
};

/// What was tried, and how it is to be read.
struct Study {
  std::vector<std::string> quantities;
  std::string reference;
  Deviation deviation = Deviation::of_mean;
  std::vector<VariantTrials> trials = {};
  std::string remarks = {};  ///< lines
};

std::vector<Variant> chosen_variants(const TradeoffOptions& options) {
  if (options.vary.empty()) return usual_variants();
  std::vector<Variant> variants = {{as_is, {}}};
  for (const std::string& text : options.vary) {
    const auto more = variants_of(text);
    variants.insert(variants.end(), more.begin(), more.end());
  }
  return variants;
}

std::string full_name(const TradeoffOptions& options, const std::string& quantity) {
  if (!options.picture) return quantity_of(quantity);
  if (quantity == picture_quantity || quantity == "difference") return picture_quantity;
  throw InputError(fmt::format("\"{}\" is no quantity of a picture; {} is the only one", quantity, picture_quantity));
}

std::map<std::string, double> tolerances_of(const TradeoffOptions& options) {
  std::map<std::string, double> tolerances;
  for (const std::string& text : options.tolerances) {
    const auto equals = text.find('=');
    const auto number = equals == std::string::npos ? std::nullopt : parsed_number(text.substr(equals + 1));
    if (!number || !(*number > 0)) {
      throw InputError(
          fmt::format("--tolerance {}: QUANTITY=NUMBER would be right, such as packing_fraction=0.002", text));
    }
    tolerances[full_name(options, text.substr(0, equals))] = *number;
  }
  return tolerances;
}

/// What is measured: what was asked for, and what has a tolerance; else the usual.
std::vector<std::string> quantities_of(const TradeoffOptions& options, const std::map<std::string, double>& tolerances,
                                       const std::vector<std::string>& usual) {
  std::vector<std::string> quantities;
  for (const std::string& name : options.measures) quantities.push_back(full_name(options, name));
  if (options.measures.empty() && (options.of_runs() || tolerances.empty())) {
    for (const std::string& name : usual) quantities.push_back(full_name(options, name));
  }
  for (const auto& [quantity, tolerance] : tolerances) {
    if (std::find(quantities.begin(), quantities.end(), quantity) == quantities.end()) quantities.push_back(quantity);
  }
  return quantities;
}

/// Tries all variants that were not refused, seed by seed, so that a slow hour of a shared machine meets all alike.
void try_all(const TradeoffOptions& options, const char* what, std::vector<VariantTrials>& all,
             const std::function<Trial(std::size_t variant, int seed)>& trial) {
  Progress progress(what, options.quiet);
  const auto count = static_cast<std::int64_t>(all.size());
  for (int k = 0; k < options.seeds; ++k) {
    for (std::size_t v = 0; v < all.size(); ++v) {
      progress.update(k * count + static_cast<std::int64_t>(v), count * options.seeds, all[v].label);
      if (interrupted()) throw Interrupted("stopped");
      if (all[v].refused.empty()) all[v].trials.push_back(trial(v, k));
    }
  }
}

std::vector<VariantTrials> untried(const std::vector<Variant>& variants) {
  std::vector<VariantTrials> all;
  for (const Variant& variant : variants) all.push_back({variant.label, "", {}});
  return all;
}

/// One seed's scene of each variant; those that the scene does not bear are refused with a reason. What the user asked
/// for in words that no scene knows is an error.
VariantTrials prepared(const TradeoffOptions& options, const Variant& variant, std::vector<Scene>& scenes) {
  VariantTrials trials{variant.label, "", {}};
  try {
    for (int k = 0; k < options.seeds; ++k) {
      scenes.push_back(scene_of(options.path, options.overrides, variant, first_seed + k));
    }
  } catch (const InputError& error) {
    if (!options.vary.empty() || variant.settings.empty()) throw;
    trials.refused = error.what();
    scenes.clear();
  }
  return trials;
}

Study study_of_runs(const TradeoffOptions& options, const std::vector<std::string>& quantities) {
  const std::vector<Variant> variants = chosen_variants(options);
  Study study{quantities, options.reference};
  std::vector<std::vector<Scene>> scenes(variants.size());
  for (std::size_t v = 0; v < variants.size(); ++v) study.trials.push_back(prepared(options, variants[v], scenes[v]));
  const TrialCall call{quantities, options.threads, interrupted};
  try_all(options, "runs", study.trials, [&](std::size_t v, int k) -> Trial {
    try {
      return run_trial(scenes[v][k], variants[v].label, options.output / "runs", call);
    } catch (const InputError& error) {
      return {.reason = error.what(), .values = {}};
    }
  });
  return study;
}

Study study_of_measures(const TradeoffOptions& options, const std::vector<std::string>& quantities) {
  if (quantities.size() != 1) throw InputError("--measure: of a packing one quantity at a time");
  const RunReader run(options.path);
  const Snapshot snapshot = run.snapshot(run.snapshot_count() - 1);
  const MeasureStudy measures(snapshot, quantities.front());
  const std::vector<Variant> variants = measures.variants(options.vary);
  Study study{quantities, options.reference.empty() ? measures.reference() : options.reference, Deviation::of_one,
              untried(variants)};
  try_all(options, "measurements", study.trials,
          [&](std::size_t v, int k) { return measures.run(variants[v], first_seed + k); });
  return study;
}

Study study_of_pictures(const TradeoffOptions& options, const std::vector<std::string>& quantities) {
  const auto [width, height] = picture_size(options.picture_size);
  PictureStudy pictures(options.path, options.output / "pictures", width, height);
  const std::vector<Variant> variants = pictures.variants(options.vary);
  Study study{quantities, pictures.reference(), Deviation::of_one, untried(variants)};
  try_all(options, "pictures", study.trials,
          [&](std::size_t v, int k) { return pictures.run(variants[v], first_seed + k); });
  study.remarks = pictures.same_pictures(variants);
  return study;
}

/// What options that do not go together say of themselves.
void check(const TradeoffOptions& options) {
  if (options.of_runs() && options.picture) {
    throw InputError("--picture: of a packing, that is a run folder or a snapshot, not of a scene");
  }
  if (!options.of_runs() && !options.overrides.empty()) throw InputError("--set: of a scene, which this is not");
  if (options.picture && !options.measures.empty()) throw InputError("--measure goes without --picture");
  if (options.picture && !options.reference.empty()) {
    throw InputError("--reference: the finest picture of each look is its reference");
  }
}

Study study_of(const TradeoffOptions& options, const std::map<std::string, double>& tolerances) {
  if (options.picture) return study_of_pictures(options, quantities_of(options, tolerances, {picture_quantity}));
  if (options.of_runs()) {
    return study_of_runs(options, quantities_of(options, tolerances, {"packing_fraction", "coordination"}));
  }
  return study_of_measures(options, quantities_of(options, tolerances, {"packing_fraction"}));
}

std::string title_of(const TradeoffOptions& options) {
  if (!options.title.empty()) return options.title;
  if (options.of_runs()) return read_scene(options.path, options.overrides).title;
  const std::string title = figure_title({RunReader(options.path)}, "");
  return title.empty() ? options.path.filename().string() : title;
}

void tradeoff(const TradeoffOptions& options) {
  check(options);
  const auto tolerances = tolerances_of(options);
  catch_interrupts();
  const Study study = study_of(options, tolerances);
  const auto& quantities = study.quantities;
  const Tradeoff result = tradeoff_of(study.trials, quantities, study.reference, study.deviation);
  const std::string title = title_of(options);
  fs::create_directories(options.output);
  std::string text;
  for (const std::string& quantity : quantities) {
    text += to_markdown(result, quantity) + "\n";
    viz::Chart chart = tradeoff_chart(result, quantity, title);
    if (chart.series.empty()) continue;
    take_size(options.figure, chart.options);
    save_figure(options.output / (quantity + "." + options.format), viz::chart_drawing(chart), options.figure,
                chart.options.supersampling, chart.options.title);
  }
  text += failures(result) + study.remarks;
  if (options.seeds == 1) text += "one seed: what of an error is noise is not known; take more --seeds\n";
  if (!tolerances.empty()) text += advice(result, tolerances) + "\n";
  write_csv(options.output / "tradeoff.csv", result);
  formats::TextOutput table(options.output / "tradeoff.md");
  table.print("{}", text);
  table.finish();
  if (!options.quiet) fmt::print("{}\n{}\n", text, options.output.string());
}

}  // namespace

void add_tradeoff(Program& program) {
  auto options = std::make_shared<TradeoffOptions>();
  options->figure.size = "1600x1000";
  Verb verb = program.add_verb(tradeoff_verb.name, tradeoff_verb.description);
  verb.add("path", options->path,
           "Scene file (TOML), whose runs are varied; else a packing, run folder or snapshot: ways to measure it, or "
           "with --picture to draw it")
      .required();
  verb.add("--set", options->overrides, "Override a key of the scene for all variants, KEY=VALUE; may be repeated")
      .one_at_a_time();
  verb.add(
          "--vary", options->vary,
          "Variants beside the scene as it is; may be repeated. KEY=V1,V2,...: one for each value of a key of the "
          "scene, of stiffness (a factor on all, restitutions kept) or of step (a factor on the recommended one). "
          "\"NAME: KEY=VALUE; KEY=VALUE\": one [step 0.5, 1, 2; stiffness 0.1, 0.01; mixed precision; goal rest]. Of a "
          "packing's fraction: points, even_points, voxels (edge over the mean radius); of its surface: columns "
          "(distance over the mean radius); of a picture: supersampling, cull (on, off), parts, occlusion")
      .one_at_a_time();
  verb.add("--measure", options->measures,
           "Quantities of the last snapshot, by comma: MEASURE.QUANTITY as in analyze --json, or packing_fraction, "
           "coordination, bed_height, lacey [packing_fraction,coordination]; of a packing packing_fraction or "
           "surface.surface_volume")
      .by_comma();
  verb.add_flag("--picture", options->picture, "Ways to draw the packing's last snapshot");
  verb.add("--picture-size", options->picture_size, "Of the pictures that are compared").shows_default();
  verb.add("--tolerance", options->tolerances,
           "Recommend the cheapest variant whose error is below, QUANTITY=NUMBER; may be repeated")
      .one_at_a_time();
  verb.add("--reference", options->reference, "Label of the variant to compare with [the dearest]");
  verb.add("--seeds", options->seeds,
           "Runs of each variant, of seeds 1, 2, ...: errors carry their spread; of points and grids, too; of pictures "
           "views")
      .between(1, 1000)
      .shows_default();
  verb.add("--threads", options->threads, "Threads of each run [all cores]").between(1, 1024);
  verb.add("-o,--output", options->output,
           "Folder for table, charts and runs; called again, runs that it holds are not made again")
      .shows_default();
  verb.add("--format", options->format, "Of the charts").one_of({"png", "svg", "pdf"}).shows_default();
  add_figure_options(verb, options->figure);
  verb.add("--title", options->title, "Title of the charts [the scene's]");
  verb.add_flag("--quiet", options->quiet, "No text and no progress");
  verb.set_action([options] { tradeoff(*options); });
}

}  // namespace packstone::cli
