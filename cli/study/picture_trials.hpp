// Ways to draw one packing: samples a pixel, culling, parts, occlusion.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/study/tradeoff_table.hpp"
#include "cli/study/trials.hpp"
#include "cli/study/variants.hpp"
#include "viz/image.hpp"
#include "viz/particle_scene.hpp"

namespace packstone::cli {

/// Mean absolute difference from the finest picture of the same look over all pixels and channels, of 255.
inline constexpr const char* picture_quantity = "picture.difference";

class PictureStudy {
 public:
  /// packing: a run folder, whose last snapshot it is, or a file. folder: for the pictures.
  PictureStudy(std::filesystem::path packing, std::filesystem::path folder, int width, int height);

  /// As asked for beside the usual picture, else what a user would first ask about. Throws InputError for one that no
  /// picture has.
  std::vector<Variant> variants(const std::vector<std::string>& vary);

  /// Label of the variant with most samples.
  const std::string& reference() const { return finest_.label; }

  /// Settings: supersampling=N, parts=N, cull=on or off, occlusion=SHARE. A process of its own draws the picture
  /// several times and writes it; cost: median processor time of a frame, PNG included, and the most memory of that
  /// process. view: from where, 1, 2, ... Occlusion is a look and no error: a picture is compared with the finest of
  /// its own look. Throws RunError where the process fails.
  Trial run(const Variant& variant, std::int64_t view);

  /// A line for variants that draw the same bytes as one before them, in all views that were run.
  std::string same_pictures(const std::vector<Variant>& variants) const;

 private:
  viz::PictureOptions options_of(const Variant& variant) const;
  std::filesystem::path file_of(const std::string& label, std::int64_t view) const;
  /// The finest picture of the look, drawn where it is not there yet.
  viz::Image finest_of_look(viz::PictureOptions options, std::int64_t view);

  std::filesystem::path packing_, folder_;
  viz::PictureOptions usual_;
  Variant finest_;
  std::vector<std::filesystem::path> drawn_;
  std::int64_t views_ = 0;
};

}  // namespace packstone::cli
