// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "render/image/image.h"

namespace hydroscope {

/// Keyword -> text, kept in the file beside the pixels (PNG tEXt).
using PngTexts = std::map<std::string, std::string>;

/// Writes an opaque PNG fast (alpha is dropped), under a temporary name that is
/// renamed when the file is whole. Throws EnvironmentError.
void write_png(const std::string& file, const Image& image, const PngTexts& texts = {});

struct PngPicture {
  Image image;
  PngTexts texts;
};

/// Reads any PNG as RGBA. Throws EnvironmentError when the file cannot be read,
/// InputError when it is no whole PNG.
PngPicture read_png(const std::string& file);

}  // namespace hydroscope
