// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

/// Triangles over a grid of `columns` x `rows` points point(i, j); normals point along
/// (step in i) x (step in j). The shorter diagonal splits each cell, of equal ones the rising one; or
/// the rising one where `rises(i, j)` says so. Points that coincide exactly become one, and cells
/// collapse where they do: closed grids come out closed.
TriangleMesh make_grid_mesh(int columns, int rows, const std::function<Vec3(int, int)>& point,
                            const std::function<bool(int, int)>& rises = nullptr);

/// Outline of a rounded rectangle, counter-clockwise from the start of the corner (+x, +y):
/// `corner_steps` facets a corner, at least two and at most `flat_steps` a flat, finer towards the corners
/// (where averaged normals would lean).
std::vector<Vec2> make_rounded_outline(double half_width, double half_height, double corner_radius,
                                       int corner_steps, int flat_steps);

/// Positions from 0 to 1, symmetric about 0.5, `steps` intervals (an odd number is lowered by one):
/// the first and the last are `end_size` (a part of the whole) or equal ones if that is smaller.
std::vector<double> make_graded_steps(double end_size, int steps);

}  // namespace hydroscope
