// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer_fingerprint.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>

#include "render/image/canvas.h"
#include "render/stage.h"

namespace hydroscope {
namespace {

constexpr int kWidth = 160, kHeight = 96;  // [px]

/// A bowl of which every facet has another light and another value of the map.
Surface make_bowl() {
  constexpr int kAround = 24, kRings = 12;
  Surface bowl;
  for (int j = 0; j <= kRings; ++j)
    for (int i = 0; i <= kAround; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / kAround, lean = 0.45 * std::numbers::pi * j / kRings;
      const Vec3 n(std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean));
      bowl.add_point(n, n);
      bowl.values.push_back(static_cast<float>(i + j));
    }
  for (int j = 0; j < kRings; ++j)
    for (int i = 0; i < kAround; ++i) {
      const int a = j * (kAround + 1) + i, b = a + kAround + 1;
      bowl.polygons.push_back({a, b, b + 1, a + 1});
    }
  return bowl;
}

Surface make_pane() {
  Surface pane;
  for (const auto& [x, y] : {std::array{0.1, -0.9}, {1.4, -0.7}, {1.2, 0.8}, {-0.1, 0.6}})
    pane.add_point({x, y, 1.2}, Vec3::UnitZ());
  pane.polygons.push_back({0, 1, 2, 3});
  return pane;
}

LineSet make_rays() {
  LineSet rays;
  for (int i = 0; i < 9; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / 9.0;
    rays.add_line({0.2 * std::cos(turn), 0.2 * std::sin(turn), 1.3},
                  {1.5 * std::cos(turn), 1.5 * std::sin(turn), 1.3});
  }
  return rays;
}

Image draw_probe(Stage& stage) {
  DrawList list;
  list.surfaces.push_back({.surface = std::make_shared<const Surface>(make_bowl()),
                           .table = &colour_table(MapName::kSea),
                           .range = {0.0, 36.0}});
  list.surfaces.push_back(
      {.surface = std::make_shared<const Surface>(make_pane()), .colour = {120, 130, 145}, .opacity = 0.35});
  list.lines.push_back(
      {.lines = std::make_shared<const LineSet>(make_rays()), .colour = {20, 20, 20}, .width = 1.3});
  CameraPose pose;
  pose.position = Vec3(1.0, 2.0, 9.0);
  pose.scale = 1.5;
  return stage.draw(list, pose, theme("light"));
}

Image draw_lettering() {
  Image image = make_image(kWidth, kHeight, {255, 255, 255});
  Canvas(image).text(4, 4, "Contact 0.123 [mm]", {.size = 14, .colour = {10, 10, 10}});
  Canvas(image).text(4, 40, "Slip 45", {.size = 25, .colour = {10, 10, 10}, .is_bold = true});
  return image;
}

/// FNV-1a, 64 bits.
std::string calc_hash(const Image& image) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const std::uint8_t byte : image.rgba) hash = (hash ^ byte) * 0x100000001b3U;
  std::array<char, 20> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

}  // namespace

RendererFingerprint calc_renderer_fingerprint(int rasteriser_threads) {
  Stage stage({.width = kWidth, .height = kHeight, .smoothing = 2, .rasteriser_threads = rasteriser_threads});
  return {stage.info(), lettering_font(), calc_hash(draw_probe(stage)), calc_hash(draw_lettering())};
}

}  // namespace hydroscope
