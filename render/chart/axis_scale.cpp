// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/chart/axis_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render/view_text.h"

namespace hydroscope {
namespace {

/// Number with as many decimals as the step between ticks asks for.
std::string format_tick(double value, double step) {
  const double size = std::max(std::abs(value), step);
  std::array<char, 40> text{};
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  if (size < 1e6 && decimals <= 6)
    std::snprintf(text.data(), text.size(), "%.*f", decimals, std::abs(value) < 1e-9 * step ? 0.0 : value);
  else
    std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

std::string make_superscript(int number) {
  static const std::array<const char*, 10> kDigits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(number))
    text += c == '-' ? "⁻" : kDigits[static_cast<std::size_t>(c - '0')];
  return text;
}

/// 0.05, 300, or 10⁻⁷ where zeros would have to be counted.
std::string format_decade(int factor, int power, bool in_powers) {
  if (in_powers) return (factor == 1 ? "" : std::to_string(factor) + "·") + "10" + make_superscript(power);
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.10g", factor * std::pow(10.0, power));
  return text.data();
}

}  // namespace

AxisScale::AxisScale(const ChartAxis& axis, const std::vector<double>& values)
    : is_log_(axis.scale == ChartScale::kLog), low_(0.0), high_(1.0) {
  bool is_first = true;
  for (const double value : values) {
    if (!takes(value)) continue;
    low_ = is_first ? value : std::min(low_, value);
    high_ = is_first ? value : std::max(high_, value);
    is_first = false;
  }
  if (is_log_) {
    if (is_first) low_ = 0.1;
    // A tenth of the range on either side, and never less than a factor of 2.5 in all.
    const double room = std::max(0.08 * std::log10(high_ / low_), 0.5 * (0.4 - std::log10(high_ / low_)));
    low_ *= std::pow(10.0, -std::max(room, 0.02));
    high_ *= std::pow(10.0, std::max(room, 0.02));
  } else {
    // Values that differ by rounding alone are one value, with a tenth of it on either side.
    const double size = std::max(std::abs(low_), std::abs(high_)), span = high_ - low_;
    const double room = span > 1e-6 * size ? 0.05 * span : std::max(0.1 * size, 1e-9);
    // Values that begin at zero keep their axis there.
    const bool from_zero = low_ >= 0.0 && low_ < 0.05 * high_;
    low_ = from_zero ? 0.0 : low_ - room;
    high_ += room;
  }
  if (axis.low && (!is_log_ || *axis.low > 0.0)) low_ = *axis.low;
  if (axis.high && (!is_log_ || *axis.high > 0.0)) high_ = *axis.high;
  // Also what was asked for must leave room for ticks.
  if (!(high_ - low_ > 1e-9 * std::max(std::abs(low_), std::abs(high_))))
    high_ = is_log_ ? 10.0 * low_ : low_ + std::max(1.0, std::abs(low_));
}

bool AxisScale::takes(double value) const { return std::isfinite(value) && (!is_log_ || value > 0.0); }

double AxisScale::to_unit(double value) const {
  if (is_log_) return std::log(value / low_) / std::log(high_ / low_);
  return (value - low_) / (high_ - low_);
}

std::vector<AxisTick> AxisScale::find_ticks(int count) const {
  return is_log_ ? find_log_ticks(count) : find_linear_ticks(count);
}

std::vector<AxisTick> AxisScale::find_linear_ticks(int count) const {
  const double step = calc_round_step((high_ - low_) / std::max(count, 1));
  std::vector<AxisTick> ticks;
  for (double k = std::ceil(low_ / step - 1e-9); k * step <= high_ + 1e-9 * step; k += 1.0)
    ticks.push_back({k * step, format_tick(k * step, step)});
  return ticks;
}

std::vector<AxisTick> AxisScale::find_log_ticks(int count) const {
  const int first = static_cast<int>(std::floor(std::log10(low_))),
            last = static_cast<int>(std::ceil(std::log10(high_)));
  const bool in_powers = first < -4 || last > 5;
  const double decades = std::log10(high_ / low_);
  const int stride = std::max(1, static_cast<int>(std::ceil(decades / std::max(count, 1))));
  std::vector<AxisTick> ticks;
  for (int power = first; power <= last; ++power)
    for (int factor = 1; factor < 10; ++factor) {
      const double value = factor * std::pow(10.0, power);
      if (value < low_ * (1.0 - 1e-9) || value > high_ * (1.0 + 1e-9)) continue;
      const bool is_decade = factor == 1 && (power % stride + stride) % stride == 0;
      // Within few decades, the numbers between are wanted, too.
      const bool is_between = (decades < 2.5 && (factor == 2 || factor == 5)) ||
                              (decades < 0.8 && (factor == 3 || factor == 4 || factor == 7));
      if (is_decade || is_between)
        ticks.push_back({value, format_decade(factor, power, in_powers)});
      else if (stride == 1 || factor == 1)
        ticks.push_back({value, ""});
    }
  return ticks;
}

}  // namespace hydroscope
