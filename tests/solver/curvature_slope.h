// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "solver/contact/constraint.h"
#include "solver/geometry/tool_surface.h"

namespace hydroscope {

/// One node with its fibre, pressed onto a tool and held by springs.
struct SpringNode {
  Vec3 x;               ///< mid-surface [mm]
  SlavePoint slave;     ///< the fibre; the tool meets x + offset V
  double normal_force;  ///< t_N [N]
  Eigen::Matrix<double, kDofs, kDofs> springs;

  Vec3 point() const { return x + slave.offset * slave.triad.v; }
  /// Moved by (u, alpha, beta), the fibre turned rigidly.
  SpringNode moved(const Eigen::Matrix<double, kDofs, 1>& q) const;
};

/// A node whose slave point is `at`, with a fibre that leans a little against the tool's normal there.
SpringNode make_spring_node(const ToolSurface& tool, const Vec3& at, double offset, double normal_force);

/// The foot point of `x`; throws when there is none within 50 mm.
FootPoint find_foot(const ToolSurface& tool, const Vec3& x);

/// Treatment of the turning normal in the tangent.
enum class CurvatureInSlide { none, full, symmetric };

/// What is left across the true normal n' after one step along the tool, before re-projection:
/// |t' - n' (n' . t')| [N].
struct TangentialRest {
  double slide = 0.0;        ///< length of the step of the slave point [mm]
  double transported = 0.0;  ///< of t' = t + t_N dn/dx du: the force turned by what the foot point says
  /// Of t' as the step's own equations have it: t + dt_N n less what the contact's part of the tangent,
  /// calc_contact_stiffness(), gives for the step.
  double balanced = 0.0;
  bool in_one_facet = true;  ///< the foot point has not left its facet
};

/// One linear step under `force` (u, alpha, beta) [N, N mm]: springs and contact stiffness on the left, the
/// gap held (4.35).
TangentialRest slide_once(const ToolSurface& tool, const SpringNode& node, CurvatureInSlide curvature,
                          const Eigen::Matrix<double, kDofs, 1>& force);

struct SlopeRow {
  TangentialRest none, full, symmetric;
};

/// `steps` slides under forces halved from one to the next.
std::vector<SlopeRow> measure_slopes(const ToolSurface& tool, const SpringNode& node, double first_force,
                                     int steps);

/// A tool with a place on it, inside of a facet.
struct SlopeCase {
  std::string name;
  std::shared_ptr<const ToolSurface> tool;
  Vec3 at;            ///< on the surface [mm]
  bool is_symmetric;  ///< whether dn/dx of the surface is
};

/// Sphere of 320 uneven facets and saddle side of a torus, R about 10 mm: flat and smooth facets with
/// averaged normals, Nagata patches, exact.
std::vector<SlopeCase> make_slope_cases();

/// Slope of log y over log x by least squares.
double fit_slope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace hydroscope
