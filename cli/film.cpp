#include "cli/film.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cli/drawn_by.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/output_folder.hpp"
#include "viz/movie.hpp"
#include "viz/pixel_window.hpp"

namespace packstone::cli {

namespace {

/// The frames' files, each whole or absent.
class FrameFiles {
 public:
  FrameFiles(const Film& film, const std::filesystem::path& folder) : film_(film), folder_(folder) {
    check_writable(path(0));
  }

  void write(std::size_t frame, const Frame& drawn, const std::string& renderer) const {
    if (film_.has_vector_files()) {
      write_text_file(path(frame), drawn.vector_file);
    } else {
      viz::write_png(path(frame), drawn.pixels, with_renderer(film_.text(frame), renderer), film_.dots_per_inch);
    }
  }

  /// What workers that were ended in the middle of a file left of it.
  void discard_unfinished() const { remove_leftovers(folder_.path()); }

 private:
  std::filesystem::path path(std::size_t frame) const {
    return folder_.path() / fmt::format("frame_{:06}.{}", film_.number(frame), film_.frame_format);
  }

  const Film& film_;
  OutputFolder folder_;
};

/// The frames on their way into files and the film. Workers of this machine write the files of their frames themselves,
/// which saves time; other ranks leave that to the first.
class FilmWork {
 public:
  FilmWork(const Film& film, const viz::Ranks& ranks)
      : film_(film), alone_(ranks.count() == 1), progress_("frames", film.quiet) {
    if (!ranks.first()) return;
    if (film.is_movie()) {
      check_writable(film.output);
      movie_.emplace(film.output, film.width, film.height, viz::MovieOptions{film.rate});
    }
    const auto& folder = film.is_movie() ? film.kept : film.output;
    if (!folder.empty() || !film.is_movie()) files_.emplace(film, folder);
  }

  void run(viz::Ranks& ranks) {
    try {
      ranks.do_units(in_units(), film_.workers);
    } catch (...) {
      if (files_) files_->discard_unfinished();
      throw;
    }
    if (movie_) movie_->finish([this] { stop_when_interrupted(); });
  }

 private:
  bool hands_over_pixels() const { return film_.is_movie() || (!alone_ && film_.needs_pixels()); }
  std::size_t pixel_bytes() const {
    return hands_over_pixels() ? viz::PixelWindow{0, 0, film_.width, film_.height}.pixels() * 3 : 0;
  }

  viz::WorkInUnits in_units() {
    return {.count = film_.frames,
            .unit_name = "frame",
            .subject = film_.subject,
            .result_bytes = pixel_bytes() + drawn_by_bytes,
            .prepare =
                [this] {
                  return
                      [this, draw = film_.prepare()](std::size_t frame) { return done_by_worker(frame, draw(frame)); };
                },
            .take = [this](std::size_t frame, viz::UnitResult result) { take(frame, std::move(result)); },
            .while_waiting = [this] { stop_when_interrupted(); }};
  }

  /// Pixels, then the vector file, as far as somebody else writes them; what drew them last.
  viz::UnitResult done_by_worker(std::size_t frame, Frame drawn) const {
    if (alone_ && files_) files_->write(frame, drawn, viz::renderer_in_use());
    viz::UnitResult result;
    if (hands_over_pixels()) result = std::move(drawn.pixels.rgb);
    if (!alone_) result.insert(result.end(), drawn.vector_file.begin(), drawn.vector_file.end());
    tell_drawn_by(result);
    return result;
  }

  void take(std::size_t frame, viz::UnitResult result) {
    const std::string renderer = take_drawn_by(result);
    Frame drawn;
    drawn.vector_file.assign(result.begin() + static_cast<std::ptrdiff_t>(pixel_bytes()), result.end());
    result.resize(pixel_bytes());
    drawn.pixels = {film_.width, film_.height, std::move(result)};
    if (!alone_ && files_) files_->write(frame, drawn, renderer);
    if (movie_) movie_->add(drawn.pixels);
    done_ = frame + 1;
    stop_when_interrupted();
    progress_.update(static_cast<std::int64_t>(done_), static_cast<std::int64_t>(film_.frames),
                     done_ == film_.frames ? renderer : "");
  }

  void stop_when_interrupted() const {
    if (interrupted()) throw Interrupted(fmt::format("stopped after {} of {} frames", done_, film_.frames));
  }

  const Film& film_;
  bool alone_;
  Progress progress_;
  std::optional<viz::MovieWriter> movie_;
  std::optional<FrameFiles> files_;
  std::size_t done_ = 0;
};

}  // namespace

void check_frame_options(const std::filesystem::path& output, const std::filesystem::path& kept,
                         const std::string& frame_format) {
  const std::string extension = output.extension().string();
  if (!kept.empty() && extension != ".mp4" && extension != ".gif") {
    throw InputError(
        fmt::format("--keep-frames {}: {} is no .mp4 or .gif whose frames to keep", kept.string(), output.string()));
  }
  if (frame_format != Film{}.frame_format && kept.empty() && !extension.empty()) {
    throw InputError(
        fmt::format("--frame-format {}: is of frames in a folder, which -o or --keep-frames names", frame_format));
  }
}

void make_film(const Film& film, viz::Ranks& ranks) { FilmWork(film, ranks).run(ranks); }

}  // namespace packstone::cli
