#include "cli/study/measure_trials.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "analysis/mean_diameter.hpp"
#include "analysis/measures.hpp"
#include "analysis/packing/fraction_estimates.hpp"
#include "cli/study/median_time.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace packstone::cli {

namespace {

constexpr const char *fraction = "packing.bulk_fraction", *surface = "surface.surface_volume";
constexpr int times_measured = 3;

const std::vector<std::string> fraction_keys = {"points", "even_points", "voxels"}, surface_keys = {"columns"};
const std::vector<std::string> usual_fractions = {"points=1e3,1e4,1e5,1e6", "even_points=1e3,1e4,1e5,1e6",
                                                  "voxels=1,0.5,0.25,0.125"};
const std::vector<std::string> usual_surfaces = {"columns=1,0.5,0.25,0.125,0.0625,0.03125"};

/// Key and number of a variant's one setting; of none an empty key.
std::pair<std::string, double> setting_in(const Variant& variant, const std::vector<std::string>& keys) {
  if (variant.settings.empty()) return {};
  const auto [key, value] = setting_of(variant.settings.front());
  if (variant.settings.size() > 1 || std::find(keys.begin(), keys.end(), key) == keys.end()) {
    throw InputError(
        fmt::format("\"{}\" is no way to measure; one of {} would be", joined(variant.settings), joined(keys)));
  }
  return {key, factor_of(key, value)};
}

}  // namespace

MeasureStudy::MeasureStudy(const Snapshot& snapshot, const std::string& quantity)
    : snapshot_(snapshot),
      quantity_(quantity),
      surface_(quantity == surface),
      context_(analysis::make_context(snapshot)) {
  if (quantity == fraction) {
    bulk_ = analysis::bulk_region(snapshot, context_);
  } else if (!surface_) {
    throw InputError(
        fmt::format("{} is measured in one way alone; there are several for {} and {}", quantity, fraction, surface));
  }
}

const std::vector<std::string>& MeasureStudy::keys() const { return surface_ ? surface_keys : fraction_keys; }

std::vector<Variant> MeasureStudy::variants(const std::vector<std::string>& vary) const {
  std::vector<std::string> texts = vary;
  if (vary.empty()) texts = surface_ ? usual_surfaces : usual_fractions;
  std::vector<Variant> variants;
  if (!surface_) variants.push_back({exact, {}});
  for (const std::string& text : texts) {
    for (const Variant& variant : variants_of(text)) {
      setting_in(variant, keys());
      variants.push_back(variant);
    }
  }
  return variants;
}

double MeasureStudy::value(const std::string& key, double number, std::int64_t seed) const {
  if (surface_) {
    analysis::Options options;
    if (!key.empty()) options.surface_step = number * analysis::volume_mean_diameter(snapshot_.radius) / 2;
    const auto results = analysis::analyze(snapshot_, {"surface"}, options);
    const analysis::Quantity& volume = *results.front().quantity("surface_volume");
    if (!volume.value) throw InputError("the packing has no free surface: " + volume.note);
    return *volume.value;
  }
  const auto start = static_cast<std::uint64_t>(seed);
  if (key.empty()) return analysis::exact_fraction(snapshot_, bulk_);
  if (key == "voxels") return analysis::voxel_fraction(snapshot_, bulk_, number * context_.mean_radius, start);
  const auto set = key == "points" ? analysis::PointSet::random : analysis::PointSet::even;
  return analysis::sampled_fraction(snapshot_, bulk_, static_cast<std::size_t>(number), set, start);
}

Trial MeasureStudy::run(const Variant& variant, std::int64_t seed) const {
  const auto [key, number] = setting_in(variant, keys());
  Trial trial;
  double found = 0;
  trial.seconds = median_processor_seconds(times_measured, [&] { found = value(key, number, seed); });
  trial.values[quantity_] = found;
  trial.units[quantity_] = surface_ ? "m3" : "";
  trial.finished = true;
  return trial;
}

}  // namespace packstone::cli
