// Views: options of a picture kept in a file, or known by a name.
#pragma once

#include <string>
#include <vector>

namespace packstone::cli {

/// An option of a verb, as views see it.
struct ViewOption {
  std::string name;  ///< without dashes
  bool flag;         ///< takes no value
  bool of_view;      ///< says how the picture looks, not where it goes and who draws it
  bool given;        ///< in the call, which views do not change
};

/// An option's value that a view sets.
struct ViewSetting {
  std::string name;
  std::string value;  ///< none of a flag
  bool flag;
  std::string place;  ///< FILE:LINE:COLUMN, or the preset
};

/// Names of the presets.
std::vector<std::string> preset_names();

/// What a view file (TOML, keys named as the options) and a preset set for a call; the file comes before the preset,
/// which it may name. Either may be empty. Throws InputError with the place for keys that are no options.
std::vector<ViewSetting> view_settings(const std::vector<ViewOption>& options, const std::string& file,
                                       const std::string& preset);

}  // namespace packstone::cli
