// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "solver/base/types.h"
#include "solver/geometry/closest_point.h"

namespace hydroscope {

/// How the facets near a point are shortlisted (the global search of method 7).
enum class SearchRule {
  tree,  ///< bounding-volume tree: logarithmic, whatever the sizes of the facets
  grid,  ///< uniform grid of cells: constant for facets of like size, slow for mixed ones
  all    ///< every facet, every time: what the others are measured against
};

/// "tree", "grid" or "all"; throws InputError otherwise.
SearchRule parse_search_rule(const std::string& name);

/// Global search over the facets of a mesh. All rules give the same answers to the last bit.
/// Immutable after construction.
class FacetSearch {
 public:
  virtual ~FacetSearch() = default;

  struct Nearest {
    int facet = -1;
    double distance2 = std::numeric_limits<double>::infinity();  ///< [mm^2]
  };

  /// The facet nearest to `x`, if one is nearer than `start` (or as near with a lower
  /// id); otherwise `start`. Exact ties go to the lowest facet id, so the answer does
  /// not depend on `start`: a good start only makes it cheaper.
  virtual Nearest find_nearest(const Vec3& x, Nearest start) const = 0;

  /// Calls visit(facet) once for each facet whose own box is within `radius` [mm] of `x`, in any order.
  virtual void visit_within(const Vec3& x, double radius, const std::function<void(int)>& visit) const = 0;

  /// Squared distance of `x` to one facet [mm^2], with the same rounding as in `find_nearest`.
  double calc_distance2(const Vec3& x, int facet) const {
    return slots_[static_cast<std::size_t>(slot_of_facet_[static_cast<std::size_t>(facet)])].calc_distance2(
        x);
  }

  /// The box around all facets [mm].
  const Vec3& low() const { return low_; }
  const Vec3& high() const { return high_; }

 protected:
  /// Needs at least one facet (ContractError).
  explicit FacetSearch(const TriangleMesh& mesh);

  struct Slot {
    Vec3 a, b, c;
    int facet = -1;

    double calc_distance2(const Vec3& x) const { return find_closest_point(x, a, b, c).distance2; }
    Vec3 low() const { return a.cwiseMin(b).cwiseMin(c); }
    Vec3 high() const { return a.cwiseMax(b).cwiseMax(c); }
    bool is_box_within(const Vec3& x, double radius) const {
      return (low() - x).cwiseMax(x - high()).cwiseMax(0.0).squaredNorm() <= radius * radius;
    }
  };

  /// Keeps the facet of `slot` if it is nearer than `best`.
  static void keep_nearer(const Slot& slot, const Vec3& x, Nearest& best) {
    const double distance2 = slot.calc_distance2(x);
    const bool is_better = distance2 < best.distance2 ||
                           (distance2 == best.distance2 && (best.facet < 0 || slot.facet < best.facet));
    if (is_better) best = {slot.facet, distance2};
  }
  /// After the slots have been brought into another order.
  void number_slots();

  std::vector<Slot> slots_;  // ascending facets, unless a rule brings them into its own order

 private:
  std::vector<int> slot_of_facet_;
  Vec3 low_, high_;
};

/// Tries every facet.
class FacetList final : public FacetSearch {
 public:
  explicit FacetList(const TriangleMesh& mesh) : FacetSearch(mesh) {}
  Nearest find_nearest(const Vec3& x, Nearest start) const override;
  void visit_within(const Vec3& x, double radius, const std::function<void(int)>& visit) const override;
};

std::unique_ptr<const FacetSearch> make_facet_search(const TriangleMesh& mesh, SearchRule rule);

}  // namespace hydroscope
