// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace hydroscope {

/// Isotropic hardening: flow stress [MPa] as a function of the equivalent
/// plastic strain. One aggregate for all laws; `kind` chooses.
struct Hardening {
  enum class Kind { kElastic, kPerfect, kSwift, kVoce, kTable };
  Kind kind = Kind::kElastic;
  double yield = 0.0;                        ///< perfect, Voce [MPa]
  double k = 0.0, eps0 = 0.0, n = 0.0;       ///< Swift: k (eps0 + ep)^n
  double q = 0.0, b = 0.0;                   ///< Voce: yield + q (1 - exp(-b ep))
  std::vector<std::array<double, 2>> table;  ///< (ep, MPa), linear between, constant slope 0 after

  bool is_plastic() const { return kind != Kind::kElastic; }

  struct Value {
    double stress = 0.0;  ///< [MPa]
    double slope = 0.0;   ///< H = d stress / d ep [MPa]
  };
  Value operator()(double plastic_strain) const;
};

}  // namespace hydroscope
