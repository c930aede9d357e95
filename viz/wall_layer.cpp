#include "viz/wall_layer.hpp"

#include <cstring>
#include <limits>
#include <optional>

#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include "viz/container.hpp"
#include "viz/offscreen.hpp"

namespace packstone::viz {

struct WallLayer::Stage {
  int width, height, side;  // of the picture and of a square, in samples
  OffscreenWindow window{1, 1};
  vtkNew<vtkRenderer> renderer;
  Container container{renderer};
  std::optional<Camera> camera;

  std::vector<BoundaryRecord> shown;  // what the patch shows, with the domain
  Domain domain;
  PixelWindow patch, prepared;         // patch without pixels: none is drawn
  std::vector<std::uint32_t> colours;  // of the patch, top row first
  std::vector<float> distances;

  Stage(int whole_width, int whole_height, int square) : width(whole_width), height(whole_height), side(square) {
    renderer->SetBackground(0, 0, 0);
    renderer->SetBackgroundAlpha(0);
    renderer->AutomaticLightCreationOff();  // all is unlit
    window.window()->AddRenderer(renderer);
  }

  void draw(const PixelWindow& wanted) {
    patch = wanted;
    window.resize(patch.width, patch.height);
    camera->of_part({static_cast<double>(patch.left), static_cast<double>(patch.top)})
        .apply(*renderer->GetActiveCamera(), patch.width, patch.height);
    window.render();
    read_back();
  }

  void read_back() {
    const std::vector<std::uint8_t>& rgba = window.rgba();
    const std::vector<float> depths = window.depths();
    const auto near = static_cast<float>(camera->nearest_distance());
    const auto far = static_cast<float>(camera->farthest_distance());
    colours.resize(patch.pixels());
    distances.resize(patch.pixels());
    const auto columns = static_cast<std::size_t>(patch.width), rows = static_cast<std::size_t>(patch.height);
    constexpr std::uint32_t alpha = 0xff000000;
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t from = (rows - 1 - row) * columns, to = row * columns;  // OpenGL has the bottom row first
      std::memcpy(&colours[to], &rgba[4 * from], 4 * columns);
      for (std::size_t k = 0; k < columns; ++k) {
        const float depth = depths[from + k];
        const float distance =
            camera->parallel() ? near + depth * (far - near) : near * far / (far - depth * (far - near));
        distances[to + k] = (colours[to + k] & alpha) != 0 ? distance : std::numeric_limits<float>::infinity();
      }
    }
  }
};

WallLayer::WallLayer(int width, int height, int supersampling)
    : stage_(std::make_unique<Stage>(width * supersampling, height * supersampling,
                                     patch_side(supersampling) * supersampling)) {}

WallLayer::~WallLayer() = default;

void WallLayer::show(const Snapshot& snapshot, const UnitSpace& space, const Camera& camera, double line_width) {
  Stage& stage = *stage_;
  const bool same = stage.camera == camera && stage.shown == snapshot.boundaries && stage.domain == snapshot.domain;
  if (same) return;
  stage.camera = camera;
  stage.shown = snapshot.boundaries;
  stage.domain = snapshot.domain;
  stage.patch = {};
  stage.container.update(snapshot, space.centre, space.scale, camera, line_width);
}

void WallLayer::prepare(const PixelWindow& window) {
  Stage& stage = *stage_;
  const int left = window.left / stage.side * stage.side, top = window.top / stage.side * stage.side;
  const PixelWindow patch{left, top, std::min(stage.side, stage.width - left),
                          std::min(stage.side, stage.height - top)};
  if (stage.patch != patch) stage.draw(patch);
  stage.prepared = window;
}

WallLayer::Row WallLayer::row(int row) const {
  const Stage& stage = *stage_;
  const std::size_t from_top = static_cast<std::size_t>(stage.prepared.top + row - stage.patch.top);
  const std::size_t first = from_top * static_cast<std::size_t>(stage.patch.width) +
                            static_cast<std::size_t>(stage.prepared.left - stage.patch.left);
  return {&stage.colours[first], &stage.distances[first]};
}

}  // namespace packstone::viz
