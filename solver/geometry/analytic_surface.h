// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/geometry/pose.h"
#include "solver/geometry/tool_surface.h"

namespace hydroscope {

/// On which side of a curved tool the sheet lies.
enum class Side { inside, outside };

/// Surfaces with exact gap, normal and curvature. Each is described in its own frame
/// and placed by a pose on construction; the hint is not used, but for far points.
/// Where no nearest point exists (a centre, an axis) a fixed normal is given, without curvature.
class AnalyticSurface : public ToolSurface {
 public:
  explicit AnalyticSurface(const Pose& pose) : pose_(pose) {}

  std::optional<FootPoint> find_foot_point(const Vec3& x, double band, double depth,
                                           SearchHint& hint) const final;
  const TriangleMesh& display_mesh() const final { return display_mesh_; }
  const std::vector<Vec3>& display_normals() const final { return display_normals_; }

 protected:
  /// The foot point of `x` in the surface's own frame, before placing.
  virtual FootPoint locate(const Vec3& x) const = 0;
  /// Takes a display mesh in the own frame; its normals are those of `locate`. Called by constructors.
  void set_display_mesh(TriangleMesh mesh);

 private:
  Pose pose_;
  TriangleMesh display_mesh_;
  std::vector<Vec3> display_normals_;
};

/// The plane z = 0 of its frame; free space above.
class PlaneSurface final : public AnalyticSurface {
 public:
  /// Shown as a square of 2 `extent` [mm].
  PlaneSurface(const Pose& pose, double extent);

 protected:
  FootPoint locate(const Vec3& x) const override;
};

/// A circular cylinder about the z axis of its frame.
class CylinderSurface final : public AnalyticSurface {
 public:
  /// `radius` [mm]; shown for |z| <= `extent` [mm].
  CylinderSurface(const Pose& pose, double radius, Side side, double extent);

 protected:
  FootPoint locate(const Vec3& x) const override;

 private:
  double radius_;
  Side side_;
};

/// A square or rectangular tube with rounded corners along the z axis of its frame.
/// Patches: 0..3 flats (+x, +y, -x, -y), 4..7 corners (+x+y, -x+y, -x-y, +x-y).
class RoundedBoxSurface final : public AnalyticSurface {
 public:
  struct Section {
    double half_width = 0.0;     ///< x [mm]
    double half_height = 0.0;    ///< y [mm]
    double corner_radius = 0.0;  ///< [mm]
  };
  RoundedBoxSurface(const Pose& pose, const Section& section, Side side, double extent);

 protected:
  FootPoint locate(const Vec3& x) const override;

 private:
  Section section_;
  Side side_;
};

/// A torus about the z axis of its frame: the fillet of a round entry (sheet outside of
/// the torus tube) or of a round bottom (inside).
class TorusSurface final : public AnalyticSurface {
 public:
  /// `radius`: of the circle of tube centres, `minor_radius`: of the tube [mm].
  TorusSurface(const Pose& pose, double radius, double minor_radius, Side side);

 protected:
  FootPoint locate(const Vec3& x) const override;

 private:
  double radius_;
  double minor_radius_;
  Side side_;
};

}  // namespace hydroscope
