// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/facet_grid.h"

#include <algorithm>
#include <cmath>

namespace hydroscope {

namespace {

constexpr double kCellPerEdge = 1.5;
constexpr double kCellsPerFacet = 8.0;
constexpr double kGrowth = 1.25;
// Distances of cells and facets round differently.
constexpr double kSlack = 1.0 + 1e-12;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

template <class Visit>
void FacetGrid::for_cells(const Cell& low, const Cell& high, Visit&& visit) {
  for (int i = low[0]; i <= high[0]; ++i) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int k = low[2]; k <= high[2]; ++k) visit(i, j, k);
    }
  }
}

FacetGrid::FacetGrid(const TriangleMesh& mesh) : FacetSearch(mesh) {
  choose_cells();
  const std::size_t cells = at(count_[0]) * at(count_[1]) * at(count_[2]);
  start_.assign(cells + 1, 0);
  const auto for_cells_of = [&](const Slot& slot, auto&& use) {
    for_cells(find_cell(slot.low()), find_cell(slot.high()),
              [&](int i, int j, int k) { use(index(i, j, k)); });
  };
  for (const Slot& slot : slots_) {
    for_cells_of(slot, [&](std::size_t cell) { ++start_[cell + 1]; });
  }
  for (std::size_t cell = 0; cell < cells; ++cell) start_[cell + 1] += start_[cell];
  listed_.resize(at(start_.back()));
  std::vector<int> next(start_.begin(), start_.end() - 1);
  for (const Slot& slot : slots_) {
    for_cells_of(slot, [&](std::size_t cell) { listed_[at(next[cell]++)] = slot.facet; });
  }
}

void FacetGrid::choose_cells() {
  std::vector<double> edges;
  edges.reserve(3 * slots_.size());
  for (const Slot& slot : slots_) {
    edges.insert(edges.end(), {(slot.b - slot.a).norm(), (slot.c - slot.b).norm(), (slot.a - slot.c).norm()});
  }
  const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
  std::nth_element(edges.begin(), middle, edges.end());
  const Vec3 extent = high() - low();
  size_ = std::max(kCellPerEdge * *middle, 1e-9 * extent.norm());
  const double most = kCellsPerFacet * static_cast<double>(slots_.size()) + 64.0;
  const auto calc_count = [&] { return ((extent / size_).array().floor() + 1.0).eval(); };
  while (calc_count().prod() > most) size_ *= kGrowth;
  const auto count = calc_count();
  for (int k = 0; k < 3; ++k) count_[at(k)] = static_cast<int>(count[k]);
}

FacetGrid::Cell FacetGrid::find_cell(const Vec3& x) const {
  Cell cell{};
  for (int k = 0; k < 3; ++k) {
    const double place = std::floor((x[k] - low()[k]) / size_);
    // Clamped as a number: far points do not fit an int. Not a number ends in the first cell.
    cell[at(k)] = place > 0.0 ? static_cast<int>(std::min(place, static_cast<double>(count_[at(k)] - 1))) : 0;
  }
  return cell;
}

std::size_t FacetGrid::index(int i, int j, int k) const {
  return (at(i) * at(count_[1]) + at(j)) * at(count_[2]) + at(k);
}

void FacetGrid::search_cell(int i, int j, int k, const Vec3& x, Nearest& best) const {
  const std::size_t cell = index(i, j, k);
  if (start_[cell] == start_[cell + 1]) return;
  const Vec3 corner = low() + size_ * Vec3(i, j, k);
  const Vec3 outside = (corner - x).cwiseMax(x - corner - Vec3::Constant(size_)).cwiseMax(0.0);
  // Facets on the border of two cells: let the cell be a little larger than it is.
  const double distance = std::max(0.0, outside.norm() - 1e-9 * size_);
  if (distance * distance > best.distance2 * kSlack) return;
  for (int s = start_[cell]; s < start_[cell + 1]; ++s) keep_nearer(slots_[at(listed_[at(s)])], x, best);
}

void FacetGrid::search_ring(const Cell& centre, int ring, const Vec3& x, Nearest& best) const {
  Cell low_cell{}, high_cell{};
  for (std::size_t k = 0; k < 3; ++k) {
    low_cell[k] = std::max(0, centre[k] - ring);
    high_cell[k] = std::min(count_[k] - 1, centre[k] + ring);
  }
  for (int i = low_cell[0]; i <= high_cell[0]; ++i) {
    for (int j = low_cell[1]; j <= high_cell[1]; ++j) {
      const bool is_face = std::abs(i - centre[0]) == ring || std::abs(j - centre[1]) == ring;
      if (is_face) {
        for (int k = low_cell[2]; k <= high_cell[2]; ++k) search_cell(i, j, k, x, best);
        continue;
      }
      if (centre[2] - ring >= 0) search_cell(i, j, centre[2] - ring, x, best);
      if (ring > 0 && centre[2] + ring < count_[2]) search_cell(i, j, centre[2] + ring, x, best);
    }
  }
}

double FacetGrid::calc_ring_distance(const Cell& centre, int ring, const Vec3& x) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const int first = centre[at(k)] - ring;
    const int last = centre[at(k)] + ring;
    if (first > 0) nearest = std::min(nearest, x[k] - (low()[k] + first * size_));
    if (last + 1 < count_[at(k)]) nearest = std::min(nearest, low()[k] + (last + 1) * size_ - x[k]);
  }
  return nearest - 1e-9 * size_;
}

FacetSearch::Nearest FacetGrid::find_nearest(const Vec3& x, Nearest start) const {
  Nearest best = start;
  const double to_box = (low() - x).cwiseMax(x - high()).cwiseMax(0.0).squaredNorm();
  if (!(to_box <= best.distance2 * kSlack)) return best;
  const Cell centre = find_cell(x);
  for (int ring = 0;; ++ring) {
    search_ring(centre, ring, x, best);
    const double next = std::max(0.0, calc_ring_distance(centre, ring, x));
    if (std::isinf(next) || next * next > best.distance2 * kSlack) return best;
  }
}

void FacetGrid::visit_within(const Vec3& x, double radius, const std::function<void(int)>& visit) const {
  const Vec3 reach = Vec3::Constant(radius * (1.0 + 1e-9) + 1e-9 * size_);
  const Cell from = find_cell(x - reach);
  const Cell to = find_cell(x + reach);
  for_cells(from, to, [&](int i, int j, int k) {
    const std::size_t cell = index(i, j, k);
    for (int s = start_[cell]; s < start_[cell + 1]; ++s) {
      const Slot& slot = slots_[at(listed_[at(s)])];
      // A facet of several cells is met in the first of them.
      const Cell own = find_cell(slot.low());
      const Cell first{std::max(from[0], own[0]), std::max(from[1], own[1]), std::max(from[2], own[2])};
      if (first == Cell{i, j, k} && slot.is_box_within(x, radius)) visit(slot.facet);
    }
  });
}

}  // namespace hydroscope
