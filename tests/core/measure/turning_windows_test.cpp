// Windows along curves against closed forms and against sums over each window.
#include "talweg/core/measure/turning_windows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/measure/measures.hpp"

namespace talweg {
namespace {

constexpr double kPi = std::numbers::pi;

/// The sum of the turns in the closed window about `place`; on a closed curve positions count
/// modulo its length.
double sum_about(const CurveTurns& turns, double place, double window) {
  double sum = 0;
  for (std::size_t k = 0; k < turns.at.size(); ++k) {
    for (const double round : {-turns.length, 0.0, turns.length}) {
      if (round != 0 && !turns.closed) continue;
      if (std::abs(turns.at[k] + round - place) <= window / 2) sum += turns.angle[k];
    }
  }
  return sum;
}

CurveTurns random_turns(std::uint32_t seed, bool closed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  CurveTurns turns;
  turns.length = 10;
  turns.closed = closed;
  for (int k = 0; k < 60; ++k) {
    turns.at.push_back(10 * unit(random));
    turns.angle.push_back(2 * unit(random) - 0.8);
  }
  std::sort(turns.at.begin(), turns.at.end());
  return turns;
}

TEST(TurningWindows, OneKinkAloneBendsByTwiceItsSquare) {
  for (const bool closed : {false, true}) {
    for (const double at : {0.0, 1.0, 4.0}) {
      const CurveTurns kink{{at}, {0.7}, 4, closed};
      EXPECT_NEAR(bending(kink, 0.3), 2 * 0.7 * 0.7, 1e-12) << closed << at;
      EXPECT_NEAR(window_turning(kink, 0.3), 0.7, 1e-15) << closed << at;
    }
  }
}

TEST(TurningWindows, TurnsOneWindowApartCountTogether) {
  const CurveTurns stairs{{0.1, 0.1 + 0.3, 0.1 + 0.3 + 0.3}, {1, 1, -1}, 2, false};
  EXPECT_DOUBLE_EQ(window_turning(stairs, 0.3), 2);
  const CurveTurns zigzag{{0.5, 0.55, 0.6}, {1, -1, 1}, 2, false};  // turns back at once
  EXPECT_DOUBLE_EQ(window_turning(zigzag, 0.3), 1);
}

TEST(TurningWindows, AgreeWithSumsOverEachWindow) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    for (const bool closed : {false, true}) {
      const CurveTurns turns = random_turns(seed, closed);
      const double edge = 0.1 * seed;
      constexpr int kPlaces = 40000;
      const double from = closed ? 0 : -2, to = closed ? 10 : 12;
      double integral = 0, largest = 0;
      for (int k = 0; k < kPlaces; ++k) {
        const double place = from + (to - from) * (k + 0.5) / kPlaces;
        const double curvature = sum_about(turns, place, edge / 2) / (edge / 2);
        integral += edge * curvature * curvature * (to - from) / kPlaces;
        largest = std::max(largest, std::abs(sum_about(turns, place, edge)));
      }
      EXPECT_NEAR(bending(turns, edge), integral, 0.01 * integral) << seed << closed;
      EXPECT_GE(window_turning(turns, edge), largest - 1e-12) << seed << closed;
      EXPECT_LE(window_turning(turns, edge), 1.1 * largest) << seed << closed;
    }
  }
}

TEST(TurningWindows, CurvatureAlongACurveIsTheSumInEachWindow) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    for (const bool closed : {false, true}) {
      const CurveTurns turns = random_turns(seed, closed);
      const double window = 0.05 * seed;
      double end = 0, square = 0;
      for (const CurvatureStep& step : curvature_along(turns, window)) {
        EXPECT_NEAR(step.from, end, 1e-12);
        ASSERT_GT(step.to, step.from);
        end = step.to;
        const double middle = (step.from + step.to) / 2;
        EXPECT_NEAR(step.curvature, sum_about(turns, middle, window) / window, 1e-9);
        square += (step.to - step.from) * step.curvature * step.curvature;
      }
      EXPECT_NEAR(end, turns.length, 1e-12);
      if (closed) {
        EXPECT_NEAR(2 * window * square, bending(turns, 2 * window), 1e-9);
      }
    }
  }
  EXPECT_TRUE(curvature_along({}, 1).empty());
  EXPECT_TRUE(curvature_along({{0.5}, {1}, 1, false}, 0).empty());
}

TEST(TurningWindows, LoopsShorterThanTheWindowCountEachTurnOnce) {
  const CurveTurns square{{0, 1, 2, 3}, {kPi / 2, kPi / 2, kPi / 2, kPi / 2}, 4, true};
  EXPECT_NEAR(window_turning(square, 100), 2 * kPi, 1e-12);
  EXPECT_NEAR(bending(square, 1000), 1000 * 4 * std::pow(2 * kPi / 4, 2), 1e-4);
}

TEST(TurningWindows, NothingToMeasureIsZero) {
  EXPECT_EQ(bending({}, 1), 0);
  EXPECT_EQ(window_turning({}, 1), 0);
  EXPECT_EQ(bending({{0}, {1}, 0, true}, 1), 0);
  EXPECT_EQ(bending({{0}, {1}, 1, false}, 0), 0);
}

/// The middle ring of vertices of a net whose rows have these radii and heights.
CurveMeasures ring_measures(const std::vector<double>& radii, const std::vector<double>& heights,
                            double edge) {
  constexpr std::uint32_t kColumns = 720;
  MeshLists lists;
  for (std::size_t j = 0; j < radii.size(); ++j) {
    for (std::uint32_t i = 0; i < kColumns; ++i) {
      const double angle = 2 * kPi * i / kColumns;
      lists.points.emplace_back(radii[j] * std::cos(angle), radii[j] * std::sin(angle), heights[j]);
    }
  }
  test::add_net(lists, kColumns, static_cast<std::uint32_t>(radii.size()), false);
  const Surface surface = test::surface_of_lists(lists);
  std::vector<VertexId> ring;
  for (std::uint32_t i = 0; i < kColumns; ++i) ring.emplace_back(kColumns + i);
  return measure_curve(surface, test::vertex_curve(surface, ring, true), edge);
}

TEST(TurningWindows, CircleOfASphere) {
  const double polar = kPi / 5, step = 0.01, edge = 0.2;
  std::vector<double> radii, heights;
  for (const double at : {polar + step, polar, polar - step}) {
    radii.push_back(std::sin(at));
    heights.push_back(std::cos(at));
  }
  const CurveMeasures m = ring_measures(radii, heights, edge);
  const double curvature = std::cos(polar) / std::sin(polar), length = 2 * kPi * std::sin(polar);
  EXPECT_NEAR(m.length, length, 1e-3 * length);
  EXPECT_NEAR(m.bending, edge * curvature * curvature * length, 2e-3 * m.bending);
  EXPECT_NEAR(m.window_turning, curvature * edge, 0.03 * m.window_turning);
  EXPECT_NEAR(m.window_turning_2, curvature * 2 * edge, 0.03 * m.window_turning_2);
}

TEST(TurningWindows, CircleAroundTheApexOfACone) {
  // On a cone of half-angle 0.4 the circle at the distance d from the apex has curvature 1 / d.
  const double half = 0.4, d = 1.5, edge = 0.25;
  std::vector<double> radii, heights;
  for (const double at : {d - 0.02, d, d + 0.02}) {
    radii.push_back(at * std::sin(half));
    heights.push_back(at * std::cos(half));
  }
  const CurveMeasures m = ring_measures(radii, heights, edge);
  EXPECT_NEAR(m.bending, edge / (d * d) * 2 * kPi * d * std::sin(half), 2e-3 * m.bending);
  EXPECT_NEAR(m.window_turning, edge / d, 0.03 * m.window_turning);
}

TEST(TurningWindows, CircleOnAnUnrolledCylinder) {
  constexpr std::uint32_t kColumns = 60, kRows = 21;
  const SurfaceMesh mesh = SurfaceMesh::open(test::tube(kColumns, kRows, 4));
  const double side = 2 * std::sin(kPi / kColumns), radius = 0.8, edge = 0.3;
  std::vector<Point> circle;
  for (int k = 0; k < 1440; ++k) {
    const double angle = 2 * kPi * k / 1440;
    const double across = 10 + (radius * std::cos(angle) + 0.01) / side,
                 column = std::floor(across);
    const auto at = [](double c) {
      return Point(std::cos(2 * kPi * c / kColumns), std::sin(2 * kPi * c / kColumns), 0);
    };
    Point p = (column + 1 - across) * at(column) + (across - column) * at(column + 1);
    p.z() = 2 + radius * std::sin(angle);
    circle.push_back(p);
  }
  const SnappedCurve snapped = snap(mesh, CurveInput{true, circle, {}});
  const SurfaceCurve curve = StraightLines(mesh.surface()).join(snapped.points, true);
  const CurveMeasures m = measure_curve(mesh.surface(), curve, edge);
  EXPECT_NEAR(m.length, 2 * kPi * radius, 1e-3);
  EXPECT_NEAR(std::abs(m.signed_curvature), 2 * kPi, 1e-9);
  EXPECT_NEAR(m.bending, edge * 2 * kPi / radius, 2e-3 * m.bending);
  EXPECT_NEAR(m.window_turning, edge / radius, 0.03 * m.window_turning);
  // A ring of the cylinder itself is straight.
  const CurveMeasures straight = ring_measures({1, 1, 1}, {0, 0.1, 0.2}, edge);
  EXPECT_NEAR(straight.bending, 0, 1e-12);
  EXPECT_NEAR(straight.window_turning, 0, 1e-9);
}

}  // namespace
}  // namespace talweg
