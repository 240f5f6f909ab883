// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tool_picture.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "render/camera.h"
#include "render/image/png_file.h"
#include "render/overlay.h"
#include "render/shape/arrows.h"
#include "render/shape/tool_shape.h"
#include "render/stage.h"
#include "render/view_text.h"
#include "render/views.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr Rgb kHighlight{213, 94, 0};
constexpr Rgb kNormal{0, 114, 178};
constexpr int kMostArrows = 600;

/// The highlighted facets alone, or all but them.
Surface calc_selected(const Surface& all, const std::vector<bool>& is_highlighted, bool wanted) {
  Surface selected = all;
  selected.polygons.clear();
  for (std::size_t f = 0; f < all.polygons.size(); ++f)
    if (is_highlighted[f] == wanted) selected.polygons.push_back(all.polygons[f]);
  if (wanted) selected.values.clear();
  return selected;
}

/// The direction, of eight around the wished one and from below, from which most
/// of the working side is seen.
std::array<double, 2> find_direction(const ToolShape& shape, const ToolPictureOptions& options) {
  std::array<double, 2> best{options.azimuth, options.elevation};
  double most = -1.0;
  for (double elevation : {options.elevation, -options.elevation})
    for (double turn : {0.0, 90.0, 180.0, 270.0}) {
      const double a = (options.azimuth + turn) * std::numbers::pi / 180.0;
      const double e = elevation * std::numbers::pi / 180.0;
      const Vec3 direction(std::cos(a) * std::cos(e), std::sin(e), std::sin(a) * std::cos(e));
      double seen = 0.0;
      for (std::size_t f = 0; f < shape.facet_normals().size(); ++f)
        seen += std::max(0.0, shape.calc_facet_area(f) * shape.facet_normals()[f].dot(direction));
      if (seen <= most * 1.05) continue;  // only a clear gain is worth another side
      most = seen;
      best = {options.azimuth + turn, elevation};
    }
  return best;
}

DrawList make_tool_list(const ToolShape& shape, const std::vector<int>& highlighted_facets,
                        const Bounds& bounds, const Theme& colours) {
  std::vector<bool> is_highlighted(shape.mesh().triangles.size(), false);
  for (int facet : highlighted_facets) {
    require(facet >= 0 && static_cast<std::size_t>(facet) < is_highlighted.size(),
            "highlighted facet out of range");
    is_highlighted[static_cast<std::size_t>(facet)] = true;
  }
  const Surface all = shape.make_surface(Vec3::Zero());
  const ColourTable& table = colour_table(MapName::kEmber);
  const Range range = calc_round_range({0.0, shape.largest_angle()});
  std::vector<Arrow> arrows;
  const double size = 0.035 * bounds.diagonal();
  for (int node : find_spread_points(shape.mesh().points, kMostArrows)) {
    const auto i = static_cast<std::size_t>(node);
    arrows.push_back({.start = shape.mesh().points[i], .span = size * shape.normals()[i]});
  }
  const auto share = [](auto value) { return std::make_shared<const decltype(value)>(std::move(value)); };
  DrawList list;
  const auto plain = share(calc_selected(all, is_highlighted, false));
  // Walls seen from behind are ghosts, so that one can look into a closed die.
  list.surfaces = {
      {.surface = plain, .table = &table, .range = range, .faces = SurfaceItem::Faces::kFront},
      {.surface = share(calc_selected(all, is_highlighted, true)), .colour = kHighlight},
      {.surface = share(make_arrows(arrows, 0.2 * size, {Reflection{}})), .colour = kNormal},
      {.surface = plain, .colour = colours.tool, .opacity = 0.16, .faces = SurfaceItem::Faces::kBack}};
  list.lines = {{.lines = share(shape.make_facet_edges(Vec3::Zero())),
                 .colour = colours.line,
                 .width = 0.6,
                 .opacity = 0.35},
                {.lines = share(shape.make_edges(Vec3::Zero())), .colour = colours.line, .width = 1.6}};
  list.legend.heading = "Tool";
  list.legend.bars = {{"normal angle [°]", &table, range}};
  list.legend.swatches = {{kNormal, "continuous normal"}};
  if (!highlighted_facets.empty())
    list.legend.swatches.push_back(
        {kHighlight, "reported facets  " + std::to_string(highlighted_facets.size())});
  return list;
}

}  // namespace

void render_tool_picture(const TriangleMesh& mesh, const std::vector<Vec3>& normals,
                         const std::vector<int>& highlighted_facets, const std::string& title,
                         const std::string& file, const ToolPictureOptions& options) {
  const Theme& colours = theme(options.theme);
  const ToolShape shape({.name = title, .mesh = mesh, .normals = normals}, {});
  Bounds bounds;
  for (const Vec3& x : mesh.points) bounds.include(x);
  require(!mesh.points.empty(), "a tool has points");
  FrameOptions view;
  view.size = options.size;
  const std::array<double, 2> direction = find_direction(shape, options);
  view.azimuth = direction[0];
  view.elevation = direction[1];
  CameraPose camera = calc_camera(view, bounds, std::nullopt, 0, 1);
  // The picture moves up and shrinks by what the report takes below it.
  const double report = calc_report_height(static_cast<int>(options.notes.size()));
  require(report < 0.8, "a tool picture's notes leave room for the tool");
  camera.scale /= 1.0 - report;
  const Vec3 shift = -report * camera.scale * camera.up;
  camera.focal += shift;
  camera.position += shift;
  DrawList list = make_tool_list(shape, highlighted_facets, bounds, colours);
  Stage stage({.width = options.size[0], .height = options.size[1]});
  Image image = stage.draw(list, camera, colours);
  const std::string counts =
      std::to_string(mesh.triangles.size()) + " facets, " + std::to_string(mesh.points.size()) + " points";
  draw_overlay(image, list.legend, title, counts, camera, colours);
  draw_report(image, options.notes, colours);
  write_png(file, image,
            {{"Renderer", stage.info().renderer}, {"Software", "Hydroscope " HYDROSCOPE_VERSION}});
}

}  // namespace hydroscope
