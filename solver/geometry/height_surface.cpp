// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/height_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/geometry/closest_point.h"
#include "solver/geometry/edge_foot.h"

namespace hydroscope {

namespace {

constexpr double kEps = 1e-9;        // of a cell: on the border between two
constexpr int kLongestWalk = 16;     // cells
constexpr int kLongestRimWalk = 64;  // cells
constexpr double kFarReach = 4.0;    // how far to look for a clearance, in reaches
constexpr double kSlack = 1.0 + 1e-12;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Side k of a cell runs from corner k to corner k + 1; the neighbour beyond it.
constexpr std::array<std::array<int, 2>, 4> kBeyond{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
constexpr std::array<std::array<int, 2>, 4> kCorner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/// How far a place lies beyond side `k`, in cells; negative inside.
double calc_beyond(const QuadPoint& place, int k) {
  return k == 0 ? -place.eta : k == 1 ? place.xi - 1.0 : k == 2 ? place.eta - 1.0 : -place.xi;
}

double calc_outside(const QuadPoint& place) {
  return std::max(std::max(-place.xi, place.xi - 1.0), std::max(-place.eta, place.eta - 1.0));
}

}  // namespace

bool HeightSurface::has_cell(const Cell& cell) const {
  return cell.i >= 0 && cell.j >= 0 && cell.i + 1 < field_.columns && cell.j + 1 < field_.rows &&
         field_.has_cell(cell.i, cell.j);
}

HeightSurface::Cell HeightSurface::find_column(const Vec3& x) const {
  const auto find = [&](int k, int count) {
    const double place = std::floor((x[k] - field_.origin[k]) / field_.pitch[k]);
    // Clamped as a number: far points do not fit an int. Not a number ends in the first cell.
    return place > 0.0 ? static_cast<int>(std::min(place, static_cast<double>(count - 2))) : 0;
  };
  return {find(0, field_.columns), find(1, field_.rows)};
}

std::optional<FootPoint> HeightSurface::find_foot_point(const Vec3& placed, double band, double depth,
                                                        SearchHint& hint) const {
  const double window = std::max(band, depth);
  if (hint.clearance > 0.0 && (placed - hint.position).norm() + window < hint.clearance) return std::nullopt;
  const Vec3 x = pose_.take_back(placed);
  Nearest best{{}, kFarReach * kFarReach * window * window};
  if (hint.facet >= 0 && hint.facet / 2 < (field_.columns - 1) * (field_.rows - 1)) {
    if (has_cell(cell_of(hint.facet / 2))) search_cell(cell_of(hint.facet / 2), x, best);
  }
  best = find_nearest(x, best);
  const double distance = std::sqrt(best.distance2);
  hint.position = placed;
  hint.clearance = distance;
  hint.facet = best.cell.i < 0 ? -1 : 2 * number(best.cell);
  if (best.cell.i < 0 || !(distance <= window)) return std::nullopt;
  const FootPoint foot = locate(x, best.cell);
  hint.facet = foot.facet;
  if (foot.gap > band || foot.gap < -depth) return std::nullopt;
  return place_foot_point(pose_, foot);
}

void HeightSurface::search_cell(const Cell& cell, const Vec3& x, Nearest& best) const {
  const std::array<Vec3, 4> c = list_corners(cell);
  const double low = std::min(std::min(c[0].z(), c[1].z()), std::min(c[2].z(), c[3].z()));
  const double high = std::max(std::max(c[0].z(), c[1].z()), std::max(c[2].z(), c[3].z()));
  const double above = std::max(std::max(low - x.z(), x.z() - high), 0.0);
  if (above * above > best.distance2 * kSlack) return;
  const double distance2 = std::min(find_closest_point(x, c[0], c[1], c[2]).distance2,
                                    find_closest_point(x, c[0], c[2], c[3]).distance2);
  const bool is_tie = distance2 == best.distance2 && (best.cell.i < 0 || number(cell) < number(best.cell));
  if (distance2 < best.distance2 || is_tie) best = {cell, distance2};
}

HeightSurface::Nearest HeightSurface::find_nearest(const Vec3& x, Nearest start) const {
  Nearest best = start;
  const Cell centre = find_column(x);
  const double above = std::max(std::max(low_ - x.z(), x.z() - high_), 0.0);
  if (!(above * above <= best.distance2 * kSlack)) return best;
  // Ring by ring around the column of the point; rings beyond the nearest cell found so far are left.
  for (int ring = 0;; ++ring) {
    const int i0 = std::max(0, centre.i - ring), i1 = std::min(field_.columns - 2, centre.i + ring);
    const int j0 = std::max(0, centre.j - ring), j1 = std::min(field_.rows - 2, centre.j + ring);
    for (int j = j0; j <= j1; ++j) {
      const bool is_whole_row = std::abs(j - centre.j) == ring;
      const int step = is_whole_row || ring == 0 ? 1 : 2 * ring;
      for (int i = is_whole_row ? i0 : centre.i - ring; i <= i1; i += step) {
        if (i >= 0 && field_.has_cell(i, j)) search_cell({i, j}, x, best);
      }
    }
    double next = std::numeric_limits<double>::infinity();
    const Vec3 from = field_.point(i0, j0), to = field_.point(i1 + 1, j1 + 1);
    if (i0 > 0) next = std::min(next, x.x() - from.x());
    if (j0 > 0) next = std::min(next, x.y() - from.y());
    if (i1 < field_.columns - 2) next = std::min(next, to.x() - x.x());
    if (j1 < field_.rows - 2) next = std::min(next, to.y() - x.y());
    next = std::max(0.0, next - kEps * field_.pitch.maxCoeff());
    if (std::isinf(next) || next * next > best.distance2 * kSlack) return best;
  }
}

FootPoint HeightSurface::locate(const Vec3& x, const Cell& nearest) const {
  Cell cell = nearest;
  Cell previous;
  for (int step = 0; step < kLongestWalk; ++step) {
    const QuadPoint place = locate_in_quad(make_cell(cell), x);
    if (!place.is_valid || keeps_cell_normals_) break;
    if (calc_outside(place) <= kEps) return finish(x, cell, place);
    // Over the side that is missed most; a rim only counts when nothing else is left.
    int crossed = -1, rim = -1;
    for (int k = 0; k < 4; ++k) {
      const double beyond = calc_beyond(place, k);
      if (beyond <= kEps) continue;
      int& best = has_cell({cell.i + kBeyond[at(k)][0], cell.j + kBeyond[at(k)][1]}) ? crossed : rim;
      if (best < 0 || beyond > calc_beyond(place, best)) best = k;
    }
    if (crossed < 0) return follow_rim(x, cell, rim);
    const Cell next{cell.i + kBeyond[at(crossed)][0], cell.j + kBeyond[at(crossed)][1]};
    if (next == previous) break;
    previous = cell;
    cell = next;
  }
  return fix(x, nearest);
}

FootPoint HeightSurface::finish(const Vec3& x, const Cell& cell, const QuadPoint& place) const {
  Cell owner = cell;
  QuadPoint owner_place = place;
  if (calc_outside(place) >= -kEps) {
    // On the border of several cells the lowest one answers, whatever the way that led here.
    for (int j = cell.j - 1; j <= cell.j + 1; ++j) {
      for (int i = cell.i - 1; i <= cell.i + 1; ++i) {
        if (!has_cell({i, j}) || number({i, j}) >= number(owner)) continue;
        const QuadPoint there = locate_in_quad(make_cell({i, j}), x);
        if (!there.is_valid || calc_outside(there) > kEps) continue;
        if (std::abs(there.g - place.g) > 1e-6 * field_.pitch.maxCoeff()) continue;
        owner = {i, j};
        owner_place = there;
      }
    }
  }
  FootPoint foot = make_foot_point(make_cell(owner), owner_place, x);
  foot.facet = 2 * number(owner) + (owner_place.eta > owner_place.xi ? 1 : 0);
  return foot;
}

FootPoint HeightSurface::follow_rim(const Vec3& x, Cell cell, int side) const {
  FootPoint best;
  double nearest = std::numeric_limits<double>::infinity();
  int last_end = 0;
  for (int i = 0; i < kLongestRimWalk; ++i) {
    const std::array<Vec3, 4> c = list_corners(cell);
    const std::array<Vec3, 4> v = list_normals(cell);
    const auto from = at(side), to = at((side + 1) % 4);
    ToolEdge edge;
    edge.start = c[from];
    edge.end = c[to];
    edge.start_left = edge.start_right = v[from];
    edge.end_left = edge.end_right = v[to];
    RimFoot rim = find_rim_foot(edge, x);
    rim.foot.facet = 2 * number(cell) + (side >= 2 ? 1 : 0);
    const double distance = (x - rim.foot.point).norm();
    if (distance < nearest) {
      nearest = distance;
      best = rim.foot;
    }
    if (rim.end == 0 || rim.end == -last_end) break;
    last_end = rim.end;
    // The rim goes on along the same line or around the cell; at an inner corner it has met the surface
    // again.
    const int ahead = rim.end > 0 ? (side + 1) % 4 : (side + 3) % 4;
    const Cell next{cell.i + kBeyond[at(ahead)][0], cell.j + kBeyond[at(ahead)][1]};
    if (!has_cell(next)) {
      side = ahead;
      continue;
    }
    if (has_cell({next.i + kBeyond[at(side)][0], next.j + kBeyond[at(side)][1]})) break;
    cell = next;
  }
  return best;
}

FootPoint HeightSurface::fix(const Vec3& x, const Cell& cell) const {
  const QuadPrism quad = make_cell(cell);
  const QuadPoint place = locate_in_quad(quad, x);
  FootPoint foot;
  if (place.is_valid && calc_outside(place) <= kEps) {
    foot = make_foot_point(quad, place, x);
    foot.facet = 2 * number(cell) + (place.eta > place.xi ? 1 : 0);
    return foot;
  }
  // Facet normals, or a point beyond the focal distance: the closest place still answers.
  const std::array<Vec3, 4> c = list_corners(cell);
  const ClosestPoint first = find_closest_point(x, c[0], c[1], c[2]);
  const ClosestPoint second = find_closest_point(x, c[0], c[2], c[3]);
  const bool is_first = first.distance2 <= second.distance2;
  const double xi = is_first ? first.weights[1] + first.weights[2] : second.weights[1];
  const double eta = is_first ? first.weights[2] : second.weights[1] + second.weights[2];
  foot = make_fixed_foot(quad, xi, eta, x);
  foot.facet = 2 * number(cell) + (is_first ? 0 : 1);
  const QuadPoint fixed{xi, eta, 0.0, true};
  for (int k = 0; k < 4; ++k) {
    if (calc_beyond(fixed, k) < -kEps) continue;
    if (has_cell({cell.i + kBeyond[at(k)][0], cell.j + kBeyond[at(k)][1]})) continue;
    foot.beyond_edge = (x - foot.point - foot.gap * foot.normal).norm();
  }
  return foot;
}

std::array<Vec3, 4> HeightSurface::list_corners(const Cell& cell) const {
  std::array<Vec3, 4> corners;
  for (std::size_t k = 0; k < 4; ++k)
    corners[k] = field_.point(cell.i + kCorner[k][0], cell.j + kCorner[k][1]);
  return corners;
}

std::array<Vec3, 4> HeightSurface::list_normals(const Cell& cell) const {
  std::array<Vec3, 4> normals;
  for (std::size_t k = 0; k < 4; ++k) {
    normals[k] = keeps_cell_normals_
                     ? normals_[at(4 * number(cell)) + k]
                     : normals_[at((cell.j + kCorner[k][1]) * field_.columns + cell.i + kCorner[k][0])];
  }
  return normals;
}

}  // namespace hydroscope
