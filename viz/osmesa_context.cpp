// OSMesa: Mesa's renderer as a library that knows no screen at all. Mesa 25.1 and later have none.
#include <array>
#include <cstdint>

#include <GL/osmesa.h>

#include "core/error.hpp"
#include "viz/gl_context.hpp"
#include "viz/glx_shims.hpp"

namespace packstone::viz {

namespace {

constexpr int osmesa_attributes[] = {OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     2,
                                     OSMESA_DEPTH_BITS,
                                     24,
                                     0};

class OsmesaContext : public GlContext {
 public:
  OsmesaContext() : context_(OSMesaCreateContextAttribs(osmesa_attributes, nullptr)) {
    if (context_ == nullptr) {
      throw RunError("OSMesa gives no OpenGL 3.2 core context; is libosmesa6 as built installed?");
    }
    find_gl_functions_by([](const char* name) { return OSMesaGetProcAddress(name); });
    if (make_current()) return;
    OSMesaDestroyContext(context_);
    throw RunError("OSMesa does not let its OpenGL context be used");
  }
  ~OsmesaContext() override { OSMesaDestroyContext(context_); }

  bool make_current() override {
    return OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, token_side, token_side) == GL_TRUE;
  }
  bool is_current() const override { return OSMesaGetCurrentContext() == context_; }

 private:
  OSMesaContext context_;
  std::array<std::uint8_t, token_side * token_side * 4> buffer_{};
};

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace packstone::viz
