#include <catch2/catch.hpp>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkHDFReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include "core/run_folder.hpp"
#include "engine/run.hpp"
#include "tests/sample_scene.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;

TEST_CASE("VTK's own reader sees what was written") {
  const testing::TemporaryFolder folder;
  engine::run_scene(parse_scene(testing::small_scene, "s.toml"), folder / "run", {});
  const RunReader run(folder / "run");
  const Snapshot s = run.snapshot(4);
  vtkNew<vtkHDFReader> reader;
  REQUIRE(reader->CanReadFile(run.snapshot_files()[4].c_str()));
  reader->SetFileName(run.snapshot_files()[4].c_str());
  reader->Update();
  auto* grid = vtkUnstructuredGrid::SafeDownCast(reader->GetOutputDataObject(0));
  REQUIRE(grid);
  REQUIRE(grid->GetNumberOfPoints() == 120);
  REQUIRE(grid->GetNumberOfCells() == 120);
  vtkPointData* data = grid->GetPointData();
  for (const char* name : {"radius", "id", "type", "material", "velocity", "force"}) {
    INFO(name);
    REQUIRE(data->GetArray(name));
  }
  for (vtkIdType i = 0; i < 120; ++i) {
    CHECK(Vec3(grid->GetPoint(i)) == s.position[i]);
    CHECK(data->GetArray("radius")->GetTuple1(i) == s.radius[i]);
    CHECK(data->GetArray("id")->GetTuple1(i) == static_cast<double>(s.id[i]));
    CHECK(data->GetArray("velocity")->GetComponent(i, 2) == s.fields.at("velocity").values[3 * i + 2]);
    CHECK(grid->GetCellType(i) == 1);
  }
  CHECK(grid->GetFieldData()->GetArray("time")->GetTuple1(0) == s.time);
}
