// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "solver/geometry/height_field.h"

namespace hydroscope {

/// Reads a point set from a text file, lengths times `unit_scale`:
///
///     hydroscope-grid 1        first line: kind of file and its version
///     columns 41               points along x
///     rows 21                  points along y
///     origin -20 -10           x and y of the first point
///     pitch 1 1                between columns, between rows
///     heights                  and then z, row by row from the lowest y, in a row from the lowest x
///     0.0, 0.1, ...            numbers apart by blanks, tabs, commas or new lines; - where there is no
///     surface
///
/// What follows a # is a comment. Throws InputError naming file, line and what is wrong, and for fields that
/// are no surface (see check_height_field()).
HeightField read_grid_file(const std::string& file, double unit_scale);

/// The text of such a file, exact to the last bit.
std::string format_grid_file(const HeightField& field);

}  // namespace hydroscope
