// A snapshot as a picture in space: shaded spheres, the container, and what is needed to read them.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/particle_view.hpp"
#include "viz/camera.hpp"
#include "viz/colouring.hpp"
#include "viz/cut_away.hpp"
#include "viz/image.hpp"
#include "viz/overlay.hpp"
#include "viz/pixel_window.hpp"

namespace packstone::viz {

/// How particles are drawn: at their size, at shrunk_share of it so that one sees between them, or not at all.
enum class Shown { all, shrunk, hidden };
inline constexpr double shrunk_share = 0.3;

/// Sizes of what is drawn among the particles.
struct OverlayLook {
  double thickest_force = 0;  ///< that the thickest tube shows, and those above it [N]; 0: link_quantile of all
  double link_width = 0.5;    ///< radius of that tube, in mean particle radii
  double longest_arrow = 0;   ///< value of the arrow of that length [SI]; 0: the largest
  double arrow_length = 6;    ///< in mean particle radii
};

struct PictureOptions {
  int width = 1920;                 ///< [px]
  int height = 1080;                ///< [px]
  int supersampling = 2;            ///< every pixel is the mean of so many squared
  std::string color = "type";       ///< see colour_names()
  std::optional<ValueRange> range;  ///< of the colour scale, SI; for movies, as the default is each frame's own
  Viewpoint view;
  std::optional<Vec3>
      fit;  ///< size of what fits into the picture, standing on the domain's floor [m]; the domain's own
  std::string title;
  double font_scale = 1;  ///< of all letters and lines, over their usual size
  Ground ground = Ground::white;
  bool legend = true;
  bool time = true;
  bool container = true;
  bool scale = true;         ///< lengths of the box's edges (iso), or a scale bar
  bool axes = true;          ///< directions of x, y, z
  double occlusion = 0;      ///< 0 to 1: how dark hollows between particles are
  CutAway cut;               ///< particles with centres in it are left out, and what is drawn among them
  bool cut_through = false;  ///< particles lose only what lies in the cut, and show flat faces there
  Shown shown = Shown::all;
  OverlayLook look;
  bool cull = true;  ///< leaves out hidden particles first: the same picture, faster
  int parts = 1;     ///< the particles are drawn in so many parts, merged by depth: the same picture
};

/// Throws InputError where a number of the options is out of range.
void check_picture(const PictureOptions& options);

/// Draws snapshots, one after the other, with the same options.
class ParticlePainter {
 public:
  /// Throws InputError as check_picture does.
  explicit ParticlePainter(const PictureOptions& options);
  ~ParticlePainter();

  /// The domain alone decides what is in view. Throws InputError when the snapshot lacks what to colour by. What is
  /// drawn among particles takes those of the view's snapshot.
  Image paint(const ParticleView& particles, const Overlay& overlay = {});

  /// The same in two steps: what is to be seen, then any parts of the picture, byte for byte those of the whole, as
  /// long as what the view looks at is there. A colouring takes the place of the options'.
  void show(const ParticleView& particles, const Overlay& overlay = {},
            std::optional<Colouring> colouring = std::nullopt);
  Image part(const PixelWindow& window);

  /// The point [m] of a particle or wall seen at the middle of a pixel of the last picture; nothing on the ground.
  std::optional<Vec3> surface_point(int column, int row);

 private:
  struct Stage;

  PictureOptions options_;
  std::unique_ptr<Stage> stage_;
};

/// Room that legend, time, scale bar and directions, or the length of an edge, take to the right of what is seen [px].
double room_beside(const PictureOptions& options, const Snapshot& snapshot, const Colouring& colouring,
                   const Overlay& overlay);

/// One picture.
Image draw_particles(const ParticleView& particles, const PictureOptions& options);

}  // namespace packstone::viz
