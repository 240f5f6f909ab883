// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/colour_map.h"

#include <algorithm>
#include <cmath>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

struct Lab {
  double L, a, b;
};

double lab_inverse(double t) { return t > 6.0 / 29.0 ? t * t * t : (t - 4.0 / 29.0) * 108.0 / 841.0; }

std::uint8_t gamma_encoded(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  const double s = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * s));
}

/// CIE L*a*b* (D65) to sRGB, IEC 61966-2-1.
Rgb to_rgb(const Lab& lab) {
  const double fy = (lab.L + 16.0) / 116.0;
  const double X = 0.95047 * lab_inverse(fy + lab.a / 500.0);
  const double Y = lab_inverse(fy);
  const double Z = 1.08883 * lab_inverse(fy - lab.b / 200.0);
  return {gamma_encoded(3.2406 * X - 1.5372 * Y - 0.4986 * Z),
          gamma_encoded(-0.9689 * X + 1.8758 * Y + 0.0415 * Z),
          gamma_encoded(0.0557 * X - 0.2040 * Y + 1.0570 * Z)};
}

template <std::size_t N>
ColourTable make_table(const std::array<Lab, N>& points) {
  ColourTable table;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double s = static_cast<double>(i) * (N - 1) / (kColours - 1);
    const auto k = std::min(static_cast<std::size_t>(s), N - 2);
    const double w = s - static_cast<double>(k);
    const Lab &p = points[k], &q = points[k + 1];
    table[i] = to_rgb({p.L + w * (q.L - p.L), p.a + w * (q.a - p.a), p.b + w * (q.b - p.b)});
  }
  return table;
}

// Control points of equal steps in lightness L.
constexpr std::array<Lab, 6> kSeaPoints{
    {{20, 28, -42}, {34, 4, -34}, {48, -18, -16}, {62, -34, 12}, {76, -30, 46}, {90, -8, 72}}};
constexpr std::array<Lab, 5> kDuskPoints{{{22, 6, -34}, {39, 1, -26}, {56, 0, 2}, {73, 1, 38}, {90, -4, 66}}};
constexpr std::array<Lab, 5> kEmberPoints{
    {{92, 0, 3}, {78, 14, 34}, {62, 34, 48}, {45, 46, 36}, {28, 34, 12}}};
constexpr std::array<Lab, 5> kTidePoints{
    {{32, 50, 38}, {63, 38, 32}, {94, 0, 4}, {63, -6, -34}, {32, 10, -50}}};

constexpr Theme kLight{.background_top = {214, 223, 233},
                       .background_bottom = {250, 251, 252},
                       .text = {24, 32, 44},
                       .faint_text = {84, 96, 112},
                       .panel = {255, 255, 255},
                       .panel_frame = {190, 198, 208},
                       .sheet = {206, 211, 218},
                       .tool = {122, 140, 160},
                       .line = {38, 46, 58},
                       .tool_line = {70, 84, 102},
                       .arrow = {28, 34, 44},
                       .second_arrow = {28, 34, 44},
                       .section = {62, 72, 88}};
constexpr Theme kDark{.background_top = {22, 26, 34},
                      .background_bottom = {52, 60, 72},
                      .text = {236, 240, 245},
                      .faint_text = {160, 170, 184},
                      .panel = {24, 28, 36},
                      .panel_frame = {84, 94, 108},
                      .sheet = {150, 157, 168},
                      .tool = {128, 146, 168},
                      .line = {14, 17, 22},
                      .tool_line = {186, 198, 212},
                      .arrow = {232, 236, 242},
                      .second_arrow = {245, 247, 250},
                      .section = {222, 228, 236}};

}  // namespace

const ColourTable& colour_table(MapName name) {
  static const ColourTable sea = make_table(kSeaPoints), dusk = make_table(kDuskPoints),
                           ember = make_table(kEmberPoints), tide = make_table(kTidePoints);
  switch (name) {
    case MapName::kSea:
      return sea;
    case MapName::kDusk:
      return dusk;
    case MapName::kEmber:
      return ember;
    case MapName::kTide:
      return tide;
  }
  throw ContractError("colour map out of range");
}

Rgb map_colour(const ColourTable& table, double value, double low, double high) {
  if (!std::isfinite(value)) return kNoValueColour;
  const double s = (value - low) / (high - low) * kColours;
  return table[static_cast<std::size_t>(std::clamp(s, 0.0, kColours - 1.0))];
}

Rgb class_colour(ContactClass contact_class) {
  switch (contact_class) {
    case ContactClass::kFree:
      return {203, 208, 215};
    case ContactClass::kStick:
      return {0, 114, 178};  // blue
    case ContactClass::kSlip:
      return {240, 228, 66};  // yellow
    case ContactClass::kDetachedNow:
      return {213, 94, 0};  // vermillion
  }
  throw ContractError("contact class out of range");
}

const char* class_name(ContactClass contact_class) {
  switch (contact_class) {
    case ContactClass::kFree:
      return "free";
    case ContactClass::kStick:
      return "stick";
    case ContactClass::kSlip:
      return "slip";
    case ContactClass::kDetachedNow:
      return "detached now";
  }
  throw ContractError("contact class out of range");
}

const Theme& theme(const std::string& name) {
  if (name == "light") return kLight;
  if (name == "dark") return kDark;
  throw InputError("theme '" + name + "' is unknown; there are light and dark");
}

}  // namespace hydroscope
