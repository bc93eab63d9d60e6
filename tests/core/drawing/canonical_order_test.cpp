#include "talweg/core/drawing/canonical_order.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::grid;
using test::ids;

MeshLists disturbed_grid() {
  MeshLists lists = grid(20, 20);
  for (Point& p : lists.points) {
    p += 0.2 * Point(std::sin(3 * p.y()), std::cos(5 * p.x() + p.y()), std::sin(p.x()));
  }
  return lists;
}

SurfaceCurve drawn_on(const Surface& surface, bool closed) {
  const auto path = draw_edge_path(surface, ids({44, 60, 340, 312, 350}), closed);
  return test::vertex_curve(surface, path, closed);
}

TEST(CanonicalOrder, IsTheSameForReversedAndRotatedCurves) {
  const auto opened = OpenedMesh::open(disturbed_grid());
  const Surface& surface = opened->surface();
  for (const bool closed : {false, true}) {
    const SurfaceCurve drawn = drawn_on(surface, closed);
    const SurfaceCurve ordered = in_order(drawn, canonical_order(opened->mesh(), drawn));
    SurfaceCurve other = drawn;
    for (std::size_t turn = 0; turn < (closed ? drawn.points.size() : 1); ++turn) {
      EXPECT_EQ(in_order(other, canonical_order(opened->mesh(), other)).points, ordered.points)
          << turn;
      std::reverse(other.points.begin(), other.points.end());
      EXPECT_EQ(in_order(other, canonical_order(opened->mesh(), other)).points, ordered.points)
          << turn;
      std::reverse(other.points.begin(), other.points.end());
      if (closed) std::rotate(other.points.begin(), other.points.begin() + 1, other.points.end());
    }
  }
}

/// Expects the same canonical order for every first point and both directions.
void expect_one_order(const SurfaceMesh& mesh, SurfaceCurve drawn) {
  const std::vector<SurfacePoint> ordered = in_order(drawn, canonical_order(mesh, drawn)).points;
  for (std::size_t turn = 0; turn < (drawn.closed ? drawn.points.size() : 1); ++turn) {
    for (int direction = 0; direction < 2; ++direction) {
      EXPECT_EQ(in_order(drawn, canonical_order(mesh, drawn)).points, ordered)
          << "begun at point " << turn << ", direction " << direction;
      std::reverse(drawn.points.begin(), drawn.points.end());
    }
    if (drawn.closed)
      std::rotate(drawn.points.begin(), drawn.points.begin() + 1, drawn.points.end());
  }
}

TEST(CanonicalOrder, IsUniqueAlsoForEqualSegments) {
  const auto opened = OpenedMesh::open(grid(7, 7));
  const auto vertices = [&](std::initializer_list<std::uint32_t> list, bool closed) {
    return test::vertex_curve(opened->surface(), ids(list), closed);
  };
  expect_one_order(opened->mesh(), vertices({9, 10, 11, 12}, false));
  // A square of 2 x 2, an L of the same outline's length, and a staircase up and back down.
  expect_one_order(opened->mesh(), vertices({9, 10, 11, 19, 27, 26, 25, 17}, true));
  expect_one_order(opened->mesh(), vertices({9, 10, 11, 19, 18, 26, 25, 17}, true));
  // Out and back; the way back differs at one point only.
  expect_one_order(opened->mesh(), vertices({9, 10, 11, 12, 13, 12, 11, 10}, true));
  expect_one_order(opened->mesh(), vertices({9, 10, 18, 26, 27, 26, 18, 17}, true));
  expect_one_order(opened->mesh(), vertices({9, 10, 18, 19, 27, 28, 36, 35, 34, 33, 25, 17}, true));
}

TEST(CanonicalOrder, TurnsDecideBeforePositionsDo) {
  // An L of eight equal segments. Its turns decide, so its position and rotation do not matter.
  const auto opened = OpenedMesh::open(grid(7, 7));
  const auto shape = [&](std::initializer_list<std::uint32_t> list) {
    return test::vertex_curve(opened->surface(), ids(list), true);
  };
  const SurfaceCurve there = shape({9, 10, 11, 19, 18, 26, 25, 17});
  const SurfaceCurve turned = shape({46, 45, 44, 36, 37, 29, 30, 38});  // rotated by a half turn
  const CurveOrder one = canonical_order(opened->mesh(), there);
  const CurveOrder other = canonical_order(opened->mesh(), turned);
  EXPECT_EQ(one.start, other.start);
  EXPECT_EQ(one.reversed, other.reversed);
}

TEST(CanonicalOrder, KeepsASinglePoint) {
  const auto opened = OpenedMesh::open(grid(5, 5));
  const SurfaceCurve point = test::vertex_curve(opened->surface(), ids({6}), false);
  EXPECT_EQ(in_order(point, canonical_order(opened->mesh(), point)).points, point.points);
}

TEST(CanonicalOrder, OfASetDoesNotDependOnTheListing) {
  const auto opened = OpenedMesh::open(grid(7, 7));
  const auto curve = [&](std::initializer_list<std::uint32_t> list, bool closed) {
    return test::vertex_curve(opened->surface(), ids(list), closed);
  };
  const std::vector<SurfaceCurve> set = {curve({33, 34, 42, 41}, true), curve({9, 10, 11}, false),
                                         curve({33, 34, 35}, false), curve({12, 21, 29}, false),
                                         curve({1, 2, 3, 4}, false)};
  const std::vector<std::size_t> expected = canonical_set_order(opened->mesh(), set);
  std::vector<std::size_t> listed = {0, 1, 2, 3, 4};
  do {
    std::vector<SurfaceCurve> other;
    for (const std::size_t c : listed) other.push_back(set[c]);
    const std::vector<std::size_t> found = canonical_set_order(opened->mesh(), other);
    for (std::size_t k = 0; k < set.size(); ++k) EXPECT_EQ(listed[found[k]], expected[k]);
  } while (std::next_permutation(listed.begin(), listed.end()));
  EXPECT_EQ(expected.back(), 0U);  // open curves come first
}

TEST(CanonicalOrder, ResultsHaveTheDirectionOfTheDrawing) {
  const auto opened = OpenedMesh::open(disturbed_grid());
  SurfaceCurve drawn = drawn_on(opened->surface(), false);
  CurveSmoother smoother(opened);
  std::vector<SurfacePoint> results[2];
  for (std::vector<SurfacePoint>& points : results) {
    smoother.set_curve(drawn);
    points = smoother.smooth(1.0).curve().points;
    EXPECT_EQ(points.front(), drawn.points.front());
    EXPECT_EQ(points.back(), drawn.points.back());
    std::reverse(drawn.points.begin(), drawn.points.end());
  }
  std::reverse(results[1].begin(), results[1].end());
  EXPECT_EQ(results[1], results[0]);
}

TEST(CanonicalOrder, ASlackFieldGoesWithItsPoints) {
  const auto opened = OpenedMesh::open(disturbed_grid());
  SurfaceCurve drawn = drawn_on(opened->surface(), false);
  SmoothingOptions options;
  options.tau = 2;
  auto& field = options.slack_at.emplace_back();
  for (std::size_t i = 0; i < drawn.points.size(); ++i) field.push_back(i < 10 ? 0.1 : 1.0);
  const SmoothingResult there = smooth_curve(opened, drawn, options);
  std::reverse(drawn.points.begin(), drawn.points.end());
  std::reverse(field.begin(), field.end());
  SmoothingResult back = smooth_curve(opened, drawn, options);
  std::reverse(back.curves[0].points.begin(), back.curves[0].points.end());
  EXPECT_EQ(back.curve().points, there.curve().points);
}

}  // namespace
}  // namespace talweg
