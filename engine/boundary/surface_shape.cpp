#include "engine/boundary/surface_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "core/text_lines.hpp"
#include "engine/formula.hpp"

namespace packstone::engine {

namespace {

constexpr int first_cells = 4;  ///< along each axis
constexpr std::int64_t most_cells = 1 << 20;

/// Heights over a rectangular grid, row by row along x.
struct Heights {
  std::vector<double> x, y, z;

  double at(std::size_t i, std::size_t j) const { return z[j * x.size() + i]; }
};

TriangleSurface joined_up(const Heights& h) {
  TriangleSurface surface;
  for (std::size_t j = 0; j < h.y.size(); ++j) {
    for (std::size_t i = 0; i < h.x.size(); ++i) surface.points.emplace_back(h.x[i], h.y[j], h.at(i, j));
  }
  const auto row = static_cast<std::int32_t>(h.x.size());
  for (std::int32_t j = 0; j + 1 < static_cast<std::int32_t>(h.y.size()); ++j) {
    for (std::int32_t i = 0; i + 1 < row; ++i) {
      const std::int32_t a = j * row + i, b = a + 1, c = a + row, d = c + 1;
      surface.triangles.push_back({a, b, d});
      surface.triangles.push_back({a, d, c});
    }
  }
  return surface;
}

std::vector<double> evenly(double low, double high, std::int64_t cells) {
  std::vector<double> at;
  for (std::int64_t k = 0; k <= cells; ++k) {
    at.push_back(low + (high - low) * static_cast<double>(k) / static_cast<double>(cells));
  }
  return at;
}

}  // namespace

TriangleSurface surface_of_formula(const Scene& scene, const std::string& path, const std::string& text,
                                   double tolerance) {
  const Domain box = scene.box();
  const Formula formula = formula_of(scene, path + ".formula", text, {"x", "y"});
  const auto value = [&](double x, double y) {
    const double z = formula({x, y});
    if (std::isfinite(z)) return z;
    scene.fail(
        path + ".formula",
        fmt::format("\"{}\" is not a number at x = {:g}, y = {:g}; it must be one all over the domain", text, x, y));
  };
  std::int64_t nx = first_cells, ny = first_cells;
  for (;;) {
    Heights h{evenly(box.min[0], box.max[0], nx), evenly(box.min[1], box.max[1], ny), {}};
    for (const double y : h.y) {
      for (const double x : h.x) h.z.push_back(value(x, y));
    }
    double off_x = 0, off_y = 0, off = 0;
    for (std::size_t j = 0; j + 1 < h.y.size(); ++j) {
      for (std::size_t i = 0; i + 1 < h.x.size(); ++i) {
        const double x = 0.5 * (h.x[i] + h.x[i + 1]), y = 0.5 * (h.y[j] + h.y[j + 1]);
        off_x = std::max(off_x, std::abs(value(x, h.y[j]) - 0.5 * (h.at(i, j) + h.at(i + 1, j))));
        off_y = std::max(off_y, std::abs(value(h.x[i], y) - 0.5 * (h.at(i, j) + h.at(i, j + 1))));
        off = std::max(off, std::abs(value(x, y) - 0.5 * (h.at(i, j) + h.at(i + 1, j + 1))));
      }
    }
    if (std::max({off_x, off_y, off}) <= tolerance) return joined_up(h);
    if (nx * ny >= most_cells) {
      scene.fail(path + ".tolerance",
                 fmt::format("{:.3g} m takes more than {} triangles: they still are up to {:.3g} m off; allow more, or "
                             "smooth the formula",
                             tolerance, 2 * nx * ny, std::max({off_x, off_y, off})));
    }
    // A quarter of the error with half the cell, along the axis that needs it.
    const bool both = std::max(off_x, off_y) <= tolerance;
    if (both || off_x > tolerance) nx *= 2;
    if (both || off_y > tolerance) ny *= 2;
  }
}

TriangleSurface surface_of_grid(const std::string& file) {
  const std::string text = read_text_file(file);
  TextLines lines(text, file);
  if (!lines.next() || lines.line() != "x,y,z") {
    throw InputError(file + ":1: expected the header x,y,z; below it a point a line");
  }
  std::map<std::pair<double, double>, double> points;
  std::map<double, int> xs, ys;
  while (lines.next()) {
    const auto fields = split(lines.line(), ',');
    if (fields.size() != 3) lines.fail(fmt::format("the row has {} fields; x, y and z are needed", fields.size()));
    double value[3];
    for (int k = 0; k < 3; ++k) {
      const auto number = parsed_number(fields[k]);
      if (!number || !std::isfinite(*number)) {
        lines.fail(fmt::format("{}: \"{}\" is not a finite number", axis_names[k], fields[k]));
      }
      value[k] = *number;
    }
    if (!points.try_emplace({value[1], value[0]}, value[2]).second) {
      lines.fail(fmt::format("the point x = {:g}, y = {:g} occurs twice", value[0], value[1]));
    }
    ++xs[value[0]];
    ++ys[value[1]];
  }
  if (xs.size() < 2 || ys.size() < 2) throw InputError(file + ": a grid needs two x and two y at least");
  if (points.size() != xs.size() * ys.size()) {
    throw InputError(fmt::format("{}: {} points do not fill a grid of {} x by {} y; each x must occur with each y",
                                 file, points.size(), xs.size(), ys.size()));
  }
  Heights h;
  for (const auto& [x, count] : xs) h.x.push_back(x);
  for (const auto& [y, count] : ys) h.y.push_back(y);
  for (const auto& [place, z] : points) h.z.push_back(z);  // in the order of y, then x
  return joined_up(h);
}

}  // namespace packstone::engine
