// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/views.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/camera.h"
#include "render/shape/arrows.h"
#include "render/view_text.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

MapName find_map(const std::string& view) {
  return view == "thickness" || view == "gap" ? MapName::kDusk : MapName::kSea;
}

std::shared_ptr<const Surface> share(Surface surface) {
  return std::make_shared<const Surface>(std::move(surface));
}
std::shared_ptr<const LineSet> share(LineSet lines) {
  return std::make_shared<const LineSet>(std::move(lines));
}

/// The camera need not hold the far ends of tools that are much larger than the sheet.
Bounds calc_scene_bounds(const Bounds& sheet, const std::vector<const ToolShape*>& tools) {
  Bounds box = sheet;
  const Vec3 margin = (0.35 * (sheet.greatest - sheet.least)).cwiseMax(0.05 * sheet.diagonal());
  const Vec3 least = sheet.least - margin, greatest = sheet.greatest + margin;
  for (const ToolShape* tool : tools)
    for (const Reflection& reflection : tool->reflections())
      for (const Vec3& x : tool->mesh().points)
        box.include(reflection.point(x).cwiseMax(least).cwiseMin(greatest));
  if (tools.empty()) {  // a free bulge grows: keep room for it
    box.include(sheet.least - 0.2 * margin);
    box.include(sheet.greatest + 0.2 * margin);
  }
  return box;
}

/// Whether the sheet is out of the box by more than the eye forgives.
bool has_left(const Bounds& sheet, const Bounds& box) {
  const double margin = 0.01 * box.diagonal();
  return ((box.least - sheet.least).array() > margin).any() ||
         ((sheet.greatest - box.greatest).array() > margin).any();
}

}  // namespace

void Views::hold(const Snapshot& snapshot) {
  if (options_.bounds) return;
  const Bounds sheet = calc_bounds(snapshot, sheet_.reflections());
  if (!has_left(sheet, bounds_)) return;
  const Vec3 more =
      0.3 * ((bounds_.least - sheet.least).cwiseMax(0.0) + (sheet.greatest - bounds_.greatest).cwiseMax(0.0));
  const Bounds before = bounds_;
  for (int axis = 0; axis < 3; ++axis) {
    if (sheet.least[axis] < before.least[axis]) bounds_.least[axis] = sheet.least[axis] - more[axis];
    if (sheet.greatest[axis] > before.greatest[axis])
      bounds_.greatest[axis] = sheet.greatest[axis] + more[axis];
  }
}

Views::Views(const Snapshot& first, const FrameOptions& options)
    : options_(options), theme_(&hydroscope::theme(options.theme)), sheet_(first, options.is_mirrored) {
  for (const std::string& view : options.views)
    if (std::find(view_names().begin(), view_names().end(), view) == view_names().end())
      throw InputError("view '" + view + "' is unknown; there are " + join(view_names()));
  const std::vector<Plane> mirrors = options.is_mirrored ? first.model->mirrors : std::vector<Plane>{};
  for (const SnapshotModel::Tool& tool : first.model->tools) {
    tools_.emplace_back(ToolShape(tool, mirrors));
    largest_angle_ = std::max(largest_angle_, tools_.back().shape.largest_angle());
  }
  first_points_ = first.points;
  const Bounds sheet_bounds = calc_bounds(first, sheet_.reflections());
  std::vector<const ToolShape*> shapes;
  for (const ToolState& tool : tools_) shapes.push_back(&tool.shape);
  bounds_ = options.bounds.value_or(calc_scene_bounds(sheet_bounds, shapes));
  if (options.later_sheet && !options.bounds && has_left(*options.later_sheet, bounds_)) {
    bounds_.include(options.later_sheet->least);
    bounds_.include(options.later_sheet->greatest);
  }
  sheet_size_ = sheet_bounds.diagonal();
}

void Views::choose_arrows() {
  if (arrows_chosen_ == options_.most_arrows && arrow_scale_ == options_.arrow_scale) return;
  arrows_chosen_ = options_.most_arrows;
  arrow_scale_ = options_.arrow_scale;
  for (ToolState& tool : tools_) {
    const int copies = static_cast<int>(tool.shape.reflections().size());
    const int share_of_arrows = std::max(1, options_.most_arrows / copies / static_cast<int>(tools_.size()));
    tool.normal_arrows = nullptr;
    tool.arrow_nodes.clear();
    tool.arrow_facets.clear();
    if (options_.most_arrows == 0) continue;
    tool.arrow_nodes = find_spread_points(tool.shape.mesh().points, share_of_arrows);
    tool.arrow_facets = find_spread_points(tool.shape.calc_facet_centres(), share_of_arrows);
  }
  arrow_nodes_.clear();
  if (options_.most_arrows > 0)
    arrow_nodes_ = find_spread_points(first_points_,
                                      options_.most_arrows / static_cast<int>(sheet_.reflections().size()));
  arrow_size_ = 0.05 * sheet_size_ * options_.arrow_scale;
}

void Views::restyle(const FrameOptions& options) {
  require(options.is_mirrored == options_.is_mirrored, "mirror images belong to what a view is made with");
  const bool has_other_cut = options.is_tool_cut != options_.is_tool_cut;
  options_ = options;
  theme_ = &hydroscope::theme(options.theme);
  if (has_other_cut)
    for (ToolState& tool : tools_) tool.cut.point.setConstant(std::numeric_limits<double>::quiet_NaN());
}

void Views::make_normal_arrows(ToolState& tool, const Plane& cut) const {
  const bool is_cut = options_.is_tool_cut;
  std::vector<Arrow> nodes, facets;
  const auto centres = tool.shape.calc_facet_centres();
  // Reflected here, not as a finished shape: which arrows the cut takes differs from copy to copy.
  for (const Reflection& reflection : tool.shape.reflections()) {
    const auto add = [&](std::vector<Arrow>& arrows, const Vec3& x, const Vec3& n) {
      const Vec3 start = reflection.point(x + tool.translation);
      if (is_cut && cut.normal.dot(start - cut.point) > 0.0) return;
      arrows.push_back({.start = start, .span = 0.5 * arrow_size_ * reflection.vector(n)});
    };
    for (int node : tool.arrow_nodes)
      add(nodes, tool.shape.mesh().points[at(node)], tool.shape.normals()[at(node)]);
    if (!options_.facet_normals) continue;
    for (int facet : tool.arrow_facets)
      add(facets, centres[at(facet)], tool.shape.facet_normals()[at(facet)]);
  }
  tool.normal_arrows = share(make_arrows(nodes, 0.1 * arrow_size_, {Reflection{}}));
  tool.facet_arrows = share(make_arrows(facets, 0.1 * arrow_size_, {Reflection{}}));
}

void Views::update_tools(const Snapshot& snapshot, const Plane& cut) {
  // In a close-up a gap must not look larger than it is.
  const double set_back = options_.pose ? 0.01 * options_.pose->scale : 2e-3 * bounds_.diagonal();
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    ToolState& tool = tools_[i];
    tool.is_there = snapshot.tool_translation[i].allFinite();
    if (!tool.is_there) continue;
    const bool has_moved = !(tool.translation == snapshot.tool_translation[i]);
    const bool has_new_cut = !(tool.cut.normal == cut.normal && tool.cut.point == cut.point);
    tool.translation = snapshot.tool_translation[i];
    tool.cut = cut;
    if (has_moved) {
      tool.surface = share(tool.shape.make_surface(tool.translation, set_back));
      tool.edges = share(tool.shape.make_edges(tool.translation));
      tool.facet_edges = share(tool.shape.make_facet_edges(tool.translation));
    }
    if (has_moved || has_new_cut) {
      // Just behind the cut: on a plane of symmetry the mesh's own edges would only graze it.
      const Plane behind{cut.point - 1e-4 * bounds_.diagonal() * cut.normal, cut.normal};
      tool.section =
          share(options_.is_tool_cut ? tool.shape.make_section(tool.translation, behind) : LineSet{});
      tool.normal_arrows = nullptr;
    }
  }
}

std::vector<std::reference_wrapper<const Views::ToolState>> Views::present_tools() const {
  std::vector<std::reference_wrapper<const ToolState>> present;
  for (const ToolState& tool : tools_)
    if (tool.is_there) present.push_back(tool);
  return present;
}

void Views::add_wall(DrawList& list, const Snapshot& snapshot, const std::optional<NodePaint>& paint) const {
  // A closed solid: its polygons are seen from outside or not at all.
  list.surfaces.push_back({.surface = share(sheet_.make_wall(snapshot, paint, options_.is_coarse)),
                           .colour = theme_->sheet,
                           .faces = SurfaceItem::Faces::kFront});
  if (options_.is_flat) return;
  list.lines.push_back({.lines = share(sheet_.make_rim(snapshot)), .colour = theme_->line, .width = 1.3});
  if (options_.element_edges)
    list.lines.push_back({.lines = share(sheet_.make_element_edges(snapshot, options_.is_coarse)),
                          .colour = theme_->line,
                          .width = 0.7,
                          .opacity = 0.45});
}

void Views::add_tools(DrawList& list) const {
  if (options_.is_flat || options_.tool_opacity == 0.0) return;
  using Faces = SurfaceItem::Faces;
  // First the walls seen from the sheet's side, then those seen from behind,
  // which are nearer: so each pixel blends in the right order without sorting.
  for (const Faces faces : {Faces::kFront, Faces::kBack})
    for (const ToolState& tool : present_tools())
      list.surfaces.push_back(
          {.surface = tool.surface,
           .colour = theme_->tool,
           .opacity = faces == Faces::kFront ? options_.tool_opacity : 0.5 * options_.tool_opacity,
           .faces = faces,
           .is_cut = options_.is_tool_cut});
  for (const ToolState& tool : present_tools()) {
    if (options_.feature_edges)
      list.lines.push_back(
          {.lines = tool.edges, .colour = theme_->tool_line, .width = 1.0, .is_cut = options_.is_tool_cut});
    list.lines.push_back({.lines = tool.section, .colour = theme_->line, .width = 2.0});
  }
}

void Views::draw_contact_map(DrawList& list, const Snapshot& snapshot) const {
  list.legend.heading = "Contact map";
  const ClassCounts counts = count_classes(snapshot);
  for (int c = 0; c < kContactClasses; ++c) {
    const auto contact_class = static_cast<ContactClass>(c);
    list.legend.swatches.push_back(
        {class_colour(contact_class),
         std::string(class_name(contact_class)) + "  " + std::to_string(counts.nodes[at(c)])});
  }
  list.legend.notes.push_back("nodes of the model");
  add_wall(list, snapshot, NodePaint{.values = {}, .classes = snapshot.contact_state});
  add_tools(list);
}

void Views::draw_tool_normals(DrawList& list, const Snapshot& snapshot) const {
  list.legend.heading = "Tool normals";
  if (tools_.empty()) {
    list.legend.notes.push_back("no tools");
    add_wall(list, snapshot, std::nullopt);
    return;
  }
  const ColourTable& table = colour_table(MapName::kEmber);
  const Range range = calc_round_range({0.0, largest_angle_});
  list.legend.bars.push_back({"normal angle [°]", &table, range});
  list.legend.notes = {"angle between facet", "and continuous normal"};
  for (const ToolState& tool : present_tools()) {
    const bool is_cut = options_.is_tool_cut;
    list.surfaces.push_back({.surface = tool.surface, .table = &table, .range = range, .is_cut = is_cut});
    list.surfaces.push_back({.surface = tool.normal_arrows,
                             .colour = class_colour(ContactClass::kStick),
                             .faces = SurfaceItem::Faces::kFront});
    if (options_.facet_normals)
      list.surfaces.push_back(
          {.surface = tool.facet_arrows, .colour = {0, 158, 115}, .faces = SurfaceItem::Faces::kFront});
    if (options_.is_flat) continue;
    list.lines.push_back(
        {.lines = tool.facet_edges, .colour = theme_->line, .width = 0.6, .opacity = 0.3, .is_cut = is_cut});
    if (options_.feature_edges)
      list.lines.push_back({.lines = tool.edges, .colour = theme_->line, .width = 1.2, .is_cut = is_cut});
    list.lines.push_back({.lines = tool.section, .colour = theme_->line, .width = 2.0});
  }
  list.legend.swatches.push_back({class_colour(ContactClass::kStick), "continuous normal"});
  if (options_.facet_normals) list.legend.swatches.push_back({{0, 158, 115}, "facet normal"});
  if (!options_.is_flat)
    list.lines.push_back(
        {.lines = share(sheet_.make_rim(snapshot)), .colour = theme_->faint_text, .width = 1.3});
}

void Views::draw_slip(DrawList& list, const Snapshot& snapshot,
                      const std::map<std::string, Range>& ranges) const {
  list.legend.heading = "Slip";
  const Range range = ranges.at("slip"), step_range = ranges.at("slip-increment");
  const ColourTable& table = colour_table(MapName::kEmber);
  list.legend.bars.push_back({"sliding distance [mm]", &table, range});
  std::vector<Arrow> accumulated, incremental;
  const double width = 0.2 * arrow_size_;
  for (int node : arrow_nodes_) {
    const std::size_t i = at(node);
    const Vec3 start = calc_outer_place(snapshot, node, 0.3 * width);
    const Vec3 out = (start - snapshot.points[i]).normalized();
    accumulated.push_back({start, arrow_size_ / range.high * snapshot.slip[i], snapshot.slip[i].norm()});
    // Beside the other arrow, which mostly points the same way.
    const Vec3 beside = width * out.cross(snapshot.slip_increment[i]).normalized();
    incremental.push_back({start + beside, 0.6 * arrow_size_ / step_range.high * snapshot.slip_increment[i]});
  }
  add_wall(list, snapshot, std::nullopt);
  list.surfaces.push_back({.surface = share(make_arrows(accumulated, width, sheet_.reflections())),
                           .table = &table,
                           .range = range,
                           .faces = SurfaceItem::Faces::kFront});
  list.surfaces.push_back({.surface = share(make_arrows(incremental, 0.7 * width, sheet_.reflections())),
                           .colour = class_colour(ContactClass::kStick),
                           .faces = SurfaceItem::Faces::kFront});
  add_tools(list);
  list.legend.swatches.push_back({class_colour(ContactClass::kStick), "last increment"});
  list.legend.notes.push_back("longest arrows: " + format_number(range.high) + " mm in all,");
  list.legend.notes.push_back(format_number(step_range.high) + " mm in the increment");
}

void Views::draw_scalar(DrawList& list, const std::string& view, const Snapshot& snapshot,
                        const Range& range) const {
  const ViewText text = find_view_text(view);
  list.legend.heading = text.heading;
  const ColourTable& table = colour_table(find_map(view));
  const std::vector<double> field = calc_field(view, snapshot);
  list.legend.bars.push_back({text.quantity, &table, range});
  const int without = count_without_value(view, snapshot);
  if (without > 0) list.legend.swatches.push_back({kNoValueColour, "no value  " + std::to_string(without)});
  NodePaint paint{.values = field, .classes = {}};
  // An infinite value has no place on the map either.
  for (double& value : paint.values)
    if (!std::isfinite(value)) value = std::numeric_limits<double>::quiet_NaN();
  add_wall(list, snapshot, paint);
  list.surfaces.back().table = &table;
  list.surfaces.back().range = range;
  add_tools(list);
}

DrawList Views::make_draw_list(const std::string& view, const Snapshot& snapshot, const CameraPose& camera,
                               const std::map<std::string, Range>& ranges, double since) {
  return make_draw_list(view, snapshot, camera, ranges, calc_cut(options_, camera, bounds_), since);
}

DrawList Views::make_draw_list(const std::string& view, const Snapshot& snapshot, const CameraPose& camera,
                               const std::map<std::string, Range>& ranges, const Plane& cut, double since) {
  check_snapshot(snapshot);
  require(snapshot.tool_translation.size() == tools_.size(), "the tools of a sequence stay the same");
  for (const std::string& name : range_names(view)) {
    const auto range = ranges.find(name);
    if (range == ranges.end() || !(range->second.low < range->second.high))
      throw ContractError("view '" + view + "' needs a range '" + name + "' that is not empty");
  }
  DrawList list;
  list.cut = cut;
  if (view == "tool-normals" || view == "slip") choose_arrows();
  update_tools(snapshot, *list.cut);
  if (view == "contact-map") {
    draw_contact_map(list, snapshot);
  } else if (view == "tool-normals") {
    for (ToolState& tool : tools_)
      if (tool.is_there && tool.normal_arrows == nullptr) make_normal_arrows(tool, *list.cut);
    draw_tool_normals(list, snapshot);
  } else if (view == "slip") {
    draw_slip(list, snapshot, ranges);
  } else if (view == "chatter") {
    draw_chatter(list, snapshot, calc_contact_life(snapshot, since));
  } else if (view == "detachment" || view == "release-margin") {
    const ContactLife life = calc_contact_life(snapshot, since);
    if (view == "detachment") draw_detachment(list, snapshot, life, ranges.at(view));
    if (view == "release-margin") draw_release_margin(list, snapshot, life, ranges.at(view));
    add_nearest(list, snapshot, life, camera.scale);
  } else {
    draw_scalar(list, view, snapshot, ranges.at(view));
  }
  return list;
}

}  // namespace hydroscope
