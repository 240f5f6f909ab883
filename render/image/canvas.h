// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "render/image/image.h"
#include "render/image/pixel_box.h"

namespace hydroscope {

/// The font of all lettering: "DejaVu Sans", or VTK's own where that is not installed.
std::string lettering_font();

/// Draws lettering and flat shapes over a picture, without OpenGL: the same
/// bits whatever renderer drew what lies below. Positions in pixels from the top left.
class Canvas {
 public:
  explicit Canvas(Image& image) : image_(image) {}

  enum class Align { kLeft, kCentre, kRight };
  struct TextStyle {
    int size = 16;  ///< [px] of the letters' em
    Rgb colour{0, 0, 0};
    bool is_bold = false;
    bool is_mono = false;  ///< letters of one width, for columns
    Align align = Align::kLeft;
  };

  void fill(int x, int y, int width, int height, Rgb colour, double opacity = 1.0);
  void frame(int x, int y, int width, int height, Rgb colour);
  /// `y` is the top of the line. Throws EnvironmentError when the font cannot be used.
  void text(int x, int y, const std::string& words, const TextStyle& style);
  /// Line with smooth edges and round ends.
  void line(double x0, double y0, double x1, double y1, double width, Rgb colour);

  /// Box around the pixels that were drawn on since the last call.
  PixelBox take_touched();

  /// Width and height that text() takes [px].
  static std::array<int, 2> text_size(const std::string& words, const TextStyle& style);

 private:
  void blend(int x, int y, Rgb colour, double opacity);

  Image& image_;
  PixelBox touched_;
};

}  // namespace hydroscope
