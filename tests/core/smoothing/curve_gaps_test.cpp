// Gaps between the curves of a set, compared with known values.
#include "talweg/core/smoothing/curve_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::grid;

constexpr std::uint32_t kGapColumns = 20;

/// Along a row of the grid's vertices, from column to column.
SurfaceCurve row(const Surface& surface, std::uint32_t j, std::uint32_t from, std::uint32_t to) {
  std::vector<VertexId> path;
  for (std::uint32_t i = from; i <= to; ++i) path.emplace_back(j * (kGapColumns + 1) + i);
  return test::vertex_curve(surface, path, false);
}

TEST(CurveGaps, AreThoseOfTheNearestPoints) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(kGapColumns, kGapColumns));
  const Surface& s = mesh.surface();
  const std::vector<SurfaceCurve> rows{row(s, 2, 0, 20), row(s, 5, 3, 9), row(s, 9, 13, 15)};
  const std::vector<double> gaps = gaps_to_others(mesh, rows, 6);
  EXPECT_NEAR(gaps[0], 3, 1e-12);
  EXPECT_NEAR(gaps[1], 3, 1e-12);
  EXPECT_NEAR(gaps[2], std::hypot(4, 4), 1e-12);
  for (const double gap : gaps_to_others(mesh, rows, 2.9)) EXPECT_EQ(gap, HUGE_VAL);
}

TEST(CurveGaps, CurvesThatTouchDoNotCountForEachOther) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(kGapColumns, kGapColumns));
  const Surface& s = mesh.surface();
  const std::vector<SurfaceCurve> curves{row(s, 5, 0, 7), row(s, 5, 7, 12), row(s, 8, 2, 4)};
  const std::vector<double> gaps = gaps_to_others(mesh, curves, 10);
  EXPECT_NEAR(gaps[0], 3, 1e-12);
  EXPECT_NEAR(gaps[1], std::hypot(3, 3), 1e-12);
  EXPECT_NEAR(gaps[2], 3, 1e-12);
}

/// The gap of two curves by exact distances of all points of each to the other.
double gap_of_pair(const SurfaceMesh& mesh, const SurfaceCurve& a, const SurfaceCurve& b) {
  PolylineDistance distance(mesh.surface());
  double least = HUGE_VAL;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    distance.set(std::span(to, 1));
    for (const SurfacePoint& p : from->points) least = std::min(least, distance.at(p).distance);
  }
  return least;
}

// Short and long curves between random points, many of which cross or touch.
TEST(CurveGaps, OfRandomCurvesAreThoseOfAllPairs) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::hills(24));
  StraightLines lines(mesh.surface());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int run = 0; run < 4; ++run) {
    std::vector<SurfaceCurve> curves;
    for (int c = 0; c < 14; ++c) {
      CurveInput input;
      std::vector<Point> points;
      const double length = c % 4 == 0 ? 14 : 1.5;
      const double x = (24 - length) * unit(random);
      const double y = (24 - length) * unit(random);
      for (int k = 0; k < 3; ++k) {
        const double across = length * unit(random);  // separate statements fix the order
        const double along = length * unit(random);
        points.emplace_back(x + across, y + along, 0);
      }
      input.points = points;
      curves.push_back(lines.join(snap(mesh, input).points, false));
    }
    const double limit = run % 2 == 0 ? 3 : 9;
    const std::vector<double> gaps = gaps_to_others(mesh, curves, limit);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      double least = HUGE_VAL;
      for (std::size_t j = 0; j < curves.size(); ++j) {
        if (i == j) continue;
        const double gap = gap_of_pair(mesh, curves[i], curves[j]);
        if (gap > 1e-9 * limit && gap < limit) least = std::min(least, gap);
      }
      if (std::isinf(least)) {
        EXPECT_EQ(gaps[i], least) << run << ", curve " << i;
      } else {
        EXPECT_NEAR(gaps[i], least, 1e-9) << run << ", curve " << i;
      }
    }
  }
}

// Two sheets a hundredth apart, not connected: near in space, not on the surface.
TEST(CurveGaps, GoAlongTheSurface) {
  MeshLists lists = grid(kGapColumns, kGapColumns);
  const auto vertices = static_cast<std::uint32_t>(lists.points.size());
  const std::vector<std::array<std::uint32_t, 3>> faces(lists.triangles.begin(),
                                                        lists.triangles.end());
  for (std::uint32_t v = 0; v < vertices; ++v) {
    lists.points.push_back(lists.points[v] + Point(0, 0, 0.01));
  }
  for (const auto& f : faces) {
    lists.triangles.push_back({f[0] + vertices, f[1] + vertices, f[2] + vertices});
  }
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const SurfaceCurve below = row(mesh.surface(), 5, 3, 9);
  std::vector<VertexId> path;
  for (std::uint32_t i = 3; i <= 9; ++i) path.emplace_back(vertices + 5 * (kGapColumns + 1) + i);
  const SurfaceCurve above = test::vertex_curve(mesh.surface(), path, false);
  for (const double gap : gaps_to_others(mesh, std::vector{below, above}, 4)) {
    EXPECT_EQ(gap, HUGE_VAL);
  }
}

// Overlapping slacks would let the curves cross.
TEST(CurveGaps, KeepTheSlacksOfASetApart) {
  const auto opened = OpenedMesh::open(grid(kGapColumns, kGapColumns));
  const Surface& s = opened->surface();
  CurveSmoother smoother(opened);
  smoother.set_curve(row(s, 5, 1, 19));
  const double alone = smoother.slack()[0];
  smoother.set_curves(std::vector{row(s, 5, 1, 19), row(s, 6, 1, 19)});
  EXPECT_GT(alone, 0.5);
  EXPECT_NEAR(smoother.slack()[0], 0.45, 1e-12);
  EXPECT_NEAR(smoother.slack()[1], 0.45, 1e-12);
}

}  // namespace
}  // namespace talweg
