#include "viz/wall_layer.hpp"

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
  PixelWindow patch, prepared;  // patch without pixels: none is drawn
  std::vector<float> depth;

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
    window.rgba();
    depth = window.depths();
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
  const int from_bottom = stage.patch.bottom() - 1 - (stage.prepared.top + row);
  const std::size_t first =
      static_cast<std::size_t>(from_bottom) * stage.patch.width + stage.prepared.left - stage.patch.left;
  return {&stage.window.last_rgba()[4 * first], &stage.depth[first]};
}

float WallLayer::distance(float depth) const {
  const auto near = static_cast<float>(stage_->camera->nearest_distance());
  const auto far = static_cast<float>(stage_->camera->farthest_distance());
  return stage_->camera->parallel() ? near + depth * (far - near) : near * far / (far - depth * (far - near));
}

}  // namespace packstone::viz
