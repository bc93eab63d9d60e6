// The bounds of a deviation with a budget hold for every amount of work.
#include "talweg/core/measure/bounded_deviation.hpp"

#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/measure/deviation.hpp"

namespace talweg {
namespace {

using test::grid;
using test::ids;
using test::vertex_curve;

Progress of_work(std::uint64_t work) {
  Budget budget;
  budget.work = work;
  return Progress().with(budget);
}

/// A drawing, and a straight line that is far from it in places.
struct Pair {
  SurfaceMesh mesh;
  SurfaceCurve drawn, result;

  explicit Pair(MeshLists lists) : mesh(SurfaceMesh::open(std::move(lists))) {
    drawn = test::wave_on_hills(mesh);
    const SurfacePoint ends[] = {drawn.points.front(), drawn.points.back()};
    result = StraightLines(mesh.surface()).join(ends, false);
  }
  [[nodiscard]] SurfaceDeviation measured(const Progress& progress = {}) const {
    return DeviationMeter(mesh).measure(std::span(&result, 1), std::span(&drawn, 1), progress);
  }
};

/// hills(40) with every row of vertices but a few pressed together: needles.
MeshLists needles() {
  MeshLists lists = test::hills(40);
  for (Point& p : lists.points) p.y() = std::floor(p.y() / 4) * 4 + 1e-3 * std::fmod(p.y(), 4.0);
  return lists;
}

void expect_same(const OneSidedSurfaceDeviation& a, const OneSidedSurfaceDeviation& b) {
  EXPECT_EQ(a.max, b.max);
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.at, b.at);
  EXPECT_EQ(a.exact, b.exact);
  EXPECT_EQ(a.at_least, b.at_least);
}

void expect_bounds_that_hold(const OneSidedSurfaceDeviation& bound,
                             const OneSidedSurfaceDeviation& exact) {
  EXPECT_GE(bound.max, exact.max * (1 - 1e-12));
  EXPECT_LE(bound.at_least,
            exact.max * (1 + 1e-3) + 1e-3);  // within the tolerance of DeviationMeter
  EXPECT_GE(bound.mean, exact.mean * (1 - 1e-3));
  EXPECT_LE(bound.at_least, bound.max);
}

void expect_no_worse(const OneSidedSurfaceDeviation& more, const OneSidedSurfaceDeviation& less) {
  EXPECT_LE(more.max, less.max);
  EXPECT_GE(more.at_least, less.at_least);
  EXPECT_LE(more.mean, less.mean * (1 + 1e-3));  // the accuracy of the exact mean
}

void expect_bounds_for_all_work(const Pair& pair) {
  const SurfaceDeviation exact = pair.measured();
  ASSERT_TRUE(exact.is_exact());
  EXPECT_EQ(exact.to_drawn.at_least, exact.to_drawn.max);
  SurfaceDeviation last = pair.measured(of_work(1));
  EXPECT_FALSE(last.to_drawn.exact);
  EXPECT_FALSE(last.from_drawn.exact);
  std::size_t bounded = 0;
  for (std::uint64_t work = 100; work < 1'000'000'000; work += work / 5) {
    SCOPED_TRACE(work);
    const SurfaceDeviation found = pair.measured(of_work(work));
    expect_bounds_that_hold(found.to_drawn, exact.to_drawn);
    expect_bounds_that_hold(found.from_drawn, exact.from_drawn);
    expect_no_worse(found.to_drawn, last.to_drawn);
    expect_no_worse(found.from_drawn, last.from_drawn);
    const SurfaceDeviation again = pair.measured(of_work(work));
    expect_same(found.to_drawn, again.to_drawn);
    expect_same(found.from_drawn, again.from_drawn);
    last = found;
    if (found.is_exact()) break;
    ++bounded;
  }
  EXPECT_GT(bounded, 20U);
  expect_same(last.to_drawn, exact.to_drawn);
  expect_same(last.from_drawn, exact.from_drawn);
}

TEST(BoundedDeviation, HoldsAndBecomesBetterWithMoreWork) {
  expect_bounds_for_all_work(Pair(test::hills(40)));
}

TEST(BoundedDeviation, AmongNeedlesToo) { expect_bounds_for_all_work(Pair(needles())); }

TEST(BoundedDeviation, IsNotFarOffWithoutAnyWork) {
  const Pair pair(test::hills(40));
  const SurfaceDeviation exact = pair.measured(), rough = pair.measured(of_work(1));
  EXPECT_LT(rough.larger().max, 1.5 * exact.larger().max);
  EXPECT_GT(rough.larger().at_least, 0.5 * exact.larger().max);
}

TEST(BoundedDeviation, OfPointsAndOfPartsThatAreNotConnected) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::together(grid(4, 4), grid(4, 4), 9));
  const std::uint32_t row[] = {10, 11, 12}, other[] = {25, 26};
  const SurfaceCurve line = vertex_curve(mesh.surface(), ids(row), false);
  const SurfaceCurve there = vertex_curve(mesh.surface(), ids(other), false);
  const SurfaceCurve point{false, {SurfacePoint::at_vertex(mesh.surface(), VertexId{2})}};
  DeviationMeter meter(mesh);
  const auto near = meter.measure(std::span(&point, 1), std::span(&line, 1), of_work(1));
  EXPECT_NEAR(near.to_drawn.max, 2, 1e-12);  // straight up along edges
  EXPECT_NEAR(near.to_drawn.at_least, 2, 1e-12);
  EXPECT_FALSE(near.to_drawn.exact);
  const auto apart = meter.measure(std::span(&there, 1), std::span(&line, 1), of_work(1));
  EXPECT_EQ(apart.to_drawn.max, HUGE_VAL);
  EXPECT_EQ(apart.to_drawn.mean, HUGE_VAL);
}

TEST(BoundedDeviation, NeedsNoClockAndNoCallback) {
  const Pair pair(test::hills(40));
  std::size_t asked = 0;
  Budget budget;
  budget.work = 5000;
  const Progress progress = Progress([&](const char*, double) { return ++asked > 0; }).with(budget);
  expect_same(pair.measured(progress).to_drawn, pair.measured(of_work(5000)).to_drawn);
  EXPECT_GT(asked, 0U);
}

}  // namespace
}  // namespace talweg
