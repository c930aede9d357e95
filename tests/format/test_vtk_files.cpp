// VTK's files as packstone writes them and as Yade does, through VTK's readers.
#include <array>
#include <fstream>

#include <catch2/catch.hpp>
#include <vtkCell.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "core/error.hpp"
#include "core/formats/packing_output.hpp"
#include "core/formats/packing_series.hpp"
#include "core/formats/vtk_file.hpp"
#include "tests/core/random_packing.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using testing::random_packing;
using testing::TemporaryFolder;

namespace {

/// As Yade's VTKRecorder writes them, in text instead of base64.
const std::string yade_spheres = R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">
<UnstructuredGrid><Piece NumberOfPoints="2" NumberOfCells="2">
<PointData>
<DataArray type="Float32" Name="radii" format="ascii">1 1</DataArray>
<DataArray type="Float32" Name="materialId" format="ascii">0 1</DataArray>
<DataArray type="Float32" Name="linVelVec" NumberOfComponents="3" format="ascii">1 2 3 4 5 6</DataArray>
</PointData>
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 0 0 1.75</DataArray></Points>
<Cells>
<DataArray type="Int64" Name="connectivity" format="ascii">0 1</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">1 2</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">1 1</DataArray>
</Cells></Piece></UnstructuredGrid></VTKFile>
)";

/// The first interaction is that of the spheres, the second that of one with a wall.
const std::string yade_interactions = R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">
<PolyData><Piece NumberOfPoints="3" NumberOfVerts="0" NumberOfLines="2" NumberOfStrips="0" NumberOfPolys="0">
<CellData>
<DataArray type="Float32" Name="forceN" format="ascii">8 9</DataArray>
</CellData>
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 0 0 1.75 0 0 -1</DataArray></Points>
<Lines>
<DataArray type="Int64" Name="connectivity" format="ascii">0 1 0 2</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">2 4</DataArray>
</Lines></Piece></PolyData></VTKFile>
)";

const std::string legacy =
    "# vtk DataFile Version 3.0.\ncomment\nASCII\n\nDATASET POLYDATA\nPOINTS 2 double\n"
    "0.1 0.2 0.3\n1 2 3\n\nPOINT_DATA 2\nSCALARS radius double 1\nLOOKUP_TABLE default\n0.05\n0.15\n";

}  // namespace

TEST_CASE("VTK's XML files bring everything back to the last bit") {
  const TemporaryFolder folder;
  Snapshot s = random_packing(500);
  s.fields["v_a<b & \"c\">"] = {1, "", s.radius};
  const auto file = folder / GENERATE("a.vtu", "a.vtp");
  write_packing(file, s);
  const Snapshot read = read_packing(file), t = with_rows(read, id_order(read));
  CHECK(t.position == s.position);
  CHECK(t.radius == s.radius);
  CHECK(t.id == s.id);
  CHECK(t.type == s.type);
  CHECK(t.fields.at("velocity").values == s.fields.at("velocity").values);
  CHECK(t.fields.at("v_a<b & \"c\">").values == s.radius);
  CHECK(t.domain.max == s.domain.max);
  CHECK(t.domain.periodic == s.domain.periodic);
  CHECK(t.time == s.time);
  CHECK(t.step == s.step);
}

TEST_CASE("VTK's own readers see in XML files what was written") {
  const TemporaryFolder folder;
  const Snapshot s = random_packing(200);
  write_packing(folder / "a.vtu", s);
  write_packing(folder / "a.vtp", s);
  vtkNew<vtkXMLUnstructuredGridReader> grids;
  vtkNew<vtkXMLPolyDataReader> surfaces;
  grids->SetFileName((folder / "a.vtu").c_str());
  surfaces->SetFileName((folder / "a.vtp").c_str());
  grids->Update();
  surfaces->Update();
  REQUIRE(surfaces->GetOutput()->GetNumberOfVerts() == 200);
  for (vtkPointSet* points :
       {static_cast<vtkPointSet*>(grids->GetOutput()), static_cast<vtkPointSet*>(surfaces->GetOutput())}) {
    REQUIRE(points->GetNumberOfPoints() == 200);
    REQUIRE(points->GetNumberOfCells() == 200);
    vtkPointData* data = points->GetPointData();
    for (const char* name : {"radius", "id", "type", "velocity", "angular_velocity", "force"}) {
      CAPTURE(name);
      REQUIRE(data->GetArray(name));
    }
    for (vtkIdType k = 0; k < 200; ++k) {
      const auto i = static_cast<std::size_t>(k);  // rows are by id, and so is the packing
      CHECK(Vec3(points->GetPoint(k)) == s.position[i]);
      CHECK(data->GetArray("radius")->GetTuple1(k) == s.radius[i]);
      CHECK(data->GetArray("id")->GetTuple1(k) == static_cast<double>(s.id[i]));
      CHECK(data->GetArray("type")->GetTuple1(k) == s.type[i]);
      for (int c = 0; c < 3; ++c) {
        CHECK(data->GetArray("force")->GetComponent(k, c) ==
              s.fields.at("force").values[3 * i + static_cast<std::size_t>(c)]);
      }
      REQUIRE(points->GetCellType(k) == VTK_VERTEX);
      CHECK(points->GetCell(k)->GetPointId(0) == k);
    }
    CHECK(points->GetFieldData()->GetArray(formats::vtk_time_name)->GetTuple1(0) == s.time);
  }
}

TEST_CASE("Yade's spheres come with the interactions beside them") {
  const TemporaryFolder folder;
  std::ofstream(folder / "x-spheres.7.vtu") << yade_spheres;
  std::ofstream(folder / "x-intrs.7.vtp") << yade_interactions;
  const Snapshot s = read_packing(folder / "x-spheres.7.vtu");
  REQUIRE(s.size() == 2);
  CHECK(s.radius == std::vector<double>{1, 1});
  CHECK(s.type == std::vector<std::int32_t>{0, 1});
  CHECK(s.fields.at("velocity").values == std::vector<double>{1, 2, 3, 4, 5, 6});
  REQUIRE(s.contacts);
  REQUIRE(s.contacts->size() == 1);
  CHECK(s.contacts->overlap[0] == 0.25);
  CHECK(s.contacts->force[0] == Vec3(0, 0, -8));  // pushes the first, the lower one, down
}

TEST_CASE("Yade's legacy files are read") {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.vtk") << legacy;
  const Snapshot s = read_packing(folder / "a.vtk");
  CHECK(s.position[1] == Vec3(1, 2, 3));
  CHECK(s.radius == std::vector<double>{0.05, 0.15});
}

TEST_CASE("a damaged file of VTK is refused by name") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text) {
    std::ofstream(folder / "bad.vtu") << text;
    CHECK_THROWS_AS(read_packing(folder / "bad.vtu"), InputError);
    CHECK_THROWS_WITH(read_packing(folder / "bad.vtu"), Contains("bad.vtu"));
  };
  refused(yade_spheres.substr(0, yade_spheres.size() / 2));
  refused("<?xml version=\"1.0\"?>\n<svg/>\n");
  refused(legacy.substr(0, legacy.size() - 40));
  std::string renamed = yade_spheres;
  refused(renamed.replace(renamed.find("radii"), 5, "sizes"));
}
