// EGL on Mesa's surfaceless platform, which needs neither a display server nor a device. It is loaded when asked for:
// the program starts without it. OpenGL's oldest functions, which VTK takes from the linker, stay those of libOSMesa;
// both libraries hand them to the current context through libglapi, which they share.
#include <string>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include "core/error.hpp"
#include "viz/gl_context.hpp"
#include "viz/glx_shims.hpp"

namespace packstone::viz {

namespace {

constexpr EGLint config_attributes[] = {EGL_SURFACE_TYPE,
                                        EGL_PBUFFER_BIT,
                                        EGL_RED_SIZE,
                                        8,
                                        EGL_GREEN_SIZE,
                                        8,
                                        EGL_BLUE_SIZE,
                                        8,
                                        EGL_ALPHA_SIZE,
                                        8,
                                        EGL_DEPTH_SIZE,
                                        24,
                                        EGL_RENDERABLE_TYPE,
                                        EGL_OPENGL_BIT,
                                        EGL_NONE};
constexpr EGLint context_attributes[] = {
    EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
constexpr EGLint surface_attributes[] = {EGL_WIDTH, GlContext::token_side, EGL_HEIGHT, GlContext::token_side, EGL_NONE};

[[noreturn]] void no_egl(const std::string& why) {
  throw RunError(
      fmt::format("EGL gives no OpenGL context without a screen: {}; Debian's libegl1 and libegl-mesa0 do, "
                  "or take the backend osmesa",
                  why));
}

/// The functions of libEGL, and its display without a screen; both last as long as the process.
class Egl {
 public:
  decltype(&eglGetProcAddress) get_function;
  decltype(&eglMakeCurrent) make_current;
  decltype(&eglGetCurrentContext) current_context;
  decltype(&eglCreateContext) create_context;
  decltype(&eglDestroyContext) destroy_context;
  decltype(&eglCreatePbufferSurface) create_surface;
  decltype(&eglDestroySurface) destroy_surface;
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLConfig config = nullptr;

  static const Egl& loaded() {
    static const Egl egl;
    return egl;
  }

  std::string last_error() const { return fmt::format("EGL error {:#x}", get_error_()); }

 private:
  Egl() {
    library_ = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (library_ == nullptr) no_egl(dlerror());
    find(get_function, "eglGetProcAddress");
    find(make_current, "eglMakeCurrent");
    find(current_context, "eglGetCurrentContext");
    find(create_context, "eglCreateContext");
    find(destroy_context, "eglDestroyContext");
    find(create_surface, "eglCreatePbufferSurface");
    find(destroy_surface, "eglDestroySurface");
    find(get_error_, "eglGetError");
    open_display();
  }

  template <class Function>
  void find(Function& function, const char* name) const {
    function = reinterpret_cast<Function>(dlsym(library_, name));
    if (function == nullptr) no_egl(fmt::format("its library has no {}", name));
  }

  void open_display() {
    decltype(&eglGetPlatformDisplay) get_display;
    decltype(&eglInitialize) initialize;
    decltype(&eglBindAPI) bind_api;
    decltype(&eglChooseConfig) choose_config;
    find(get_display, "eglGetPlatformDisplay");
    find(initialize, "eglInitialize");
    find(bind_api, "eglBindAPI");
    find(choose_config, "eglChooseConfig");
    display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY) no_egl("it has no surfaceless platform");
    if (initialize(display, nullptr, nullptr) == EGL_FALSE) no_egl(last_error());
    if (bind_api(EGL_OPENGL_API) == EGL_FALSE) no_egl("it has no desktop OpenGL");
    EGLint configs = 0;
    if (choose_config(display, config_attributes, &config, 1, &configs) == EGL_FALSE || configs == 0) {
      no_egl("it has no buffer of 8 bits a colour");
    }
  }

  void* library_ = nullptr;
  decltype(&eglGetError) get_error_;
};

class EglContext : public GlContext {
 public:
  EglContext() : egl_(Egl::loaded()) {
    context_ = egl_.create_context(egl_.display, egl_.config, EGL_NO_CONTEXT, context_attributes);
    if (context_ == EGL_NO_CONTEXT) no_egl(egl_.last_error());
    surface_ = egl_.create_surface(egl_.display, egl_.config, surface_attributes);
    find_gl_functions_by([](const char* name) { return Egl::loaded().get_function(name); });
    if (surface_ != EGL_NO_SURFACE && make_current()) return;
    const std::string why = egl_.last_error();
    release();
    no_egl(why);
  }
  ~EglContext() override { release(); }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  bool make_current() override { return egl_.make_current(egl_.display, surface_, surface_, context_) == EGL_TRUE; }
  bool is_current() const override { return egl_.current_context() == context_; }

 private:
  void release() {
    egl_.make_current(egl_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (surface_ != EGL_NO_SURFACE) egl_.destroy_surface(egl_.display, surface_);
    egl_.destroy_context(egl_.display, context_);
  }

  const Egl& egl_;
  EGLContext context_ = EGL_NO_CONTEXT;
  EGLSurface surface_ = EGL_NO_SURFACE;
};

}  // namespace

std::unique_ptr<GlContext> make_egl_context() { return std::make_unique<EglContext>(); }

}  // namespace packstone::viz
