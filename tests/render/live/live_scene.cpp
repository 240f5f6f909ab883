// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/render/live/live_scene.h"

#include <cmath>
#include <cstdlib>

namespace hydroscope {

void fill_fields(Snapshot& s) {
  const std::size_t nodes = s.points.size();
  s.plastic_strain.assign(nodes, 0.0);
  s.contact_state.assign(nodes, ContactClass::kFree);
  s.contact_tool.assign(nodes, -1);
  s.gap.assign(nodes, std::nan(""));
  s.contact_pressure.assign(nodes, 0.0);
  s.contact_force.assign(nodes, Vec3::Zero());
  s.tool_normal.assign(nodes, Vec3::Zero());
  s.slip.assign(nodes, Vec3::Zero());
  s.slip_increment.assign(nodes, Vec3::Zero());
}

std::shared_ptr<Snapshot> FlatStrip::make() const {
  auto model = std::make_shared<SnapshotModel>();
  model->title = "Flat strip";
  model->mirrors = mirrors;
  auto s = std::make_shared<Snapshot>();
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) {
      s->points.push_back(Vec3(column, row, 0.0));
      s->directors.push_back(Vec3::UnitZ());
      s->thickness.push_back(thickness);
    }
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      model->quads.push_back(
          {node(column, row), node(column + 1, row), node(column + 1, row + 1), node(column, row + 1)});
  s->model = std::move(model);
  fill_fields(*s);
  return s;
}

LiveView make_front_view(int width, int height) {
  LiveView view;
  view.width = width;
  view.height = height;
  view.azimuth = 90.0;
  view.elevation = 0.0;
  view.has_text = false;
  return view;
}

namespace {

bool is_like(const std::uint8_t* a, const std::uint8_t* b, int tolerance) {
  for (int c = 0; c < 3; ++c)
    if (std::abs(a[c] - b[c]) > tolerance) return false;
  return true;
}

}  // namespace

int count_colour(const Image& image, Rgb colour, int tolerance) {
  int count = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    count += is_like(image.rgba.data() + i, colour.data(), tolerance) ? 1 : 0;
  return count;
}

int count_changed(const Image& a, const Image& b, int tolerance) {
  if (a.width != b.width || a.height != b.height) return -1;
  int count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4)
    count += is_like(a.rgba.data() + i, b.rgba.data() + i, tolerance) ? 0 : 1;
  return count;
}

}  // namespace hydroscope
