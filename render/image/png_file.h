// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "render/image/image.h"

namespace hydroscope {

/// Keyword -> text, kept in the file beside the pixels (PNG tEXt).
using PngTexts = std::map<std::string, std::string>;

/// Frames of a run are written fast; pictures that are kept in a repository should be small.
enum class PngSize { kFast, kSmall };

/// Writes an opaque PNG (alpha is dropped), under a temporary name that is
/// renamed when the file is whole. Throws EnvironmentError.
void write_png(const std::string& file, const Image& image, const PngTexts& texts = {},
               PngSize size = PngSize::kFast);
std::string make_png(const Image& image, const PngTexts& texts, PngSize size);

struct PngPicture {
  Image image;
  PngTexts texts;
};

/// Reads any PNG as RGBA. Throws EnvironmentError when the file cannot be read,
/// InputError when it is no whole PNG.
PngPicture read_png(const std::string& file);

}  // namespace hydroscope
