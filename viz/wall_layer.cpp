#include "viz/wall_layer.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include "viz/container.hpp"
#include "viz/offscreen.hpp"

namespace packstone::viz {

namespace {

/// A square of the picture, drawn.
struct Patch {
  PixelWindow window;
  std::vector<std::uint32_t> colours;  // top row first
  std::vector<float> distances;
};

/// What a window has drawn, with depths as distances from the viewer.
Patch read_patch(OffscreenWindow& drawn, const PixelWindow& window, const Camera& camera) {
  const std::vector<std::uint8_t>& rgba = drawn.rgba();
  const std::vector<float> depths = drawn.depths();
  const auto near = static_cast<float>(camera.nearest_distance());
  const auto far = static_cast<float>(camera.farthest_distance());
  Patch patch{window, std::vector<std::uint32_t>(window.pixels()), std::vector<float>(window.pixels())};
  const auto columns = static_cast<std::size_t>(window.width), rows = static_cast<std::size_t>(window.height);
  constexpr std::uint32_t alpha = 0xff000000;
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t from = (rows - 1 - row) * columns, to = row * columns;  // OpenGL has the bottom row first
    std::memcpy(&patch.colours[to], &rgba[4 * from], 4 * columns);
    for (std::size_t k = 0; k < columns; ++k) {
      const float depth = depths[from + k];
      const float distance =
          camera.parallel() ? near + depth * (far - near) : near * far / (far - depth * (far - near));
      const bool wall = (patch.colours[to + k] & alpha) != 0;
      patch.distances[to + k] = wall ? distance : std::numeric_limits<float>::infinity();
    }
  }
  return patch;
}

}  // namespace

struct WallLayer::Stage {
  int width, height, side;  // of the picture and of a square, in samples
  OffscreenWindow window{1, 1};
  vtkNew<vtkRenderer> renderer;
  Container container;
  std::optional<Camera> camera;

  std::vector<BoundaryRecord> shown;  // what the patches show, with the domain
  Domain domain;
  std::vector<Patch> patches;
  std::size_t current = 0;
  PixelWindow prepared;  // in the current patch

  Stage(int whole_width, int whole_height, int square, Ground ground)
      : width(whole_width), height(whole_height), side(square), container(renderer, ground) {
    renderer->SetBackground(0, 0, 0);
    renderer->SetBackgroundAlpha(0);
    renderer->AutomaticLightCreationOff();  // all is unlit
    window.window()->AddRenderer(renderer);
  }

  void draw(const PixelWindow& wanted) {
    std::size_t kept = wanted.pixels();
    for (const Patch& patch : patches) kept += patch.window.pixels();
    if (kept > most_kept) patches.clear();
    window.resize(wanted.width, wanted.height);
    camera->of_part({static_cast<double>(wanted.left), static_cast<double>(wanted.top)})
        .apply(*renderer->GetActiveCamera(), wanted.width, wanted.height);
    window.render();
    current = patches.size();
    patches.push_back(read_patch(window, wanted, *camera));
  }
};

WallLayer::WallLayer(int width, int height, int supersampling, Ground ground)
    : stage_(std::make_unique<Stage>(width * supersampling, height * supersampling,
                                     patch_side(supersampling) * supersampling, ground)) {}

WallLayer::~WallLayer() = default;

void WallLayer::show(const Snapshot& snapshot, const UnitSpace& space, const Camera& camera, double line_width) {
  Stage& stage = *stage_;
  const bool same = stage.camera == camera && stage.shown == snapshot.boundaries && stage.domain == snapshot.domain;
  if (same) return;
  stage.camera = camera;
  stage.shown = snapshot.boundaries;
  stage.domain = snapshot.domain;
  stage.patches.clear();
  stage.container.update(snapshot, space.centre, space.scale, camera, line_width);
}

void WallLayer::prepare(const PixelWindow& window) {
  Stage& stage = *stage_;
  const int left = window.left / stage.side * stage.side, top = window.top / stage.side * stage.side;
  const PixelWindow square{left, top, std::min(stage.side, stage.width - left),
                           std::min(stage.side, stage.height - top)};
  const auto drawn = std::find_if(stage.patches.begin(), stage.patches.end(),
                                  [&](const Patch& patch) { return patch.window == square; });
  stage.current = static_cast<std::size_t>(drawn - stage.patches.begin());
  if (drawn == stage.patches.end()) stage.draw(square);
  stage.prepared = window;
}

WallLayer::Row WallLayer::row(int row) const {
  const Stage& stage = *stage_;
  const Patch& patch = stage.patches[stage.current];
  const std::size_t from_top = static_cast<std::size_t>(stage.prepared.top + row - patch.window.top);
  const std::size_t first = from_top * static_cast<std::size_t>(patch.window.width) +
                            static_cast<std::size_t>(stage.prepared.left - patch.window.left);
  return {&patch.colours[first], &patch.distances[first]};
}

}  // namespace packstone::viz
