// The order in which items leave the queue.
#include "talweg/intrinsic/exact_distance/polyline_queue.hpp"

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
  // Steps 2, 0, 0, and far ahead 2000 and 1000.
  const double keys[] = {1.2, 0.4, 0.1, 1000, 500};
  for (std::uint32_t id = 0; id < 5; ++id) queue.push({keys[id], id, 0});
  EXPECT_EQ(queue.front(), 0);
  EXPECT_EQ(ids_in_order(queue), (std::vector<std::uint32_t>{1, 2, 0, 4, 3}));
}

TEST(StepQueue, TakesWhatComesTooLateAtOnce) {
  StepQueue queue;
  queue.reset(0.5);
  queue.push({0.9, 1, 0});
  StepQueue::Item item{};
  EXPECT_FALSE(queue.pop(item));  // nothing in the first step
  EXPECT_EQ(queue.front(), 0.5);
  EXPECT_FALSE(queue.is_later(0.9));
  EXPECT_TRUE(queue.is_later(1.1));
  queue.push({0.1, 2, 0});
  ASSERT_NE(queue.ahead(1), nullptr);
  EXPECT_EQ(queue.ahead(1)->id, 2U);
  EXPECT_EQ(queue.ahead(2), nullptr);
  EXPECT_EQ(ids_in_order(queue), (std::vector<std::uint32_t>{1, 2}));
}

}  // namespace
}  // namespace talweg
