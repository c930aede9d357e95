// The free surface as VTK's own reader sees it.
#include <catch2/catch.hpp>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "analysis/surface/surface_file.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;

TEST_CASE("VTK reads the free surface: heights, normals up, the area that lies under it") {
  for (const double up : {1.0, -1.0}) {
    Snapshot s;
    s.domain = {Vec3(0, 0, -5), Vec3(4, 3, 5), {false, false, false}};
    s.gravity = Vec3(0, 0, -9.8 * up);
    s.groups = {{"grain", "grain", 1000}};
    s.material_names = {"grain"};
    s.id = {0};
    s.position = {Vec3(2, 1.5, -4 * up)};
    s.radius = {1};
    s.type = s.material = {0};
    const testing::TemporaryFolder folder;
    const std::string path = (folder / "surface.vtp").string();
    analysis::write_surface(path, s, {.surface_step = 0.1});

    vtkNew<vtkXMLPolyDataReader> reader;
    REQUIRE(reader->CanReadFile(path.c_str()));
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkPolyData* const surface = reader->GetOutput();
    REQUIRE(surface->GetNumberOfPoints() == 40 * 30);
    REQUIRE(surface->GetNumberOfPolys() == 2 * 39 * 29);
    vtkDataArray* const height = surface->GetPointData()->GetScalars();
    REQUIRE(height);
    CHECK(std::string(height->GetName()) == "height");
    for (vtkIdType k = 0; k < surface->GetNumberOfPoints(); ++k) {
      CHECK(up * surface->GetPoint(k)[2] + 5 == Approx(height->GetTuple1(k)).margin(1e-12));
    }
    CHECK(height->GetRange()[1] == Approx(2).margin(0.01));
    double area = 0;
    for (vtkIdType k = 0; k < surface->GetNumberOfPolys(); ++k) {
      vtkCell* const triangle = surface->GetCell(k);
      const Vec3 a(triangle->GetPoints()->GetPoint(0)), b(triangle->GetPoints()->GetPoint(1)),
          c(triangle->GetPoints()->GetPoint(2));
      const double across = up * (b - a).cross(c - a).z() / 2;
      CHECK(across > 0);
      area += across;
    }
    CHECK(area == Approx(3.9 * 2.9));
  }
}
