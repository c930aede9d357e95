#include "viz/glx_shims.hpp"

#include <cstring>
#include <string>

#include <dlfcn.h>

namespace packstone::viz {

namespace {

GlFunction (*find_by_name)(const char* name) = nullptr;

}  // namespace

void find_gl_functions_by(GlFunction (*find)(const char* name)) { find_by_name = find; }

}  // namespace packstone::viz

// GLEW as Debian builds it finds OpenGL through these four glX functions alone. The executable exports them, so that
// the dynamic linker takes them before libGLX's. Their types are X's own, written without its headers.
extern "C" {

using packstone::viz::GlFunction;

GlFunction glXGetProcAddressARB(const unsigned char* name);
void* glXGetCurrentDisplay();
int glXQueryVersion(void* display, int* major, int* minor);
const char* glXGetClientString(void* display, int name);

GlFunction glXGetProcAddressARB(const unsigned char* name) {
  const char* text = reinterpret_cast<const char*>(name);
  if (std::strcmp(text, "glXGetCurrentDisplay") == 0) return reinterpret_cast<GlFunction>(&glXGetCurrentDisplay);
  return packstone::viz::find_by_name(text);
}

void* glXGetCurrentDisplay() {
  static int display = 0;  // GLEW only asks whether there is one
  return &display;
}

int glXQueryVersion(void* /*display*/, int* major, int* minor) {
  *major = 1;
  *minor = 4;
  return 1;
}

const char* glXGetClientString(void* /*display*/, int /*name*/) { return ""; }

}  // extern "C"

namespace packstone::viz {

bool glx_shims_in_place() {
  Dl_info found;
  const void* clear = dlsym(RTLD_DEFAULT, "glClear");
  if (clear == nullptr || dladdr(clear, &found) == 0) return false;
  if (std::string(found.dli_fname).find("OSMesa") == std::string::npos) return false;
  return dlsym(RTLD_DEFAULT, "glXGetProcAddressARB") == reinterpret_cast<const void*>(&glXGetProcAddressARB);
}

}  // namespace packstone::viz
