// SPDX-License-Identifier: GPL-3.0-or-later
// Which picture comes next: no threads, no clock.
#include "app/server/frame_queue.h"

#include <gtest/gtest.h>

namespace hydroscope::test {
namespace {

using std::chrono::milliseconds;
using Kind = FrameOrder::Kind;

class Turns : public testing::Test {
 protected:
  FrameQueue::Added add(const std::string& viewer, const std::string& slot, Kind kind, int after = -1) {
    FrameOrder order;
    order.viewer = viewer;
    order.slot = slot;
    order.kind = kind;
    if (kind == Kind::kWatch) order.after = StateKey{kAnyBranch, after};
    return queue_.add(order, now_);
  }
  /// "viewer.slot" of what is drawn now, or "".
  std::string take(bool is_solving = true) {
    const auto taken = queue_.take(now_, live_, is_solving);
    return taken ? taken->second.order.viewer + "." + taken->second.order.slot : "";
  }
  FrameQueue queue_;
  FrameQueue::Time now_ = FrameQueue::Time{} + std::chrono::hours(1);
  std::optional<StateKey> live_ = StateKey{0, 5};
};

TEST_F(Turns, OfOneSlotOnlyTheNewestWaits) {
  const auto first = add("a", "1", Kind::kHand);
  EXPECT_FALSE(first.replaced);
  EXPECT_EQ(add("a", "1", Kind::kHand).replaced, first.ticket);
  EXPECT_FALSE(add("a", "2", Kind::kHand).replaced);
  EXPECT_FALSE(add("b", "1", Kind::kHand).replaced);
  EXPECT_EQ(queue_.size(), 3U);
}

TEST_F(Turns, ViewersTakeTurns) {
  add("a", "1", Kind::kHand);
  add("a", "2", Kind::kHand);
  add("b", "1", Kind::kHand);
  EXPECT_EQ(take(), "a.1");
  EXPECT_EQ(take(), "b.1");  // a has been served more recently
  EXPECT_EQ(take(), "a.2");
  EXPECT_EQ(take(), "");
}

TEST_F(Turns, HandsComeBeforeWatchingAndWatchingBeforeFilms) {
  add("f", "1", Kind::kFilm);
  add("w", "1", Kind::kWatch);
  add("h", "1", Kind::kHand);
  EXPECT_EQ(take(), "h.1");
  EXPECT_EQ(take(), "w.1");
  EXPECT_EQ(take(), "f.1");
}

TEST_F(Turns, WhoeverWaitsLongComesToo) {
  add("f", "1", Kind::kFilm);
  now_ += FrameQueue::kPatience + milliseconds(1);
  add("h", "1", Kind::kHand);
  EXPECT_EQ(take(), "f.1");
}

TEST_F(Turns, WatchingWaitsForAnotherState) {
  add("w", "1", Kind::kWatch, 5);
  EXPECT_EQ(take(), "");
  EXPECT_FALSE(queue_.next_look(live_, true));
  live_->increment = 4;  // gone back
  EXPECT_EQ(take(), "w.1");
  FrameOrder order;
  order.kind = Kind::kWatch;
  order.after = StateKey{0, 4};
  queue_.add(order, now_);
  EXPECT_EQ(take(), "");
  live_->branch = 1;
  EXPECT_EQ(take(), ".");
}

TEST_F(Turns, WatchingIsPacedOverAllViewersWhileTheSolverWorks) {
  queue_.note_drawn(Kind::kWatch, now_, 0.01);  // 10 ms: the rate bounds
  add("w", "1", Kind::kWatch);
  now_ += milliseconds(249);
  EXPECT_EQ(take(), "");
  EXPECT_EQ(*queue_.next_look(live_, true), now_ + milliseconds(1));
  now_ += milliseconds(1);
  EXPECT_EQ(take(), "w.1");
  queue_.note_drawn(Kind::kWatch, now_, 0.08);  // 80 ms: the share of a core bounds
  add("v", "1", Kind::kWatch);
  now_ += milliseconds(799);
  EXPECT_EQ(take(), "");
  EXPECT_EQ(take(false), "v.1");  // nobody computes
}

TEST_F(Turns, HandsAreNotPacedAndDoNotPaceWatching) {
  queue_.note_drawn(Kind::kHand, now_, 10.0);
  add("w", "1", Kind::kWatch);
  add("h", "1", Kind::kHand);
  EXPECT_EQ(take(), "h.1");
  EXPECT_EQ(take(), "w.1");
}

TEST_F(Turns, NothingLiveIsDrawnBeforeThereIsAState) {
  live_.reset();
  add("h", "1", Kind::kHand);
  EXPECT_EQ(take(), "");
  live_ = StateKey{0, 0};
  EXPECT_EQ(take(), "h.1");
}

TEST_F(Turns, TooManyAreRefusedAndWhoLeavesMakesRoom) {
  FrameQueue::Ticket last = 0;
  for (std::size_t i = 0; i < FrameQueue::kMost; ++i)
    last = add("v" + std::to_string(i), "1", Kind::kHand).ticket;
  EXPECT_EQ(add("more", "1", Kind::kHand).ticket, 0U);
  queue_.remove(last);
  EXPECT_NE(add("more", "1", Kind::kHand).ticket, 0U);
}

}  // namespace
}  // namespace hydroscope::test
