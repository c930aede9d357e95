// Draws how the errors of a collision fall with the step, law by law: `step_errors FOLDER` writes
// step_errors_normal.png and step_errors_tangential.png there and prints their numbers.
#include "step_errors.hpp"

#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "viz/chart.hpp"
#include "viz/save_drawing.hpp"

namespace {

using namespace packstone;

constexpr int steps_in_a_contact[] = {8, 13, 25, 50, 100, 200, 400, 800};

/// Cases: errors over the steps in a contact.
template <class Cases>
viz::Chart chart_of(const Cases& cases, const std::string& title, const std::string& error) {
  viz::Chart chart;
  chart.options.title = title;
  chart.options.x_label = "Steps in a contact";
  chart.options.y_label = error;
  chart.options.log_x = chart.options.log_y = true;
  chart.options.x_range = {6, 1000};
  chart.options.y_range = {1e-7, 0.2};
  for (const auto& c : cases) {
    viz::Series series;
    series.name = c.name;
    series.marked = true;
    for (const int steps : steps_in_a_contact) {
      series.x.push_back(steps);
      series.y.push_back(c.error(steps));
    }
    fmt::print("{:24} {:.1e}\n", c.name, fmt::join(series.y, " "));
    chart.series.push_back(series);
  }
  return chart;
}

void save(const std::filesystem::path& path, const viz::Chart& chart) {
  viz::save_drawing(path, viz::chart_drawing(chart), chart.options.supersampling, chart.options.title);
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 2) throw InputError("step_errors FOLDER: the folder for the charts is missing");
  const std::filesystem::path folder = arguments[1];
  fmt::print("{:24} {} steps in a contact\n", "law", fmt::join(steps_in_a_contact, " "));
  save(folder / "step_errors_normal.png",
       chart_of(engine::testing::head_on_errors(), "Head-on collision beside the equation of motion",
                "Error of the restitution"));
  save(folder / "step_errors_tangential.png",
       chart_of(engine::testing::oblique_errors(), "Oblique collision beside its finest step",
                "Error of the departure / approach"));
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}
