// A stability map as table and chart.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/study/stability_map.hpp"
#include "viz/chart.hpp"

namespace packstone::cli {

/// One row a run: both parameters, verdict, reason.
void write_csv(const std::filesystem::path& path, const StabilityMap& map, const std::vector<MapPoint>& points);

/// A disc a run, coloured by its verdict, and the lines of theory.
viz::Chart stability_chart(const StabilityMap& map, const std::vector<MapPoint>& points);

/// How many runs had each verdict: "52 sound, 10 stopped".
std::string tally(const std::vector<MapPoint>& points);

}  // namespace packstone::cli
