#include "viz/offscreen.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string>

#include <GL/gl.h>
#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include "core/error.hpp"
#include "viz/gl_context.hpp"
#include "viz/glx_shims.hpp"

namespace packstone::viz {

namespace {

void check_size(int width, int height) {
  if (width < 1 || height < 1 || width > max_side || height > max_side) {
    throw InputError(
        fmt::format("cannot draw a picture of {} x {} px (with its super-sampling); a side takes 1 to {} px", width,
                    height, max_side));
  }
}

struct KnownBackend {
  const char* name;
  Backend backend;
  const char* shown;  ///< in renderer_in_use
};

constexpr KnownBackend backends[] = {
    {"osmesa", Backend::osmesa, "OSMesa"}, {"egl", Backend::egl, "EGL"}, {"vtk", Backend::vtk, "VTK"}};

Backend wanted = Backend::osmesa;
std::string in_use;

/// What the current context says of itself.
std::string described(Backend backend) {
  const auto words = [](GLenum name) {
    const GLubyte* const text = glGetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "unknown";
  };
  const auto* known =
      std::find_if(std::begin(backends), std::end(backends), [&](const auto& one) { return one.backend == backend; });
  return fmt::format("{} {}, OpenGL {}", known->shown, words(GL_RENDERER), words(GL_VERSION));
}

}  // namespace

Backend backend_named(const std::string& name) {
  for (const KnownBackend& known : backends) {
    if (name == known.name) return known.backend;
  }
  throw InputError(fmt::format("there is no way '{}' to draw without a screen; there are osmesa, egl and vtk", name));
}

void use_backend(Backend backend) { wanted = backend; }

std::string renderer_in_use() { return in_use; }

/// VTK's window and the OpenGL context it draws with.
struct OffscreenWindow::Context {
  std::unique_ptr<GlContext> gl;  ///< none where the window has its own
  vtkSmartPointer<vtkOpenGLRenderWindow> window;
  std::string failure;  ///< VTK's own words; empty while all is well

  Context(int width, int height) {
    if (wanted == Backend::vtk) {
      window = make_vtk_window(width, height);
      observe({vtkCommand::ErrorEvent});
      set_up_buffers();
    } else {
      make_window_on_context(width, height);
    }
    in_use = described(wanted);
  }

  ~Context() {
    if (gl) gl->make_current();
    window->Finalize();
  }

  void make_window_on_context(int width, int height) {
    if (!glx_shims_in_place()) {
      throw RunError(
          "this program was linked without its off-screen renderer; link it to the CMake target packstone::viz");
    }
    gl = wanted == Backend::egl ? make_egl_context() : make_osmesa_context();
    const auto on_context = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
    window = on_context;
    window->SetSize(width, height);
    observe({vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent, vtkCommand::WindowIsDirectEvent,
             vtkCommand::WindowSupportsOpenGLEvent, vtkCommand::ErrorEvent});
    on_context->SetOwnContext(0);
    on_context->SetReadyForRendering(true);
    set_up_buffers();
    if (!window->InitializeFromCurrentContext() || !failure.empty()) {
      throw RunError("VTK cannot use the OpenGL context: " + failure);
    }
  }

  void observe(std::initializer_list<vtkCommand::EventIds> events) {
    vtkNew<vtkCallbackCommand> answer;
    answer->SetClientData(this);
    answer->SetCallback(&Context::answer_event);
    for (const auto event : events) window->AddObserver(event, answer);
  }

  void set_up_buffers() const {
    window->SetMultiSamples(0);
    window->SetAlphaBitPlanes(1);
    window->SetFrameBlitModeToNoBlit();
  }

  static void answer_event(vtkObject* /*caller*/, unsigned long event, void* client, void* data) {
    auto* self = static_cast<Context*>(client);
    switch (event) {
      case vtkCommand::WindowMakeCurrentEvent:
        if (!self->gl->is_current()) self->gl->make_current();
        break;
      case vtkCommand::WindowIsCurrentEvent:
        *static_cast<bool*>(data) = self->gl->is_current();
        break;
      case vtkCommand::ErrorEvent:
        self->failure = data == nullptr ? "VTK gives no reason" : static_cast<const char*>(data);
        break;
      default:  // is it direct, does it support OpenGL
        *static_cast<int*>(data) = 1;
        break;
    }
  }
};

OffscreenWindow::OffscreenWindow(int width, int height) : width_(width), height_(height) {
  check_size(width, height);
  context_ = std::make_unique<Context>(width, height);
}

OffscreenWindow::~OffscreenWindow() = default;

vtkRenderWindow* OffscreenWindow::window() const { return context_->window; }

void OffscreenWindow::resize(int width, int height) {
  check_size(width, height);
  width_ = width;
  height_ = height;
  context_->window->SetSize(width, height);
}

void OffscreenWindow::render() {
  context_->window->Render();
  if (!context_->failure.empty()) throw RunError("VTK failed to draw: " + context_->failure);
}

const std::vector<std::uint8_t>& OffscreenWindow::rgba() {
  pixels_.resize(static_cast<std::size_t>(width_) * height_ * 4);
  vtkNew<vtkUnsignedCharArray> view;
  view->SetNumberOfComponents(4);
  view->SetArray(pixels_.data(), static_cast<vtkIdType>(pixels_.size()), 1);
  constexpr int back_buffer = 0;
  if (context_->window->GetRGBACharPixelData(0, 0, width_ - 1, height_ - 1, back_buffer, view) == 0) {
    throw RunError("VTK cannot read the picture back");
  }
  return pixels_;
}

std::vector<float> OffscreenWindow::depths() const {
  std::vector<float> depths(static_cast<std::size_t>(width_) * height_);
  if (context_->window->GetZbufferData(0, 0, width_ - 1, height_ - 1, depths.data()) == 0) {
    throw RunError("VTK cannot read the depth");
  }
  return depths;
}

}  // namespace packstone::viz
