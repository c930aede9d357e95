// What packstone render is asked for, and its two ways to do it.
#pragma once

#include <filesystem>
#include <string>

#include "cli/pictures.hpp"
#include "cli/render_overlay.hpp"
#include "core/run_folder.hpp"
#include "viz/particle_scene.hpp"
#include "viz/ranks.hpp"

namespace packstone::cli {

struct RenderCall {
  std::vector<std::filesystem::path> paths;
  std::vector<std::string> titles;  ///< of panels
  int columns = 0;
  std::filesystem::path output;
  std::filesystem::path kept_frames;
  PictureCall picture;
  OverlayCall overlay;
  std::string camera = "iso";
  double zoom = 1;
  std::string focus;
  double font_scale = 1;
  std::string at = "last";
  bool failure = false;  ///< of run folders, the state in which they were stopped
  std::string frames;
  std::string cut;
  bool cut_through = false;
  double occlusion = 0;
  std::string tiles;
  int parts = 1;
  int workers = 0;  ///< 0: one a core
  std::string backend = "osmesa";
  int rate = 25;
  bool quiet = false;
  std::string recipe;  ///< Verb::recipe
};

/// Throws InputError.
viz::PictureOptions picture_options(const RenderCall& call, const std::vector<RunReader>& runs);

/// One picture, tile by tile, written in bands: its size is bounded by the disk, not by memory.
void render_picture(const RenderCall& call, viz::Ranks& ranks);

/// A film, or frames into a folder.
void render_film(const RenderCall& call, viz::Ranks& ranks);

}  // namespace packstone::cli
