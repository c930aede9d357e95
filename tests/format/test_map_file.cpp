// The map of the solid fraction as VTK's own reader sees it.
#include <array>
#include <numbers>

#include <catch2/catch.hpp>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkXMLImageDataReader.h>

#include "analysis/packing/fraction_map.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;

TEST_CASE("VTK reads the map of the solid fraction, cell by cell") {
  // Spheres in the middle of cells of edge 1: the highest one bounds the map, the other cells are empty.
  Snapshot s;
  s.domain = {Vec3(-1, 2, 0), Vec3(3, 5, 9), {true, true, false}};
  s.gravity = Vec3(0, 0, -9.8);
  s.groups = {{"grain", "grain", 1000}};
  s.material_names = {"grain"};
  const std::vector<std::pair<Vec3, double>> spheres = {
      {Vec3(-0.5, 2.5, 0.5), 0.1}, {Vec3(2.5, 2.5, 0.5), 0.2}, {Vec3(-0.5, 4.5, 0.5), 0.3}, {Vec3(1.5, 3.5, 1.5), 0.5}};
  for (const auto& [place, radius] : spheres) {
    s.id.push_back(static_cast<std::int64_t>(s.size()));
    s.position.push_back(place);
    s.radius.push_back(radius);
    s.type.push_back(0);
    s.material.push_back(0);
  }
  const testing::TemporaryFolder folder;
  const std::string path = (folder / "map.vti").string();
  analysis::write_fraction_map(path, s, {.map_cell = 1});

  vtkNew<vtkXMLImageDataReader> reader;
  REQUIRE(reader->CanReadFile(path.c_str()));
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* const map = reader->GetOutput();
  REQUIRE(map->GetNumberOfCells() == 4 * 3 * 2);
  CHECK(Vec3(map->GetOrigin()) == s.domain.min);
  CHECK((Vec3(map->GetSpacing()) - Vec3::Ones()).norm() < 1e-15);
  vtkDataArray* const fraction = map->GetCellData()->GetScalars();
  REQUIRE(fraction);
  CHECK(std::string(fraction->GetName()) == "solid_fraction");
  std::vector<double> expected(24, 0.0);
  for (const auto& [place, radius] : spheres) {
    Vec3 at = place;
    std::array<double, 3> inside;
    std::array<double, 8> weights;
    int corner = 0;
    const vtkIdType cell = map->FindCell(at.data(), nullptr, 0, 0, corner, inside.data(), weights.data());
    REQUIRE(cell >= 0);  // where VTK puts the sphere's centre
    expected[static_cast<std::size_t>(cell)] = 4 * std::numbers::pi / 3 * radius * radius * radius;
  }
  for (vtkIdType k = 0; k < 24; ++k) {
    CHECK(fraction->GetTuple1(k) == Approx(expected[static_cast<std::size_t>(k)]).epsilon(1e-13).margin(1e-15));
  }
}
