// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/facet_search.h"

#include "solver/base/error.h"
#include "solver/geometry/facet_grid.h"
#include "solver/geometry/triangle_tree.h"

namespace hydroscope {

SearchRule parse_search_rule(const std::string& name) {
  if (name == "tree") return SearchRule::tree;
  if (name == "grid") return SearchRule::grid;
  if (name == "all") return SearchRule::all;
  throw InputError("search = \"" + name + "\": expected tree, grid or all");
}

FacetSearch::FacetSearch(const TriangleMesh& mesh) {
  require(!mesh.triangles.empty(), "a search needs at least one facet");
  slots_.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(t[k])]; };
    slots_.push_back({corner(0), corner(1), corner(2), static_cast<int>(slots_.size())});
  }
  low_ = slots_.front().low();
  high_ = slots_.front().high();
  for (const Slot& slot : slots_) {
    low_ = low_.cwiseMin(slot.low());
    high_ = high_.cwiseMax(slot.high());
  }
  number_slots();
}

void FacetSearch::number_slots() {
  slot_of_facet_.resize(slots_.size());
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    slot_of_facet_[static_cast<std::size_t>(slots_[s].facet)] = static_cast<int>(s);
  }
}

FacetSearch::Nearest FacetList::find_nearest(const Vec3& x, Nearest start) const {
  for (const Slot& slot : slots_) keep_nearer(slot, x, start);
  return start;
}

void FacetList::visit_within(const Vec3& x, double radius, const std::function<void(int)>& visit) const {
  for (const Slot& slot : slots_) {
    if (slot.is_box_within(x, radius)) visit(slot.facet);
  }
}

std::unique_ptr<const FacetSearch> make_facet_search(const TriangleMesh& mesh, SearchRule rule) {
  switch (rule) {
    case SearchRule::grid:
      return std::make_unique<FacetGrid>(mesh);
    case SearchRule::all:
      return std::make_unique<FacetList>(mesh);
    case SearchRule::tree:
      break;
  }
  return std::make_unique<TriangleTree>(mesh);
}

}  // namespace hydroscope
