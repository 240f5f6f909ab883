// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "render/image/image.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

constexpr int kColours = 256;  ///< entries of a map
using ColourTable = std::array<Rgb, kColours>;

/// Sequential maps with lightness rising evenly, safe for the usual kinds of
/// colour blindness: `sea` (indigo, teal, yellow-green) for what starts at
/// zero, `dusk` (blue, grey, yellow) for what has no natural zero, `ember`
/// (pale to dark red-brown, lightness falling) for angles on a pale surface. `tide` (red, pale,
/// blue; lightness the same at both ends) for what lies on either side of zero.
enum class MapName { kSea, kDusk, kEmber, kTide };
const ColourTable& colour_table(MapName name);

/// Colour of `value` in a map over [low, high]; ends continue outside.
Rgb map_colour(const ColourTable& table, double value, double low, double high);

/// Okabe-Ito colours of the contact classes; free nodes a neutral grey.
Rgb class_colour(ContactClass contact_class);
const char* class_name(ContactClass contact_class);
constexpr int kContactClasses = 4;

/// Where a field has no value (a gap out of its band).
constexpr Rgb kNoValueColour{176, 180, 186};

/// Everything that is not data.
struct Theme {
  Rgb background_top, background_bottom;
  Rgb text, faint_text;
  Rgb panel, panel_frame;
  Rgb sheet, tool, line, tool_line;
  Rgb arrow, second_arrow;
  Rgb section;  ///< where a clip plane cuts the wall
};
/// "light" or "dark"; throws InputError for another name.
const Theme& theme(const std::string& name);

}  // namespace hydroscope
