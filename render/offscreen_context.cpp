// SPDX-License-Identifier: GPL-3.0-or-later
// Where VTK meets OpenGL. See docs/decisions/0002-osmesa-with-debian-vtk.md.
#include "render/offscreen_context.h"

#include <GL/gl.h>
#include <dlfcn.h>
#include <vtkActor.h>                      // VTK::RenderingCore
#include <vtkCamera.h>                     // VTK::RenderingCore
#include <vtkGenericOpenGLRenderWindow.h>  // VTK::RenderingOpenGL2
#include <vtkNew.h>                        // VTK::CommonCore
#include <vtkOpenGLFramebufferObject.h>    // VTK::RenderingOpenGL2
#include <vtkOpenGLState.h>                // VTK::RenderingOpenGL2
#include <vtkPlaneSource.h>                // VTK::FiltersSources
#include <vtkPolyDataMapper.h>             // VTK::RenderingCore
#include <vtkProperty.h>                   // VTK::RenderingCore
#include <vtkRenderer.h>                   // VTK::RenderingCore

#include <cstdlib>
#include <cstring>
#include <mutex>
#include <vector>

#include "render/offscreen_library.h"
#include "render/vtk_messages.h"
#include "solver/base/error.h"

namespace {

// ---- OpenGL 1.0 and 1.1, which VTK calls by name ----------------------------

enum GlCall : int {
#define FORWARD(result, name, parameters, arguments) k_##name,
#include "render/offscreen_gl_calls.inc"
#undef FORWARD
  kGlCallCount
};

constexpr const char* kGlCallNames[kGlCallCount] = {
#define FORWARD(result, name, parameters, arguments) #name,
#include "render/offscreen_gl_calls.inc"
#undef FORWARD
};

void* g_gl_calls[kGlCallCount] = {};

/// Opened when the first picture is wanted. Linking a library would make the loader abort the
/// whole program where it is missing, also for runs without frames.
hydroscope::OffscreenLibrary open_library() {
  const char* chosen = std::getenv("HYDROSCOPE_RENDERER");
  const std::string name = chosen != nullptr ? chosen : "osmesa";
  hydroscope::OffscreenLibrary library;
  if (name == "egl")
    library = hydroscope::open_egl();
  else if (name == "osmesa")
    library = hydroscope::open_osmesa();
  else
    library.error = "HYDROSCOPE_RENDERER is '" + name + "'; there are osmesa and egl";
  for (int call = 0; call < kGlCallCount && library.error.empty(); ++call) {
    g_gl_calls[call] = library.find_function(kGlCallNames[call]);
    if (g_gl_calls[call] == nullptr)
      library.error =
          "cannot use the software renderer " + library.name + ": it has no function " + kGlCallNames[call];
  }
  return library;
}

// ---- what GLEW, built for GLX, asks before it loads any function ------------

void* pretended_display() {
  static int display = 0;  // only compared with null
  return &display;
}

}  // namespace

// ---- names that VTK and GLEW bind to: the program's own come before GLVND's --

extern "C" {
#define FORWARD(result, name, parameters, arguments) \
  result name parameters { return reinterpret_cast<decltype(&name)>(g_gl_calls[k_##name]) arguments; }
#include "render/offscreen_gl_calls.inc"
#undef FORWARD

using GlFunction = void (*)();

GlFunction glXGetProcAddressARB(const GLubyte* name) {
  const char* wanted = reinterpret_cast<const char*>(name);
  if (std::strcmp(wanted, "glXGetCurrentDisplay") == 0)
    return reinterpret_cast<GlFunction>(&pretended_display);
  if (std::strncmp(wanted, "glX", 3) == 0) return nullptr;
  const hydroscope::OffscreenLibrary& library = hydroscope::offscreen_library();
  if (library.find_function == nullptr) return nullptr;
  return reinterpret_cast<GlFunction>(library.find_function(wanted));
}
GlFunction glXGetProcAddress(const GLubyte* name) { return glXGetProcAddressARB(name); }
int glXQueryVersion(void*, int* major, int* minor) {
  *major = 1;
  *minor = 4;
  return 1;
}
const char* glXGetClientString(void*, int) { return ""; }

#ifdef __SANITIZE_ADDRESS__
// OSMesa keeps a few bytes of every destroyed context; the leak check is for ours.
const char* __lsan_default_suppressions();
const char* __lsan_default_suppressions() { return "leak:libOSMesa\n"; }
#endif
#ifdef __SANITIZE_THREAD__
// Neither was built for this check, which then misses how their threads wait for each other.
const char* __tsan_default_suppressions();
const char* __tsan_default_suppressions() { return "race:libOSMesa\nrace:libvtk\n"; }
#endif
}

namespace hydroscope {

const OffscreenLibrary& offscreen_library() {
  static const OffscreenLibrary library = open_library();
  return library;
}

namespace {

/// A current context on this thread for as long as it lives.
class CurrentContext {
 public:
  explicit CurrentContext(int rasteriser_threads);
  ~CurrentContext();
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

  bool make_current() { return offscreen_library().make_current(context_); }

 private:
  void* context_ = nullptr;
};

void set_rasteriser_threads(int threads) {
  // llvmpipe reads it once, with the first context of the process.
  static std::once_flag once;
  std::call_once(once, [threads] { setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1); });
}

CurrentContext::CurrentContext(int rasteriser_threads) {
  const OffscreenLibrary& library = offscreen_library();
  if (!library.error.empty()) throw EnvironmentError(library.error);
  // If another library's names came first, VTK would draw into nothing.
  if (dlsym(RTLD_DEFAULT, "glClear") != reinterpret_cast<void*>(&glClear))
    throw EnvironmentError("this program was linked so that VTK does not find the software renderer");
  set_rasteriser_threads(rasteriser_threads);
  context_ = library.create_context();
  if (context_ == nullptr)
    throw EnvironmentError("the software renderer " + library.name + " has no OpenGL 3.2 core profile");
  if (!make_current()) {
    library.destroy_context(context_);
    throw EnvironmentError("the software renderer " + library.name + " cannot make its context current");
  }
}

CurrentContext::~CurrentContext() {
  offscreen_library().make_current(nullptr);
  offscreen_library().destroy_context(context_);
}

std::string gl_text(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text != nullptr ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

struct OffscreenContext::Impl {
  explicit Impl(const Options& options);
  ~Impl();

  Image draw(int reduction);
  void read_pixels(int width, int height);
  void self_test();

  CurrentContext context;  // first: outlives the window that draws with it
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  std::vector<std::uint8_t> pixels;
  RendererInfo info;
};

OffscreenContext::Impl::Impl(const Options& options) : context(options.rasteriser_threads) {
  set_up_vtk();
  take_vtk_messages();
  info = {gl_text(GL_RENDERER), gl_text(GL_VERSION)};
  if (!is_trusted_renderer(info.renderer))
    throw EnvironmentError("renderer '" + info.renderer +
                           "' is not known to draw correctly; llvmpipe is needed (unset GALLIUM_DRIVER)");
  window->SetOwnContext(0);
  window->SetReadyForRendering(true);
  window->SetSupportsOpenGL(1);
  window->SetIsDirect(1);
  window->SetMapped(1);
  window->SetIsCurrent(true);
  window->SwapBuffersOff();
  window->SetFrameBlitModeToNoBlit();
  window->SetMultiSamples(0);
  window->SetSize(options.width, options.height);
  window->SetScreenSize(options.width, options.height);
  window->OpenGLInit();
  self_test();
}

OffscreenContext::Impl::~Impl() {
  context.make_current();
  window->Finalize();
}

Image OffscreenContext::Impl::draw(int reduction) {
  if (!context.make_current()) throw EnvironmentError("the software renderer's context was lost");
  window->Render();
  const int* size = window->GetSize();
  read_pixels(size[0], size[1]);
  const std::string messages = take_vtk_messages();
  if (!messages.empty()) throw EnvironmentError("drawing failed: " + messages);
  return reduced(pixels.data(), size[0] / reduction, size[1] / reduction, reduction);
}

/// Straight from the buffer drawn into: VTK's own reading copies it twice before.
void OffscreenContext::Impl::read_pixels(int width, int height) {
  pixels.resize(4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  vtkOpenGLFramebufferObject& buffer = *window->GetRenderFramebuffer();
  window->GetState()->PushReadFramebufferBinding();
  buffer.Bind(vtkOpenGLFramebufferObject::GetReadMode());
  buffer.ActivateReadBuffer(0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  window->GetState()->PopReadFramebufferBinding();
}

/// A red square in front of a blue ground with a known place for each.
void OffscreenContext::Impl::self_test() {
  vtkNew<vtkPlaneSource> square;  // -0.5..0.5
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(square->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.0, 0.0, 1.0);
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->ParallelProjectionOn();
  renderer->ResetCamera();
  renderer->GetActiveCamera()->SetParallelScale(1.0);
  window->AddRenderer(renderer);
  const Image image = draw(1);
  window->RemoveRenderer(renderer);
  const std::uint8_t* centre = image.pixel(image.width / 2, image.height / 2);
  const std::uint8_t* corner = image.pixel(1, 1);
  const bool is_right = centre[0] == 255 && centre[1] == 0 && centre[2] == 0 && corner[0] == 0 &&
                        corner[1] == 0 && corner[2] == 255;
  if (!is_right)
    throw EnvironmentError("renderer '" + info.renderer + "' failed its self-test: wrong pixels");
}

OffscreenContext::OffscreenContext(const Options& options) : impl_(std::make_unique<Impl>(options)) {}
OffscreenContext::~OffscreenContext() = default;
vtkRenderWindow& OffscreenContext::window() { return *impl_->window; }
void OffscreenContext::resize(int width, int height) {
  impl_->window->SetSize(width, height);
  impl_->window->SetScreenSize(width, height);
}
const RendererInfo& OffscreenContext::info() const { return impl_->info; }
Image OffscreenContext::draw(int reduction) { return impl_->draw(reduction); }

std::string describe_renderer(int rasteriser_threads) {
  const OffscreenContext context({.width = 64, .height = 64, .rasteriser_threads = rasteriser_threads});
  return context.info().renderer + ", OpenGL " + context.info().version + ", through " +
         offscreen_library().name;
}

bool is_trusted_renderer(const std::string& gl_renderer) {
  return gl_renderer.find("llvmpipe") != std::string::npos;
}

}  // namespace hydroscope
