// Films of a run, and its frames as pictures.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "cli/drawn_by.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/render_call.hpp"
#include "cli/selection.hpp"
#include "core/error.hpp"
#include "viz/movie.hpp"
#include "viz/png.hpp"

namespace packstone::cli {

namespace {

/// The scales of a film span all of its frames.
void fix_scales(viz::PictureOptions& picture, const RunReader& run, const std::vector<std::size_t>& frames,
                const OverlayMaker& overlay) {
  const bool colours = !picture.range && !viz::colours_categories(picture.color);
  const bool forces = picture.look.thickest_force == 0, lengths = picture.look.longest_arrow == 0;
  if (!colours && !overlay.needs_common_scale()) return;
  for (const std::size_t index : frames) {
    const Snapshot snapshot = run.snapshot(index, read_for(picture, overlay));
    const auto range = colours ? viz::value_range(snapshot, picture.color) : std::nullopt;
    if (range) {
      picture.range = picture.range ? std::pair{std::min(picture.range->first, range->first),
                                                std::max(picture.range->second, range->second)}
                                    : *range;
    }
    if (!overlay.needs_common_scale()) continue;
    const viz::Overlay shown = overlay.of(snapshot, index);
    if (forces)
      picture.look.thickest_force = std::max(picture.look.thickest_force, shown.links.quantile(viz::link_quantile));
    if (lengths)
      picture.look.longest_arrow = std::max(picture.look.longest_arrow, shown.arrows.quantile(viz::arrow_quantile));
  }
}

/// Frames of a run as pictures of one size, drawn by workers.
class Film {
 public:
  Film(const RenderCall& call, const RunReader& run)
      : run_(run),
        frames_(frame_range(run, call.frames.empty() ? ":" : call.frames)),
        picture_(picture_options(call, run)),
        overlay_(call.overlay, run, frames_),
        progress_("frames", call.quiet) {
    viz::check_picture(picture_);
    fix_scales(picture_, run, frames_, overlay_);
  }

  const viz::PictureOptions& picture() const { return picture_; }
  std::size_t snapshot_of(std::size_t frame) const { return frames_[frame]; }
  std::size_t bytes() const { return viz::PixelWindow{0, 0, picture_.width, picture_.height}.pixels() * 3; }
  viz::Image image(const std::uint8_t* bytes_of_it) const {
    return {picture_.width, picture_.height, {bytes_of_it, bytes_of_it + bytes()}};
  }

  /// All frames; use(snapshot, image, result) makes the result of one in a worker, take(frame, result) has it here.
  template <class Use, class Take>
  viz::WorkInUnits in_units(std::size_t result_bytes, const Use& use, const Take& take) {
    const auto prepare = [this, use, result_bytes] {
      const auto painter = std::make_shared<viz::ParticlePainter>(picture_);
      return [this, use, painter, result_bytes](std::size_t frame, std::uint8_t* result) {
        const Snapshot snapshot = run_.snapshot(frames_[frame], read_for(picture_, overlay_));
        use(snapshot, painter->paint(snapshot, overlay_.of(snapshot, frames_[frame])), frame, result);
        tell_drawn_by(result + result_bytes);
      };
    };
    const auto take_and_tell = [this, take, result_bytes](std::size_t frame, const std::uint8_t* result) {
      take(frame, result);
      done_ = frame + 1;
      stop_when_interrupted();
      progress_.update(static_cast<std::int64_t>(done_), static_cast<std::int64_t>(frames_.size()),
                       done_ == frames_.size() ? drawn_by(result + result_bytes) : "");
    };
    return {.count = frames_.size(),
            .unit_name = "frame",
            .subject = run_.snapshot_files().at(frames_.back()).filename().string(),
            .result_bytes = result_bytes + drawn_by_bytes,
            .prepare = prepare,
            .take = take_and_tell,
            .while_waiting = [this] { stop_when_interrupted(); }};
  }

 private:
  void stop_when_interrupted() const {
    if (interrupted()) throw Interrupted(fmt::format("stopped after {} of {} frames", done_, frames_.size()));
  }

  const RunReader& run_;
  std::vector<std::size_t> frames_;
  viz::PictureOptions picture_;
  OverlayMaker overlay_;
  Progress progress_;
  std::size_t done_ = 0;
};

/// As the result of a frame.
void hand_over(const Snapshot&, const viz::Image& image, std::size_t, std::uint8_t* result) {
  std::copy(image.rgb.begin(), image.rgb.end(), result);
}

/// Workers of this machine write their frames themselves, which saves time; other ranks leave that to the first.
void render_folder(const RenderCall& call, const RunReader& run, viz::Ranks& ranks) {
  Film film(call, run);
  if (ranks.first()) {
    std::error_code error;
    std::filesystem::create_directories(call.output, error);
    if (error) throw InputError(call.output.string() + ": cannot be made: " + error.message());
  }
  const auto file = [&](std::size_t frame) {
    return call.output / fmt::format("frame_{:06}.png", film.snapshot_of(frame));
  };
  if (ranks.count() == 1) {
    const auto write = [&](const Snapshot& snapshot, const viz::Image& image, std::size_t frame, std::uint8_t*) {
      viz::write_png(file(frame), image, with_renderer(provenance(run, snapshot, call.recipe), viz::renderer_in_use()));
    };
    ranks.do_units(film.in_units(0, write, [](std::size_t, const std::uint8_t*) {}), worker_count(call));
    return;
  }
  const auto write = [&](std::size_t frame, const std::uint8_t* result) {
    viz::write_png(
        file(frame), film.image(result),
        with_renderer(provenance(run, film.snapshot_of(frame), call.recipe), drawn_by(result + film.bytes())));
  };
  ranks.do_units(film.in_units(film.bytes(), hand_over, write), worker_count(call));
}

void render_movie(const RenderCall& call, const RunReader& run, viz::Ranks& ranks) {
  Film film(call, run);
  std::optional<viz::MovieWriter> movie;
  if (ranks.first()) {
    const viz::PictureOptions& picture = film.picture();
    movie.emplace(call.output, picture.width, picture.height, viz::MovieOptions{call.rate});
  }
  const auto add = [&](std::size_t, const std::uint8_t* result) { movie->add(film.image(result)); };
  ranks.do_units(film.in_units(film.bytes(), hand_over, add), worker_count(call));
  if (movie) movie->finish();
}

}  // namespace

void render_film(const RenderCall& call, const RunReader& run, viz::Ranks& ranks) {
  if (call.output.has_extension()) {
    render_movie(call, run, ranks);
  } else {
    render_folder(call, run, ranks);
  }
}

}  // namespace packstone::cli
