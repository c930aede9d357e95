#include "viz/particle_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "viz/ambient_occlusion.hpp"
#include "viz/annotation.hpp"
#include "viz/composition.hpp"
#include "viz/frustum_cloud.hpp"
#include "viz/frustum_drawing.hpp"
#include "viz/label_layer.hpp"
#include "viz/overlay_bodies.hpp"
#include "viz/pixel_layer.hpp"
#include "viz/sphere_cloud.hpp"
#include "viz/sphere_drawing.hpp"
#include "viz/wall_layer.hpp"

namespace packstone::viz {

namespace {

constexpr int largest_side = 32768;  // [px]
constexpr int largest_tile = 1024;   // [samples] a side: its memory stays below 20 MB

ColourKeys keys_of(const PictureOptions& options, const Colouring& colouring, const Overlay& drawn_among,
                   const OverlayBodies& overlay) {
  if (!options.legend) return {};
  ColourKeys keys;
  if (!colouring.empty() && (options.shown != Shown::hidden || !drawn_among.paths.empty())) keys.push_back(colouring);
  keys.insert(keys.end(), overlay.keys.begin(), overlay.keys.end());
  return keys;
}

/// Mean radius of the particles that are not cut away [m].
double mean_radius(const ParticleView& particles, const CutAway& cut) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t row = 0; row < particles.size(); ++row) {
    if (!(particles.radius[row] > 0) || is_cut_away(cut, particles.position[row])) continue;
    sum += particles.radius[row];
    ++count;
  }
  return sum / static_cast<double>(std::max<std::size_t>(1, count));
}

/// The pieces of chunks that lie within rows [first, last).
std::vector<RowChunk> within(const std::vector<RowChunk>& chunks, std::size_t first, std::size_t last) {
  std::vector<RowChunk> pieces;
  for (const RowChunk& chunk : chunks) {
    const RowChunk piece{std::max(first, chunk.first), std::min(last, chunk.last), chunk.box};
    if (piece.first < piece.last) pieces.push_back(piece);
  }
  return pieces;
}

/// What a snapshot looks like from a camera.
struct Frame {
  UnitSpace space;
  Colouring colouring;
  OverlayBodies overlay;
  ColourKeys keys;
  Layout layout;
  Camera camera;                    // of the samples
  std::vector<double> other_radii;  // where they are not the particles' own
  double reach = 0;  // of hollows: mean radius of the particles drawn, in the middle of the picture [samples]
  std::vector<SphereCloud> parts;
  FrustumCloud tubes;
  SphereCloud joints;

  Frame(const ParticleView& particles, const Overlay& drawn_among, std::optional<Colouring> given,
        const PictureOptions& options)
      : space(particles.snapshot->domain),
        colouring(given ? std::move(*given) : colour_particles(particles, options.color, options.range)),
        overlay(drawn_among, *particles.snapshot, space, colouring, options),
        keys(keys_of(options, colouring, drawn_among, overlay)),
        layout(lay_out(options, space, keys)),
        camera(layout.camera.finer(options.supersampling)),
        tubes(overlay.frusta, camera, number(particles.size())),
        joints(sphere_rows(overlay.centres, overlay.radii, overlay.colours), camera,
               number(particles.size() + overlay.frusta.size())) {
    if (options.occlusion > 0) {
      reach = mean_radius(particles, options.cut) * space.scale * camera.pixels_per_unit();
    }
    if (options.shown != Shown::all) shrink(particles, drawn_among, options.shown == Shown::shrunk ? shrunk_share : 0);
    SphereRows rows{.centres = particles.position,
                    .radii = other_radii.empty() ? particles.radius : std::span<const double>(other_radii),
                    .colours = colouring.colours,
                    .chunks = {},
                    .origin = space.centre,
                    .scale = space.scale,
                    .cut = options.cut,
                    .cut_through = options.cut_through,
                    .before_first_use = [particles](const RowChunk& chunk) { check_rows(particles, chunk); }};
    const std::vector<RowChunk> chunks = chunks_of(particles);
    const auto count = static_cast<std::size_t>(options.parts);
    for (std::size_t k = 0; k < count; ++k) {
      rows.chunks = within(chunks, particles.size() * k / count, particles.size() * (k + 1) / count);
      parts.emplace_back(rows, camera);
    }
  }
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

 private:
  static std::uint32_t number(std::size_t row) { return static_cast<std::uint32_t>(row); }

  /// All particles but those with a path.
  void shrink(const ParticleView& particles, const Overlay& drawn_among, double share) {
    std::unordered_set<std::int64_t> full;
    for (const Path& path : drawn_among.paths) full.insert(path.id);
    other_radii.assign(particles.radius.begin(), particles.radius.end());
    for (std::size_t row = 0; row < other_radii.size(); ++row) {
      if (full.empty() || !full.contains(particles.snapshot->id[row])) other_radii[row] *= share;
    }
  }
};

void draw_bodies(PixelLayer& layer, const Frame& frame, const PixelWindow& window, bool cull) {
  layer.reset(window);
  draw(layer, frame.parts.front(), cull);
  for (std::size_t k = 1; k < frame.parts.size(); ++k) {
    PixelLayer other(frame.camera);
    other.reset(window);
    draw(other, frame.parts[k], cull);
    layer.merge(other);
  }
  draw(layer, frame.tubes, cull);
  draw(layer, frame.joints, cull);
}

/// What a picture that looks closer may not draw over: its margins and legend.
void clear_outside(Layer& layer, const PixelWindow& part, const PixelWindow& frame) {
  const PixelWindow kept = part.common(frame);
  for (int row = part.top; row < part.bottom(); ++row) {
    std::uint8_t* const pixels = &layer.rgba[static_cast<std::size_t>(row - part.top) * part.width * 4];
    const bool inside = !kept.empty() && row >= kept.top && row < kept.bottom();
    const int left = inside ? kept.left - part.left : part.width,
              right = inside ? kept.right() - part.left : part.width;
    std::fill(pixels, pixels + static_cast<std::ptrdiff_t>(left) * 4, 0);
    std::fill(pixels + static_cast<std::ptrdiff_t>(right) * 4, pixels + static_cast<std::ptrdiff_t>(part.width) * 4, 0);
  }
}

}  // namespace

void check_picture(const PictureOptions& options) {
  if (options.supersampling < 1) throw InputError("super-sampling takes 1 or more");
  if (options.width < 1 || options.height < 1) throw InputError("a picture has at least 1 x 1 px");
  if (std::max(options.width, options.height) > largest_side) {
    throw InputError(fmt::format("a picture of {} x {} px is too large; a side takes 1 to {} px", options.width,
                                 options.height, largest_side));
  }
  if (!(options.occlusion >= 0 && options.occlusion <= 1)) throw InputError("the occlusion is from 0 to 1");
  if (!(options.view.zoom > 0)) throw InputError("a picture is zoomed by more than 0");
  if (!(options.font_scale > 0)) throw InputError("letters are scaled by more than 0");
  if (options.parts < 1) throw InputError("the particles are drawn in 1 part or more");
}

struct ParticlePainter::Stage {
  WallLayer walls;
  LabelLayer labels;
  std::optional<Frame> frame;
  std::optional<PixelLayer> bodies;

  Layer particles;  // of the last part

  /// A part that lies within one square of the walls, into its place in a picture.
  void paint(const PixelWindow& part, const PictureOptions& options, Image& image, const PixelWindow& window) {
    const PixelWindow samples = part.finer(options.supersampling);
    if (options.occlusion > 0) {
      draw_bodies(*bodies, *frame, samples.wider(occlusion_margin(frame->reach)), options.cull);
      bodies->occlude(options.occlusion, frame->reach, samples);
    } else {
      draw_bodies(*bodies, *frame, samples, options.cull);
    }
    if (options.container) walls.prepare(samples);
    compose(*bodies, options.container ? &walls : nullptr, options.supersampling, particles);
    if (frame->layout.frame) clear_outside(particles, part, *frame->layout.frame);
    const Layer words = labels.part(part);
    flatten({&particles, &words}, themed(paper, options.ground), image, part.left - window.left, part.top - window.top);
  }

  explicit Stage(const PictureOptions& options)
      : walls(options.width, options.height, options.supersampling, options.ground) {}
};

ParticlePainter::ParticlePainter(const PictureOptions& options) : options_(options) {
  check_picture(options);
  stage_ = std::make_unique<Stage>(options);
}

ParticlePainter::~ParticlePainter() = default;

void ParticlePainter::show(const ParticleView& particles, const Overlay& overlay, std::optional<Colouring> colouring) {
  const Snapshot& snapshot = *particles.snapshot;
  stage_->frame.emplace(particles, overlay, std::move(colouring), options_);
  const Frame& frame = *stage_->frame;
  stage_->bodies.emplace(frame.camera);
  if (options_.container) {
    constexpr double line_weight = 0.06;  // of the font size
    stage_->walls.show(snapshot, frame.space, frame.camera, line_weight * frame.layout.font * options_.supersampling);
  }
  stage_->labels.show(annotate(options_, frame.space, frame.layout, frame.keys, snapshot.time), options_.supersampling);
}

Image ParticlePainter::part(const PixelWindow& window) {
  Image image{window.width, window.height, std::vector<std::uint8_t>(window.pixels() * 3)};
  const int tile = std::max(1, largest_tile / options_.supersampling);
  // The walls of one square after the other; no tile reaches over two.
  for_each_square(window, WallLayer::patch_side(options_.supersampling), [&](const PixelWindow& square) {
    for_each_square(square, tile, [&](const PixelWindow& part) { stage_->paint(part, options_, image, window); });
  });
  return image;
}

Image ParticlePainter::paint(const ParticleView& particles, const Overlay& overlay) {
  show(particles, overlay);
  return part({0, 0, options_.width, options_.height});
}

std::optional<Vec3> ParticlePainter::surface_point(int column, int row) {
  const PixelWindow pixel = PixelWindow{column, row, 1, 1}.finer(options_.supersampling);
  const PixelWindow sample{pixel.left + pixel.width / 2, pixel.top + pixel.height / 2, 1, 1};
  const Frame& frame = *stage_->frame;
  PixelLayer seen(frame.camera);
  draw_bodies(seen, frame, sample, options_.cull);
  float distance = seen.blank() ? std::numeric_limits<float>::infinity() : *seen.distances(0);
  if (options_.container) {
    stage_->walls.prepare(sample);
    distance = std::min(distance, *stage_->walls.row(0).distances);
  }
  if (!std::isfinite(distance)) return std::nullopt;
  const Vec3 point = frame.camera.point_at({sample.left + 0.5, sample.top + 0.5}, distance);
  return point / frame.space.scale + frame.space.centre;
}

double room_beside(const PictureOptions& options, const Snapshot& snapshot, const Colouring& colouring,
                   const Overlay& overlay) {
  const UnitSpace space(snapshot.domain);
  const OverlayBodies bodies(overlay, snapshot, space, colouring, options);
  return room_beside(options, space, keys_of(options, colouring, overlay, bodies));
}

Image draw_particles(const ParticleView& particles, const PictureOptions& options) {
  return ParticlePainter(options).paint(particles);
}

}  // namespace packstone::viz
