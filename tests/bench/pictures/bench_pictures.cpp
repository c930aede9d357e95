// Time a picture of a snapshot takes: packstone's spheres, in one process and in one a core, beside VTK's two ways,
// which use all cores, in one run, each with reading back and with the same PNG writer. bench_pictures SNAPSHOT [WIDTH
// HEIGHT [FRAMES]]
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <thread>

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include "core/error.hpp"
#include "core/open_snapshot.hpp"
#include "tests/temporary_folder.hpp"
#include "viz/annotation.hpp"
#include "viz/offscreen.hpp"
#include "viz/particle_scene.hpp"
#include "viz/png.hpp"
#include "viz/workers.hpp"

namespace {

using namespace packstone;

constexpr const char* radius_array = "radius";

double median_seconds(int frames, const std::function<void()>& frame) {
  std::vector<double> seconds;
  for (int k = 0; k < frames; ++k) {
    const auto start = std::chrono::steady_clock::now();
    frame();
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

/// The spheres as points of VTK, in unit space, with radii and vertices.
vtkNew<vtkPolyData> points_of(const ParticleView& particles, const viz::UnitSpace& space) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> radii;
  vtkNew<vtkCellArray> vertices;
  radii->SetName(radius_array);
  for (std::size_t row = 0; row < particles.size(); ++row) {
    const Vec3 p = (particles.position[row] - space.centre) * space.scale;
    const vtkIdType id = points->InsertNextPoint(p.data());
    radii->InsertNextValue(static_cast<float>(particles.radius[row] * space.scale));
    vertices->InsertNextCell(1, &id);
  }
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->AddArray(radii);
  return data;
}

/// Median seconds of a frame of VTK's, drawn anew, read back and written.
double time_vtk(vtkMapper* mapper, const viz::Camera& camera, const viz::PictureOptions& options, int frames,
                const std::filesystem::path& file) {
  viz::OffscreenWindow window(options.width, options.height);
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  window.window()->AddRenderer(renderer);
  camera.apply(*renderer->GetActiveCamera(), options.width, options.height);
  viz::Image image{options.width, options.height, {}};
  window.render();  // VTK's buffers are filled once; the frames are of a moving camera, say
  return median_seconds(frames, [&] {
    window.render();
    const auto& rgba = window.rgba();
    image.rgb.clear();
    for (std::size_t k = 0; k < rgba.size(); k += 4) image.rgb.insert(image.rgb.end(), &rgba[k], &rgba[k] + 3);
    viz::write_png(file, image);
  });
}

/// Seconds a frame of many that worker processes draw anew and write.
double time_workers(const ParticleView& particles, const viz::PictureOptions& options, int workers, int frames,
                    const testing::TemporaryFolder& folder) {
  const auto prepare = [&] {
    const auto painter = std::make_shared<viz::ParticlePainter>(options);
    return [&, painter](std::size_t frame) {
      viz::write_png(folder / fmt::format("{}.png", frame), painter->paint(particles));
      return viz::UnitResult{};
    };
  };
  constexpr int rounds = 5;
  const int count = rounds * frames;
  const auto start = std::chrono::steady_clock::now();
  viz::do_units(
      {.count = static_cast<std::size_t>(count), .prepare = prepare, .take = [](std::size_t, viz::UnitResult) {}},
      workers);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / count;
}

void compare(const std::filesystem::path& path, viz::PictureOptions options, int frames) {
  const OpenSnapshot open(path);
  const ParticleView& particles = open.view();
  const testing::TemporaryFolder folder;
  const auto file = folder / "frame.png";
  options.legend = options.time = options.scale = options.axes = options.container = false;
  const viz::UnitSpace space(particles.snapshot->domain);
  const viz::Camera camera = viz::lay_out(options, space, {}).camera;

  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  fmt::print("{} spheres, {} x {} px, PNG written, {} cores\n\n| way | s a frame | frames a second | ratio |\n",
             particles.size(), options.width, options.height, cores);
  fmt::print("|---|---|---|---|\n");
  double reference = 0;
  const auto row = [&](const std::string& name, double seconds) {
    if (reference == 0) reference = seconds;
    fmt::print("| {} | {:.3f} | {:.2f} | {:.1f} |\n", name, seconds, 1 / seconds, seconds / reference);
  };
  for (const int supersampling : {1, 2}) {
    options.supersampling = supersampling;
    viz::ParticlePainter painter(options);
    const auto frame = [&] { viz::write_png(file, painter.paint(particles)); };
    frame();
    const std::string samples = supersampling == 1 ? "" : ", 2 x 2 samples a pixel";
    row("packstone, one process" + samples, median_seconds(frames, frame));
    row(fmt::format("packstone, {} processes{}", cores, samples),
        time_workers(particles, options, cores, frames, folder));
  }
  const auto points = points_of(particles, space);
  vtkNew<vtkOpenGLSphereMapper> impostors;
  impostors->SetInputData(points);
  impostors->SetScaleArray(radius_array);
  row("vtkOpenGLSphereMapper", time_vtk(impostors, camera, options, frames, file));
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(points);
  glyphs->SetSourceConnection(sphere->GetOutputPort());
  glyphs->SetScaleArray(radius_array);
  glyphs->SetScaleModeToScaleByMagnitude();
  row("vtkGlyph3DMapper, 8 x 8 facets", time_vtk(glyphs, camera, options, 1, file));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 4 && argc != 5) {
    fmt::print(stderr, "usage: bench_pictures SNAPSHOT [WIDTH HEIGHT [FRAMES]]\n");
    return 2;
  }
  constexpr int usual_frames = 9;
  try {
    packstone::viz::PictureOptions options;
    if (argc > 2) options.width = std::atoi(argv[2]);
    if (argc > 2) options.height = std::atoi(argv[3]);
    compare(argv[1], options, argc > 4 ? std::atoi(argv[4]) : usual_frames);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_pictures: error: {}\n", error.what());
    return 1;
  }
}
