#include "cli/study/tradeoff_report.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "cli/study/axis_range.hpp"
#include "core/formats/text_output.hpp"
#include "core/text.hpp"

namespace packstone::cli {

namespace {

constexpr std::size_t colours = 7;    ///< of series that are told apart
constexpr double chart_margin = 1.6;  ///< of a range on a logarithmic axis, to each side

/// Those that have the quantity, the cheapest first.
std::vector<const TradeoffRow*> rows_with(const Tradeoff& tradeoff, const std::string& quantity) {
  std::vector<const TradeoffRow*> rows;
  for (const TradeoffRow& row : tradeoff.rows) {
    if (row.accuracy.count(quantity)) rows.push_back(&row);
  }
  std::stable_sort(rows.begin(), rows.end(), [](const auto* a, const auto* b) { return a->seconds < b->seconds; });
  return rows;
}

/// Which costs beside the time any variant has.
struct Costs {
  bool steps = false, memory = false;
};

Costs costs_known(const Tradeoff& tradeoff) {
  Costs costs;
  for (const TradeoffRow& row : tradeoff.rows) {
    costs.steps = costs.steps || row.particle_steps > 0;
    costs.memory = costs.memory || row.memory > 0;
  }
  return costs;
}

std::pair<double, double> with_room(double low, double high) {
  return with_two_decades({low / chart_margin, high * chart_margin});
}

struct Extent {
  double low = INFINITY, high = 0;

  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Those whose names differ in the last word alone as one series, in the order of their first: more points than there
/// are colours could not be told apart.
std::vector<viz::Series> in_families(const std::vector<viz::Series>& points) {
  std::vector<viz::Series> families;
  std::vector<std::string> names;
  const auto last_word = [](const std::string& name) { return name.substr(name.find_last_of(' ') + 1); };
  for (const viz::Series& point : points) {
    const std::string name = point.name.substr(0, point.name.find_last_of(' '));
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      names.push_back(name);
      families.push_back(point);
      continue;
    }
    viz::Series& family = families[static_cast<std::size_t>(found - names.begin())];
    family.name = family.name.substr(0, family.name.find(" to ")) + " to " + last_word(point.name);
    family.x.push_back(point.x.front());
    family.y.push_back(point.y.front());
    family.spread.push_back(point.spread.front());
  }
  return families;
}

/// " [m]"; nothing for a pure number.
std::string unit_of(const Tradeoff& tradeoff, const std::string& quantity) {
  const auto unit = tradeoff.units.find(quantity);
  return unit == tradeoff.units.end() || unit->second.empty() ? "" : " [" + unit->second + "]";
}

std::string in_quotes(std::string text) {
  for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) text.insert(at, 1, '"');
  return "\"" + text + "\"";
}

}  // namespace

std::string to_markdown(const Tradeoff& tradeoff, const std::string& quantity) {
  std::string text =
      fmt::format("{}{}, errors beside \"{}\"\n\n", quantity, unit_of(tradeoff, quantity), tradeoff.reference);
  const Costs costs = costs_known(tradeoff);
  text += fmt::format("| variant | seconds |{}{} mean | spread | error | its standard error | |\n",
                      costs.steps ? " million particle steps |" : "", costs.memory ? " memory [GB] |" : "");
  text += fmt::format("|---|---|{}{}---|---|---|---|---|\n", costs.steps ? "---|" : "", costs.memory ? "---|" : "");
  for (const TradeoffRow* row : rows_with(tradeoff, quantity)) {
    const Accuracy& a = row->accuracy.at(quantity);
    std::vector<std::string> marks;
    if (row->label == tradeoff.reference) {
      marks.emplace_back("reference");
    } else if (!a.measured) {
      marks.emplace_back("within noise");
    }
    if (row->on_front.at(quantity)) marks.emplace_back("front");
    text += fmt::format("| {} | {:.3g} |", row->label, row->seconds);
    if (costs.steps) text += fmt::format(" {:.4g} |", 1e-6 * row->particle_steps);
    if (costs.memory) text += fmt::format(" {:.2g} |", 1e-9 * row->memory);
    text += fmt::format(" {:.5g} | {:.2g} | {:.2g} | {:.2g} | {} |\n", a.mean, a.spread, a.error, a.standard_error,
                        joined(marks));
  }
  return text;
}

std::string failures(const Tradeoff& tradeoff) {
  std::string text;
  for (const TradeoffRow& row : tradeoff.rows) {
    if (!row.failure.empty()) text += fmt::format("{}: {}\n", row.label, row.failure);
  }
  return text;
}

void write_csv(const std::filesystem::path& path, const Tradeoff& tradeoff) {
  formats::TextOutput file(path);
  file.print(
      "variant,quantity,seconds,particle_steps,memory,mean,spread,error,standard_error,reference,front,failure\n");
  for (const TradeoffRow& row : tradeoff.rows) {
    if (!row.failure.empty()) {
      file.print("{},,{},{},{},,,,,0,0,{}\n", in_quotes(row.label), row.seconds, row.particle_steps, row.memory,
                 in_quotes(row.failure));
    }
    for (const auto& [quantity, a] : row.accuracy) {
      file.print("{},{},{},{},{},{},{},{},{},{:d},{:d},\n", in_quotes(row.label), quantity, row.seconds,
                 row.particle_steps, row.memory, a.mean, a.spread, a.error, a.standard_error,
                 row.label == tradeoff.reference, row.on_front.at(quantity));
    }
  }
  file.finish();
}

viz::Chart tradeoff_chart(const Tradeoff& tradeoff, const std::string& quantity, const std::string& title) {
  viz::Chart chart;
  chart.options.title = fmt::format("{}, beside \"{}\"", title, tradeoff.reference);
  chart.options.x_label = "Cost [s]";
  chart.options.y_label = "Error of " + quantity.substr(quantity.find('.') + 1) + unit_of(tradeoff, quantity);
  chart.options.log_x = chart.options.log_y = true;
  viz::Series front{"nothing cheaper is nearer", {}, {}};
  front.colour = viz::faint_ink;
  Extent errors, costs;
  double reference_seconds = 0;
  std::vector<viz::Series> points;
  for (const TradeoffRow* row : rows_with(tradeoff, quantity)) {
    const double shown = row->accuracy.at(quantity).known();
    if (row->label == tradeoff.reference || !(shown > 0) || !row->on_front.at(quantity)) continue;
    front.x.push_back(row->seconds);
    front.y.push_back(shown);
  }
  for (const TradeoffRow& row : tradeoff.rows) {
    if (row.label == tradeoff.reference) reference_seconds = row.seconds;
    const auto accuracy = row.accuracy.find(quantity);
    if (row.label == tradeoff.reference || accuracy == row.accuracy.end()) continue;
    const Accuracy& a = accuracy->second;
    const double shown = a.known();
    if (!(shown > 0)) continue;  // the same bed
    viz::Series point{row.label + (a.measured ? "" : " (within noise)"), {row.seconds}, {shown}};
    // An error bar must not reach 0 on a logarithmic axis.
    point.spread = {std::min(a.standard_error, 0.9 * shown)};
    point.marked = true;
    points.push_back(point);
    errors.take(std::max(shown - point.spread.front(), shown / 2));  // longer bars leave the chart
    errors.take(shown + point.spread.front());
    costs.take(row.seconds);
  }
  if (points.empty()) return chart;
  chart.options.x_range = with_room(costs.low, costs.high);
  chart.options.y_range = with_room(errors.low, errors.high);
  if (front.x.size() > 1) chart.series.push_back(front);
  for (viz::Series& series : points.size() > colours ? in_families(points) : points) chart.series.push_back(series);
  if (reference_seconds > costs.low && reference_seconds < costs.high) {
    viz::Series cost{fmt::format("cost of \"{}\"", tradeoff.reference), {reference_seconds, reference_seconds}, {}};
    cost.y = {chart.options.y_range->first, chart.options.y_range->second};
    cost.colour = viz::ink;
    chart.series.push_back(cost);
  }
  return chart;
}

std::string advice(const Tradeoff& tradeoff, const std::map<std::string, double>& tolerances) {
  std::vector<std::string> asked;
  for (const auto& [quantity, tolerance] : tolerances)
    asked.push_back(fmt::format("{} within {:g}", quantity, tolerance));
  const TradeoffRow* best = tradeoff.cheapest(tolerances);
  if (!best) {
    return fmt::format("for {}: no variant is sure to meet that; more --seeds narrow the noise", joined(asked));
  }
  if (best->label == tradeoff.reference) {
    return fmt::format("for {}: \"{}\", the reference; nothing cheaper is sure to meet that", joined(asked),
                       best->label);
  }
  double reference_seconds = 0;
  for (const TradeoffRow& row : tradeoff.rows) {
    if (row.label == tradeoff.reference) reference_seconds = row.seconds;
  }
  return fmt::format("for {}: \"{}\", {:.3g} times cheaper than \"{}\"", joined(asked), best->label,
                     reference_seconds / best->seconds, tradeoff.reference);
}

}  // namespace packstone::cli
