#include "cli/study/picture_trials.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/study/median_time.hpp"
#include "core/error.hpp"
#include "core/run_folder.hpp"
#include "core/text.hpp"
#include "viz/png.hpp"

namespace packstone::cli {

namespace {

namespace fs = std::filesystem;

constexpr int timed_frames = 5;
/// Views about the vertical: no two alike, however many there are.
constexpr double first_azimuth = 35, further_azimuth = 137.5, elevation = 25;  // [degrees]

const std::vector<std::string> usual_ways = {"supersampling=1,2,3,4,8", "no culling: cull=off", "3 parts: parts=3",
                                             "occlusion 0.7: occlusion=0.7",
                                             "occlusion 0.7, 1 sample: occlusion=0.7; supersampling=1"};

bool switch_of(const std::string& key, const std::string& value) {
  if (value != "on" && value != "off") throw InputError(fmt::format("{}={}: on or off would be right", key, value));
  return value == "on";
}

int count_of(const std::string& key, const std::string& value) {
  const double number = factor_of(key, value);
  constexpr double most = 1000;
  if (number != std::floor(number) || number > most) {
    throw InputError(fmt::format("{}={}: a whole number from 1 to {:g} would be right", key, value, most));
  }
  return static_cast<int>(number);
}

viz::Viewpoint viewpoint(std::int64_t view) {
  const double azimuth = std::fmod(first_azimuth + further_azimuth * static_cast<double>(view - 1), 360.0);
  return viz::viewpoint_from_text(fmt::format("{},{}", azimuth, elevation));
}

struct Drawn {
  double seconds;  ///< processor time of a frame
  double memory;   ///< [B]
};

/// What the work returns, in a process of its own, with the most memory that it took. Throws RunError with what the
/// work threw.
Drawn in_own_process(const std::function<double()>& work) {
  int ends[2];
  if (pipe(ends) != 0) throw RunError("no pipe to a process that draws");
  const pid_t child = fork();
  if (child < 0) throw RunError("no process to draw in");
  if (child == 0) {
    std::string answer;
    int code = EXIT_SUCCESS;
    try {
      answer = fmt::format("{}", work());
    } catch (const std::exception& error) {
      answer = error.what();
      code = EXIT_FAILURE;
    }
    const bool told = write(ends[1], answer.data(), answer.size()) == static_cast<ssize_t>(answer.size());
    _exit(told ? code : EXIT_FAILURE);
  }
  close(ends[1]);
  std::string answer;
  char part[256];
  for (ssize_t got = 0; (got = read(ends[0], part, sizeof part)) > 0;)
    answer.append(part, static_cast<std::size_t>(got));
  close(ends[0]);
  int status = 0;
  rusage used{};
  wait4(child, &status, 0, &used);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS) {
    throw RunError("drawing failed: " + (answer.empty() ? "the process died" : answer));
  }
  constexpr double kilobyte = 1024;
  return {std::stod(answer), kilobyte * static_cast<double>(used.ru_maxrss)};
}

/// Draws the packing's last snapshot so many times beyond the first and leaves the picture in the file.
Drawn draw(const fs::path& packing, const viz::PictureOptions& options, const fs::path& file, int frames) {
  return in_own_process([&] {
    const RunReader run(packing);
    const OpenSnapshot snapshot = run.open(run.snapshot_count() - 1);
    viz::ParticlePainter painter(options);
    return median_processor_seconds(frames, [&] { viz::write_png(file, painter.paint(snapshot.view())); });
  });
}

double mean_difference(const viz::Image& a, const viz::Image& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.rgb.size(); ++k) sum += std::abs(a.rgb[k] - b.rgb[k]);
  return sum / static_cast<double>(a.rgb.size());
}

}  // namespace

PictureStudy::PictureStudy(fs::path packing, fs::path folder, int width, int height)
    : packing_(std::move(packing)), folder_(std::move(folder)) {
  usual_.width = width;
  usual_.height = height;
}

viz::PictureOptions PictureStudy::options_of(const Variant& variant) const {
  viz::PictureOptions options = usual_;
  for (const std::string& setting : variant.settings) {
    const auto [key, value] = setting_of(setting);
    if (key == "supersampling") {
      options.supersampling = count_of(key, value);
    } else if (key == "parts") {
      options.parts = count_of(key, value);
    } else if (key == "cull") {
      options.cull = switch_of(key, value);
    } else if (key == "occlusion") {
      options.occlusion = factor_of(key, value);
    } else {
      throw InputError(
          fmt::format("\"{}\" is nothing a picture is drawn by; supersampling, parts, cull and occlusion "
                      "are",
                      key));
    }
  }
  viz::check_picture(options);
  return options;
}

std::vector<Variant> PictureStudy::variants(const std::vector<std::string>& vary) {
  std::vector<Variant> variants;
  if (!vary.empty()) variants.push_back({as_is, {}});
  for (const std::string& text : vary.empty() ? usual_ways : vary) {
    const auto more = variants_of(text);
    variants.insert(variants.end(), more.begin(), more.end());
  }
  finest_ = *std::max_element(variants.begin(), variants.end(), [&](const Variant& a, const Variant& b) {
    return options_of(a).supersampling < options_of(b).supersampling;
  });
  return variants;
}

fs::path PictureStudy::file_of(const std::string& label, std::int64_t view) const {
  return folder_ / fmt::format("{}_{}.png", file_name_of(label), view);
}

viz::Image PictureStudy::finest_of_look(viz::PictureOptions options, std::int64_t view) {
  const viz::PictureOptions finest = options_of(finest_);
  options.supersampling = finest.supersampling;
  options.cull = finest.cull;
  options.parts = finest.parts;
  const fs::path file = file_of(fmt::format("finest_occlusion_{:g}", options.occlusion), view);
  if (std::find(drawn_.begin(), drawn_.end(), file) == drawn_.end()) {
    draw(packing_, options, file, 1);
    drawn_.push_back(file);
  }
  return viz::read_png(file);
}

Trial PictureStudy::run(const Variant& variant, std::int64_t view) {
  fs::create_directories(folder_);
  viz::PictureOptions options = options_of(variant);
  options.view = viewpoint(view);
  const fs::path file = file_of(variant.label, view);
  const Drawn drawn = draw(packing_, options, file, timed_frames);
  Trial trial;
  trial.seconds = drawn.seconds;
  trial.memory = drawn.memory;
  trial.values[picture_quantity] = mean_difference(viz::read_png(file), finest_of_look(options, view));
  trial.units[picture_quantity] = "of 255";
  trial.finished = true;
  views_ = std::max(views_, view);
  return trial;
}

std::string PictureStudy::same_pictures(const std::vector<Variant>& variants) const {
  const auto same = [&](const Variant& a, const Variant& b) {
    for (std::int64_t view = 1; view <= views_; ++view) {
      if (viz::read_png(file_of(a.label, view)).rgb != viz::read_png(file_of(b.label, view)).rgb) return false;
    }
    return true;
  };
  std::string text;
  for (auto later = variants.begin(); later != variants.end(); ++later) {
    const auto earlier = std::find_if(variants.begin(), later, [&](const Variant& v) { return same(v, *later); });
    if (earlier != later) text += fmt::format("\"{}\" draws the same bytes as \"{}\"\n", later->label, earlier->label);
  }
  return text;
}

}  // namespace packstone::cli
