// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings of contact that comes and goes, and of contact about to be lost.
#include "app/workstation/contact_watch.h"

#include <gmock/gmock.h>

namespace hydroscope {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Two nodes on a tool, pressed with these forces; each may let go at 1 N of tension and is held by 100 N.
Snapshot make_snapshot(double first, double second) {
  auto model = std::make_shared<SnapshotModel>();
  model->tools.push_back({"die", {}, {}});
  Snapshot s;
  s.model = model;
  s.contact_tool = {0, 0};
  s.tool_normal = {Vec3::UnitX(), Vec3::UnitX()};
  s.contact_force = {Vec3(first, 50.0, 0.0), Vec3(second, 0.0, 0.0)};  // friction does not hold
  s.release_reference = {100.0, 100.0};
  s.release_threshold = {1.0, 1.0};
  return s;
}

IncrementReport make_report(int increment, const std::vector<std::pair<EventKind, int>>& events = {}) {
  IncrementReport report;
  report.increment = increment;
  report.time = 0.1 * increment;
  for (const auto& [kind, node] : events) {
    ContactEvent event;
    event.kind = kind;
    event.node = node;
    event.tool = 0;
    report.events.push_back(event);
  }
  return report;
}

TEST(ContactWatch, NodesThatComeBackSoonAreChatterOnceInAWhile) {
  const Snapshot held = make_snapshot(60.0, 60.0);
  ContactWatch watch;
  EXPECT_THAT(watch.look(make_report(1, {{EventKind::kTouch, 0}, {EventKind::kTouch, 1}}), held), IsEmpty());
  EXPECT_THAT(watch.look(make_report(2, {{EventKind::kDetach, 0}, {EventKind::kDetach, 1}}), held),
              IsEmpty());
  const auto first = watch.look(make_report(4, {{EventKind::kRetouch, 0}, {EventKind::kRetouch, 1}}), held);
  ASSERT_THAT(first, SizeIs(1));
  EXPECT_EQ(first[0].kind, "chatter");
  EXPECT_EQ(first[0].increment, 4);
  EXPECT_THAT(first[0].text,
              HasSubstr("node 0 (tool die) came back 2 increments after it let go, and another node"));
  EXPECT_THAT(watch.look(make_report(5, {{EventKind::kDetach, 0}, {EventKind::kRetouch, 0}}), held),
              IsEmpty());
  EXPECT_THAT(watch.look(make_report(9, {{EventKind::kDetach, 1}, {EventKind::kRetouch, 0}}), held),
              SizeIs(1));
}

TEST(ContactWatch, WhoComesBackLateDoesNotChatter) {
  const Snapshot held = make_snapshot(60.0, 60.0);
  ContactWatch watch;
  watch.look(make_report(2, {{EventKind::kDetach, 1}}), held);
  EXPECT_THAT(watch.look(make_report(3 + ContactWatch::kWindow, {{EventKind::kRetouch, 1}}), held),
              IsEmpty());
}

TEST(ContactWatch, ContactAboutToBeLostIsToldOnceUntilItIsSafeAgain) {
  ContactWatch watch;
  EXPECT_THAT(watch.look(make_report(1), make_snapshot(60.0, 5.0)), IsEmpty());  // 6 of 100 N left
  const auto warned = watch.look(make_report(2), make_snapshot(60.0, 3.0));
  ASSERT_THAT(warned, SizeIs(1));
  EXPECT_EQ(warned[0].kind, "near-release");
  EXPECT_THAT(warned[0].text, HasSubstr("node 1 (tool die) may let go soon"));
  EXPECT_THAT(watch.look(make_report(3), make_snapshot(2.0, 3.0)), IsEmpty());
  EXPECT_THAT(watch.look(make_report(4), make_snapshot(60.0, 60.0)), IsEmpty());
  EXPECT_THAT(watch.look(make_report(5), make_snapshot(0.0, 0.0)), SizeIs(1));
}

TEST(ContactWatch, FreeNodesAreNotAboutToLetGo) {
  Snapshot free = make_snapshot(0.0, 0.0);
  free.contact_tool = {-1, -1};
  free.release_reference = free.release_threshold = {0.0, 0.0};
  ContactWatch watch;
  EXPECT_THAT(watch.look(make_report(1), free), IsEmpty());
}

}  // namespace
}  // namespace hydroscope
