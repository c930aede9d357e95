#include "cli/charts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/measures.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace packstone::cli {

namespace {

/// A chart of columns of history.csv over time.
struct TimeChart {
  const char* name;
  const char* title;
  const char* y_label;
  bool log_y;
  std::vector<std::pair<const char*, const char*>> columns;  ///< column, name in the legend
};

const std::vector<TimeChart>& time_charts() {
  static const std::vector<TimeChart> charts = {
      {"energy",
       "Energies",
       "Energy [J]",
       true,
       {{"gravitational", "gravitational"},
        {"kinetic_translational", "kinetic, translation"},
        {"kinetic_rotational", "kinetic, rotation"},
        {"elastic", "elastic"}}},
      {"kinetic", "Kinetic energy", "Energy [J]", true, {{"kinetic_translational", "translation"}}},
      {"packing", "Packing fraction of the bed's bulk", "Solid fraction", false, {{"packing_fraction", "fraction"}}},
      {"height", "Height of the equivalent bed", "Height [m]", false, {{"bed_height", "height"}}},
      {"coordination", "Contacts with other particles", "Coordination number", false, {{"coordination", "contacts"}}},
      {"account",
       "Energy account",
       "Energy [J]",
       true,
       {{"growth_work", "put in by growth"},
        {"gravity_work", "put in by gravity"},
        {"dissipated", "dissipated by the law"},
        {"energy_error", "unaccounted for"}}}};
  return charts;
}

viz::Chart over_time(const TimeChart& what, const std::vector<RunReader>& runs) {
  viz::Chart chart;
  chart.options.title = what.title;
  chart.options.x_label = "Time [s]";
  chart.options.y_label = what.y_label;
  chart.options.log_y = what.log_y;
  for (const RunReader& run : runs) {
    const History history = run.history();
    for (const auto& [column, name] : what.columns) {
      const auto& values = history.column(column);
      const bool anything = std::any_of(values.begin(), values.end(), [](double v) { return v > 0; });
      if (!anything && what.columns.size() > 1) continue;  // an energy that this scene does not have
      const std::string label = runs.size() == 1           ? name
                                : what.columns.size() == 1 ? run_label(run)
                                                           : fmt::format("{}: {}", run_label(run), name);
      chart.series.push_back({label, history.column("time"), values});
    }
  }
  return chart;
}

std::vector<double> column(const analysis::Table& table, const std::string& name) {
  std::size_t index = 0;
  while (table.columns[index].name != name) ++index;
  std::vector<double> values;
  for (const auto& row : table.rows) values.push_back(row[index]);
  return values;
}

std::vector<double> middles(const analysis::Table& table) {
  std::vector<double> values = column(table, "lower");
  const auto upper = column(table, "upper");
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = 0.5 * (values[k] + upper[k]);
  return values;
}

/// The last snapshot's table; throws when the measure does not apply.
analysis::Table last_table(const RunReader& run, const std::string& measure, const std::string& key) {
  const auto results = analysis::analyze(run.snapshot(run.index_at("last")), {measure});
  const analysis::Table* table = results.front().table(key);
  if (!table) throw InputError(fmt::format("{}: there is no {} of {}", run.path().string(), key, measure));
  return *table;
}

viz::Chart fraction_profile(const std::vector<RunReader>& runs) {
  viz::Chart chart;
  chart.options.title = "Solid fraction by height";
  chart.options.x_label = "Solid fraction";
  chart.options.y_label = "Height above the floor [m]";
  chart.options.profile = true;
  for (const RunReader& run : runs) {
    const analysis::Table table = last_table(run, "packing", "profile");
    chart.series.push_back({run_label(run), column(table, "fraction"), middles(table)});
  }
  return chart;
}

viz::Chart composition(const std::vector<RunReader>& runs) {
  viz::Chart chart;
  chart.options.title = "Composition by height";
  chart.options.x_label = "Share of the solid";
  chart.options.y_label = "Height above the floor [m]";
  chart.options.profile = true;
  chart.options.x_range = std::pair{0.0, 1.0};
  for (const RunReader& run : runs) {
    const Snapshot snapshot = run.snapshot(run.index_at("last"));
    const analysis::Table table = last_table(run, "segregation", "composition");
    const auto type = column(table, "type"), share = column(table, "share"), height = middles(table);
    const auto expected = column(table, "expected"), spread = column(table, "spread");
    for (std::size_t g = 0; g < snapshot.groups.size(); ++g) {
      viz::Series line, mixed;
      line.name =
          runs.size() == 1 ? snapshot.groups[g].name : fmt::format("{}: {}", run_label(run), snapshot.groups[g].name);
      mixed.name = "random mixing";
      mixed.colour = viz::faint_ink;
      if (runs.size() == 1) line.colour = viz::category_colour(g);
      for (std::size_t k = 0; k < table.rows.size(); ++k) {
        if (static_cast<std::size_t>(type[k]) != g) continue;
        line.x.push_back(share[k]);
        line.y.push_back(height[k]);
        mixed.x.push_back(expected[k]);
        mixed.y.push_back(height[k]);
        mixed.spread.push_back(spread[k]);
      }
      // Of two types the random shares mirror each other: one band says it all.
      if (g == 0 && runs.size() == 1) chart.series.push_back(mixed);
      chart.series.push_back(line);
    }
  }
  return chart;
}

/// Radius [m], summed, and number of the particles of one group.
struct GroupSize {
  double radius = 0;
  double count = 0;

  double mean() const { return radius / count; }
};

/// How many of the smaller kind there are for each of the larger.
double small_per_big(const RunReader& run, const Snapshot& snapshot) {
  std::vector<GroupSize> groups(snapshot.groups.size());
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    groups[snapshot.type[i]].radius += snapshot.radius[i];
    ++groups[snapshot.type[i]].count;
  }
  std::erase_if(groups, [](const GroupSize& g) { return g.count == 0; });
  if (groups.size() != 2) {
    throw InputError(fmt::format("{}: --what mixture is for packings of two kinds of particles; there are {}",
                                 run.path().string(), groups.size()));
  }
  const bool first_is_small = groups[0].mean() < groups[1].mean();
  return first_is_small ? groups[0].count / groups[1].count : groups[1].count / groups[0].count;
}

/// One point a run.
viz::Chart mixture(const std::vector<RunReader>& runs) {
  struct Point {
    double ratio, fraction, error;
  };
  std::vector<Point> points;
  for (const RunReader& run : runs) {
    const Snapshot snapshot = run.snapshot(run.index_at("last"));
    const auto results = analysis::analyze(snapshot, {"packing"});
    const analysis::Quantity* fraction = results.front().quantity("bulk_fraction");
    points.push_back(
        {small_per_big(run, snapshot), fraction->value.value_or(std::nan("")), fraction->uncertainty.value_or(0)});
  }
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.ratio < b.ratio; });
  viz::Series series{.name = "fraction", .x = {}, .y = {}, .marked = true};
  for (const Point& p : points) {
    series.x.push_back(p.ratio);
    series.y.push_back(p.fraction);
    series.spread.push_back(p.error);
  }
  viz::Chart chart;
  chart.options.title = "Packing fraction of a mixture of two sizes";
  chart.options.x_label = "Small particles for each big one";
  chart.options.y_label = "Solid fraction of the bed's bulk \u00b1 standard deviation";
  constexpr double room = 1.05;  // so that the last mark is whole
  chart.options.x_range = std::pair{0.0, room * series.x.back()};
  chart.series = {series};
  return chart;
}

}  // namespace

const std::vector<std::string>& chart_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& chart : time_charts()) all.push_back(chart.name);
    all.insert(all.end(), {"profile", "composition", "mixture"});
    return all;
  }();
  return names;
}

viz::Chart make_chart(const std::string& name, const std::vector<RunReader>& runs) {
  for (const auto& chart : time_charts()) {
    if (name == chart.name) return over_time(chart, runs);
  }
  if (name == "profile") return fraction_profile(runs);
  if (name == "composition") return composition(runs);
  if (name == "mixture") return mixture(runs);
  const auto near = nearest_name(name, chart_names());
  throw InputError(fmt::format("--what {}: unknown chart; {}there are: {}", name,
                               near ? fmt::format("did you mean \"{}\"? ", *near) : "", joined(chart_names())));
}

std::string run_label(const RunReader& run) {
  const auto path = std::filesystem::absolute(run.path()).lexically_normal();
  return path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
}

}  // namespace packstone::cli
