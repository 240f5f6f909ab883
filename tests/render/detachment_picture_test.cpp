// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and sidecars of the views of detachment; what the camera holds; lettering that keeps apart.
#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "render/frame_painter.h"
#include "render/frame_sequence.h"
#include "render/image/png_file.h"
#include "tests/render/synthetic.h"
#include "tests/temporary_folder.h"

namespace hydroscope {
namespace {

constexpr Rgb kNow{213, 94, 0};  // vermillion, of what has just let go

int count_colour(const Image& image, Rgb colour) {
  int count = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    if (Rgb{image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]} == colour) ++count;
  return count;
}

std::string find_value(const std::string& json, const std::string& key) {
  const std::string start = "\"" + key + "\": ";
  const std::size_t at = json.find(start);
  if (at == std::string::npos) return "missing";
  const std::size_t from = at + start.size();
  const std::string line = json.substr(from, json.find('\n', from) - from);
  return line.ends_with(',') ? line.substr(0, line.size() - 1) : line;
}

std::vector<double> find_numbers(const std::string& json, const std::string& key) {
  std::string list = find_value(json, key);
  for (char& c : list)
    if (c == '[' || c == ']' || c == ',') c = ' ';
  std::istringstream stream(list);
  std::vector<double> numbers;
  for (double number; stream >> number;) numbers.push_back(number);
  return numbers;
}

class DetachmentPicture : public testing::Test {
 protected:
  DetachmentPicture() {
    options.size = {320, 180};
    options.views = {"detachment"};
    options.is_flat = true;
  }
  /// Nothing touches; node 5 * 21, on the flat that faces the camera, let go at 0.4 s, its neighbour at 0.9
  /// s.
  std::shared_ptr<Snapshot> make(double time) {
    auto s = bulge.make_snapshot(model, 0.7, 3);
    const std::size_t nodes = s->points.size();
    s->time = time;
    s->contact_state.assign(nodes, ContactClass::kFree);
    s->contact_tool.assign(nodes, -1);
    s->contact_force.assign(nodes, Vec3::Zero());
    s->let_go_time.assign(nodes, std::nan(""));
    s->toggles.assign(nodes, 0);
    s->release_reference.assign(nodes, 0.0);
    s->release_threshold.assign(nodes, 0.0);
    for (std::size_t k = 0; k < 2; ++k) {
      if (time < moments[k]) continue;
      s->let_go_time[5 * 21 + k] = moments[k];
      s->toggles[5 * 21 + k] = 1;
    }
    return s;
  }

  SyntheticBulge bulge;
  std::shared_ptr<const SnapshotModel> model = bulge.make_model();
  const std::array<double, 2> moments{0.4, 0.9};
  FrameOptions options;
};

TEST_F(DetachmentPicture, WhatLetGoSinceTheFrameBeforeIsHighlightedOnce) {
  FramePainter painter(options);
  const std::map<std::string, Range> ranges{{"detachment", {0, 1}}};
  const auto paint = [&](double time, int index) {
    return painter.paint("detachment", *make(time), {index, 4}, ranges);
  };
  EXPECT_EQ(count_colour(paint(0.2, 0).image, kNow), 0);
  const Frame first = paint(0.5, 1);
  EXPECT_GT(count_colour(first.image, kNow), 5);
  EXPECT_EQ(find_value(first.sidecar, "let_go_in_frame"), "1");
  const Frame second = paint(1.0, 2);
  EXPECT_GT(count_colour(second.image, kNow), 5) << "the neighbour";
  EXPECT_EQ(find_value(second.sidecar, "let_go_in_frame"), "1");
  EXPECT_EQ(find_value(second.sidecar, "let_go_before"), "1");
  EXPECT_EQ(find_value(second.sidecar, "toggles"), "2");
  // Described again, a frame says the same.
  EXPECT_EQ(find_value(painter.describe("detachment", *make(1.0), {2, 4}, ranges), "let_go_in_frame"), "1");
  EXPECT_EQ(count_colour(paint(1.1, 3).image, kNow), 0);
}

TEST_F(DetachmentPicture, ASequenceAndItsSidecars) {
  const TemporaryFolder folder;
  options.views = {"detachment", "chatter", "release-margin"};
  options.animation = "none";
  FrameSequence sequence(options, folder.path());
  for (const double time : {0.2, 0.5, 1.0}) sequence.submit(make(time), 3);
  EXPECT_EQ(sequence.finish().frames, 3);
  for (const std::string& view : options.views) {
    const std::string path = folder.path().string() + "/" + view;
    EXPECT_EQ(find_value(read_text(path + "/00001.json"), "let_go_in_frame"), "0") << view;
    EXPECT_EQ(find_value(read_text(path + "/00003.json"), "let_go_in_frame"), "1") << view;
    EXPECT_EQ(find_value(read_text(path + "/00003.json"), "nearest_node"), "-1") << view;
    EXPECT_GT(read_png(path + "/00003.png").image.width, 0);
  }
}

TEST_F(DetachmentPicture, TheCameraHoldsASheetThatLeavesItsFirstPlace) {
  options.views = {"thickness"};
  options.is_mirrored = false;
  const std::map<std::string, Range> ranges{{"thickness", {1, 1.5}}};
  const auto first = bulge.make_snapshot(model, 0.7, 3), gone = bulge.make_snapshot(model, 0.7, 4);
  for (Vec3& x : gone->points) x += Vec3(150.0, 80.0, -60.0);
  const auto count_sheet = [](const Image& image) {
    return static_cast<int>(image.rgba.size() / 4) - count_colour(image, theme("light").background_bottom);
  };
  const auto has_clear_rim = [](const Image& image) {
    const auto is_ground = [&](int x, int y) {
      const std::uint8_t* p = image.pixel(x, y);
      return Rgb{p[0], p[1], p[2]} == theme("light").background_bottom;
    };
    for (int x = 0; x < image.width; ++x)
      if (!is_ground(x, 0) || !is_ground(x, image.height - 1)) return false;
    for (int y = 0; y < image.height; ++y)
      if (!is_ground(0, y) || !is_ground(image.width - 1, y)) return false;
    return true;
  };
  FramePainter live(options);  // does not know what comes
  const Image start = live.paint("thickness", *first, {0, 2}, ranges).image;
  const Image end = live.paint("thickness", *gone, {1, 2}, ranges).image;
  EXPECT_GT(count_sheet(end), 100);
  EXPECT_TRUE(has_clear_rim(end));
  // Known from the start: one camera for both.
  options.later_sheet = calc_sheet_bounds(*gone, false);
  FramePainter knowing(options);
  const Frame a = knowing.paint("thickness", *first, {0, 2}, ranges);
  const Frame b = knowing.paint("thickness", *gone, {1, 2}, ranges);
  EXPECT_EQ(find_value(a.sidecar, "scale_mm"), find_value(b.sidecar, "scale_mm"));
  EXPECT_EQ(find_value(a.sidecar, "focal_mm"), find_value(b.sidecar, "focal_mm"));
  EXPECT_TRUE(has_clear_rim(a.image) && has_clear_rim(b.image));
  // A sheet that stays leaves the camera alone.
  options.later_sheet = calc_sheet_bounds(*first, false);
  EXPECT_EQ(FramePainter(options).paint("thickness", *first, {0, 2}, ranges).image, start);
}

TEST_F(DetachmentPicture, LetteringKeepsApartInNarrowPictures) {
  options.is_flat = false;
  options.smoothing = 1;
  for (const std::array<int, 2> size :
       {std::array{240, 300}, std::array{320, 240}, std::array{390, 300}, std::array{640, 360}}) {
    options.size = size;
    for (const char* view : {"contact-map", "detachment"}) {
      const Frame frame = FramePainter(options).paint(view, *make(1.0), {}, {{"detachment", {0, 1}}});
      const std::vector<double> boxes = find_numbers(frame.sidecar, "lettering_px");
      ASSERT_GE(boxes.size(), 8U);
      // The heading is the first, the legend's panels follow; the axes are the last.
      for (std::size_t k = 4; k + 4 < boxes.size(); k += 4) {
        const bool is_beside = boxes[k] >= boxes[0] + boxes[2],
                   is_below = boxes[k + 1] >= boxes[1] + boxes[3];
        EXPECT_TRUE(is_beside || is_below) << view << " " << size[0] << " x " << size[1];
        EXPECT_LE(boxes[k + 1] + boxes[k + 3], size[1]) << view << " " << size[0] << " x " << size[1];
      }
    }
  }
}

}  // namespace
}  // namespace hydroscope
