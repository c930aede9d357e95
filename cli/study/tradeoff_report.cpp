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

std::pair<double, double> with_room(double low, double high) {
  return with_two_decades({low / chart_margin, high * chart_margin});
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
  text += "| variant | seconds | million particle steps | mean | spread | error | its standard error | |\n";
  text += "|---|---|---|---|---|---|---|---|\n";
  for (const TradeoffRow* row : rows_with(tradeoff, quantity)) {
    const Accuracy& a = row->accuracy.at(quantity);
    std::vector<std::string> marks;
    if (row->label == tradeoff.reference) {
      marks.emplace_back("reference");
    } else if (!a.measured) {
      marks.emplace_back("within noise");
    }
    if (row->on_front.at(quantity)) marks.emplace_back("front");
    text += fmt::format("| {} | {:.3g} | {:.4g} | {:.5g} | {:.2g} | {:.2g} | {:.2g} | {} |\n", row->label, row->seconds,
                        1e-6 * row->particle_steps, a.mean, a.spread, a.error, a.standard_error, joined(marks));
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
  file.print("variant,quantity,seconds,particle_steps,mean,spread,error,standard_error,reference,front,failure\n");
  for (const TradeoffRow& row : tradeoff.rows) {
    if (!row.failure.empty()) {
      file.print("{},,{},{},,,,,0,0,{}\n", in_quotes(row.label), row.seconds, row.particle_steps,
                 in_quotes(row.failure));
    }
    for (const auto& [quantity, a] : row.accuracy) {
      file.print("{},{},{},{},{},{},{},{},{:d},{:d},\n", in_quotes(row.label), quantity, row.seconds,
                 row.particle_steps, a.mean, a.spread, a.error, a.standard_error, row.label == tradeoff.reference,
                 row.on_front.at(quantity));
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
  double lowest = INFINITY, highest = 0, cheapest = INFINITY, dearest = 0;
  std::vector<viz::Series> points;
  for (const TradeoffRow* row : rows_with(tradeoff, quantity)) {
    if (row->label == tradeoff.reference) continue;
    const Accuracy& a = row->accuracy.at(quantity);
    const double shown = a.known();
    if (!(shown > 0)) continue;  // the same bed
    viz::Series point{row->label + (a.measured ? "" : " (within noise)"), {row->seconds}, {shown}};
    // An error bar must not reach 0 on a logarithmic axis.
    point.spread = {std::min(a.standard_error, 0.9 * shown)};
    point.marked = true;
    points.push_back(point);
    if (row->on_front.at(quantity)) {
      front.x.push_back(row->seconds);
      front.y.push_back(shown);
    }
    lowest = std::min(lowest, shown - point.spread.front());
    highest = std::max(highest, shown + point.spread.front());
    cheapest = std::min(cheapest, row->seconds);
    dearest = std::max(dearest, row->seconds);
  }
  if (points.empty()) return chart;
  chart.options.x_range = with_room(cheapest, dearest);
  chart.options.y_range = with_room(std::max(lowest, 0.02 * highest), highest);
  if (front.x.size() > 1) chart.series.push_back(front);
  chart.series.insert(chart.series.end(), points.begin(), points.end());
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
  double reference_seconds = 0;
  for (const TradeoffRow& row : tradeoff.rows) {
    if (row.label == tradeoff.reference) reference_seconds = row.seconds;
  }
  return fmt::format("for {}: {}, {:.3g} times cheaper than \"{}\"", joined(asked),
                     best->label == tradeoff.reference ? "only the reference itself" : "\"" + best->label + "\"",
                     reference_seconds / best->seconds, tradeoff.reference);
}

}  // namespace packstone::cli
