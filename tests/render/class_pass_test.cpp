// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/class_pass.h"

#include <gmock/gmock.h>

#include "render/view_range.h"
#include "tests/render/synthetic.h"

namespace hydroscope {
namespace {

class Classes : public testing::Test {
 protected:
  SyntheticBulge bulge;
  std::shared_ptr<Snapshot> snapshot = bulge.make_snapshot(bulge.make_model(), 0.7, 3);

  /// A patch of stuck nodes around the middle of the mesh becomes free.
  Snapshot make_lost(int reach) const {
    Snapshot lost = *snapshot;
    for (int j = 5 - reach; j <= 5 + reach; ++j)
      for (int i = 4 - reach; i <= 4 + reach; ++i)
        lost.contact_state.at(static_cast<std::size_t>(j * 21 + i)) = ContactClass::kFree;
    return lost;
  }
};

TEST_F(Classes, WhatIsDrawnIsWhatWasSolved) {
  const ClassAgreement agreement = read_class_pictures(ClassPass().draw(*snapshot), *snapshot);
  EXPECT_EQ(agreement.nodes, 21 * 25);
  EXPECT_EQ(agreement.unseen, 0);
  EXPECT_EQ(agreement.drawn, count_classes(*snapshot).nodes) << "every node is counted, in its class";
  EXPECT_TRUE(agreement.wrong.empty());
  // Both pictures have the same polygons wherever classes differ.
  EXPECT_EQ(agreement.stray_share, 0.0);
}

TEST_F(Classes, LostNodesAreNamed) {
  for (const int reach : {0, 1, 3}) {
    const std::vector<ClassPicture> pictures = ClassPass().draw(make_lost(reach));
    const ClassAgreement agreement = read_class_pictures(pictures, *snapshot);
    EXPECT_EQ(agreement.wrong.size(), static_cast<std::size_t>((2 * reach + 1) * (2 * reach + 1)));
    EXPECT_THAT(agreement.wrong, testing::Contains(5 * 21 + 4));
  }
}

TEST_F(Classes, AWholeTubeIsSeenFromAllSides) {
  SyntheticBulge narrow{.around = 8, .along = 4};
  auto model = std::make_shared<SnapshotModel>(*narrow.make_model());
  Snapshot tube = *narrow.make_snapshot(model, 0.7, 3);
  // The quarter once more on the other side: no direction shows both.
  const std::size_t count = tube.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 turned(-1.0, -1.0, 1.0);
    tube.points.push_back(tube.points[i].cwiseProduct(turned));
    tube.directors.push_back(tube.directors[i].cwiseProduct(turned));
    for (auto* field : {&tube.thickness, &tube.plastic_strain, &tube.gap, &tube.contact_pressure})
      field->push_back((*field)[i]);
    for (auto* field : {&tube.contact_force, &tube.tool_normal, &tube.slip, &tube.slip_increment})
      field->push_back((*field)[i]);
    tube.contact_state.push_back(tube.contact_state[i]);
    tube.contact_tool.push_back(tube.contact_tool[i]);
  }
  const int shift = static_cast<int>(count);
  const auto quads = model->quads;
  for (const auto& quad : quads)
    model->quads.push_back({quad[0] + shift, quad[1] + shift, quad[2] + shift, quad[3] + shift});
  tube.model = model;
  const std::vector<ClassPicture> pictures = ClassPass().draw(tube);
  EXPECT_GE(pictures.size(), 2u);
  const ClassAgreement agreement = read_class_pictures(pictures, tube);
  EXPECT_EQ(agreement.unseen, 0);
  EXPECT_TRUE(agreement.wrong.empty());
}

TEST_F(Classes, AColourThatNoClassHasIsNoClass) {
  std::vector<ClassPicture> pictures = ClassPass().draw(*snapshot);
  for (ClassPicture& picture : pictures)
    for (std::uint8_t& byte : picture.classes.rgba) byte = static_cast<std::uint8_t>(byte / 2);
  const ClassAgreement agreement = read_class_pictures(pictures, *snapshot);
  EXPECT_EQ(agreement.wrong.size(), snapshot->points.size());
}

TEST_F(Classes, BlankPicturesAreCalledBlank) {
  std::vector<ClassPicture> pictures = ClassPass().draw(*snapshot);
  for (ClassPicture& picture : pictures)
    picture.classes = picture.nodes = make_image(picture.classes.width, picture.classes.height, {0, 0, 0});
  EXPECT_TRUE(read_class_pictures(pictures, *snapshot).is_blank());
}

}  // namespace
}  // namespace hydroscope
