// State as a stream of values. A class names the members that live from step to step once, in archive(Archive&), for
// both ways: written and read back.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace packstone {

/// Types whose every byte is part of their value: no padding, whose bytes nobody sets. A struct with floating-point
/// members says so itself: static constexpr bool solid = true.
template <class T>
inline constexpr bool is_solid = [] {
  if constexpr (requires { T::solid; }) {
    return T::solid;
  } else {
    return std::is_arithmetic_v<T> || std::is_enum_v<T> ||
           (std::is_trivially_copyable_v<T> && std::has_unique_object_representations_v<T> && !std::is_pointer_v<T>);
  }
}();
template <class Scalar, int rows, int columns, int options, int most_rows, int most_columns>
inline constexpr bool is_solid<Eigen::Matrix<Scalar, rows, columns, options, most_rows, most_columns>> =
    rows > 0 && columns > 0;

class Archive {
 public:
  virtual ~Archive() = default;

  virtual bool reads() const = 0;
  /// What follows belongs to the part of this name. Reading throws InputError where there is none, or where the part
  /// before was not read to its end.
  virtual void begin(std::string_view part) = 0;

  /// Writes the values, or reads them. Reading throws InputError where the part ends before.
  template <class... Values>
  void operator()(Values&... values) {
    (pass(values), ...);
  }

 protected:
  virtual void bytes(void* data, std::size_t size) = 0;
  /// Bytes of the part still to be read.
  virtual std::size_t left() const = 0;
  /// What is read cannot be.
  [[noreturn]] virtual void fail() const = 0;

 private:
  template <class T>
  void pass(T& value) {
    if constexpr (requires(Archive & a) { value.archive(a); }) {
      value.archive(*this);
    } else {
      static_assert(is_solid<T>, "needs a member archive(Archive&)");
      bytes(&value, sizeof value);
    }
  }

  void pass(bool& value) {
    std::uint8_t byte = value;
    bytes(&byte, 1);
    value = byte != 0;
  }

  void pass(std::string& text) {
    text.resize(count(text.size(), 1));
    bytes(text.data(), text.size());
  }

  template <class T, class Allocator>
  void pass(std::vector<T, Allocator>& values) {
    values.resize(count(values.size(), is_solid<T> ? sizeof(T) : 1));
    if constexpr (is_solid<T>) {
      bytes(values.data(), values.size() * sizeof(T));
    } else {
      for (T& value : values) pass(value);
    }
  }

  template <class T, std::size_t size>
  void pass(std::array<T, size>& values) {
    for (T& value : values) pass(value);
  }

  template <class T>
  void pass(std::optional<T>& value) {
    bool there = value.has_value();
    pass(there);
    if (reads()) value = there ? std::optional<T>(T{}) : std::nullopt;
    if (there) pass(*value);
  }

  /// Of a sequence; what is read must fit into the part.
  std::size_t count(std::size_t size, std::size_t least_bytes) {
    std::uint64_t number = size;
    bytes(&number, sizeof number);
    if (reads() && number > left() / least_bytes) fail();
    return static_cast<std::size_t>(number);
  }
};

}  // namespace packstone
