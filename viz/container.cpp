#include "viz/container.hpp"

#include <algorithm>
#include <cmath>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>

namespace packstone::viz {

namespace {

constexpr Colour wall_edge = {110, 110, 110};
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
  Plates() {
    mapper_->SetInputData(data_);
    actor->SetMapper(mapper_);
    colour(actor, plate_fill);
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
  Rods edges{faint_ink};
  Rods wall_edges{wall_edge};
  Plates plates;
};

Container::Container(vtkRenderer* renderer) : parts_(std::make_unique<Parts>()) {
  renderer->AddActor(parts_->edges.actor);
  renderer->AddActor(parts_->wall_edges.actor);
  renderer->AddActor(parts_->plates.actor);
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
  for (const BoundaryRecord& wall : snapshot.boundaries) {
    if (wall.kind != "plane") continue;
    const std::vector<Vec3> ring = plane_in_box((wall.point - centre) * scale, wall.normal, min, max);
    if (ring.empty()) continue;
    for (std::size_t i = 0; i < ring.size(); ++i) parts.wall_edges.add(ring[i], ring[(i + 1) % ring.size()]);
    if (camera.sees(ring.front(), wall.normal)) parts.plates.add(ring);
  }
  const double radius = line_width / 2 / camera.pixels_per_unit();
  parts.edges.finish(radius);
  constexpr double wall_weight = 1.5;  // thicker, so that it covers the box's own edge
  parts.wall_edges.finish(radius * wall_weight);
  parts.plates.finish();
}

void Container::hide() {
  for (vtkActor* actor : {parts_->edges.actor.Get(), parts_->wall_edges.actor.Get(), parts_->plates.actor.Get()}) {
    actor->SetVisibility(false);
  }
}

}  // namespace packstone::viz
