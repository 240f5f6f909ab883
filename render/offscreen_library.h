// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hydroscope {

/// A library that makes OpenGL contexts without a screen, opened by hand: one that is
/// missing is an error of whoever wants a picture, not of the program. Functions are empty where
/// `error` says why the library cannot be used. A context is opaque here.
struct OffscreenLibrary {
  std::string name;   ///< for messages: "OSMesa (libOSMesa.so.8)"
  std::string error;  ///< why it cannot be used; "" = it can
  /// Address of an OpenGL function, null when there is none of that name.
  void* (*find_function)(const char* name) = nullptr;
  /// A core profile of 3.2 or later; null when there is none.
  void* (*create_context)() = nullptr;
  void (*destroy_context)(void* context) = nullptr;
  /// On this thread; null: none. False when it fails.
  bool (*make_current)(void* context) = nullptr;
};

/// Mesa's rasteriser in memory; HYDROSCOPE_OSMESA names another library than libOSMesa.so.8.
OffscreenLibrary open_osmesa();

/// EGL without a surface, with Mesa's software rasteriser: what follows OSMesa, which ends with Mesa 25.1.
OffscreenLibrary open_egl();

/// The one of this process: HYDROSCOPE_RENDERER = osmesa (default) or egl.
const OffscreenLibrary& offscreen_library();

}  // namespace hydroscope
