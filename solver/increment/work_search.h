// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hydroscope {

/// Line search along a correction q for a zero of its work, g(s) = q . r(s): past it the material has
/// left the moduli that the correction counted on (Crisfield 1991, chapter 9). Full steps first; then
/// false position with the Illinois rule.
class WorkSearch {
 public:
  /// `work`: g(0) [N mm]; nothing is searched for unless it is positive.
  explicit WorkSearch(double work) : work_(work), low_work_(work) {}

  double scale() const { return scale_; }

  /// Shortens the step to `share` of it: it was too long for another reason.
  void shorten(double share);

  /// Looks at g(scale) = `rest`. True when it is small enough; else `scale` is the next to try.
  bool accepts(double rest);

 private:
  double work_, scale_ = 1.0;
  double low_ = 0.0, low_work_;        ///< largest scale known to stop short of the zero
  double high_ = 0.0, high_work_ = 0;  ///< smallest scale known to lie past it; 0: none
  int side_ = 0;                       ///< +1: the last look was past the zero, -1: short of it
};

}  // namespace hydroscope
