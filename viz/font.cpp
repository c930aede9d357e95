#include "viz/font.hpp"

#include <filesystem>
#include <string>

#include <vtkTextProperty.h>

namespace packstone::viz {

void use_font(vtkTextProperty* property, bool bold) {
  static const std::string folder = PACKSTONE_FONT_FOLDER;
  static const bool installed = std::filesystem::exists(folder + "/DejaVuSans.ttf");
  if (!installed) {
    property->SetFontFamilyToArial();
    property->SetBold(bold);
    return;
  }
  property->SetFontFamily(VTK_FONT_FILE);
  property->SetFontFile((folder + (bold ? "/DejaVuSans-Bold.ttf" : "/DejaVuSans.ttf")).c_str());
}

}  // namespace packstone::viz
