// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/canvas.h"

#include <vtkImageData.h>     // VTK::CommonDataModel
#include <vtkNew.h>           // VTK::CommonCore
#include <vtkStdString.h>     // VTK::CommonCore
#include <vtkTextProperty.h>  // VTK::RenderingCore
#include <vtkTextRenderer.h>  // VTK::RenderingCore

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

// Debian's VTK carries URW Gothic alone, whose brackets and figures are hard to
// read; DejaVu comes with fontconfig and so with VTK itself.
struct Fonts {
  std::string plain, mono, bold;
  bool are_there = false;
};

const Fonts& fonts() {
  static const Fonts found = [] {
    // For fonts of one's own, and for tests of their absence.
    const char* chosen = std::getenv("HYDROSCOPE_FONTS");
    const std::string folder = chosen != nullptr ? chosen : "/usr/share/fonts/truetype/dejavu";
    Fonts all{folder + "/DejaVuSans.ttf", folder + "/DejaVuSansMono.ttf", folder + "/DejaVuSans-Bold.ttf"};
    all.are_there = std::filesystem::exists(all.plain) && std::filesystem::exists(all.mono) &&
                    std::filesystem::exists(all.bold);
    return all;
  }();
  return found;
}

/// Coverage of the letters' pixels, 0..255, first row on top.
struct Lettering {
  int width = 0, height = 0;
  std::vector<std::uint8_t> coverage;
};

Lettering draw_letters(const std::string& words, const Canvas::TextStyle& style) {
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  if (renderer == nullptr) throw EnvironmentError("VTK has no text renderer (vtkRenderingFreeType)");
  const vtkNew<vtkTextProperty> property;
  if (style.is_mono) property->SetFontFamilyToCourier();
  if (!style.is_mono) property->SetFontFamilyToArial();
  if (fonts().are_there) {
    property->SetFontFamily(VTK_FONT_FILE);
    const std::string& file = style.is_mono ? fonts().mono : style.is_bold ? fonts().bold : fonts().plain;
    property->SetFontFile(file.c_str());
  }
  property->SetFontSize(style.size);
  property->SetBold(style.is_bold && !fonts().are_there);
  property->SetColor(1.0, 1.0, 1.0);
  const vtkNew<vtkImageData> image;
  int used[2] = {0, 0};
  constexpr int kPointsAsPixels = 72;
  if (!renderer->RenderString(property, words, image, used, kPointsAsPixels, vtkTextRenderer::FreeType))
    throw EnvironmentError("VTK cannot draw the text '" + words + "'");
  Lettering letters{used[0], used[1], {}};
  for (int y = used[1] - 1; y >= 0; --y)
    for (int x = 0; x < used[0]; ++x)
      letters.coverage.push_back(static_cast<const std::uint8_t*>(image->GetScalarPointer(x, y, 0))[3]);
  return letters;
}

/// The most recent ones are kept: most words stay the same from frame to frame.
const Lettering& find_letters(const std::string& words, const Canvas::TextStyle& style) {
  thread_local std::map<std::tuple<std::string, int, bool, bool>, Lettering> known;
  // FreeType's face cache is one for the process.
  static std::mutex mutex;
  const auto key = std::make_tuple(words, style.size, style.is_bold, style.is_mono);
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  if (known.size() > 500) known.clear();
  const std::lock_guard lock(mutex);
  return known.emplace(key, draw_letters(words, style)).first->second;
}

}  // namespace

std::string lettering_font() { return fonts().are_there ? "DejaVu Sans" : "URW Gothic (built into VTK)"; }

void Canvas::blend(int x, int y, Rgb colour, double opacity) {
  if (x < 0 || y < 0 || x >= image_.width || y >= image_.height || opacity <= 0.0) return;
  touched_.include(x, y);
  std::uint8_t* pixel = image_.pixel(x, y);
  for (std::size_t c = 0; c < 3; ++c)
    pixel[c] = static_cast<std::uint8_t>(pixel[c] + std::min(opacity, 1.0) * (colour[c] - pixel[c]) + 0.5);
}

PixelBox Canvas::take_touched() { return std::exchange(touched_, {}); }

void Canvas::fill(int x, int y, int width, int height, Rgb colour, double opacity) {
  for (int j = y; j < y + height; ++j)
    for (int i = x; i < x + width; ++i) blend(i, j, colour, opacity);
}

void Canvas::frame(int x, int y, int width, int height, Rgb colour) {
  fill(x, y, width, 1, colour);
  fill(x, y + height - 1, width, 1, colour);
  fill(x, y + 1, 1, height - 2, colour);
  fill(x + width - 1, y + 1, 1, height - 2, colour);
}

void Canvas::text(int x, int y, const std::string& words, const TextStyle& style) {
  if (words.empty()) return;
  const Lettering& letters = find_letters(words, style);
  if (style.align == Align::kCentre) x -= letters.width / 2;
  if (style.align == Align::kRight) x -= letters.width;
  for (int j = 0; j < letters.height; ++j)
    for (int i = 0; i < letters.width; ++i)
      blend(x + i, y + j, style.colour,
            letters.coverage[static_cast<std::size_t>(j * letters.width + i)] / 255.0);
}

std::array<int, 2> Canvas::text_size(const std::string& words, const TextStyle& style) {
  if (words.empty()) return {0, 0};
  const Lettering& letters = find_letters(words, style);
  return {letters.width, letters.height};
}

void Canvas::line(double x0, double y0, double x1, double y1, double width, Rgb colour) {
  const double reach = 0.5 * width + 1.0;
  const double dx = x1 - x0, dy = y1 - y0, squared = dx * dx + dy * dy;
  for (int y = static_cast<int>(std::floor(std::min(y0, y1) - reach)); y <= std::max(y0, y1) + reach; ++y)
    for (int x = static_cast<int>(std::floor(std::min(x0, x1) - reach)); x <= std::max(x0, x1) + reach; ++x) {
      const double px = x + 0.5 - x0, py = y + 0.5 - y0;
      const double s = squared > 0.0 ? std::clamp((px * dx + py * dy) / squared, 0.0, 1.0) : 0.0;
      const double distance = std::hypot(px - s * dx, py - s * dy);
      blend(x, y, colour, 0.5 * width + 0.5 - distance);
    }
}

}  // namespace hydroscope
