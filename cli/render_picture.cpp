// One picture of a packing, in tiles.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cli/drawn_by.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/render_source.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "viz/png.hpp"

namespace packstone::cli {

namespace {

constexpr double most_tile_pixels = 16e6;  // of the default tiles: 50 MB of picture each

/// How a picture is divided, row by row from the top left.
struct Tiling {
  viz::PixelWindow whole;
  int columns = 1, rows = 1;

  std::size_t tiles() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  viz::PixelWindow tile(std::size_t index) const {
    const auto column = static_cast<int>(index % static_cast<std::size_t>(columns));
    const auto row = static_cast<int>(index / static_cast<std::size_t>(columns));
    const auto place = [](int side, int k, int count) {
      return static_cast<int>(static_cast<std::int64_t>(side) * k / count);
    };
    const int left = place(whole.width, column, columns), top = place(whole.height, row, rows);
    return {left, top, place(whole.width, column + 1, columns) - left, place(whole.height, row + 1, rows) - top};
  }
  std::size_t largest_tile() const {
    std::size_t pixels = 0;
    for (std::size_t k = 0; k < tiles(); ++k) pixels = std::max(pixels, tile(k).pixels());
    return pixels;
  }
};

Tiling tiling_of(const RenderCall& call, const viz::PictureOptions& picture) {
  Tiling tiling{.whole = {0, 0, picture.width, picture.height}};
  if (call.tiles.empty()) {
    tiling.rows = static_cast<int>(std::ceil(static_cast<double>(tiling.whole.pixels()) / most_tile_pixels));
    return tiling;
  }
  int used = 0;
  const bool read = std::sscanf(call.tiles.c_str(), "%dx%d%n", &tiling.columns, &tiling.rows, &used) == 2 &&
                    used == static_cast<int>(call.tiles.size());
  if (!read || tiling.columns < 1 || tiling.rows < 1 || tiling.columns > picture.width ||
      tiling.rows > picture.height) {
    throw InputError(fmt::format("--tiles {}: expected COLUMNSxROWS, at most one a pixel, such as 4x3", call.tiles));
  }
  return tiling;
}

}  // namespace

void render_picture(const RenderCall& call, viz::Ranks& ranks) {
  const RenderSource source(call, call.at, "");
  viz::PictureOptions picture = picture_options(call, source.runs());
  viz::check_picture(picture);
  source.fix_scales(picture);
  const Tiling tiling = tiling_of(call, picture);
  const std::size_t index = source.snapshot_of(0);
  std::optional<viz::PngWriter> file;
  if (ranks.first()) {
    check_writable(call.output);
    file.emplace(call.output, picture.width, picture.height,
                 Provenance(source.runs().front(), index, call.recipe).at(index));
  }
  Progress progress("tiles", call.quiet || tiling.tiles() == 1);
  std::size_t done = 0;
  const auto stop_when_interrupted = [&] {
    if (interrupted()) throw Interrupted(fmt::format("stopped after {} of {} tiles", done, tiling.tiles()));
  };
  viz::Image band;
  std::string renderer;
  const viz::WorkInUnits work{
      .count = tiling.tiles(),
      .unit_name = "tile",
      .subject = source.subject(),
      .result_bytes = tiling.largest_tile() * 3 + drawn_by_bytes,
      .prepare =
          [&] {
            const auto painter = std::make_shared<viz::PanelPainter>(picture, source.titles(), call.columns);
            const auto shown = std::make_shared<const RenderSource::Shown>(source.read(0));
            painter->show(shown->contents);
            return [painter, shown, &tiling](std::size_t tile) {
              viz::UnitResult result = painter->part(tiling.tile(tile)).rgb;
              tell_drawn_by(result);
              return result;
            };
          },
      .take =
          [&](std::size_t tile, viz::UnitResult result) {
            stop_when_interrupted();
            renderer = take_drawn_by(result);
            const viz::PixelWindow window = tiling.tile(tile);
            if (window.left == 0) {
              band = {picture.width, window.height, {}};
              band.rgb.resize(static_cast<std::size_t>(band.width) * static_cast<std::size_t>(band.height) * 3);
            }
            viz::place(band, {window.width, window.height, std::move(result)}, window.left, 0);
            if (window.right() == picture.width) file->add_rows(band.rgb.data(), band.height);
            done = tile + 1;
            progress.update(static_cast<std::int64_t>(done), static_cast<std::int64_t>(tiling.tiles()),
                            done == tiling.tiles() ? renderer : "");
          },
      .while_waiting = stop_when_interrupted};
  ranks.do_units(work, worker_count(call.workers));
  if (file) file->finish(with_renderer({}, renderer));
}

}  // namespace packstone::cli
