#include "talweg/core/space/box_tree.hpp"

#include <random>
#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace talweg {
namespace {

std::vector<SpaceBox> random_boxes(std::size_t count, bool flat, std::mt19937& engine) {
  std::uniform_real_distribution<double> place(0, 1), size(0, count > 1000 ? 0.002 : 0.2);
  std::vector<SpaceBox> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Point low(place(engine), place(engine), flat ? 0 : place(engine));
    boxes.push_back({low, low + Point(size(engine), size(engine), flat ? 0 : size(engine))});
  }
  if (count > 20) std::fill(boxes.begin(), boxes.begin() + 20, boxes.front());
  return boxes;
}

class BoxTreeOf : public ::testing::TestWithParam<std::tuple<std::size_t, bool>> {
 protected:
  BoxTreeOf() : boxes_(random_boxes(std::get<0>(GetParam()), std::get<1>(GetParam()), engine_)) {}
  [[nodiscard]] BoxTree::BoxOf box_of() const {
    return [this](std::uint32_t i) { return boxes_[i]; };
  }
  std::mt19937 engine_{1};
  std::vector<SpaceBox> boxes_;
};

// The tree finds the same boxes as a search of all boxes.
TEST_P(BoxTreeOf, Pairs) {
  const BoxTree tree(boxes_.size(), box_of());
  std::set<std::pair<std::uint32_t, std::uint32_t>> expected, found;
  for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
    const auto add = [&](std::uint32_t k) {
      if (k > i) expected.emplace(i, k);
    };
    if (boxes_.size() > 1000) {  // too many for all pairs: visit() is checked by the next test
      tree.visit(boxes_[i], box_of(), add);
      continue;
    }
    for (std::uint32_t k = i + 1; k < boxes_.size(); ++k) {
      if (boxes_[i].overlaps(boxes_[k])) add(k);
    }
  }
  tree.visit_pairs(box_of(), [&](std::uint32_t i, std::uint32_t k) {
    EXPECT_TRUE(found.emplace(i, k).second) << "twice";
  });
  EXPECT_EQ(found, expected);
}

TEST_P(BoxTreeOf, VisitFindsAllOverlaps) {
  const BoxTree tree(boxes_.size(), box_of());
  for (const SpaceBox& place : random_boxes(50, false, engine_)) {
    std::set<std::uint32_t> expected, found;
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
      if (place.overlaps(boxes_[i])) expected.insert(i);
    }
    tree.visit(place, box_of(),
               [&](std::uint32_t i) { EXPECT_TRUE(found.insert(i).second) << "twice"; });
    EXPECT_EQ(found, expected);
  }
}

TEST_P(BoxTreeOf, NearestPrefersTheSmallestIndex) {
  const BoxTree tree(boxes_.size(), box_of());
  for (const SpaceBox& place : random_boxes(200, false, engine_)) {
    const Point p = 2 * place.low - Point(0.5, 0.5, 0.5);
    const auto squared = [&](std::uint32_t i) { return boxes_[i].squared_distance(p); };
    BoxTree::Nearest expected;
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
      if (squared(i) < expected.squared_distance) expected = {i, squared(i)};
    }
    const BoxTree::Nearest found = tree.nearest(p, squared);
    EXPECT_EQ(found.found(), expected.found());
    EXPECT_EQ(found.index, expected.index);
    EXPECT_EQ(found.squared_distance, expected.squared_distance);
  }
}

INSTANTIATE_TEST_SUITE_P(Boxes, BoxTreeOf,
                         ::testing::Combine(::testing::Values(0U, 1U, 2U, 5U, 9U, 300U, 1U << 15,
                                                              50000U),
                                            ::testing::Bool()));

}  // namespace
}  // namespace talweg
