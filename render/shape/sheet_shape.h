// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "render/shape/quad_blocks.h"
#include "render/shape/surface.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// How the sheet's nodes are painted: exactly one of the three has an entry a node.
struct NodePaint {
  std::vector<double> values;         ///< a field; NaN where it has no value
  std::vector<ContactClass> classes;  ///< categories: each node owns a quarter of its quads
  std::vector<Rgb> colours{};         ///< a colour a node, on a quarter of its quads
};

/// What stays the same about the drawn sheet during a sequence.
class SheetShape {
 public:
  /// `first` is the sequence's first snapshot: it tells which edges lie on a
  /// mirror plane. Throws ContractError for a snapshot that contradicts itself.
  SheetShape(const Snapshot& first, bool is_mirrored);

  const std::vector<Reflection>& reflections() const { return reflections_; }

  /// The wall as a solid: outer and inner face at X +- (h/2) V, closed along
  /// its rim. Quads whose nodes differ in class (or of which some have no
  /// value) are cut into quarters, one a node, so that no colour is invented
  /// between two classes. Without paint the wall is plain.
  /// Coarse: squares of two by two quads of one class are drawn as one quad.
  Surface make_wall(const Snapshot& snapshot, const std::optional<NodePaint>& paint,
                    bool is_coarse = false) const;

  /// Edges of the wall's rim, on both faces.
  LineSet make_rim(const Snapshot& snapshot) const;

  /// All element edges, on the outer and inner face; coarse: those around squares of two by two.
  LineSet make_element_edges(const Snapshot& snapshot, bool is_coarse = false) const;

  /// Unit normals of the mid-surface at the nodes (averaged over the quads,
  /// within the mirror planes of nodes on them).
  std::vector<Vec3> calc_normals(const Snapshot& snapshot) const;

  /// Mean length of an element edge in a snapshot [mm].
  double calc_edge_length(const Snapshot& snapshot) const;

 private:
  struct Edge {
    int a, b;  ///< nodes, in the order of the quad that owns it
  };

  void find_edges(const Snapshot& first, double tolerance);

  const QuadBlocks& blocks() const;

  std::vector<std::array<int, 4>> quads_;
  mutable std::optional<QuadBlocks> blocks_;  ///< found when first needed
  std::vector<Edge> edges_;
  std::vector<std::vector<Edge>> rim_;  ///< of each copy: where no other copy continues
  std::vector<Reflection> reflections_;
  std::vector<Plane> mirrors_;
  std::vector<std::vector<int>> mirror_nodes_;  ///< one list a mirror plane
};

/// Throws ContractError naming the first array of a wrong length or the first
/// node whose position, director or thickness is not a number.
void check_snapshot(const Snapshot& snapshot);

/// Smallest box around points: least and greatest corner [mm].
struct Bounds {
  Vec3 least = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 greatest = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void include(const Vec3& x) {
    least = least.cwiseMin(x);
    greatest = greatest.cwiseMax(x);
  }
  Vec3 centre() const { return 0.5 * (least + greatest); }
  double diagonal() const { return (greatest - least).norm(); }
};

/// Box around the sheet with its reflections.
Bounds calc_bounds(const Snapshot& snapshot, const std::vector<Reflection>& reflections);

/// The same, as drawn.
Bounds calc_sheet_bounds(const Snapshot& snapshot, bool is_mirrored);

}  // namespace hydroscope
