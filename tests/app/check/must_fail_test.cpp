// SPDX-License-Identifier: GPL-3.0-or-later
// What a check must reject, and for the right reason: the first thing it says.
#include <gmock/gmock.h>

#include <algorithm>

#include "app/check/frame_comparison.h"
#include "tests/app/check/sample_sequence.h"

namespace hydroscope::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::Property;

using States = std::vector<Snapshot>;

/// All findings as text, for messages.
std::string list(const CheckReport& report) {
  std::string text;
  for (const Finding& finding : report.findings) text += describe(finding) + "\n";
  return text;
}

void expect_first(const CheckReport& report, CheckStage stage, const std::string& text) {
  ASSERT_FALSE(report.is_passed());
  EXPECT_EQ(report.findings.front().stage, stage) << list(report);
  EXPECT_THAT(report.findings.front().text, HasSubstr(text)) << list(report);
}

bool has(const CheckReport& report, CheckStage stage, const std::string& text) {
  return std::any_of(report.findings.begin(), report.findings.end(), [&](const Finding& finding) {
    return finding.stage == stage && describe(finding).find(text) != std::string::npos;
  });
}

/// All that a state says of the contact of nodes within `reach` of a node is gone.
void lose_contact(Snapshot& s, int reach) {
  for (int j = 5 - reach; j <= 5 + reach; ++j)
    for (int i = 4 - reach; i <= 4 + reach; ++i) {
      const std::size_t node = find_node(j, i);
      s.contact_state[node] = ContactClass::kFree;
      s.contact_tool[node] = -1;
      s.contact_force[node].setZero();
      s.tool_normal[node].setZero();
      s.contact_pressure[node] = 0.0;
    }
}

class MustFail : public testing::Test {};

TEST_F(MustFail, ContactLostAtOneNodeAndAtPatches) {
  for (const int reach : {0, 1, 3}) {
    const CheckReport report =
        check_changed([&](SnapshotModel&, States& states) { lose_contact(states.back(), reach); });
    expect_first(report, CheckStage::kValues, "counts.free");
    EXPECT_TRUE(has(report, CheckStage::kBalance, "the nodes' contact forces and the tools' own sums differ"))
        << list(report);
    EXPECT_TRUE(has(report, CheckStage::kPixels, "contact-map, frame 3")) << list(report);
    EXPECT_FALSE(has(report, CheckStage::kValues, "frame 2")) << "only one frame was changed";
  }
}

TEST_F(MustFail, ContactThatMovedToANeighbourIsNoticedWithTheSameCounts) {
  const CheckReport report = check_changed([](SnapshotModel&, States& states) {
    Snapshot& s = states.back();
    const auto free = std::find(s.contact_state.begin(), s.contact_state.end(), ContactClass::kFree) -
                      s.contact_state.begin();
    std::swap(s.contact_state[static_cast<std::size_t>(free)], s.contact_state[find_node(5, 4)]);
  });
  expect_first(report, CheckStage::kValues, "sums.weighted_class");
  EXPECT_TRUE(has(report, CheckStage::kBalance, "free with a contact force, or touch without a tool"));
}

TEST_F(MustFail, OneToolNormalFlipped) {
  const CheckReport report =
      check_changed([](SnapshotModel& model, States&) { model.tools[0].normals[12 * 25 + 12] *= -1.0; });
  expect_first(report, CheckStage::kValues, "tools.die.largest_normal_angle_deg");
  EXPECT_TRUE(has(report, CheckStage::kPixels, "tool-normals"));
}

TEST_F(MustFail, AllToolNormalsFlipped) {
  const CheckReport report = check_changed([](SnapshotModel& model, States&) {
    for (Vec3& n : model.tools[0].normals) n *= -1.0;
  });
  expect_first(report, CheckStage::kValues, "tools.die.largest_normal_angle_deg");
  EXPECT_TRUE(has(report, CheckStage::kValues, "tools.die.weighted_normals"));
}

TEST_F(MustFail, AllFacetsAndNormalsFlippedTogether) {
  // The angles stay the same; the normals do not.
  const CheckReport report = check_changed([](SnapshotModel& model, States&) {
    for (Vec3& n : model.tools[0].normals) n *= -1.0;
    for (auto& facet : model.tools[0].mesh.triangles) std::swap(facet[1], facet[2]);
  });
  expect_first(report, CheckStage::kValues, "tools.die.weighted_normals");
}

TEST_F(MustFail, SlipVectorsLongerByATenth) {
  const CheckReport report = check_changed([](SnapshotModel&, States& states) {
    for (Vec3& v : states.back().slip) v *= 1.1;
  });
  expect_first(report, CheckStage::kValues, "sums.weighted_slip_mm");
  EXPECT_TRUE(has(report, CheckStage::kPixels, "slip, frame 3")) << list(report);
}

TEST_F(MustFail, RangeDoubled) {
  const CheckReport report = check_changed([](SnapshotModel&, States& states) {
    states.front().thickness[3] = 3.0;  // one node opens the range of the whole sequence
  });
  EXPECT_TRUE(has(report, CheckStage::kValues, "thickness, frame 2: range.thickness")) << list(report);
  EXPECT_TRUE(has(report, CheckStage::kPixels, "thickness, frame 2"));
}

TEST_F(MustFail, TimeLabelOffByOneStep) {
  const CheckReport report = check_changed([](SnapshotModel&, States& states) { ++states.back().increment; });
  expect_first(report, CheckStage::kValues, "increment: 21 instead of 20");
  EXPECT_TRUE(has(report, CheckStage::kValues, "increment 21\" instead of \"t = 0.9000 s")) << list(report);
  EXPECT_TRUE(has(report, CheckStage::kPixels, "contact-map, frame 3"));
}

TEST_F(MustFail, ToolMissing) {
  const CheckReport report = check_changed([](SnapshotModel&, States& states) {
    states[1].tool_translation[0].setConstant(std::numeric_limits<double>::quiet_NaN());
  });
  expect_first(report, CheckStage::kValues, "tools.die.present: false instead of true");
  EXPECT_TRUE(has(report, CheckStage::kPixels, "contact-map, frame 2"));
  const CheckReport gone = check_changed([](SnapshotModel& model, States& states) {
    model.tools.clear();
    for (Snapshot& s : states) {
      s.tool_translation.clear();
      s.tool_force.clear();
    }
  });
  expect_first(gone, CheckStage::kValues, "tools.die is missing");
}

TEST_F(MustFail, OneFrameDropped) {
  const CheckReport last = check_changed([](SnapshotModel&, States& states) { states.pop_back(); });
  expect_first(last, CheckStage::kSequence, "2 frames instead of 3");
  EXPECT_TRUE(has(last, CheckStage::kSequence, "increment 20 (t = 0.9 s) is missing")) << list(last);
  const CheckReport middle =
      check_changed([](SnapshotModel&, States& states) { states.erase(states.begin() + 1); });
  expect_first(middle, CheckStage::kSequence, "2 frames instead of 3");
  EXPECT_TRUE(has(middle, CheckStage::kSequence, "frame 2: increment 10 (t = 0.65 s) is missing"))
      << list(middle);
}

TEST_F(MustFail, AHoleInTheNumbers) {
  const SampleSequence& sample = sample_sequence();
  const TemporaryFolder folder;
  std::filesystem::copy(sample.results(), folder.path() / "run", std::filesystem::copy_options::recursive);
  std::filesystem::remove(folder.path() / "run/states/00001.vtp");
  const CheckReport report = check_states(StateSequence(folder.path() / "run"), sample.baseline(), 1);
  expect_first(report, CheckStage::kSequence, "states/00001.vtp is missing");
  EXPECT_FALSE(has(report, CheckStage::kValues, "increment"))
      << "frames keep their numbers: " << list(report);
}

TEST_F(MustFail, FramesSwapped) {
  const CheckReport report =
      check_changed([](SnapshotModel&, States& states) { std::swap(states[1], states[2]); });
  expect_first(report, CheckStage::kSequence, "time does not rise");
  EXPECT_TRUE(has(report, CheckStage::kValues, "frame 2: increment: 20 instead of 10")) << list(report);
}

TEST_F(MustFail, WrongSymmetryMirror) {
  const CheckReport report = check_changed(
      [](SnapshotModel& model, States&) { std::swap(model.mirrors[0].normal, model.mirrors[2].normal); });
  expect_first(report, CheckStage::kValues, "mirrors.plane_1.normal");
  const CheckReport moved =
      check_changed([](SnapshotModel& model, States&) { model.mirrors[2].point.z() -= 0.5; });
  EXPECT_TRUE(has(moved, CheckStage::kValues, "mirrors.plane_3.point_mm")) << list(moved);
  EXPECT_TRUE(has(moved, CheckStage::kPixels, "contact-map")) << list(moved);
}

TEST_F(MustFail, ForcesThatDoNotAddUp) {
  // Also without a baseline's numbers: the state contradicts itself.
  const CheckReport report = check_changed([](SnapshotModel&, States& states) {
    for (Vec3& force : states.back().support_force) force *= 0.9;
  });
  EXPECT_TRUE(has(report, CheckStage::kBalance, "pressure, contact and supports leave")) << list(report);
}

TEST_F(MustFail, PicturesOfAnotherSize) {
  const PictureVerdict verdict =
      compare_pictures(make_image(64, 64, {1, 2, 3}), make_image(64, 65, {1, 2, 3}), {}, {});
  EXPECT_EQ(verdict.text, "64 x 65 pixels instead of 64 x 64");
}

TEST_F(MustFail, NothingDrawnInTheClassPass) {
  ClassAgreement agreement;
  agreement.nodes = agreement.unseen = 10;
  EXPECT_THAT(check_classes(agreement, 1),
              ElementsAre(AllOf(Field(&Finding::stage, CheckStage::kClasses),
                                Field(&Finding::text, "nothing of the sheet is drawn"))));
}

TEST_F(MustFail, ClassesDrawnOtherwiseThanSolved) {
  const Snapshot& solved = *sample_sequence().states().back();
  Snapshot drawn = solved;
  lose_contact(drawn, 1);
  const std::vector<Finding> findings =
      check_classes(read_class_pictures(ClassPass().draw(drawn), solved), 3);
  ASSERT_FALSE(findings.empty());
  EXPECT_THAT(findings.front().text, HasSubstr("nodes drawn as free"));
  EXPECT_THAT(findings.back().text, HasSubstr("9 nodes are drawn in another class than solved: "));
}

}  // namespace
}  // namespace hydroscope::test
