#include "cli/study/stability_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "cli/study/axis_range.hpp"
#include "core/formats/text_output.hpp"
#include "core/text.hpp"

namespace packstone::cli {

namespace {

constexpr viz::Colour line_colours[] = {viz::ink, {120, 60, 140}, {0, 120, 90}};
constexpr Verdict verdicts[] = {Verdict::sound, Verdict::disturbed, Verdict::stopped, Verdict::refused};

/// Light to dark from sound to refused, so that grey print tells them apart; safe for colour-blind readers.
viz::Colour colour_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::sound:
      return {86, 180, 233};
    case Verdict::disturbed:
      return {230, 159, 0};
    case Verdict::stopped:
      return {190, 60, 0};
    case Verdict::refused:
      break;
  }
  return {70, 70, 70};
}

const char* legend_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::sound:
      return "sound";
    case Verdict::disturbed:
      return "ends, but wrong";
    case Verdict::stopped:
      return "stopped by the monitor";
    case Verdict::refused:
      break;
  }
  return "refused before the run";
}

/// Values' range with half a column's room on both sides.
std::pair<double, double> with_room(const std::vector<double>& values, bool logarithmic) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const auto gaps = static_cast<double>(std::max<std::size_t>(values.size(), 2) - 1);
  if (logarithmic) {
    const double room = std::pow(*high / *low, 0.6 / gaps);
    return with_two_decades({*low / room, *high * room});
  }
  const double room = 0.6 * (*high - *low) / gaps;
  return {*low - room, *high + room};
}

}  // namespace

void write_csv(const std::filesystem::path& path, const StabilityMap& map, const std::vector<MapPoint>& points) {
  formats::TextOutput file(path);
  file.print("\"{}\",\"{}\",verdict,energy_error,kinetic,coordination,reason\n", map.x_label, map.y_label);
  for (const MapPoint& p : points) {
    std::string reason = p.outcome.reason;
    std::replace(reason.begin(), reason.end(), '"', '\'');
    file.print("{},{},{},{},{},{},\"{}\"\n", p.x, p.y, to_string(p.outcome.verdict), p.outcome.energy_error,
               p.outcome.kinetic, p.outcome.coordination, reason);
  }
  file.finish();
}

viz::Chart stability_chart(const StabilityMap& map, const std::vector<MapPoint>& points) {
  viz::Chart chart;
  chart.options.title = map.description;
  chart.options.x_label = map.x_label;
  chart.options.y_label = map.y_label;
  chart.options.log_x = true;
  chart.options.log_y = map.log_y;
  chart.options.x_range = with_room(map.x, true);
  chart.options.y_range = with_room(map.y, map.log_y);
  for (const Verdict verdict : verdicts) {
    viz::Series series{legend_of(verdict), {}, {}};
    series.colour = colour_of(verdict);
    series.marked = true;
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();  // discs are not joined
    for (const MapPoint& p : points) {
      if (p.outcome.verdict != verdict) continue;
      series.x.insert(series.x.end(), {p.x, gap});
      series.y.insert(series.y.end(), {p.y, gap});
    }
    if (!series.x.empty()) chart.series.push_back(series);
  }
  const auto [low, high] = *chart.options.y_range;
  std::size_t index = 0;
  for (const Limit& limit : map.limits) {
    viz::Series line{limit.name, {}, {}};
    line.colour = line_colours[std::min(index++, std::size(line_colours) - 1)];
    constexpr int pieces = 60;
    for (int k = 0; k <= pieces; ++k) {
      const double share = static_cast<double>(k) / pieces;
      const double y = map.log_y ? low * std::pow(high / low, share) : low + (high - low) * share;
      const double x = limit.x_at(y);
      if (!(x >= chart.options.x_range->first && x <= chart.options.x_range->second)) continue;
      line.x.push_back(x);
      line.y.push_back(y);
    }
    if (line.x.size() > 1) chart.series.push_back(line);
  }
  return chart;
}

std::string tally(const std::vector<MapPoint>& points) {
  std::vector<std::string> parts;
  for (const Verdict verdict : verdicts) {
    const auto n =
        std::count_if(points.begin(), points.end(), [&](const MapPoint& p) { return p.outcome.verdict == verdict; });
    if (n > 0) parts.push_back(fmt::format("{} {}", n, to_string(verdict)));
  }
  return joined(parts);
}

}  // namespace packstone::cli
