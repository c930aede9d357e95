// packstone tradeoff: what each choice of model, step and method costs in a scene, and what it gives.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "cli/interrupt.hpp"
#include "cli/picture_verbs.hpp"
#include "cli/pictures.hpp"
#include "cli/progress.hpp"
#include "cli/study/tradeoff_report.hpp"
#include "cli/study/tradeoff_table.hpp"
#include "cli/study/trials.hpp"
#include "cli/study/variants.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/formats/text_output.hpp"
#include "core/text_lines.hpp"

namespace packstone::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t first_seed = 1;

struct TradeoffOptions {
  fs::path scene;
  std::vector<std::string> overrides;
  std::vector<std::string> vary;
  std::vector<std::string> measures = {"packing_fraction", "coordination"};
  std::vector<std::string> tolerances;
  std::string reference;
  int seeds = 3;
  int threads = 0;
  fs::path output = "tradeoff";
  std::string format = "png";
  FigureCall figure;
  std::string title;
  bool quiet = false;
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

std::map<std::string, double> tolerances_of(const TradeoffOptions& options) {
  std::map<std::string, double> tolerances;
  for (const std::string& text : options.tolerances) {
    const auto equals = text.find('=');
    const auto number = equals == std::string::npos ? std::nullopt : parsed_number(text.substr(equals + 1));
    if (!number || !(*number > 0)) {
      throw InputError(
          fmt::format("--tolerance {}: QUANTITY=NUMBER would be right, such as packing_fraction=0.002", text));
    }
    tolerances[quantity_of(text.substr(0, equals))] = *number;
  }
  return tolerances;
}

/// What is measured: what was asked for, and what has a tolerance.
std::vector<std::string> quantities_of(const TradeoffOptions& options,
                                       const std::map<std::string, double>& tolerances) {
  std::vector<std::string> quantities;
  for (const std::string& name : options.measures) quantities.push_back(quantity_of(name));
  for (const auto& [quantity, tolerance] : tolerances) {
    if (std::find(quantities.begin(), quantities.end(), quantity) == quantities.end()) quantities.push_back(quantity);
  }
  return quantities;
}

/// One seed's scene of each variant; those that the scene does not bear are refused with a reason. What the user asked
/// for in words that no scene knows is an error.
VariantTrials prepared(const TradeoffOptions& options, const Variant& variant, std::vector<Scene>& scenes) {
  VariantTrials trials{variant.label, "", {}};
  try {
    for (int k = 0; k < options.seeds; ++k) {
      scenes.push_back(scene_of(options.scene, options.overrides, variant, first_seed + k));
    }
  } catch (const InputError& error) {
    if (!options.vary.empty() || variant.settings.empty()) throw;
    trials.refused = error.what();
    scenes.clear();
  }
  return trials;
}

std::vector<VariantTrials> run_all(const TradeoffOptions& options, const std::vector<std::string>& quantities) {
  const std::vector<Variant> variants = chosen_variants(options);
  std::vector<VariantTrials> all;
  std::vector<std::vector<Scene>> scenes(variants.size());
  for (std::size_t v = 0; v < variants.size(); ++v) all.push_back(prepared(options, variants[v], scenes[v]));
  const TrialCall call{quantities, options.threads, interrupted};
  Progress progress("runs", options.quiet);
  const auto runs = static_cast<std::int64_t>(variants.size()) * options.seeds;
  // Seed by seed, so that a slow hour of a shared machine meets all variants alike.
  for (int k = 0; k < options.seeds; ++k) {
    for (std::size_t v = 0; v < variants.size(); ++v) {
      progress.update(static_cast<std::int64_t>(k * variants.size() + v), runs, variants[v].label);
      if (!all[v].refused.empty()) continue;
      try {
        all[v].trials.push_back(run_trial(scenes[v][k], variants[v].label, options.output / "runs", call));
      } catch (const InputError& error) {
        all[v].refused = error.what();
        all[v].trials.clear();
      }
    }
  }
  return all;
}

void tradeoff(const TradeoffOptions& options) {
  const auto tolerances = tolerances_of(options);
  const auto quantities = quantities_of(options, tolerances);
  catch_interrupts();
  const Tradeoff result = tradeoff_of(run_all(options, quantities), quantities, options.reference);
  const std::string title = options.title.empty() ? read_scene(options.scene, options.overrides).title : options.title;
  std::string text;
  for (const std::string& quantity : quantities) {
    text += to_markdown(result, quantity) + "\n";
    viz::Chart chart = tradeoff_chart(result, quantity, title);
    if (chart.series.empty()) continue;
    take_size(options.figure, chart.options);
    save_figure(options.output / (quantity + "." + options.format), viz::chart_drawing(chart), options.figure,
                chart.options.supersampling, chart.options.title);
  }
  text += failures(result);
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
  verb.add("scene", options->scene, "Scene file (TOML)").required();
  verb.add("--set", options->overrides, "Override a key of the scene for all variants, KEY=VALUE; may be repeated")
      .one_at_a_time();
  verb.add("--vary", options->vary,
           "Variants beside the scene as it is; may be repeated. KEY=V1,V2,...: one for each value of a key of the "
           "scene, of stiffness (a factor on all, restitutions kept) or of step (a factor on the recommended one). "
           "\"NAME: KEY=VALUE; KEY=VALUE\": one [step 0.5, 1, 2; stiffness 0.1, 0.01; mixed precision; goal rest]")
      .one_at_a_time();
  verb.add("--measure", options->measures,
           "Quantities of the last snapshot, by comma: MEASURE.QUANTITY as in analyze --json, or packing_fraction, "
           "coordination, bed_height, lacey")
      .by_comma()
      .shows_default();
  verb.add("--tolerance", options->tolerances,
           "Recommend the cheapest variant whose error is below, QUANTITY=NUMBER; may be repeated")
      .one_at_a_time();
  verb.add("--reference", options->reference, "Label of the variant to compare with [the dearest]");
  verb.add("--seeds", options->seeds, "Runs of each variant, of seeds 1, 2, ...: errors carry their spread")
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
