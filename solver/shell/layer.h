// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/material/plane_stress.h"

namespace hydroscope {

/// Symmetric 2 x 2 metric of a layer surface, a_ij = g_i . g_j.
struct Metric {
  double a11 = 0.0, a22 = 0.0, a12 = 0.0;
  double det() const { return a11 * a22 - a12 * a12; }
};

/// State of one layer at one integration point. Stress components are kept in
/// a frame that spins with the material (Jaumann); `angle` [rad] leads from the
/// first base vector g_1 of the layer to the frame's first axis.
struct LayerState {
  MaterialPoint point;
  double angle = 0.0;
};

/// What a layer passes to the element: convected (contravariant) stress and
/// tangent, Voigt order 11, 22, 12 with the covariant strains (E11, E22, 2 E12).
struct LayerResponse {
  LayerState state;
  Vec3 stress;            ///< tau^ij [MPa]
  Mat3 tangent;           ///< d tau^ij / d E_kl, symmetric: T^T (C - Q) T (mechanics 1.2, 1.4)
  Vec3 strain_increment;  ///< D dt in the material frame
  double plastic_increment = 0.0;
  double elastic_share = 1.0;  ///< see StressUpdate
};

/// Integrates a layer from metric `start` to metric `end`. The strain
/// increment is the midpoint one (Hughes & Winget 1980) taken from the right
/// stretch, so that a rigid rotation of any size gives none; the spin is the
/// polar rotation, which is Jaumann's in the limit of small increments.
/// `tangent`: see update_stress(). `sigma33` [MPa] at the end, `sigma33_increment` over the increment.
LayerResponse advance_layer(const SheetLaw& law, const LayerState& state, const Metric& start,
                            const Metric& end, double sigma33, double sigma33_increment, TangentKind tangent);

}  // namespace hydroscope
