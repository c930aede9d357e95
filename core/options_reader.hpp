// Reads options from TOML text: each key located, checked and, when misspelt, answered with the nearest known one.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/options.hpp"

namespace packstone {

class OptionReader : public OptionVisitor {
 public:
  /// Records "SOURCE:LINE:COL" by path in locations. Throws InputError when text or an override is not TOML.
  OptionReader(const std::string& text, const std::string& source_name, const std::vector<std::string>& overrides,
               std::map<std::string, std::string>& locations);
  ~OptionReader() override;

  void number(const OptionInfo& info, double& value, Presence presence) override;
  void number(const OptionInfo& info, std::optional<double>& value) override;
  void integer(const OptionInfo& info, std::int64_t& value, Presence presence) override;
  void integer(const OptionInfo& info, std::optional<std::int64_t>& value) override;
  void boolean(const OptionInfo& info, bool& value) override;
  void text(const OptionInfo& info, std::string& value, Presence presence) override;
  void text(const OptionInfo& info, std::optional<std::string>& value) override;
  void vector(const OptionInfo& info, Vec3& value, Presence presence) override;
  void vector(const OptionInfo& info, std::optional<Vec3>& value) override;
  void number_or(const OptionInfo& info, const char* word, std::optional<double>& value) override;
  void numbers(const OptionInfo& info, std::vector<double>& value) override;
  void texts(const OptionInfo& info, std::vector<std::string>& value) override;
  void polygons(const OptionInfo& info, std::vector<std::vector<Vec3>>& value) override;
  void number_or_table(const OptionInfo& info, std::optional<double>& value, bool& is_table,
                       const std::function<void()>& describe) override;
  void choices(const OptionInfo& info, const ChoiceNames& names, std::vector<int>& value) override;
  void table(const OptionInfo& info, Presence presence, const std::function<void()>& describe) override;
  void optional_table(const OptionInfo& info, bool& present, const std::function<void()>& describe) override;

  /// Refuses keys at the top level that were not described.
  void finish();

 protected:
  void choice_index(const OptionInfo& info, const ChoiceNames& names, int& index, Presence presence) override;
  std::size_t begin_tables(const OptionInfo& info, std::size_t minimum, std::size_t held) override;
  void begin_entry(const OptionInfo& info, std::size_t index) override;
  void end_entry() override;
  void end_tables() override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace packstone
