#include "viz/particle_scene.hpp"

#include <numeric>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkUnsignedCharArray.h>

#include "core/error.hpp"
#include "viz/annotation.hpp"
#include "viz/container.hpp"
#include "viz/drawing_painter.hpp"
#include "viz/occlusion.hpp"
#include "viz/offscreen.hpp"

namespace packstone::viz {

namespace {

constexpr const char* radius_array = "radius";

/// Lights that go with the viewer: one beside him, the key light over the left shoulder, a weak one from the right; a
/// small highlight from the key light. normalVCVSOutput is the normal as seen by the viewer: right, up, to him.
constexpr const char* lighting = R"(
  const vec3 key = vec3(-0.48, 0.69, 0.55);
  const vec3 fill = vec3(0.91, 0.18, 0.37);
  const vec3 halfway = vec3(-0.27, 0.39, 0.88);
  vec3 n = normalVCVSOutput;
  float light = 0.22 + 0.36 * max(n.z, 0.0) + 0.51 * max(dot(n, key), 0.0) + 0.12 * max(dot(n, fill), 0.0);
  float shine = max(dot(n, halfway), 0.0);
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine;
  gl_FragData[0] = vec4(min(diffuseColor * light + 0.10 * shine, 1.0), 1.0);
)";

/// The particles as sphere impostors: exact at any distance, two triangles' worth of work each.
class Spheres {
 public:
  explicit Spheres(vtkRenderer* renderer) {
    mapper_->SetInputData(data_);
    mapper_->SetScaleArray(radius_array);
    mapper_->SetColorModeToDirectScalars();
    actor_->SetMapper(mapper_);
    // Replaces VTK's general lighting, which costs the software renderer twice the rest of the shader.
    constexpr bool before_vtk = true;
    constexpr bool every_place = false;
    actor_->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", before_vtk, lighting, every_place);
    renderer->AddActor(actor_);
  }

  /// Only the listed rows.
  void update(const std::vector<Vec3>& centres, const std::vector<double>& radii, const std::vector<Colour>& colours,
              const std::vector<std::size_t>& rows) {
    const auto count = static_cast<vtkIdType>(rows.size());
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> sizes;
    vtkNew<vtkUnsignedCharArray> tints;
    vtkNew<vtkCellArray> vertices;  // the mapper draws vertex cells only
    points->SetNumberOfPoints(count);
    sizes->SetName(radius_array);
    sizes->SetNumberOfValues(count);
    tints->SetNumberOfComponents(3);
    tints->SetNumberOfTuples(count);
    vertices->AllocateExact(count, count);
    for (vtkIdType i = 0; i < count; ++i) {
      const std::size_t row = rows[static_cast<std::size_t>(i)];
      points->SetPoint(i, centres[row].data());
      sizes->SetValue(i, static_cast<float>(radii[row]));
      const std::uint8_t rgb[] = {colours[row].r, colours[row].g, colours[row].b};
      tints->SetTypedTuple(i, rgb);
      vertices->InsertNextCell(1, &i);
    }
    data_->Initialize();
    data_->SetPoints(points);
    data_->SetVerts(vertices);
    data_->GetPointData()->AddArray(sizes);
    data_->GetPointData()->SetScalars(tints);
    actor_->SetVisibility(count > 0);
  }

 private:
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkOpenGLSphereMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

const PictureOptions& checked(const PictureOptions& options) {
  if (options.supersampling < 1) throw InputError("super-sampling takes 1 or more");
  if (options.width < 1 || options.height < 1) throw InputError("a picture has at least 1 x 1 px");
  return options;
}

}  // namespace

struct ParticlePainter::Stage {
  OffscreenWindow window;
  vtkNew<vtkRenderer> renderer;
  Spheres spheres{renderer};
  Container container{renderer};
  DrawingPainter labels;
  std::optional<UnitSpace> space;

  Stage(int width, int height) : window(width, height) {
    renderer->SetBackground(0, 0, 0);
    renderer->SetBackgroundAlpha(0);
    renderer->AutomaticLightCreationOff();  // the spheres bring their own, and all else is unlit
    window.window()->AddRenderer(renderer);
  }
};

ParticlePainter::ParticlePainter(const PictureOptions& options)
    : options_(checked(options)),
      stage_(std::make_unique<Stage>(options.width * options.supersampling, options.height * options.supersampling)) {}

ParticlePainter::~ParticlePainter() = default;

void ParticlePainter::draw_spheres(const Snapshot& snapshot, const UnitSpace& space, const Colouring& colouring,
                                   const Camera& camera) {
  std::vector<Vec3> centres(snapshot.size());
  std::vector<double> radii(snapshot.size());
  for (std::size_t row = 0; row < snapshot.size(); ++row) {
    centres[row] = (snapshot.position[row] - space.centre) * space.scale;
    radii[row] = snapshot.radius[row] * space.scale;
  }
  std::vector<std::size_t> rows(snapshot.size());
  if (options_.cull) {
    rows = visible_rows(centres, radii, camera, options_.width, options_.height);
  } else {
    std::iota(rows.begin(), rows.end(), std::size_t{0});
  }
  stage_->spheres.update(centres, radii, colouring.colours, rows);
}

Image ParticlePainter::paint(const Snapshot& snapshot) {
  const Colouring colouring = colour_particles(snapshot, options_.color, options_.range);
  const UnitSpace space(snapshot.domain);
  const Layout layout = lay_out(options_, space, colouring);
  layout.camera.apply(*stage_->renderer->GetActiveCamera(), options_.width, options_.height);
  draw_spheres(snapshot, space, colouring, layout.camera);
  if (options_.container) {
    constexpr double line_weight = 0.06;  // of the font size
    stage_->container.update(snapshot, space.centre, space.scale, layout.camera, line_weight * layout.font);
  } else {
    stage_->container.hide();
  }
  stage_->space = space;
  OffscreenWindow& window = stage_->window;
  window.render();
  const Layer particles = average_down(window.rgba(), window.width(), window.height(), options_.supersampling);
  const Layer labels =
      stage_->labels.paint(annotate(options_, space, layout, colouring, snapshot.time), options_.supersampling);
  return flatten({&particles, &labels}, paper);
}

std::optional<Vec3> ParticlePainter::surface_point(int column, int row) const {
  const OffscreenWindow& window = stage_->window;
  const int x = static_cast<int>((column + 0.5) * options_.supersampling);
  const int y = window.height() - 1 - static_cast<int>((row + 0.5) * options_.supersampling);
  const float depth = window.depth(x, y);
  if (!stage_->space || depth >= 1) return std::nullopt;
  double point[4];
  stage_->renderer->SetDisplayPoint(x + 0.5, y + 0.5, depth);
  stage_->renderer->DisplayToWorld();
  stage_->renderer->GetWorldPoint(point);
  return Vec3(point[0], point[1], point[2]) / point[3] / stage_->space->scale + stage_->space->centre;
}

Image draw_particles(const Snapshot& snapshot, const PictureOptions& options) {
  return ParticlePainter(options).paint(snapshot);
}

}  // namespace packstone::viz
