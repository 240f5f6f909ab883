// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

/// What a tool's form leaves of a curved surface between its points.
enum class ToolForm {
  kExact,  ///< a cylinder, box, torus or plane: nothing
  kFlat,   ///< flat facets and bilinear quadrilaterals: R theta^2 / 8
  kBent,   ///< facets bent to fit their normals, Nagata patches: R theta^4 / 128
  kOther   ///< heights and the like: not known
};
/// From the keys `shape` and `surface` of a tool.
ToolForm find_tool_form(const std::string& shape, const std::string& surface);

/// Scatter of the contact pressure that a tool's facets cause in a backed wall. NaN: not known.
struct FacetNoise {
  double angle = std::numeric_limits<double>::quiet_NaN();     ///< between neighbouring facets there [deg]
  double pressure = std::numeric_limits<double>::quiet_NaN();  ///< [MPa]
  double sagitta = std::numeric_limits<double>::quiet_NaN();   ///< of the facets off the true surface [mm]
};

/// One tool's facets. A wall of thickness t that is pressed on them is off the true surface by
/// the sagitta e; its hoop stiffness answers with dp = E' t e / R^2, E' = E / (1 - nu^2): for flat facets
/// E' (t/R) theta^2 / 8 (mechanics 6.3). The angle theta is the largest that is no crease between the
/// facet at a point and its neighbours, and R = (mean height of the two facets over their edge) / theta.
class FacetTool {
 public:
  FacetTool() = default;  ///< nothing is known of it
  FacetTool(TriangleMesh mesh, ToolForm form, double crease_angle);

  /// `x`: contact point in the tool's frame [mm]; `thickness` [mm]; `modulus`: E' [MPa].
  FacetNoise estimate(const Vec3& x, double thickness, double modulus) const;

 private:
  struct Bend {
    double angle = 0.0;  ///< [rad]
    double width = 0.0;  ///< of the facets across the edge [mm]
  };
  std::size_t find_nearest(const Vec3& x) const;

  ToolForm form_ = ToolForm::kOther;
  TriangleMesh mesh_;
  std::vector<Bend> bends_;  ///< sharpest of each facet
};

/// What the scatter needs to know of a run.
struct FacetNoiseModel {
  double modulus = std::numeric_limits<double>::quiet_NaN();  ///< E' [MPa]
  std::vector<FacetTool> tools;                               ///< in the order of the run's
};

}  // namespace hydroscope
