// Arrays of VTK's XML files, their bytes appended raw after the text that announces them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/text_output.hpp"

namespace packstone::formats {

/// A name as XML takes it between quotes.
std::string xml_escaped(const std::string& name);

/// Collects where each array's bytes will stand, then writes them one after the other. The values must live until then.
class VtkAppended {
 public:
  explicit VtkAppended(TextOutput& out) : out_(out) {}

  /// type as VTK calls it ("Float64"); count of values, all components; field: of field data, which has no other
  /// length.
  template <class T>
  void declare(const std::string& name, const char* type, int components, const T* values, std::size_t count,
               bool field = false) {
    out_.print("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"appended\" offset=\"{}\"/>\n",
               type, xml_escaped(name), components,
               field ? fmt::format(" NumberOfTuples=\"{}\"", count / components) : "", offset_);
    arrays_.push_back({reinterpret_cast<const char*>(values), count * sizeof(T)});
    offset_ += sizeof(std::uint64_t) + count * sizeof(T);
  }

  void write();

 private:
  TextOutput& out_;
  std::size_t offset_ = 0;
  std::vector<std::pair<const char*, std::size_t>> arrays_;
};

}  // namespace packstone::formats
