// Films of runs, and their frames as pictures.
#include <memory>

#include <fmt/format.h>

#include "cli/film.hpp"
#include "cli/render_source.hpp"

namespace packstone::cli {

void render_film(const RenderCall& call, viz::Ranks& ranks) {
  const RenderSource source(call, "", call.frames.empty() ? ":" : call.frames);
  viz::PictureOptions picture = picture_options(call, source.runs());
  viz::check_picture(picture);
  source.fix_scales(picture);
  const Provenance provenance(source.runs().front(), source.snapshot_of(0), call.recipe);
  const auto prepare = [&] {
    const auto painter = std::make_shared<viz::PanelPainter>(picture, source.titles(), call.columns);
    return [&, painter](std::size_t frame) { return painter->paint(source.read(frame, picture).contents); };
  };
  make_film({.output = call.output,
             .width = picture.width,
             .height = picture.height,
             .rate = call.rate,
             .quiet = call.quiet,
             .workers = worker_count(call.workers),
             .frames = source.frames(),
             .subject = source.subject(),
             .prepare = prepare,
             .file_name = [&](std::size_t frame) { return fmt::format("frame_{:06}.png", source.snapshot_of(frame)); },
             .text = [&](std::size_t frame) { return provenance.at(source.snapshot_of(frame)); }},
            ranks);
}

}  // namespace packstone::cli
