// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/view_text.h"

#include <cmath>
#include <cstdio>

namespace hydroscope {

ViewText find_view_text(const std::string& view) {
  if (view == "contact-map") return {"Contact map", "contact class"};
  if (view == "tool-normals") return {"Tool normals", "normal angle [°]"};
  if (view == "slip") return {"Slip", "sliding distance [mm]"};
  if (view == "thickness") return {"Wall thickness", "wall thickness [mm]"};
  if (view == "plastic-strain") return {"Equivalent plastic strain", "plastic strain [-]"};
  if (view == "contact-pressure") return {"Contact pressure", "contact pressure [MPa]"};
  if (view == "gap") return {"Gap", "gap to the nearest tool [mm]"};
  if (view == "detachment") return {"Detachment", "time since letting go [s]"};
  if (view == "chatter") return {"Let go and back", "times"};
  if (view == "release-margin") return {"Margin to release", "force left [share]"};
  return {view, view};
}

std::string make_time_label(const Snapshot& snapshot) {
  char label[160];
  std::snprintf(label, sizeof label, "t = %.4f s   p = %.3f MPa   increment %d", snapshot.time,
                snapshot.pressure, snapshot.increment);
  return label;
}

std::string format_number(double value) {
  char text[40];
  // Rounding noise around zero reads as zero.
  std::snprintf(text, sizeof text, "%.4g", std::abs(value) < 1e-12 ? 0.0 : value);
  return text;
}

double calc_round_step(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (double factor : {1.0, 2.0, 5.0})
    if (factor * power >= step * (1.0 - 1e-9)) return factor * power;
  return 10.0 * power;
}

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace hydroscope
