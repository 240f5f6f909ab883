// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

/// State of a node against the tools. Values are written to files: never renumber.
enum class ContactClass : std::uint8_t { kFree = 0, kStick = 1, kSlip = 2, kDetachedNow = 3 };

/// What never changes during a run and is shared by all its snapshots.
struct SnapshotModel {
  std::string title;
  std::vector<std::array<int, 4>> quads;
  /// Mirror planes in the order in which they double the part: applying all of
  /// them one after the other gives the whole part. Normals point out of the modelled part.
  std::vector<Plane> mirrors;
  bool is_pressure_inside = false;  ///< the fluid presses on the inner face, else on the mid-surface
  struct Tool {
    std::string name;
    TriangleMesh mesh;          ///< in the tool's frame [mm]
    std::vector<Vec3> normals;  ///< continuous node normals, unit
  };
  std::vector<Tool> tools;
};

/// An immutable picture of one accepted increment, for files and frames.
/// Arrays have one entry a node unless said otherwise.
struct Snapshot {
  std::shared_ptr<const SnapshotModel> model;
  int increment = 0;
  double time = 0.0;                   ///< process time [s]
  double pressure = 0.0;               ///< [MPa]
  double feed = 0.0;                   ///< axial feed [mm]
  std::vector<Vec3> points;            ///< mid-surface [mm]
  std::vector<Vec3> directors;         ///< unit, towards the outer face
  std::vector<double> thickness;       ///< [mm]
  std::vector<double> plastic_strain;  ///< equivalent, largest through the thickness
  std::vector<ContactClass> contact_state;
  std::vector<int> contact_tool;         ///< index into model->tools; -1 free
  std::vector<double> gap;               ///< to the nearest tool [mm]; NaN when out of its band
  std::vector<double> contact_pressure;  ///< smoothed [MPa]
  std::vector<Vec3> contact_force;       ///< tool on sheet, normal and friction [N]
  std::vector<Vec3> support_force;       ///< of supports, symmetry and edge loads [N]; empty: not known
  std::vector<Vec3> tool_normal;         ///< at the foot point; zero when free
  std::vector<Vec3> slip;                ///< accumulated sliding vector [mm]
  std::vector<Vec3> slip_increment;      ///< of the last increment [mm]
  // How contact ended, and how near it is to ending. All empty: not known (older states).
  std::vector<double> let_go_time;  ///< of a free node: when it last let go [s]; NaN: never, or it touches
  std::vector<int> toggles;         ///< lettings go and comings back so far
  std::vector<double> release_reference;  ///< what tension is measured against at a touching node [N]; 0 free
  std::vector<double> release_threshold;  ///< tension from which a touching node may let go [N]; 0 free
  std::vector<Vec3> tool_translation;     ///< one a tool [mm]; no number: it has been taken away
  std::vector<Vec3> tool_force;           ///< one a tool: its own sum over the sheet [N]; empty: not known
  std::map<std::string, double> quantities;  ///< as declared by the scene
};

/// What is left until a touching node may let go: its normal force and the tension that it may bear
/// (mechanics 9.4) [N]. The snapshot knows its release thresholds.
inline double calc_release_margin(const Snapshot& s, std::size_t node) {
  return s.contact_force[node].dot(s.tool_normal[node]) + s.release_threshold[node];
}

}  // namespace hydroscope
