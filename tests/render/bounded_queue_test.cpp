// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bounded_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace hydroscope {
namespace {

TEST(BoundedQueue, KeepsOrderAndLosesNothing) {
  BoundedQueue<int> queue(3);
  std::thread producer([&queue] {
    for (int i = 0; i < 1000; ++i) EXPECT_TRUE(queue.push(i));
    queue.close();
  });
  std::vector<int> got;
  while (const auto value = queue.pop()) got.push_back(*value);
  producer.join();
  ASSERT_EQ(got.size(), 1000u);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(got[static_cast<std::size_t>(i)], i);
}

TEST(BoundedQueue, TheProducerWaitsWhenItIsFull) {
  BoundedQueue<int> queue(2);
  std::atomic<int> pushed = 0;
  std::thread producer([&] {
    for (int i = 0; i < 5; ++i) {
      queue.push(i);
      ++pushed;
    }
  });
  while (pushed < 2) std::this_thread::yield();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(pushed, 2);
  queue.pop();
  while (pushed < 3) std::this_thread::yield();
  queue.abandon();
  producer.join();
}

TEST(BoundedQueue, AnAbandonedQueueTakesNothingAndHoldsNobody) {
  BoundedQueue<int> queue(1);
  queue.push(1);
  queue.abandon();
  EXPECT_FALSE(queue.push(2));
  EXPECT_FALSE(queue.pop().has_value());
}

}  // namespace
}  // namespace hydroscope
