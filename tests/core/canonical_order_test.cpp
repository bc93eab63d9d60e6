#include "talweg/core/canonical_order.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/core/curve_smoother.hpp"
#include "talweg/core/drawing.hpp"

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

TEST(CanonicalOrder, IsThatOfTheReversedAndTheTurnedCurve) {
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

TEST(CanonicalOrder, OfEqualSegmentsIsAsDrawn) {
  const auto opened = OpenedMesh::open(grid(5, 5));
  const SurfaceCurve row = test::vertex_curve(opened->surface(), ids({6, 7, 8, 9}), false);
  EXPECT_EQ(in_order(row, canonical_order(opened->mesh(), row)).points, row.points);
  const SurfaceCurve point = test::vertex_curve(opened->surface(), ids({6}), false);
  EXPECT_EQ(in_order(point, canonical_order(opened->mesh(), point)).points, point.points);
}

TEST(CanonicalOrder, TheResultRunsAsTheDrawingDoes) {
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
