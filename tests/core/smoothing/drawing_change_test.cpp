#include "talweg/core/smoothing/drawing_change.hpp"

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"

namespace talweg {
namespace {

using test::ids;

const Surface& plane() {
  static const Surface surface = test::surface_of_lists(test::grid(9, 9));
  return surface;
}

SurfaceCurve curve(std::initializer_list<std::uint32_t> vertices, bool closed) {
  return test::vertex_curve(plane(), ids(vertices), closed);
}

/// The changed vertices between the kept points.
std::vector<std::size_t> between(const SurfaceCurve& c, std::size_t front, std::size_t back) {
  std::vector<std::size_t> result;
  for (std::size_t i = front; i + back < c.points.size(); ++i) {
    result.push_back(std::get<AtVertex>(c.points[i].where()).vertex.index());
  }
  return result;
}
std::vector<std::size_t> gone(const DrawingChange& c) {
  return between(c.before, c.kept_before, c.kept_after);
}
std::vector<std::size_t> come(const DrawingChange& c) {
  return between(c.after, c.kept_before, c.kept_after);
}
using Ids = std::vector<std::size_t>;

TEST(DrawingChange, OfAnOpenCurveIsThePartBetweenTheCommonEnds) {
  const DrawingChange change =
      change_between(curve({0, 1, 2, 3, 4, 5}, false), curve({0, 1, 12, 13, 14, 4, 5}, false));
  EXPECT_EQ(change.kept_before, 2U);
  EXPECT_EQ(change.kept_after, 2U);
  EXPECT_EQ(gone(change), (Ids{2, 3}));
  EXPECT_EQ(come(change), (Ids{12, 13, 14}));
  EXPECT_EQ(change.new_points(), 3U);
}

TEST(DrawingChange, AtTheEndsOfAnOpenCurve) {
  const SurfaceCurve before = curve({0, 1, 2, 3}, false);
  EXPECT_EQ(come(change_between(before, curve({10, 1, 2, 3}, false))), (Ids{10}));
  EXPECT_EQ(come(change_between(before, curve({0, 1, 2, 12}, false))), (Ids{12}));
  EXPECT_EQ(come(change_between(before, curve({0, 1, 2, 3, 4}, false))), (Ids{4}));
  EXPECT_EQ(gone(change_between(before, curve({1, 2, 3}, false))), (Ids{0}));
}

TEST(DrawingChange, OfPointsThatComeTwiceCountsNoneTwice) {
  // The front keeps 0 1 2; the back may keep only the remaining points.
  const DrawingChange change = change_between(curve({0, 1, 2, 3}, false), curve({0, 1, 2}, false));
  EXPECT_EQ(change.kept_before + change.kept_after, 3U);
  EXPECT_TRUE(come(change).empty());
}

TEST(DrawingChange, OfALoopMayGoOverItsSeam) {
  const SurfaceCurve before = curve({0, 1, 2, 12, 22, 21, 20, 10}, true);
  const DrawingChange change = change_between(before, curve({11, 2, 12, 22, 21, 20, 10}, true));
  EXPECT_EQ(gone(change), (Ids{0, 1}));
  EXPECT_EQ(come(change), (Ids{11}));
  EXPECT_EQ(change.kept_before, 3U);
  EXPECT_EQ(change.kept_after, 3U);
}

TEST(DrawingChange, OfALoopWithAnotherFirstPointIsEmpty) {
  const SurfaceCurve before = curve({0, 1, 2, 12, 22, 21, 20, 10}, true);
  EXPECT_TRUE(change_between(before, curve({22, 21, 20, 10, 0, 1, 2, 12}, true)).is_none());
  EXPECT_TRUE(change_between(before, before).is_none());
}

TEST(DrawingChange, OfADrawingWithNothingInCommonIsAll) {
  const DrawingChange change = change_between(curve({0, 1, 2}, false), curve({10, 11, 12}, false));
  EXPECT_EQ(change.kept_before + change.kept_after, 0U);
  const DrawingChange closed = change_between(curve({0, 1, 11}, false), curve({0, 1, 11}, true));
  EXPECT_EQ(closed.kept_before + closed.kept_after, 0U);
  EXPECT_FALSE(closed.is_none());
}

}  // namespace
}  // namespace talweg
