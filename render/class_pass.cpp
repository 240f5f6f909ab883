// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/class_pass.h"

#include <algorithm>
#include <utility>

#include "render/stage.h"
#include "render/views.h"

namespace hydroscope {
namespace {

constexpr int kSize = 768;  // [px] of a side: a few pixels a node for meshes of 100 x 100 quads

/// Node numbers as colours; black is the ground, so they start at one.
Rgb make_node_colour(std::size_t node) {
  const std::size_t code = node + 1;
  return {static_cast<std::uint8_t>(code >> 16U), static_cast<std::uint8_t>(code >> 8U),
          static_cast<std::uint8_t>(code)};
}

/// -1 for the ground.
int read_node(const std::uint8_t* pixel) { return (pixel[0] << 16) + (pixel[1] << 8) + pixel[2] - 1; }

/// -1 for the ground, and for a colour that no class has.
int read_class(const std::uint8_t* pixel) {
  for (int c = 0; c < kContactClasses; ++c)
    if (class_colour(static_cast<ContactClass>(c)) == Rgb{pixel[0], pixel[1], pixel[2]}) return c;
  return -1;
}

/// Straight from outside onto a node, with the whole sheet in the picture.
CameraPose make_pose(const Bounds& bounds, const Vec3& director) {
  CameraPose pose;
  pose.focal = bounds.centre();
  pose.position = pose.focal + 4.0 * bounds.diagonal() * director;
  pose.up = std::abs(director.y()) > 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  pose.scale = 0.51 * bounds.diagonal();
  return pose;
}

Theme make_black_ground() {
  Theme theme = hydroscope::theme("light");
  theme.background_top = theme.background_bottom = {0, 0, 0};
  return theme;
}

FrameOptions make_options() {
  FrameOptions options;
  options.views = {"contact-map"};
  options.size = {kSize, kSize};
  options.is_flat = true;
  options.is_mirrored = false;
  return options;
}

}  // namespace

struct ClassPass::Impl {
  explicit Impl(int rasteriser_threads)
      : stage({.width = kSize,
               .height = kSize,
               .smoothing = 1,
               .is_flat = true,
               .rasteriser_threads = rasteriser_threads}) {}

  Stage stage;
  Theme ground = make_black_ground();
};

ClassPass::ClassPass(int rasteriser_threads) : impl_(std::make_unique<Impl>(rasteriser_threads)) {}
ClassPass::~ClassPass() = default;

std::vector<ClassPicture> ClassPass::draw(const Snapshot& snapshot) {
  Views views(snapshot, make_options());
  NodePaint numbers;
  for (std::size_t node = 0; node < snapshot.points.size(); ++node)
    numbers.colours.push_back(make_node_colour(node));
  const SheetShape sheet(snapshot, false);
  DrawList numbered;
  numbered.surfaces.push_back({.surface = std::make_shared<const Surface>(sheet.make_wall(snapshot, numbers)),
                               .faces = SurfaceItem::Faces::kFront});
  const Bounds bounds = calc_bounds(snapshot, {Reflection{}});
  std::vector<char> is_seen(snapshot.points.size(), 0), was_tried = is_seen;
  std::vector<ClassPicture> pictures;
  // The middle node first: on a sector it sees most of the others.
  std::size_t next = snapshot.points.size() / 2;
  while (next < is_seen.size() && pictures.size() < kMostPictures) {
    was_tried[next] = 1;
    const CameraPose pose = make_pose(bounds, snapshot.directors[next]);
    ClassPicture picture;
    picture.classes =
        impl_->stage.draw(views.make_draw_list("contact-map", snapshot, pose, {}), pose, impl_->ground, 0);
    picture.nodes = impl_->stage.draw(numbered, pose, impl_->ground, 1);
    for (std::size_t i = 0; i < picture.nodes.rgba.size(); i += 4)
      if (const int node = read_node(picture.nodes.rgba.data() + i); node >= 0 && node < std::ssize(is_seen))
        is_seen[static_cast<std::size_t>(node)] = 1;
    pictures.push_back(std::move(picture));
    for (next = 0; next < is_seen.size() && (is_seen[next] != 0 || was_tried[next] != 0);) ++next;
  }
  return pictures;
}

ClassAgreement read_class_pictures(const std::vector<ClassPicture>& pictures, const Snapshot& solved) {
  const std::size_t nodes = solved.points.size();
  std::vector<std::array<int, kContactClasses + 1>> votes(nodes);  // the last: no class at all
  long sheet = 0, stray = 0;
  for (const ClassPicture& picture : pictures)
    for (std::size_t i = 0; i < picture.nodes.rgba.size(); i += 4) {
      const int node = read_node(picture.nodes.rgba.data() + i);
      const int shown = read_class(picture.classes.rgba.data() + i);
      if (node < 0 && shown < 0) continue;
      ++sheet;
      if (node < 0 || static_cast<std::size_t>(node) >= nodes) {
        ++stray;
        continue;
      }
      const auto at = static_cast<std::size_t>(node);
      ++votes[at][static_cast<std::size_t>(shown < 0 ? kContactClasses : shown)];
      stray += shown == static_cast<int>(solved.contact_state[at]) ? 0 : 1;
    }
  ClassAgreement agreement;
  agreement.nodes = static_cast<int>(nodes);
  agreement.stray_share = sheet > 0 ? static_cast<double>(stray) / static_cast<double>(sheet) : 0.0;
  for (std::size_t node = 0; node < nodes; ++node) {
    const auto most = std::max_element(votes[node].begin(), votes[node].end());
    const auto drawn = static_cast<std::size_t>(most - votes[node].begin());
    const auto wanted = static_cast<std::size_t>(solved.contact_state[node]);
    // A node of which the class picture shows nothing is not drawn.
    if (*most == 0 || drawn == kContactClasses) {
      ++agreement.unseen;
      if (*most > 0) agreement.wrong.push_back(static_cast<int>(node));
      continue;
    }
    ++agreement.drawn[drawn];
    ++agreement.solved[wanted];
    if (drawn != wanted) agreement.wrong.push_back(static_cast<int>(node));
  }
  return agreement;
}

}  // namespace hydroscope
