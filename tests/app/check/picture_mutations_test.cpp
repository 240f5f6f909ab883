// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of the renderer alone: all numbers are right, and the pictures must show it, also to
// the measure that is left when another renderer drew the baseline.
#include <gmock/gmock.h>

#include "app/check/frame_comparison.h"
#include "render/image/image_difference.h"
#include "render/views.h"
#include "tests/app/check/sample_sequence.h"

namespace hydroscope::test {
namespace {

const Snapshot& last() { return *sample_sequence().states().back(); }

/// The same state with another model.
Snapshot with_model(const std::function<void(SnapshotModel&)>& change) {
  Snapshot copy = last();
  auto model = std::make_shared<SnapshotModel>(*copy.model);
  change(*model);
  copy.model = model;
  return copy;
}

PictureVerdict compare(const Drawn& expected, const Drawn& got, const PictureRule& rule) {
  std::vector<PixelBox> lettering = expected.lettering;
  lettering.insert(lettering.end(), got.lettering.begin(), got.lettering.end());
  return compare_pictures(expected.image, got.image, rule, lettering);
}

void expect_rejected(const Drawn& expected, const Drawn& got, const char* why) {
  const PictureVerdict same = compare(expected, got, {.is_same_renderer = true});
  const PictureVerdict other = compare(expected, got, {.is_same_renderer = false});
  EXPECT_THAT(same.text, testing::HasSubstr(why));
  EXPECT_NE(other.text, "") << "on another renderer: likeness " << other.likeness;
  // Far from the limit, which has to hold on machines that we do not know.
  EXPECT_LT(other.likeness, kLeastLikeness - 0.2);
}

/// Half a turn of one arrow about its start.
void turn_arrow(SurfaceItem& item) {
  constexpr std::size_t kPoints = 48;  // of an arrow
  Surface arrows = *item.surface;
  // One that is seen: of the others some are hidden by the tool.
  const std::size_t first = arrows.points.size() * 3 / 10 / kPoints * kPoints;
  const Vec3f start = arrows.points[first];
  const Vec3f t = (arrows.points[first + kPoints - 1] - start).normalized(), u = t.unitOrthogonal();
  const auto turn = [&](const Vec3f& v) -> Vec3f { return v - 2.0F * (t.dot(v) * t + u.dot(v) * u); };
  for (std::size_t i = first; i < first + kPoints; ++i) {
    arrows.points[i] = start + turn(arrows.points[i] - start);
    arrows.normals[i] = turn(arrows.normals[i]);
  }
  item.surface = std::make_shared<const Surface>(arrows);
}

class PictureMutation : public testing::Test {};

TEST_F(PictureMutation, NothingChangedIsAccepted) {
  for (const std::string view : {"contact-map", "tool-normals", "slip", "thickness"}) {
    const Drawn image = paint_changed(view, last());
    EXPECT_EQ(compare(image, paint_changed(view, last()), {}).text, "") << view;
  }
}

TEST_F(PictureMutation, ContactLost) {
  const Drawn right = paint_changed("contact-map", last());
  for (const int reach : {0, 1, 3}) {
    Snapshot lost = last();
    for (int j = 5 - reach; j <= 5 + reach; ++j)
      for (int i = 4 - reach; i <= 4 + reach; ++i) lost.contact_state[find_node(j, i)] = ContactClass::kFree;
    // The legend counts the nodes of the snapshot; a fault of the renderer would not change it.
    const Legend legend = [] {
      Legend found;
      paint_changed("contact-map", last(), [&](DrawList& list, CameraPose&) { found = list.legend; });
      return found;
    }();
    expect_rejected(
        right, paint_changed("contact-map", lost, [&](DrawList& list, CameraPose&) { list.legend = legend; }),
        "a block of 2 x 2");
  }
}

TEST_F(PictureMutation, OneToolNormalFlipped) {
  const Drawn right = paint_changed("tool-normals", last());
  Snapshot flipped = with_model([](SnapshotModel& model) {
    // A point whose arrow is drawn: the first one always is.
    model.tools[0].normals[12 * 25 + 12] *= -1.0;
  });
  expect_rejected(right, paint_changed("tool-normals", flipped), "a block of 2 x 2");
}

TEST_F(PictureMutation, OneArrowTurnedRound) {
  // The least that a flipped normal can show: its arrow, without the angle in the map.
  const Drawn right = paint_changed("tool-normals", last());
  expect_rejected(right,
                  paint_changed("tool-normals", last(),
                                [&](DrawList& list, CameraPose&) { turn_arrow(list.surfaces[1]); }),
                  "differ by more than 3 levels");
}

TEST_F(PictureMutation, AllToolNormalsFlipped) {
  const Drawn right = paint_changed("tool-normals", last());
  Snapshot flipped = with_model([](SnapshotModel& model) {
    for (Vec3& n : model.tools[0].normals) n *= -1.0;
  });
  expect_rejected(right, paint_changed("tool-normals", flipped), "a block of 2 x 2");
}

TEST_F(PictureMutation, SlipVectorsLongerByATenth) {
  const Drawn right = paint_changed("slip", last());
  Snapshot longer = last();
  for (Vec3& v : longer.slip) v *= 1.1;
  expect_rejected(right, paint_changed("slip", longer), "a block of 2 x 2");
}

TEST_F(PictureMutation, MapReversed) {
  const Drawn right = paint_changed("thickness", last());
  static ColourTable reversed = colour_table(MapName::kDusk);
  reversed = colour_table(MapName::kDusk);
  std::reverse(reversed.begin(), reversed.end());
  expect_rejected(right,
                  paint_changed("thickness", last(),
                                [](DrawList& list, CameraPose&) {
                                  for (SurfaceItem& item : list.surfaces)
                                    if (item.table != nullptr) item.table = &reversed;
                                }),
                  "a block of 2 x 2");
  // In the legend alone.
  expect_rejected(right,
                  paint_changed("thickness", last(),
                                [](DrawList& list, CameraPose&) { list.legend.bars[0].table = &reversed; }),
                  "a block of 2 x 2");
}

TEST_F(PictureMutation, RangeDoubled) {
  const Drawn right = paint_changed("thickness", last());
  expect_rejected(right,
                  paint_changed("thickness", last(),
                                [](DrawList& list, CameraPose&) {
                                  for (SurfaceItem& item : list.surfaces) {
                                    const double middle = 0.5 * (item.range.low + item.range.high);
                                    const double reach = item.range.high - item.range.low;
                                    item.range = {middle - reach, middle + reach};
                                  }
                                }),
                  "a block of 2 x 2");
}

TEST_F(PictureMutation, TimeLabelOffByOneStep) {
  const Drawn right = paint_changed("contact-map", last());
  Snapshot late = last();
  ++late.increment;

  expect_rejected(right, paint_changed("contact-map", late), "a block of 2 x 2");
}

TEST_F(PictureMutation, ToolMissing) {
  const Drawn right = paint_changed("contact-map", last());
  expect_rejected(right,
                  paint_changed("contact-map", last(),
                                [](DrawList& list, CameraPose&) {
                                  list.surfaces.resize(1);
                                  list.lines.resize(1);
                                }),
                  "a block of 2 x 2");
}

TEST_F(PictureMutation, BlankFrame) {
  const Drawn right = paint_changed("contact-map", last());
  const Drawn got = paint_changed("contact-map", last(), [](DrawList& list, CameraPose&) {
    list.surfaces.clear();
    list.lines.clear();
  });
  EXPECT_NE(compare(right, got, {.is_same_renderer = true}).text, "");
  EXPECT_NE(compare(right, got, {.is_same_renderer = false}).text, "");
  EXPECT_EQ(compare(right, {make_image(480, 270, {0, 0, 0}), {}}, {}).text, "the picture is blank");
}

TEST_F(PictureMutation, WrongMirror) {
  const Drawn right = paint_changed("contact-map", last());
  // The tube's middle plane moved out by half an element: its halves stand apart.
  Snapshot apart = with_model([](SnapshotModel& model) { model.mirrors[2].point.z() -= 1.9; });
  expect_rejected(right, paint_changed("contact-map", apart), "a block of 2 x 2");
}

TEST_F(PictureMutation, AFewLevelsOfOtherProcessorsAreStillAlike) {
  // llvmpipe's colours on another make of processor: up to 3 levels, at random at worst.
  for (const std::string view : {"contact-map", "tool-normals", "slip", "thickness"}) {
    const Drawn right = paint_changed(view, last());
    Drawn got = right;
    unsigned random = 1;
    for (std::uint8_t& byte : got.image.rgba) {
      random = random * 1664525U + 1013904223U;
      byte = static_cast<std::uint8_t>(std::clamp(byte + static_cast<int>((random >> 16U) % 7U) - 3, 0, 255));
    }
    const PictureVerdict other = compare(right, got, {.is_same_renderer = false});
    EXPECT_GT(other.likeness, 0.95) << view;
    EXPECT_EQ(other.text, "") << view;
    EXPECT_EQ(compare(right, got, {.is_same_renderer = true}).text, "") << view;
  }
}

}  // namespace
}  // namespace hydroscope::test
