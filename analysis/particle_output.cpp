// Particles with what measures know of them, as files.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "analysis/particle_fields.hpp"
#include "core/error.hpp"
#include "core/formats/packing_output.hpp"
#include "core/formats/text_output.hpp"

namespace packstone::analysis {

namespace {

constexpr std::string_view table_extension = ".csv";
constexpr std::array<std::string_view, 3> snapshot_extensions = {".vtkhdf", ".vtu", ".vtp"};

void add_column(std::vector<formats::OutputColumn>& columns, const std::string& name, const std::string& unit,
                std::span<const double> values, std::size_t component = 0, std::size_t components = 1) {
  const double* const first = values.empty() ? nullptr : values.data() + component;
  columns.push_back({unit.empty() ? name : fmt::format("{} [{}]", name, unit), first, components});
}

std::vector<formats::OutputColumn> table_columns(const Snapshot& s, const std::vector<ParticleField>& fields) {
  constexpr std::array axes = {"x", "y", "z"};
  std::vector<formats::OutputColumn> columns;
  const std::span places(s.size() > 0 ? s.position.front().data() : nullptr, axes.size() * s.size());
  for (std::size_t k = 0; k < axes.size(); ++k) add_column(columns, axes[k], "m", places, k, axes.size());
  add_column(columns, "radius", "m", s.radius);
  for (const ParticleField& field : fields) {
    if (!field.missing.empty()) continue;
    if (field.components == 1) {
      add_column(columns, field.name, field.unit, field.values);
    } else {
      for (std::size_t k = 0; k < axes.size(); ++k) {
        add_column(columns, field.name + "_" + axes[k], field.unit, field.values, k, axes.size());
      }
    }
  }
  return columns;
}

void write_table(const std::filesystem::path& path, const Snapshot& s, const std::vector<ParticleField>& fields) {
  const auto columns = table_columns(s, fields);
  formats::TextOutput out(path);
  out.print("id,type");
  for (const auto& column : columns) out.print(",{}", column.name);
  for (std::size_t i = 0; i < s.size(); ++i) {
    out.print("\n{},{}", s.id[i], s.type[i]);
    for (const auto& column : columns) {
      if (const double value = column.value(i); std::isfinite(value)) {
        out.print(",{}", value);
      } else {
        out.print(",");
      }
    }
  }
  out.print("\n");
  out.finish();
}

}  // namespace

void require_particle_format(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == table_extension) return;
  if (std::find(snapshot_extensions.begin(), snapshot_extensions.end(), extension) != snapshot_extensions.end()) return;
  throw InputError(fmt::format("{}: particles with their values are written as {}", path.string(), particle_formats));
}

void write_particles(const std::filesystem::path& path, Snapshot snapshot, const std::vector<ParticleField>& fields) {
  require_particle_format(path);
  if (path.extension() == table_extension) {
    write_table(path, snapshot, fields);
    return;
  }
  for (const ParticleField& field : fields) {
    if (field.missing.empty()) snapshot.fields[field.name] = {field.components, field.unit, field.values};
  }
  write_packing(path, snapshot);
}

}  // namespace packstone::analysis
