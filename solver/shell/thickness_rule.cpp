// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/shell/thickness_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

struct Legendre {
  double value, slope, previous;
};

/// P_n, its derivative and P_(n-1) by the three-term recurrence.
Legendre evaluate_legendre(int n, double x) {
  double p0 = 1.0, p1 = x;
  for (int k = 2; k <= n; ++k) {
    const double p2 = ((2.0 * k - 1.0) * x * p1 - (k - 1.0) * p0) / k;
    p0 = p1;
    p1 = p2;
  }
  return {p1, n * (x * p1 - p0) / (x * x - 1.0), p0};
}

ThicknessRule make_gauss(int n) {
  ThicknessRule rule;
  if (n == 1) return {{0.0}, {1.0}};
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    for (int k = 0; k < 50; ++k) {
      const Legendre p = evaluate_legendre(n, x);
      x -= p.value / p.slope;
    }
    if (2 * i + 1 == n) x = 0.0;
    const double slope = evaluate_legendre(n, x).slope;
    rule.zeta.push_back(x);
    rule.weight.push_back(1.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

/// Ends and the zeros of P'_(n-1); weights 2 / (n (n-1) P_(n-1)^2), halved.
ThicknessRule make_lobatto(int n) {
  ThicknessRule rule;
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * i / (n - 1));
    const bool is_end = i == 0 || i == n - 1;
    for (int k = 0; k < 50 && !is_end; ++k) {
      const Legendre p = evaluate_legendre(n - 1, x);
      const double second = (2.0 * x * p.slope - n * (n - 1.0) * p.value) / (1.0 - x * x);
      x -= p.slope / second;
    }
    const double value = is_end ? 1.0 : evaluate_legendre(n - 1, x).value;
    rule.zeta.push_back(x);
    rule.weight.push_back(1.0 / (n * (n - 1.0) * value * value));
  }
  return rule;
}

ThicknessRule make_simpson(int n) {
  ThicknessRule rule;
  const int intervals = n - 1;
  for (int i = 0; i < n; ++i) {
    rule.zeta.push_back(-1.0 + 2.0 * i / intervals);
    const double factor = (i == 0 || i == intervals) ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    rule.weight.push_back(factor / (3.0 * intervals));
  }
  return rule;
}

ThicknessRule make_split_gauss(int n) {
  const ThicknessRule half = make_gauss(n / 2);
  ThicknessRule rule;
  for (const double side : {-0.5, 0.5}) {
    for (int i = 0; i < half.size(); ++i) {
      rule.zeta.push_back(side + 0.5 * half.zeta[static_cast<std::size_t>(i)]);
      rule.weight.push_back(0.5 * half.weight[static_cast<std::size_t>(i)]);
    }
  }
  return rule;
}

[[noreturn]] void refuse(const std::string& kind, int points, const char* expected) {
  throw InputError("shell.thickness_points = " + std::to_string(points) + ": the rule '" + kind + "' needs " +
                   expected);
}

}  // namespace

ThicknessRule make_thickness_rule(const std::string& kind, int points) {
  if (points > 41) refuse(kind, points, "at most 41 points");
  if (kind == "gauss") {
    if (points < 1) refuse(kind, points, "at least 1 point");
    return make_gauss(points);
  }
  if (kind == "lobatto") {
    if (points < 2) refuse(kind, points, "at least 2 points");
    return make_lobatto(points);
  }
  if (kind == "simpson") {
    if (points < 3 || points % 2 == 0) refuse(kind, points, "an odd number of points from 3");
    return make_simpson(points);
  }
  if (kind == "split_gauss") {
    if (points < 2 || points % 2 != 0) refuse(kind, points, "an even number of points from 2");
    return make_split_gauss(points);
  }
  throw InputError("shell.thickness_rule = \"" + kind +
                   "\": expected gauss, lobatto, simpson or split_gauss");
}

}  // namespace hydroscope
