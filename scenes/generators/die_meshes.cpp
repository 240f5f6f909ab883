// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/generators/die_meshes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "solver/base/error.h"
#include "solver/geometry/grid_mesh.h"
#include "solver/geometry/pose.h"

namespace hydroscope {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kMargin = 2;  // facets beyond a symmetry plane

/// Section of a rounded square from the middle of the flat (+x) to the 45 degree point.
std::vector<Vec2> make_octant(double half_width, double corner_radius, int corner_facets, int flat_facets) {
  if (!(half_width > 0.0 && corner_radius > 0.0 && corner_radius < half_width)) {
    throw InputError("a square die needs 0 < corner radius < half width");
  }
  if (corner_facets < 2 || corner_facets % 2 != 0 || flat_facets < 2 || flat_facets % 2 != 0) {
    throw InputError("facets of a corner and of a flat must be even numbers from 2");
  }
  const double centre = half_width - corner_radius;
  const double corner_facet = corner_radius * kPi / 2.0 / corner_facets;
  const std::vector<double> steps =
      make_graded_steps(std::min(corner_facet / (2.0 * centre), 0.5), flat_facets);
  std::vector<Vec2> octant;
  for (std::size_t i = steps.size() / 2; i + 1 < steps.size(); ++i) {
    octant.emplace_back(half_width, (2.0 * steps[i] - 1.0) * centre);
  }
  for (int i = 0; i < corner_facets / 2; ++i) {
    const double angle = kPi / 2.0 * i / corner_facets;
    octant.emplace_back(centre + corner_radius * std::cos(angle), centre + corner_radius * std::sin(angle));
  }
  const double diagonal = centre + corner_radius * std::sqrt(0.5);
  octant.emplace_back(diagonal, diagonal);
  return octant;
}

/// Columns around the axis as reflections of one octant: bit for bit the same coordinates in each.
class Columns {
 public:
  Columns(int facets_in_octant, Coverage coverage) : octant_(facets_in_octant), coverage_(coverage) {}

  int first() const { return coverage_ == Coverage::full ? 0 : -kMargin; }
  int count() const {
    if (coverage_ == Coverage::full) return 8 * octant_ + 1;
    return (coverage_ == Coverage::quarter ? 2 : 1) * octant_ + 1 + 2 * kMargin;
  }
  /// Place of column `i` (from 0) in the octant.
  int index(int i) const {
    const int k = wrap(i) % (2 * octant_);
    return k <= octant_ ? k : 2 * octant_ - k;
  }
  /// Brings a point of the octant to column `i`.
  Vec2 reflect(int i, Vec2 p) const {
    const int k = wrap(i);
    const int quarter = k / (2 * octant_);
    if (k % (2 * octant_) > octant_) std::swap(p.x(), p.y());
    if (quarter == 1) return {-p.y(), p.x()};
    if (quarter == 2) return {-p.x(), -p.y()};
    if (quarter == 3) return {p.y(), -p.x()};
    return p;
  }

 private:
  int wrap(int i) const { return (i + first() + 8 * octant_) % (8 * octant_); }
  int octant_;
  Coverage coverage_;
};

/// Diagonals like the squares of a chessboard: every node has as much facet on its left as on its
/// right, so that averaged normals do not lean, and the mesh mirrors about its columns and rows.
bool is_even_cell(int i, int j) { return (i + j) % 2 == 0; }

TriangleMesh make_die(const Columns& columns, const std::vector<double>& rows,
                      const std::function<Vec2(int, double)>& section) {
  TriangleMesh mesh = make_grid_mesh(
      columns.count(), static_cast<int>(rows.size()),
      [&](int i, int j) {
        const double z = rows[static_cast<std::size_t>(j)];
        const Vec2 p = columns.reflect(i, section(columns.index(i), std::abs(z)));
        return Vec3(p.x() + 0.0, p.y() + 0.0, z);  // + 0.0: no negative zeros
      },
      is_even_cell);
  flip_mesh(mesh);  // into the cavity
  return mesh;
}

/// Equal rows over |z| <= reach, one of them at 0.
std::vector<double> make_rows(double reach, double largest) {
  if (!(reach > 0.0 && largest > 0.0)) throw InputError("length and row must be above 0");
  const int half = std::max(1, static_cast<int>(std::ceil(reach / largest - 1e-9)));
  std::vector<double> rows;
  for (int j = -half; j <= half; ++j) rows.push_back(reach * j / half);
  return rows;
}

/// From the size `first` on, growing by a quarter from row to row up to `largest`, then equal, over `length`.
std::vector<double> make_growing_rows(double first, double largest, double length) {
  std::vector<double> ends;
  double size = std::min(first, largest);
  for (double z = size; z < length - 0.5 * size; z += size) {
    ends.push_back(z);
    size = std::min(1.25 * size, largest);
  }
  const double scale = ends.empty() ? 1.0 : length / (ends.back() + size);
  for (double& z : ends) z *= scale;
  ends.push_back(length);
  return ends;
}

std::vector<double> make_bulge_rows(const SquareBulgeDie& die) {
  const double loft = die.round_start - die.square_end;
  const double step = loft / die.loft_rows;
  std::vector<double> rows;  // z >= 0
  rows.push_back(0.0);
  const std::vector<double> inner = make_growing_rows(step, die.row, die.square_end);
  for (auto z = inner.rbegin() + 1; z != inner.rend(); ++z) rows.push_back(die.square_end - *z);
  for (int j = 0; j <= die.loft_rows; ++j) rows.push_back(die.square_end + step * j);
  for (double z : make_growing_rows(step, die.row, die.half_length - die.round_start)) {
    rows.push_back(die.round_start + z);
  }
  std::vector<double> both;
  const std::size_t behind = die.is_half_length ? std::size_t{kMargin} : rows.size() - 1;
  for (std::size_t j = behind; j > 0; --j) both.push_back(-rows[j]);
  both.insert(both.end(), rows.begin(), rows.end());
  return both;
}

}  // namespace

TriangleMesh make_square_die(const SquareDie& die) {
  const auto octant = make_octant(die.half_width, die.corner_radius, die.corner_facets, die.flat_facets);
  const Columns columns(static_cast<int>(octant.size()) - 1, die.coverage);
  return make_die(columns, make_rows(0.5 * die.length, die.row),
                  [&](int k, double) { return octant[static_cast<std::size_t>(k)]; });
}

TriangleMesh make_square_bulge_die(const SquareBulgeDie& die) {
  const bool is_in_order =
      0.0 < die.square_end && die.square_end < die.round_start && die.round_start < die.half_length;
  if (!is_in_order) throw InputError("a bulge die needs 0 < square end < round start < half length");
  if (die.loft_rows < 2 || !(die.row > 0.0)) throw InputError("a bulge die needs two loft rows and row > 0");
  if (!(die.guide_radius > 0.0 && die.guide_radius <= die.half_width)) {
    throw InputError("a bulge die needs 0 < guide radius <= half width");
  }
  const auto octant = make_octant(die.half_width, die.corner_radius, die.corner_facets, die.flat_facets);
  const Columns columns(static_cast<int>(octant.size()) - 1, die.coverage);
  return make_die(columns, make_bulge_rows(die), [&](int k, double z) {
    const Vec2& square = octant[static_cast<std::size_t>(k)];
    // Equal facets around the guides: there averaged normals point exactly at the axis.
    const int last = static_cast<int>(octant.size()) - 1;
    const double angle = 0.25 * kPi * k / last;
    // Exactly on the 45 degree line, for the sake of its reflections.
    const Vec2 round = k == last ? Vec2(Vec2::Constant(die.guide_radius * std::sqrt(0.5)))
                                 : Vec2(die.guide_radius * Vec2(std::cos(angle), std::sin(angle)));
    const double u = std::clamp((z - die.square_end) / (die.round_start - die.square_end), 0.0, 1.0);
    const double roundness = u >= 1.0 ? 1.0 : 0.5 * (1.0 - std::cos(kPi * u));
    return Vec2(square + roundness * (round - square));
  });
}

TriangleMesh make_punch(const Punch& punch) {
  const double range = punch.end - punch.start;
  if (!(punch.radius > 0.0 && range > 0.0 && range <= 360.0 && punch.facet_angle > 0.0)) {
    throw InputError("a punch needs radius > 0, start < end <= start + 360 and a facet angle > 0");
  }
  const int facets = std::max(3, static_cast<int>(std::ceil(range / punch.facet_angle - 1e-9)));
  const std::vector<double> rows = make_rows(0.5 * punch.length, punch.row);
  const auto point = [&](int i, int j) {
    const int k = range == 360.0 ? i % facets : i;
    const double angle = (punch.start + range * k / facets) * kPi / 180.0;
    return Vec3(punch.radius * std::cos(angle), punch.radius * std::sin(angle),
                rows[static_cast<std::size_t>(j)]);
  };
  return make_grid_mesh(facets + 1, static_cast<int>(rows.size()), point, is_even_cell);
}

}  // namespace hydroscope
