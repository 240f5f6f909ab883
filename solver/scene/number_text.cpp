// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace hydroscope {

std::string format_exact(double number) {
  std::array<char, 40> text{};
  const double size = std::abs(number);
  // As people write numbers of this size; `general` would turn 100000 into 1e+05.
  const bool plain = size == 0.0 || (size >= 1e-4 && size < 1e15);
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, format).ptr;
  return std::string(text.data(), end);
}

}  // namespace hydroscope
