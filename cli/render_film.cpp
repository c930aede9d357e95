// Films of runs, and their frames as pictures.
#include <memory>

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
    return [&, painter](std::size_t frame) { return Frame{painter->paint(source.read(frame).contents), {}}; };
  };
  make_film({.output = call.output,
             .kept = call.kept_frames,
             .width = picture.width,
             .height = picture.height,
             .rate = call.rate,
             .quiet = call.quiet,
             .workers = worker_count(call.workers),
             .frames = source.frames(),
             .subject = source.subject(),
             .prepare = prepare,
             .number = [&](std::size_t frame) { return source.snapshot_of(frame); },
             .text = [&](std::size_t frame) { return provenance.at(source.snapshot_of(frame)); },
             .dots_per_inch = {}},
            ranks);
}

}  // namespace packstone::cli
