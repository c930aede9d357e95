// Options declared once. A part of the scene describes its keys to an OptionVisitor; parsing with range checks, the
// docs page, --help and the filled-in scene.toml are visitors of the same description.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/units.hpp"
#include "core/vec3.hpp"

namespace packstone {

/// Allowed values of a number, ends excluded where said.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_included = true;
  bool high_included = true;

  static Range any() { return {}; }
  static Range positive() { return {0, std::numeric_limits<double>::infinity(), false, true}; }
  static Range at_least(double low) { return {low, std::numeric_limits<double>::infinity(), true, true}; }
  static Range between(double low, double high) { return {low, high, true, true}; }
  static Range half_open(double low, double high) { return {low, high, true, false}; }
  static Range above_up_to(double low, double high) { return {low, high, false, true}; }

  bool contains(double v) const {
    return (low_included ? v >= low : v > low) && (high_included ? v <= high : v < high);
  }
  /// "greater than 0", "from 0 to 1"; empty when anything goes.
  std::string text() const;
};

/// What a key is, in one sentence, and its unit and range.
struct OptionInfo {
  const char* key;
  const char* help;
  Unit unit = unit::none;
  Range range = Range::any();
};

/// Whether a key must be there. A key with a default always has a value.
enum class Presence { required, has_default };

/// Names of an enumeration's values, in its order.
using ChoiceNames = std::vector<std::string>;

/// Visits each option of a description in turn. The value passed in holds the default; a reader replaces it.
class OptionVisitor {
 public:
  virtual ~OptionVisitor() = default;

  virtual void number(const OptionInfo& info, double& value, Presence presence) = 0;
  virtual void number(const OptionInfo& info, std::optional<double>& value) = 0;
  virtual void integer(const OptionInfo& info, std::int64_t& value, Presence presence) = 0;
  virtual void integer(const OptionInfo& info, std::optional<std::int64_t>& value) = 0;
  virtual void boolean(const OptionInfo& info, bool& value) = 0;
  virtual void text(const OptionInfo& info, std::string& value, Presence presence) = 0;
  virtual void text(const OptionInfo& info, std::optional<std::string>& value) = 0;
  virtual void vector(const OptionInfo& info, Vec3& value, Presence presence) = 0;
  virtual void vector(const OptionInfo& info, std::optional<Vec3>& value) = 0;
  /// A number or a word that stands for one chosen by the program: nullopt.
  virtual void number_or(const OptionInfo& info, const char* word, std::optional<double>& value) = 0;
  /// A list of numbers.
  virtual void numbers(const OptionInfo& info, std::vector<double>& value) = 0;
  /// A list of texts.
  virtual void texts(const OptionInfo& info, std::vector<std::string>& value) = 0;
  /// A list of polygons, each a list of its corners.
  virtual void polygons(const OptionInfo& info, std::vector<std::vector<Vec3>>& value) = 0;
  /// A number, or a table [key] in its place; is_table says which. Last of the keys of its own table.
  virtual void number_or_table(const OptionInfo& info, std::optional<double>& value, bool& is_table,
                               const std::function<void()>& describe) = 0;
  /// A list of words out of names; value holds their indices.
  virtual void choices(const OptionInfo& info, const ChoiceNames& names, std::vector<int>& value) = 0;

  template <class Enum>
  void choice(const OptionInfo& info, const ChoiceNames& names, Enum& value, Presence presence) {
    int index = static_cast<int>(value);
    choice_index(info, names, index, presence);
    value = static_cast<Enum>(index);
  }

  /// A table [key]. Absent tables leave the defaults; required keys inside are then missing only if the table is
  /// required.
  virtual void table(const OptionInfo& info, Presence presence, const std::function<void()>& describe) = 0;
  /// A table that may be left out; present says whether it is there.
  virtual void optional_table(const OptionInfo& info, bool& present, const std::function<void()>& describe) = 0;

  /// An array of tables [[key]] with at least minimum entries.
  template <class T>
  void tables(const OptionInfo& info, std::size_t minimum, std::vector<T>& values,
              const std::function<void(OptionVisitor&, T&)>& describe) {
    const std::size_t count = begin_tables(info, minimum, values.size());
    values.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      begin_entry(info, k);
      describe(*this, values[k]);
      end_entry();
    }
    end_tables();
  }

 protected:
  virtual void choice_index(const OptionInfo& info, const ChoiceNames& names, int& index, Presence presence) = 0;
  /// Returns how many entries to visit, given how many the value holds.
  virtual std::size_t begin_tables(const OptionInfo& info, std::size_t minimum, std::size_t held) = 0;
  virtual void begin_entry(const OptionInfo& info, std::size_t index) = 0;
  virtual void end_entry() = 0;
  virtual void end_tables() = 0;
};

}  // namespace packstone
