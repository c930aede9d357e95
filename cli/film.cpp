#include "cli/film.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>

#include <fmt/format.h>

#include "cli/drawn_by.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "viz/movie.hpp"
#include "viz/pixel_window.hpp"

namespace packstone::cli {

namespace {

/// The frames as units of work, with their progress.
class FrameWork {
 public:
  explicit FrameWork(const Film& film) : film_(film), progress_("frames", film.quiet) {}

  std::size_t bytes() const { return viz::PixelWindow{0, 0, film_.width, film_.height}.pixels() * 3; }
  viz::Image image(const std::uint8_t* bytes_of_it) const {
    return {film_.width, film_.height, {bytes_of_it, bytes_of_it + bytes()}};
  }

  /// use(image, frame, result) makes the result of a frame in a worker, take(frame, result) has it here.
  template <class Use, class Take>
  viz::WorkInUnits in_units(std::size_t result_bytes, const Use& use, const Take& take) {
    const auto prepare = [this, use, result_bytes] {
      return [this, use, result_bytes, draw = film_.prepare()](std::size_t frame, std::uint8_t* result) {
        use(draw(frame), frame, result);
        tell_drawn_by(result + result_bytes);
      };
    };
    const auto take_and_tell = [this, take, result_bytes](std::size_t frame, const std::uint8_t* result) {
      take(frame, result);
      done_ = frame + 1;
      stop_when_interrupted();
      progress_.update(static_cast<std::int64_t>(done_), static_cast<std::int64_t>(film_.frames),
                       done_ == film_.frames ? drawn_by(result + result_bytes) : "");
    };
    return {.count = film_.frames,
            .unit_name = "frame",
            .subject = film_.subject,
            .result_bytes = result_bytes + drawn_by_bytes,
            .prepare = prepare,
            .take = take_and_tell,
            .while_waiting = [this] { stop_when_interrupted(); }};
  }

 private:
  void stop_when_interrupted() const {
    if (interrupted()) throw Interrupted(fmt::format("stopped after {} of {} frames", done_, film_.frames));
  }

  const Film& film_;
  Progress progress_;
  std::size_t done_ = 0;
};

/// As the result of a frame.
void hand_over(const viz::Image& image, std::size_t, std::uint8_t* result) {
  std::copy(image.rgb.begin(), image.rgb.end(), result);
}

/// Workers of this machine write their frames themselves, which saves time; other ranks leave that to the first.
void make_folder(const Film& film, viz::Ranks& ranks) {
  FrameWork work(film);
  if (ranks.first()) {
    std::error_code error;
    std::filesystem::create_directories(film.output, error);
    if (error) throw InputError(film.output.string() + ": cannot be made: " + error.message());
  }
  const auto write = [&](std::size_t frame, const viz::Image& image, const std::string& renderer) {
    viz::write_png(film.output / film.file_name(frame), image, with_renderer(film.text(frame), renderer));
  };
  if (ranks.count() == 1) {
    const auto write_here = [&](const viz::Image& image, std::size_t frame, std::uint8_t*) {
      write(frame, image, viz::renderer_in_use());
    };
    ranks.do_units(work.in_units(0, write_here, [](std::size_t, const std::uint8_t*) {}), film.workers);
    return;
  }
  const auto write_result = [&](std::size_t frame, const std::uint8_t* result) {
    write(frame, work.image(result), drawn_by(result + work.bytes()));
  };
  ranks.do_units(work.in_units(work.bytes(), hand_over, write_result), film.workers);
}

/// Before any frame is drawn; ffmpeg tells only at the end.
void check_writable(const std::filesystem::path& film) {
  const std::filesystem::path probe = temporary_name(temporary_name(film));  // not what a film is written under
  if (!std::ofstream(probe, std::ios::binary)) {
    throw RunError(film.string() + ": cannot be written: " + std::strerror(errno));
  }
  std::error_code ignored;
  std::filesystem::remove(probe, ignored);
}

void make_movie(const Film& film, viz::Ranks& ranks) {
  FrameWork work(film);
  std::optional<viz::MovieWriter> movie;
  if (ranks.first()) {
    check_writable(film.output);
    movie.emplace(film.output, film.width, film.height, viz::MovieOptions{film.rate});
  }
  const auto add = [&](std::size_t, const std::uint8_t* result) { movie->add(work.image(result)); };
  ranks.do_units(work.in_units(work.bytes(), hand_over, add), film.workers);
  if (movie) movie->finish();
}

}  // namespace

void make_film(const Film& film, viz::Ranks& ranks) {
  if (film.output.has_extension()) {
    make_movie(film, ranks);
  } else {
    make_folder(film, ranks);
  }
}

}  // namespace packstone::cli
