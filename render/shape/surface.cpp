// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/surface.h"

#include <utility>

namespace hydroscope {
namespace {

template <typename T>
void append_copies(std::vector<T>& all, const std::vector<T>& piece, std::size_t copies) {
  all.reserve(all.size() + piece.size() * copies);
  for (std::size_t i = 0; i < copies; ++i) all.insert(all.end(), piece.begin(), piece.end());
}

void append_flipped(std::vector<std::array<int, 4>>& all, const std::array<int, 4>& polygon, int offset,
                    bool flips) {
  std::array<int, 4> copy;
  for (std::size_t k = 0; k < 4; ++k) copy[k] = polygon[k] < 0 ? -1 : polygon[k] + offset;
  // Keeping the first and the third also keeps the diagonal along which a quad is split.
  if (flips && copy[3] >= 0) std::swap(copy[1], copy[3]);
  if (flips && copy[3] < 0) std::swap(copy[1], copy[2]);
  all.push_back(copy);
}

}  // namespace

void append(Surface& surface, const Surface& more) {
  const int offset = static_cast<int>(surface.points.size());
  append_copies(surface.points, more.points, 1);
  append_copies(surface.normals, more.normals, 1);
  append_copies(surface.values, more.values, 1);
  append_copies(surface.colours, more.colours, 1);
  for (const auto& polygon : more.polygons) append_flipped(surface.polygons, polygon, offset, false);
}

Surface calc_reflected(const Surface& piece, const std::vector<Reflection>& reflections) {
  Surface whole;
  append_copies(whole.values, piece.values, reflections.size());
  append_copies(whole.colours, piece.colours, reflections.size());
  whole.points.reserve(piece.points.size() * reflections.size());
  whole.normals.reserve(piece.normals.size() * reflections.size());
  whole.polygons.reserve(piece.polygons.size() * reflections.size());
  for (const Reflection& reflection : reflections) {
    const int offset = static_cast<int>(whole.points.size());
    const Eigen::Matrix3f Q = reflection.Q.cast<float>();
    const Vec3f c = reflection.c.cast<float>();
    for (const Vec3f& x : piece.points) whole.points.push_back(Q * x + c);
    for (const Vec3f& n : piece.normals) whole.normals.push_back(Q * n);
    for (const auto& polygon : piece.polygons)
      append_flipped(whole.polygons, polygon, offset, reflection.flips);
  }
  return whole;
}

LineSet calc_reflected(const LineSet& piece, const std::vector<Reflection>& reflections) {
  LineSet whole;
  for (const Reflection& reflection : reflections) {
    const int offset = static_cast<int>(whole.points.size());
    for (const Vec3f& x : piece.points)
      whole.points.push_back(reflection.point(x.cast<double>()).cast<float>());
    for (const auto& line : piece.lines) whole.lines.push_back({line[0] + offset, line[1] + offset});
  }
  return whole;
}

}  // namespace hydroscope
