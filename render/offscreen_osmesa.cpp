// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/gl.h>
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <array>
#include <cstdlib>

#include "render/offscreen_library.h"

namespace hydroscope {
namespace {

constexpr int kBufferSize = 16;  // [px] of OSMesa's own buffer: VTK draws into frame buffer objects

void* g_handle = nullptr;
decltype(&OSMesaCreateContextAttribs) g_create = nullptr;
decltype(&OSMesaDestroyContext) g_destroy = nullptr;
decltype(&OSMesaMakeCurrent) g_make_current = nullptr;
decltype(&OSMesaGetProcAddress) g_proc_address = nullptr;

/// A context with the memory that it wants for itself.
struct Context {
  OSMesaContext osmesa = nullptr;
  std::array<unsigned char, 4 * kBufferSize * kBufferSize> buffer{};
};

template <typename Function>
void bind(const char* name, Function& function, std::string& error) {
  function = reinterpret_cast<Function>(dlsym(g_handle, name));
  if (function == nullptr && error.empty()) error = std::string("it has no function ") + name;
}

void* find_function(const char* name) {
  if (void* function = dlsym(g_handle, name)) return function;
  return reinterpret_cast<void*>(g_proc_address(name));
}

void* create_context() {
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            2,
                            0};
  const OSMesaContext osmesa = g_create(attributes, nullptr);
  return osmesa != nullptr ? new Context{osmesa, {}} : nullptr;
}

bool make_current(void* context) {
  if (context == nullptr) return g_make_current(nullptr, nullptr, 0, 0, 0) != 0;
  auto* ours = static_cast<Context*>(context);
  return g_make_current(ours->osmesa, ours->buffer.data(), GL_UNSIGNED_BYTE, kBufferSize, kBufferSize) != 0;
}

void destroy_context(void* context) {
  auto* ours = static_cast<Context*>(context);
  g_destroy(ours->osmesa);
  delete ours;
}

}  // namespace

OffscreenLibrary open_osmesa() {
  // For a Mesa of one's own, and for tests of its absence.
  const char* chosen = std::getenv("HYDROSCOPE_OSMESA");
  const std::string file = chosen != nullptr ? chosen : "libOSMesa.so.8";
  OffscreenLibrary library;
  library.name = "OSMesa (" + file + ")";
  // Never closed: Mesa's and LLVM's exit handlers must find their code.
  g_handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (g_handle == nullptr) {
    const char* reason = dlerror();
    library.error = reason != nullptr ? reason : file;
  } else {
    bind("OSMesaCreateContextAttribs", g_create, library.error);
    bind("OSMesaDestroyContext", g_destroy, library.error);
    bind("OSMesaMakeCurrent", g_make_current, library.error);
    bind("OSMesaGetProcAddress", g_proc_address, library.error);
  }
  if (!library.error.empty()) {
    library.error = "cannot use the software renderer " + file + ": " + library.error +
                    " (Debian package: libosmesa6; runs without frames do not need it)";
    return library;
  }
  library.find_function = &find_function;
  library.create_context = &create_context;
  library.destroy_context = &destroy_context;
  library.make_current = &make_current;
  return library;
}

}  // namespace hydroscope
