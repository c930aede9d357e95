#include "core/formats/text_output.hpp"

namespace packstone::formats {

void TextOutput::print_values(fmt::string_view format, fmt::format_args values) {
  fmt::vformat_to(fmt::appender(buffer_), format, values);
  if (buffer_.size() > flush_bytes) flush();
}

void TextOutput::flush() {
  file_.write({buffer_.data(), buffer_.size()});
  buffer_.clear();
}

void TextOutput::raw(const void* bytes, std::size_t count) {
  flush();
  file_.write({static_cast<const char*>(bytes), count});
}

void TextOutput::finish() {
  flush();
  file_.commit();
}

std::vector<OutputColumn> vector_columns(const Snapshot& snapshot, const std::array<const char*, 3>& velocity,
                                         const std::array<const char*, 3>& angular_velocity) {
  std::vector<OutputColumn> columns;
  const auto add = [&](const char* field, const std::array<const char*, 3>& names) {
    const auto found = snapshot.fields.find(field);
    if (found == snapshot.fields.end() || found->second.components != 3) return;
    for (std::size_t k = 0; k < 3; ++k) columns.push_back({names[k], found->second.values.data() + k, 3});
  };
  add("velocity", velocity);
  add("angular_velocity", angular_velocity);
  add("force", {"fx", "fy", "fz"});
  return columns;
}

double mass_of(const Snapshot& snapshot, std::size_t row) {
  const auto found = snapshot.fields.find("mass");
  const bool own = found != snapshot.fields.end() && found->second.components == 1;
  return own ? found->second.values[row] : snapshot.mass(row);
}

}  // namespace packstone::formats
