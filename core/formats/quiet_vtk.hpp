// VTK without words of its own.
#pragma once

#include <vtkObject.h>

namespace packstone::formats {

/// Keeps VTK from writing to the terminal: what is wrong is said by who asks it.
class QuietVtk {
 public:
  QuietVtk() : before_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::SetGlobalWarningDisplay(0); }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before_); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

 private:
  int before_;
};

}  // namespace packstone::formats
