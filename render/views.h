// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "render/contact_life.h"
#include "render/frame_options.h"
#include "render/shape/tool_shape.h"
#include "render/view_range.h"

namespace hydroscope {

/// What one sequence draws: a tool whose translation is not a number has been
/// taken away and is not drawn. Turns snapshots into draw lists. Knows no GL.
class Views {
 public:
  Views(const Snapshot& first, const FrameOptions& options);

  /// Throws InputError for an unknown view, ContractError for a missing range.
  /// `since`: see calc_contact_life().
  DrawList make_draw_list(const std::string& view, const Snapshot& snapshot, const CameraPose& camera,
                          const std::map<std::string, Range>& ranges,
                          double since = std::numeric_limits<double>::quiet_NaN());
  /// The same with a cut of the tools that is set.
  DrawList make_draw_list(const std::string& view, const Snapshot& snapshot, const CameraPose& camera,
                          const std::map<std::string, Range>& ranges, const Plane& cut,
                          double since = std::numeric_limits<double>::quiet_NaN());

  /// Cuts everything in the list by a plane and shows where it cuts the wall and the tools. The list may be
  /// one of any snapshot of the sequence.
  void add_clip(DrawList& list, const std::string& view, const Snapshot& snapshot, const Plane& plane) const;

  /// Rings around nodes, `pixel` [mm] being one of a picture of 720 rows, on the face that is turned to the
  /// viewer, and around all mirror images. Those beyond the list's clip plane are left out.
  void add_marks(DrawList& list, const std::vector<int>& nodes, const Snapshot& snapshot,
                 const Vec3& towards_viewer, double pixel) const;

  /// Mean length of an element edge [mm].
  double calc_edge_length(const Snapshot& snapshot) const { return sheet_.calc_edge_length(snapshot); }

  /// What the camera holds: see FrameOptions::bounds.
  const Bounds& bounds() const { return bounds_; }

  /// Widens the bounds when the sheet has left them, by a little more than needed, so that
  /// the camera of a sequence whose end is not known yet moves seldom. Given bounds stay as they are.
  void hold(const Snapshot& snapshot);

  /// Other colours, edges, arrows, opacity and cuts from now on; mirror images and bounds stay.
  void restyle(const FrameOptions& options);

 private:
  struct ToolState {
    explicit ToolState(ToolShape given) : shape(std::move(given)) {}

    ToolShape shape;
    bool is_there = false;  ///< not taken away: its translation is a number
    Vec3 translation = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    std::shared_ptr<const Surface> surface, normal_arrows, facet_arrows;
    std::shared_ptr<const LineSet> edges, facet_edges, section;
    Plane cut;
    std::vector<int> arrow_nodes, arrow_facets;
  };

  std::vector<std::reference_wrapper<const ToolState>> present_tools() const;
  /// Which nodes get arrows, and how long they are; again only where the options say something else.
  void choose_arrows();
  void update_tools(const Snapshot& snapshot, const Plane& cut);
  void make_normal_arrows(ToolState& tool, const Plane& cut) const;
  void add_wall(DrawList& list, const Snapshot& snapshot, const std::optional<NodePaint>& paint) const;
  void add_tools(DrawList& list) const;
  void draw_contact_map(DrawList& list, const Snapshot& snapshot) const;
  void draw_tool_normals(DrawList& list, const Snapshot& snapshot) const;
  void draw_slip(DrawList& list, const Snapshot& snapshot, const std::map<std::string, Range>& ranges) const;
  void draw_detachment(DrawList& list, const Snapshot& snapshot, const ContactLife& life,
                       const Range& range) const;
  void draw_chatter(DrawList& list, const Snapshot& snapshot, const ContactLife& life) const;
  void draw_release_margin(DrawList& list, const Snapshot& snapshot, const ContactLife& life,
                           const Range& range) const;
  void add_nearest(DrawList& list, const Snapshot& snapshot, const ContactLife& life,
                   double picture_scale) const;
  /// On the face that meets the tool, `height` [mm] above it.
  static Vec3 calc_outer_place(const Snapshot& snapshot, int node, double height);
  void draw_scalar(DrawList& list, const std::string& view, const Snapshot& snapshot,
                   const Range& range) const;

  FrameOptions options_;
  const Theme* theme_;
  SheetShape sheet_;
  std::vector<ToolState> tools_;
  std::vector<Vec3> first_points_;
  std::vector<int> arrow_nodes_;
  int arrows_chosen_ = -1;
  double arrow_scale_ = 0.0;
  Bounds bounds_;
  double sheet_size_ = 0.0;  ///< diagonal of the first sheet's box [mm]
  double arrow_size_ = 0.0;  ///< length of the longest arrow [mm]
  double largest_angle_ = 0.0;
};

}  // namespace hydroscope
