#include "viz/container.hpp"

#include <algorithm>
#include <cmath>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

#include "viz/surface.hpp"

namespace packstone::viz {

namespace {

constexpr double dash = 0.014;  ///< of the domain's longest side
constexpr double gap = 0.010;

void colour(vtkActor* actor, Colour c) {
  actor->GetProperty()->SetColor(c.r / 255.0, c.g / 255.0, c.b / 255.0);
  actor->GetProperty()->LightingOff();
}

/// Straight rods, thick enough to be a line of some pixels.
class Rods {
 public:
  explicit Rods(Colour c) {
    constexpr int sides = 8;
    tubes_->SetInputData(data_);
    tubes_->SetNumberOfSides(sides);
    tubes_->CappingOn();
    mapper_->SetInputConnection(tubes_->GetOutputPort());
    actor->SetMapper(mapper_);
    colour(actor, c);
  }

  void clear() {
    data_->Initialize();
    data_->SetPoints(vtkNew<vtkPoints>());
    data_->SetLines(vtkNew<vtkCellArray>());
  }

  void add(const Vec3& from, const Vec3& to) {
    const vtkIdType ends[] = {data_->GetPoints()->InsertNextPoint(from.data()),
                              data_->GetPoints()->InsertNextPoint(to.data())};
    data_->GetLines()->InsertNextCell(2, ends);
  }

  void add_dashed(const Vec3& from, const Vec3& to) {
    const double length = (to - from).norm();
    const int count = std::max(1, static_cast<int>(std::lround(length / (dash + gap))));
    const Vec3 step = (to - from) / count;
    const double drawn = dash / (dash + gap);
    for (int i = 0; i < count; ++i) add(from + i * step, from + (i + drawn) * step);
  }

  void finish(double radius) {
    tubes_->SetRadius(radius);
    data_->Modified();
    actor->SetVisibility(data_->GetNumberOfLines() > 0);
  }

  vtkNew<vtkActor> actor;

 private:
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkTubeFilter> tubes_;
  vtkNew<vtkPolyDataMapper> mapper_;
};

/// Filled polygons.
class Plates {
 public:
  explicit Plates(Colour fill) {
    mapper_->SetInputData(data_);
    actor->SetMapper(mapper_);
    colour(actor, fill);
  }

  void clear() {
    data_->Initialize();
    data_->SetPoints(vtkNew<vtkPoints>());
    data_->SetPolys(vtkNew<vtkCellArray>());
  }

  void add(const std::vector<Vec3>& corners) {
    data_->GetPolys()->InsertNextCell(static_cast<vtkIdType>(corners.size()));
    for (const Vec3& c : corners) data_->GetPolys()->InsertCellPoint(data_->GetPoints()->InsertNextPoint(c.data()));
  }

  void finish() {
    data_->Modified();
    actor->SetVisibility(data_->GetNumberOfPolys() > 0);
  }

  vtkNew<vtkActor> actor;

 private:
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkPolyDataMapper> mapper_;
};

/// A colour in the light from over the viewer's left shoulder that the spheres have, softened so that it reaches
/// round.
Colour shaded(Colour full_light, const Vec3& normal, const Camera& camera) {
  const Vec3 key(-0.48, 0.69, 0.55);  // to the right, up, to the viewer
  constexpr double least = 0.74;
  constexpr double most = 1.02;  // of which a floor, seen from above at an angle, has 1
  double along = 0;
  for (int k = 0; k < 3; ++k) along += key[k] * camera.axes()[k].dot(normal);
  const double light = least + (most - least) * (1 + along) / 2;
  const auto tone = [&](std::uint8_t full) { return static_cast<std::uint8_t>(std::lround(light * full)); };
  return {tone(full_light.r), tone(full_light.g), tone(full_light.b)};
}

/// Triangles with a colour at every corner.
class Faces {
 public:
  explicit Faces(Colour fill) : fill_(fill) {
    mapper_->SetInputData(data_);
    actor->SetMapper(mapper_);
    actor->GetProperty()->LightingOff();
  }

  void clear() {
    data_->Initialize();
    colours_->Initialize();
    colours_->SetNumberOfComponents(3);
    data_->SetPoints(vtkNew<vtkPoints>());
    data_->SetPolys(vtkNew<vtkCellArray>());
    data_->GetPointData()->SetScalars(colours_);
  }

  void add(const SeenSurface& surface, const Camera& camera) {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      vtkIdType corners[3];
      for (std::size_t c = 0; c < 3; ++c) {
        corners[c] = data_->GetPoints()->InsertNextPoint(surface.points[surface.triangles[t][c]].data());
        const Colour colour = shaded(fill_, surface.normals[t][c], camera);
        const std::uint8_t rgb[] = {colour.r, colour.g, colour.b};
        colours_->InsertNextTypedTuple(rgb);
      }
      data_->GetPolys()->InsertNextCell(3, corners);
    }
  }

  void finish(const Camera& camera) {
    // A little nearer than they are, so that they lie before plates in the same plane.
    constexpr double step = 2e-4;
    const Vec3 shift = step * camera.axes()[2];
    actor->SetPosition(shift.x(), shift.y(), shift.z());
    data_->Modified();
    actor->SetVisibility(data_->GetNumberOfPolys() > 0);
  }

  vtkNew<vtkActor> actor;

 private:
  Colour fill_;  // in full light
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkPolyDataMapper> mapper_;
};

/// Calls visit(from corner, to corner, axis) for the twelve edges of box_corners.
template <typename Visit>
void for_each_edge(const Visit& visit) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 8; ++corner) {
      if ((corner >> axis & 1) == 0) visit(corner, corner | 1 << axis, axis);
    }
  }
}

}  // namespace

std::vector<Vec3> plane_in_box(const Vec3& point, const Vec3& normal, const Vec3& min, const Vec3& max) {
  const auto corners = box_corners(min, max);
  const double tolerance = 1e-6 * (max - min).norm();
  std::vector<Vec3> found;
  const auto keep = [&](const Vec3& p) {
    const auto near = [&](const Vec3& q) { return (p - q).norm() < tolerance; };
    if (std::none_of(found.begin(), found.end(), near)) found.push_back(p);
  };
  for_each_edge([&](int from, int to, int /*axis*/) {
    const double a = normal.dot(corners[from] - point);
    const double b = normal.dot(corners[to] - point);
    if (std::abs(a) < tolerance) keep(corners[from]);
    if (std::abs(b) < tolerance) keep(corners[to]);
    if (std::min(std::abs(a), std::abs(b)) >= tolerance && a * b < 0) {
      keep(corners[from] + a / (a - b) * (corners[to] - corners[from]));
    }
  });
  if (found.size() < 3) return {};
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : found) middle += p / static_cast<double>(found.size());
  const Vec3 u = (found.front() - middle).normalized();
  const Vec3 v = normal.cross(u);
  const auto angle = [&](const Vec3& p) { return std::atan2(v.dot(p - middle), u.dot(p - middle)); };
  std::sort(found.begin(), found.end(), [&](const Vec3& p, const Vec3& q) { return angle(p) < angle(q); });
  return found;
}

struct Container::Parts {
  Rods edges, wall_edges;
  Plates plates;
  Faces faces;

  explicit Parts(Ground ground)
      : edges(themed(faint_ink, ground)),
        wall_edges(themed(wall_edge, ground)),
        plates(themed(plate_fill, ground)),
        faces(themed(plate_fill, ground)) {}

  void add_plane(const BoundaryRecord& wall, const std::vector<Vec3>& ring, const Camera& camera) {
    for (std::size_t i = 0; i < ring.size(); ++i) wall_edges.add(ring[i], ring[(i + 1) % ring.size()]);
    if (!ring.empty() && camera.sees(ring.front(), wall.normal)) plates.add(ring);
  }

  void add_surface(const SeenSurface& surface, const Camera& camera) {
    for (const auto& [from, to] : surface.lines) wall_edges.add(surface.points[from], surface.points[to]);
    faces.add(surface, camera);
  }
};

Container::Container(vtkRenderer* renderer, Ground ground) : parts_(std::make_unique<Parts>(ground)) {
  renderer->AddActor(parts_->edges.actor);
  renderer->AddActor(parts_->wall_edges.actor);
  renderer->AddActor(parts_->plates.actor);
  renderer->AddActor(parts_->faces.actor);
}

Container::~Container() = default;

void Container::update(const Snapshot& snapshot, const Vec3& centre, double scale, const Camera& camera,
                       double line_width) {
  Parts& parts = *parts_;
  const Domain& domain = snapshot.domain;
  const Vec3 min = (domain.min - centre) * scale;
  const Vec3 max = (domain.max - centre) * scale;
  parts.edges.clear();
  const auto corners = box_corners(min, max);
  for_each_edge([&](int from, int to, int axis) {
    const bool periodic = domain.periodic[(axis + 1) % 3] && domain.periodic[(axis + 2) % 3];
    if (periodic) {
      parts.edges.add_dashed(corners[from], corners[to]);
    } else {
      parts.edges.add(corners[from], corners[to]);
    }
  });
  parts.wall_edges.clear();
  parts.plates.clear();
  parts.faces.clear();
  for (const BoundaryRecord& wall : snapshot.boundaries) {
    if (wall.kind == "plane") {
      parts.add_plane(wall, plane_in_box((wall.point - centre) * scale, wall.normal, min, max), camera);
    } else {
      std::vector<Vec3> points;
      points.reserve(wall.points.size());
      for (const Vec3& p : wall.points) points.emplace_back((p - centre) * scale);
      parts.add_surface(seen_surface(points, wall.triangles, wall.one_sided, camera), camera);
    }
  }
  const double radius = line_width / 2 / camera.pixels_per_unit();
  parts.edges.finish(radius);
  constexpr double wall_weight = 1.5;  // thicker, so that it covers the box's own edge
  parts.wall_edges.finish(radius * wall_weight);
  parts.plates.finish();
  parts.faces.finish(camera);
}

void Container::hide() {
  Parts& parts = *parts_;
  for (vtkActor* actor :
       {parts.edges.actor.Get(), parts.wall_edges.actor.Get(), parts.plates.actor.Get(), parts.faces.actor.Get()}) {
    actor->SetVisibility(false);
  }
}

}  // namespace packstone::viz
