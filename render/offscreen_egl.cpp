// SPDX-License-Identifier: GPL-3.0-or-later
// The few names of EGL 1.5 that are needed are stated here, so that its headers need not be there.
#include <dlfcn.h>

#include <cstdint>
#include <cstdlib>

#include "render/offscreen_library.h"

namespace hydroscope {
namespace {

using Display = void*;
using Config = void*;
using Context = void*;
using Surface = void*;
using Attribute = std::intptr_t;

constexpr int kNone = 0x3038;
constexpr int kSurfaceType = 0x3033, kPbufferBit = 0x0001;
constexpr int kRenderableType = 0x3040, kOpenGlBit = 0x0008;
constexpr int kOpenGlApi = 0x30A2;
constexpr int kMajorVersion = 0x3098, kMinorVersion = 0x30FB;
constexpr int kProfileMask = 0x30FD, kCoreProfileBit = 0x0001;
constexpr int kPlatformSurfaceless = 0x31DD;

void* (*g_proc_address)(const char*) = nullptr;
Display (*g_get_display)(unsigned, void*, const Attribute*) = nullptr;
unsigned (*g_initialize)(Display, int*, int*) = nullptr;
unsigned (*g_bind_api)(unsigned) = nullptr;
unsigned (*g_choose_config)(Display, const int*, Config*, int, int*) = nullptr;
Context (*g_create)(Display, Config, Context, const int*) = nullptr;
unsigned (*g_destroy)(Display, Context) = nullptr;
unsigned (*g_make_current)(Display, Surface, Surface, Context) = nullptr;

Display g_display = nullptr;
Config g_config = nullptr;

template <typename Function>
void bind(void* handle, const char* name, Function& function, std::string& error) {
  function = reinterpret_cast<Function>(dlsym(handle, name));
  if (function == nullptr && error.empty()) error = std::string("it has no function ") + name;
}

std::string bind_all(void* handle) {
  std::string error;
  bind(handle, "eglGetProcAddress", g_proc_address, error);
  bind(handle, "eglGetPlatformDisplay", g_get_display, error);
  bind(handle, "eglInitialize", g_initialize, error);
  bind(handle, "eglBindAPI", g_bind_api, error);
  bind(handle, "eglChooseConfig", g_choose_config, error);
  bind(handle, "eglCreateContext", g_create, error);
  bind(handle, "eglDestroyContext", g_destroy, error);
  bind(handle, "eglMakeCurrent", g_make_current, error);
  return error;
}

std::string open_display() {
  // The graphics card's driver, if there is one, draws other pixels.
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  g_display = g_get_display(kPlatformSurfaceless, nullptr, nullptr);
  int major = 0, minor = 0;
  if (g_display == nullptr || g_initialize(g_display, &major, &minor) == 0)
    return "it has no platform without surfaces (Debian packages: libegl-mesa0, libgl1-mesa-dri)";
  const int wanted[] = {kSurfaceType, kPbufferBit, kRenderableType, kOpenGlBit, kNone};
  int count = 0;
  if (g_bind_api(kOpenGlApi) == 0 || g_choose_config(g_display, wanted, &g_config, 1, &count) == 0 ||
      count < 1)
    return "it has no OpenGL";
  return "";
}

void* create_context() {
  g_bind_api(kOpenGlApi);  // of this thread
  const int attributes[] = {kMajorVersion, 3, kMinorVersion, 2, kProfileMask, kCoreProfileBit, kNone};
  return g_create(g_display, g_config, nullptr, attributes);
}

bool make_current(void* context) {
  g_bind_api(kOpenGlApi);
  return g_make_current(g_display, nullptr, nullptr, context) != 0;
}

void destroy_context(void* context) { g_destroy(g_display, context); }

}  // namespace

OffscreenLibrary open_egl() {
  OffscreenLibrary library;
  library.name = "EGL without surface (libEGL.so.1)";
  void* handle = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const char* reason = dlerror();
    library.error = reason != nullptr ? reason : "not found";
  } else {
    library.error = bind_all(handle);
    if (library.error.empty()) library.error = open_display();
  }
  if (!library.error.empty()) {
    library.error = "cannot use the software renderer libEGL.so.1: " + library.error;
    return library;
  }
  library.find_function = g_proc_address;
  library.create_context = &create_context;
  library.destroy_context = &destroy_context;
  library.make_current = &make_current;
  return library;
}

}  // namespace hydroscope
