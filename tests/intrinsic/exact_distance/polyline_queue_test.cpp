// The order in which items leave the queue.
#include "talweg/intrinsic/exact_distance/polyline_queue.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace talweg {
namespace {

std::vector<std::uint32_t> ids_in_order(StepQueue& queue) {
  std::vector<std::uint32_t> ids;
  StepQueue::Item item{};
  while (!queue.empty()) {
    while (queue.pop(item)) ids.push_back(item.id);
  }
  return ids;
}

TEST(StepQueue, OrdersBySteps) {
  StepQueue queue;
  queue.reset(0.5);
  EXPECT_TRUE(std::isinf(queue.front()));
  // Keys in steps 2, 0, 0, and beyond the last step.
  const double keys[] = {1.2, 0.4, 0.1, 1000, 500};
  for (std::uint32_t id = 0; id < 5; ++id) queue.push({keys[id], id, 0});
  EXPECT_EQ(queue.front(), 0);
  EXPECT_EQ(ids_in_order(queue), (std::vector<std::uint32_t>{1, 2, 0, 4, 3}));
}

TEST(StepQueue, LateItemsJoinTheCurrentStep) {
  StepQueue queue;
  queue.reset(0.5);
  queue.push({0.9, 1, 0});
  StepQueue::Item item{};
  EXPECT_FALSE(queue.pop(item));  // the first step is empty
  EXPECT_EQ(queue.front(), 0.5);
  EXPECT_FALSE(queue.is_later(0.9));
  EXPECT_TRUE(queue.is_later(1.1));
  queue.push({0.1, 2, 0});
  ASSERT_NE(queue.ahead(1), nullptr);
  EXPECT_EQ(queue.ahead(1)->id, 2U);
  EXPECT_EQ(queue.ahead(2), nullptr);
  EXPECT_EQ(ids_in_order(queue), (std::vector<std::uint32_t>{1, 2}));
}

// 2048 steps of width 0.5 reach to 1024, the next 2048 steps of width 1 to 3072, and so on.
TEST(StepQueue, StepsBecomeWiderFarAway) {
  StepQueue queue;
  StepQueue::Item item{};
  const auto front_at = [&](double key) {
    queue.reset(0.5);
    queue.push({key, 0, 0});
    while (!queue.pop(item)) {
    }
    queue.push({key, 0, 0});
    return queue.front();
  };
  EXPECT_EQ(front_at(1023.7), 1023.5);
  EXPECT_EQ(front_at(1024), 1024);
  EXPECT_EQ(front_at(1025.7), 1025);
  EXPECT_EQ(front_at(3071.9), 3071);
  EXPECT_EQ(front_at(3075.9), 3074);
  double key = 1e-3;
  for (int k = 0; k < 2000; ++k, key *= 1.02) {  // up to 1.6e14
    const double front = front_at(key);
    ASSERT_LE(front, key);
    ASSERT_GE(front, key - std::max(0.5, key / 1024));
  }
}

TEST(StepQueue, HoldsKeysThatNoStepReaches) {
  StepQueue queue;
  queue.reset(1e-300);
  const double keys[] = {HUGE_VAL, 1e-100, 0, 1e-300};
  for (std::uint32_t id = 0; id < 4; ++id) queue.push({keys[id], id, 0});
  EXPECT_EQ(ids_in_order(queue), (std::vector<std::uint32_t>{2, 3, 1, 0}));
}

}  // namespace
}  // namespace talweg
