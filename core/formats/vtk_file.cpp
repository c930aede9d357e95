#include "core/formats/vtk_file.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDataReader.h>
#include <vtkFieldData.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "core/error.hpp"
#include "core/formats/mapped_file.hpp"
#include "core/formats/quiet_vtk.hpp"
#include "core/trial.hpp"

namespace packstone::formats {

namespace {

constexpr std::size_t head_bytes = 1000;                         ///< in which an XML file says what it holds
constexpr std::size_t memory_at_least = std::size_t{256} << 20;  ///< [bytes], of VTK itself and small files
constexpr std::size_t memory_over_file_size = 64;                ///< arrays, unpacked

struct KnownVector {
  std::array<const char*, 4> names;
  std::array<const char*, 3> columns;
};

constexpr std::array known_vectors = {
    KnownVector{{"velocity", "linVelVec", "linVel", "v"}, {"vx", "vy", "vz"}},
    KnownVector{{"angular_velocity", "angVelVec", "angVel", "omega"}, {"wx", "wy", "wz"}},
    KnownVector{{"force", "forceVec", "forces", "f"}, {"fx", "fy", "fz"}}};

template <class Reader>
vtkSmartPointer<vtkPointSet> read_with(const std::filesystem::path& path) {
  const QuietVtk quiet;
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  if constexpr (std::is_base_of_v<vtkDataReader, Reader>) {  // which else takes the first array of each kind
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllFieldsOn();
  }
  reader->Update();
  vtkSmartPointer<vtkPointSet> points = vtkPointSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (reader->GetErrorCode() != 0 || !points) {
    throw InputError(path.string() + ": VTK cannot read it, or it holds no points; is the file cut short?");
  }
  return points;
}

using ReadPoints = vtkSmartPointer<vtkPointSet> (*)(const std::filesystem::path&);

ReadPoints reader_of(const std::filesystem::path& path, std::string_view text) {
  const std::string_view head = text.substr(0, head_bytes);
  if (head.starts_with("# vtk")) return read_with<vtkGenericDataObjectReader>;
  if (head.find("\"UnstructuredGrid\"") != std::string_view::npos) return read_with<vtkXMLUnstructuredGridReader>;
  if (head.find("\"PolyData\"") != std::string_view::npos) return read_with<vtkXMLPolyDataReader>;
  throw InputError(path.string() + ": is XML, but neither VTK's UnstructuredGrid (.vtu) nor its PolyData (.vtp)");
}

/// VTK's readers may crash on a damaged file, so they have a try at it first.
vtkSmartPointer<vtkPointSet> read_points(const std::filesystem::path& path) {
  const MappedFile file(path);
  const ReadPoints read = reader_of(path, file.text());
  const std::string failure =
      failure_in_trial(memory_at_least + memory_over_file_size * file.text().size(), [&] { read(path); });
  if (!failure.empty()) throw InputError(path.string() + ": damaged: " + failure);
  return read(path);
}

std::vector<double> component(vtkDataArray& array, int k) {
  std::vector<double> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = array.GetComponent(static_cast<vtkIdType>(i), k);
  return values;
}

void add_array(ParticleColumns& columns, vtkDataArray& array, const std::string& name) {
  const int parts = array.GetNumberOfComponents();
  if (parts == 1) add_column(columns, name, component(array, 0));
  if (parts != 3) return;
  for (const KnownVector& known : known_vectors) {
    if (std::find(known.names.begin(), known.names.end(), name) == known.names.end()) continue;
    for (int k = 0; k < 3; ++k) add_column(columns, known.columns[static_cast<std::size_t>(k)], component(array, k));
  }
}

Vec3 vector_at(vtkDataArray& array, vtkIdType row) {
  return {array.GetComponent(row, 0), array.GetComponent(row, 1), array.GetComponent(row, 2)};
}

InputError no_interactions(const std::filesystem::path& path) {
  return InputError(path.string() +
                    ": holds no interactions; expected lines with forceN, as Yade's recorder intr writes, or with "
                    "normalForce and shearForce");
}

/// Time and box, which packstone's own files have.
void read_field_data(ParticleColumns& columns, vtkFieldData& data) {
  if (vtkDataArray* time = data.GetArray(vtk_time_name); time && time->GetNumberOfValues() == 1) {
    columns.time = time->GetTuple1(0);
  }
  if (vtkDataArray* step = data.GetArray(vtk_step_name); step && step->GetNumberOfValues() == 1) {
    columns.step = static_cast<std::int64_t>(step->GetTuple1(0));
  }
  vtkDataArray* corners = data.GetArray(vtk_domain_name);
  vtkDataArray* periodic = data.GetArray(vtk_periodic_name);
  if (!corners || corners->GetNumberOfValues() != 6 || !periodic || periodic->GetNumberOfValues() != 3) return;
  Domain box;
  for (int k = 0; k < 3; ++k) {
    box.min[k] = corners->GetVariantValue(k).ToDouble();
    box.max[k] = corners->GetVariantValue(3 + k).ToDouble();
    box.periodic[k] = periodic->GetVariantValue(k).ToInt() != 0;
  }
  if ((box.min.array() < box.max.array()).all()) columns.domain = box;
}

}  // namespace

ParticleColumns read_vtk_file(const std::filesystem::path& path) {
  const vtkSmartPointer<vtkPointSet> points = read_points(path);
  ParticleColumns columns;
  columns.source = path.string();
  columns.count = static_cast<std::size_t>(points->GetNumberOfPoints());
  for (int k = 0; k < 3; ++k) {
    columns.values[axis_names[k]] =
        columns.count > 0 ? component(*points->GetPoints()->GetData(), k) : std::vector<double>();
  }
  vtkPointData* data = points->GetPointData();
  for (int a = 0; a < data->GetNumberOfArrays(); ++a) {
    vtkDataArray* array = data->GetArray(a);  // null for text
    if (!array || !array->GetName()) continue;
    if (array->GetNumberOfTuples() != points->GetNumberOfPoints()) {
      throw InputError(fmt::format("{}: {} has {} values for {} points; is the file cut short?", columns.source,
                                   array->GetName(), array->GetNumberOfTuples(), columns.count));
    }
    add_array(columns, *array, array->GetName());
  }
  read_field_data(columns, *points->GetFieldData());
  return columns;
}

PairForces read_yade_interactions(const std::filesystem::path& path) {
  const vtkSmartPointer<vtkPointSet> points = read_points(path);
  vtkPolyData* data = vtkPolyData::SafeDownCast(points);
  if (!data || data->GetNumberOfLines() != data->GetNumberOfCells()) throw no_interactions(path);
  vtkCellData* values = data->GetCellData();
  const auto array = [&](const char* name, int components) -> vtkDataArray* {
    vtkDataArray* found = values->GetArray(name);
    if (!found || found->GetNumberOfComponents() != components) return nullptr;
    return found->GetNumberOfTuples() == data->GetNumberOfCells() ? found : nullptr;
  };
  vtkDataArray* normal_part = array("forceN", 1);
  vtkDataArray* normal_force = array("normalForce", 3);
  vtkDataArray* shear_force = array("shearForce", 3);
  PairForces pairs{path.string(), 0, {}, {}, {}};
  pairs.with_friction = normal_force && shear_force;
  if (!pairs.with_friction && !normal_part) throw no_interactions(path);
  for (vtkIdType k = 0; k < data->GetNumberOfLines(); ++k) {
    vtkIdType count = 0;
    const vtkIdType* ends = nullptr;
    data->GetLines()->GetCellAtId(k, count, ends);
    if (count != 2) throw InputError(fmt::format("{}: interaction {} has {} ends; expected 2", pairs.source, k, count));
    if (std::min(ends[0], ends[1]) < 0 || std::max(ends[0], ends[1]) >= data->GetNumberOfPoints()) {
      throw InputError(fmt::format("{}: interaction {} has an end that is none of the points", pairs.source, k));
    }
    const Vec3 first(data->GetPoint(ends[0])), second(data->GetPoint(ends[1]));
    const Vec3 force = pairs.with_friction ? Vec3(-vector_at(*normal_force, k) - vector_at(*shear_force, k))
                                           : Vec3(normal_part->GetTuple1(k) * (first - second).normalized());
    if (!first.allFinite() || !second.allFinite() || !force.allFinite()) {
      throw InputError(fmt::format("{}: interaction {} has an end or a force that is not finite", pairs.source, k));
    }
    pairs.centres.push_back({first, second});
    pairs.force.push_back(force);
  }
  return pairs;
}

}  // namespace packstone::formats
