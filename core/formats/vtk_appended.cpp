#include "core/formats/vtk_appended.hpp"

#include <map>

namespace packstone::formats {

std::string xml_escaped(const std::string& name) {
  static const std::map<char, const char*> entities = {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
  std::string result;
  for (const char c : name) {
    const auto entity = entities.find(c);
    result += entity == entities.end() ? std::string(1, c) : entity->second;
  }
  return result;
}

void VtkAppended::write() {
  out_.print("<AppendedData encoding=\"raw\">\n_");
  for (const auto& [bytes, count] : arrays_) {
    const std::uint64_t size = count;
    out_.raw(&size, sizeof size);
    out_.raw(bytes, count);
  }
  out_.print("\n</AppendedData>\n");
}

}  // namespace packstone::formats
