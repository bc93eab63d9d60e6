#include "talweg/core/measure/surface_deviation.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/reference_data.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/measure/deviation.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

using test::grid;
using test::ids;
using test::vertex_curve;

SurfaceCurve line(const SurfaceMesh& mesh, std::vector<Point> points, bool closed = false) {
  CurveInput input;
  input.closed = closed;
  input.points = std::move(points);
  return StraightLines(mesh.surface()).join(snap(mesh, input).points, closed);
}

SurfaceDeviation measure(const SurfaceMesh& mesh, const SurfaceCurve& result,
                         const SurfaceCurve& drawn) {
  return DeviationMeter(mesh).measure(std::span(&result, 1), std::span(&drawn, 1));
}

/// The accuracy of a maximum: not larger than the true value, and at most 1e-3 smaller.
void expect_max(double found, double truth, double segment) {
  EXPECT_LE(found, truth * (1 + 1e-9) + 1e-12);
  EXPECT_GE(found, truth - 1.001e-3 * std::max(truth, segment));
}

TEST(SurfaceDeviation, OfParallelLinesInThePlane) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(30, 20));
  const Point along = Point(15, 4, 0).normalized(), across(-along.y(), along.x(), 0);
  for (const double gap : {0.01, 0.3, 1.0, 4.7}) {
    const Point a(6, 4.2, 0), b = a + gap * across;
    const SurfaceCurve p = line(mesh, {a, a + 20 * along}), q = line(mesh, {b, b + 20 * along});
    const SurfaceDeviation d = measure(mesh, p, q);
    for (const auto& side : {d.to_drawn, d.from_drawn}) {
      EXPECT_NEAR(side.max, gap, 1e-9);
      EXPECT_NEAR(side.mean, gap, 1e-9);
    }
  }
}

TEST(SurfaceDeviation, AgreesWithTheEuclideanOneInThePlane) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(30, 30));
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> place(1, 29);
  for (int k = 0; k < 10; ++k) {
    std::vector<Point> a, b;
    for (int i = 0; i < 4; ++i) {
      a.emplace_back(place(engine), place(engine), 0);
      b.emplace_back(place(engine), place(engine), 0);
    }
    const bool closed = k % 2 == 1;
    const SurfaceCurve p = line(mesh, a, closed), q = line(mesh, b, closed);
    const SurfaceDeviation d = measure(mesh, p, q);
    const Deviation plane = deviation(a, closed, b, closed);
    expect_max(d.to_drawn.max, plane.to_drawn.max * (1 + 1e-6), 1);
    expect_max(d.from_drawn.max, plane.from_drawn.max * (1 + 1e-6), 1);
    EXPECT_NEAR(d.to_drawn.mean, plane.to_drawn.mean, 2e-3 * plane.to_drawn.mean);
    EXPECT_NEAR(d.from_drawn.mean, plane.from_drawn.mean, 2e-3 * plane.from_drawn.mean);
    // The distance at the reported point is the maximum.
    const NearestSegment tree(segments_of(b, closed));
    EXPECT_NEAR(tree.to(mesh.position(d.to_drawn.at)).distance, d.to_drawn.max, 1e-9);
    EXPECT_EQ(d.larger().max, std::max(d.to_drawn.max, d.from_drawn.max));
  }
}

/// Each part of such a drawing computes distances over all faces. Found by fuzzing: minutes on
/// meshes that were divided along their drawing.
TEST(SurfaceDeviation, OfAWindingDrawingFarFromItsResult) {
  constexpr int kSize = 60;
  const SurfaceMesh mesh = SurfaceMesh::open(grid(kSize, kSize));
  std::vector<Point> windings;
  for (int row = 0; row < 100; ++row) {
    for (int k = 0; k <= 20; ++k) {
      windings.emplace_back(20.0 + (row % 2 == 0 ? k : 20 - k), 10 + 0.4 * row + 0.01 * k, 0);
    }
  }
  const std::vector<Point> result = {{1.3, 1.2, 0}, {58.1, 2.4, 0}};
  const SurfaceDeviation d = measure(mesh, line(mesh, result), line(mesh, windings));
  const Deviation plane = deviation(result, false, windings, false);
  expect_max(d.from_drawn.max, plane.from_drawn.max * (1 + 1e-6), 1);
  expect_max(d.to_drawn.max, plane.to_drawn.max * (1 + 1e-6), 1);
  EXPECT_NEAR(d.from_drawn.mean, plane.from_drawn.mean, 2e-3 * plane.from_drawn.mean);
  EXPECT_NEAR(d.to_drawn.mean, plane.to_drawn.mean, 2e-3 * plane.to_drawn.mean);
}

TEST(SurfaceDeviation, SeesACornerThatWasCut) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(12, 8));
  const SurfaceCurve drawn = line(mesh, {{1, 2, 0}, {6, 5, 0}, {11, 2, 0}});
  const SurfaceCurve result = line(mesh, {{1, 2, 0}, {11, 2, 0}});
  const SurfaceDeviation d = measure(mesh, result, drawn);
  EXPECT_NEAR(d.from_drawn.max, 3, 1e-9);
  EXPECT_NEAR(d.from_drawn.mean, 1.5, 2e-3);
  EXPECT_LT((mesh.position(d.from_drawn.at) - Point(6, 5, 0)).norm(), 1e-9);
  // In the middle of the base, to the line through (1, 2) and (6, 5).
  expect_max(d.to_drawn.max, 15 / std::sqrt(34.0), 1);
  EXPECT_LT((mesh.position(d.to_drawn.at) - Point(6, 2, 0)).norm(), 0.01);
  EXPECT_NEAR(d.to_drawn.mean, 7.5 / std::sqrt(34.0), 2e-3);
  EXPECT_EQ(&d.larger(), &d.from_drawn);
}

TEST(SurfaceDeviation, GoesOverTheRidgeAndNotBelowIt) {
  // A sheet folded along x = 10 to a right angle: distances along the surface are those of the
  // plane.
  const MeshLists flat_lists = grid(20, 12);
  MeshLists folded_lists = flat_lists;
  for (Point& p : folded_lists.points) {
    if (p.x() > 10) p = Point(10, p.y(), 10 - p.x());
  }
  const SurfaceMesh flat = SurfaceMesh::open(flat_lists), folded = SurfaceMesh::open(folded_lists);
  const std::vector<Point> a{{7.1, 1.3, 0}, {8.2, 10.9, 0}}, b{{12.4, 1.9, 0}, {13.7, 11.2, 0}};
  const SurfaceCurve p = line(flat, a), q = line(flat, b);
  const SurfaceDeviation d = measure(folded, p, q);
  const Deviation plane = deviation(a, false, b, false);
  const Deviation space = deviation(positions_of(folded, p), false, positions_of(folded, q), false);
  expect_max(d.to_drawn.max, plane.to_drawn.max * (1 + 1e-6), 1);
  expect_max(d.from_drawn.max, plane.from_drawn.max * (1 + 1e-6), 1);
  EXPECT_NEAR(d.to_drawn.mean, plane.to_drawn.mean, 2e-3 * plane.to_drawn.mean);
  EXPECT_NEAR(d.from_drawn.mean, plane.from_drawn.mean, 2e-3 * plane.from_drawn.mean);
  EXPECT_LT(space.to_drawn.max, 0.9 * d.to_drawn.max);  // through the air it is shorter
}

TEST(SurfaceDeviation, OfACurveFromItselfIsZero) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::sphere(4));
  const auto path = draw_edge_path(mesh.surface(), ids({0, 600, 3, 200}));
  const SurfaceCurve drawn = vertex_curve(mesh.surface(), path, false);
  SurfaceCurve finer{false, {}};
  for (std::size_t i = path.size(); i-- > 0;) {
    finer.points.push_back(drawn.points[i]);
    if (i > 0) {
      finer.points.push_back(test::between(mesh.surface(),
                                           static_cast<std::uint32_t>(path[i].index()),
                                           static_cast<std::uint32_t>(path[i - 1].index()), 0.3));
    }
  }
  const SurfaceDeviation d = measure(mesh, finer, drawn);
  for (const auto& side : {d.to_drawn, d.from_drawn}) {
    EXPECT_LT(side.max, 1e-12);
    EXPECT_LT(side.mean, 1e-12);
  }
}

TEST(SurfaceDeviation, IsNeverLessThanTheEuclideanOneOrASample) {
  for (const char* name : {"fandisk_14k", "aneurysm_14k"}) {
    const auto drawn = test::reference_curve(name);
    if (!drawn) GTEST_SKIP() << test::missing(name);
    const SurfaceMesh& mesh = drawn->mesh;
    double moved = 0;
    const SurfaceCurve result = test::reference_result_curve(*drawn, name, moved);
    const SurfaceCurve drawing = vertex_curve(mesh.surface(), drawn->path, drawn->closed);
    const SurfaceDeviation d = measure(mesh, result, drawing);
    const Deviation space = deviation(positions_of(mesh, result), drawn->closed,
                                      positions_of(mesh, drawing), drawn->closed);
    const double h = mesh.mean_edge_length();
    EXPECT_GE(d.to_drawn.max, space.to_drawn.max - 2e-3 * h) << name;
    EXPECT_GE(d.from_drawn.max, space.from_drawn.max - 2e-3 * h) << name;
    // Brute force: samples at every tenth of every segment.
    PolylineDistance to(mesh.surface());
    to.set(std::span(&drawing, 1));
    double largest = 0, integral = 0, length = 0;
    const auto& points = result.points;
    for (std::size_t i = 0; i + (result.closed ? 0 : 1) < points.size(); ++i) {
      const SurfacePoint &p = points[i], &q = points[(i + 1) % points.size()];
      const FaceId face = common_face(mesh.surface(), p, q);
      const auto a = coordinates_in(mesh.surface(), p, face);
      const auto b = coordinates_in(mesh.surface(), q, face);
      const double own = distance_in_face(mesh.surface(), a, b);
      for (int k = 0; k < 10; ++k) {
        std::array<double, 3> at{};
        for (std::size_t j = 0; j < 3; ++j) {
          at[j] = a.barycentric[j] + (k + 0.5) / 10 * (b.barycentric[j] - a.barycentric[j]);
        }
        const double distance =
            to.at(SurfacePoint::from_barycentric(mesh.surface(), face, at)).distance;
        largest = std::max(largest, distance);
        integral += distance * own / 10;
      }
      length += own;
    }
    EXPECT_GE(d.to_drawn.max, largest - 1e-3 * std::max(h, largest)) << name;
    EXPECT_NEAR(d.to_drawn.mean, integral / length, 3e-3 * std::max(h, integral / length)) << name;
  }
}

TEST(SurfaceDeviation, ScalesWithTheMesh) {
  MeshLists lists = grid(12, 8);
  const std::vector<Point> drawn{{1, 2, 0}, {6, 5, 0}, {11, 2.3, 0}}, result{{1, 2, 0}, {11, 3, 0}};
  const SurfaceMesh unit = SurfaceMesh::open(lists);
  const SurfaceDeviation one = measure(unit, line(unit, result), line(unit, drawn));
  for (Point& p : lists.points) p *= 1e-6;
  const auto small_points = [](std::vector<Point> points) {
    for (Point& p : points) p *= 1e-6;
    return points;
  };
  const SurfaceMesh tiny = SurfaceMesh::open(lists);
  const SurfaceDeviation small =
      measure(tiny, line(tiny, small_points(result)), line(tiny, small_points(drawn)));
  EXPECT_NEAR(small.to_drawn.max * 1e6, one.to_drawn.max, 2e-3 * one.to_drawn.max);
  EXPECT_NEAR(small.from_drawn.mean * 1e6, one.from_drawn.mean, 2e-3 * one.from_drawn.mean);
}

TEST(SurfaceDeviation, OnAnotherComponentIsInfiniteAndNeverNaN) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::together(grid(4, 4), grid(4, 4), 100));
  const SurfaceCurve here = vertex_curve(mesh.surface(), ids({6, 7, 8}), false);
  const SurfaceCurve there = vertex_curve(mesh.surface(), ids({31, 32, 33}), false);
  const double infinity = std::numeric_limits<double>::infinity();
  const SurfaceDeviation d = measure(mesh, here, there);
  for (const auto& side : {d.to_drawn, d.from_drawn}) {
    EXPECT_EQ(side.max, infinity);
    EXPECT_EQ(side.mean, infinity);
  }
  // Both curves against one of them: the other is on an unreachable component.
  DeviationMeter meter(mesh);
  const SurfaceDeviation half = meter.measure(std::vector{here, there}, std::span(&here, 1));
  EXPECT_EQ(half.to_drawn.max, infinity);
  EXPECT_EQ(half.to_drawn.mean, infinity);
  EXPECT_EQ(half.from_drawn.max, 0);
  EXPECT_EQ(mesh.position(half.to_drawn.at), Point(101, 1, 0));
}

TEST(SurfaceDeviation, AMeterCanBeUsedAgain) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::sphere(4));
  const Surface& surface = mesh.surface();
  const auto way = [&](std::initializer_list<std::uint32_t> through) {
    return vertex_curve(surface, draw_edge_path(surface, ids(through)), false);
  };
  const std::vector<SurfaceCurve> curves = {way({0, 600, 3}), way({0, 200, 3}), way({5, 900})};
  DeviationMeter meter(mesh);
  const auto same = [&](const SurfaceDeviation& a, const SurfaceDeviation& b) {
    EXPECT_EQ(a.to_drawn.max, b.to_drawn.max);
    EXPECT_EQ(a.to_drawn.mean, b.to_drawn.mean);
    EXPECT_EQ(a.from_drawn.max, b.from_drawn.max);
    EXPECT_EQ(a.from_drawn.mean, b.from_drawn.mean);
    EXPECT_EQ(a.larger().at, b.larger().at);
  };
  for (const std::size_t drawn : {0U, 0U, 2U, 1U, 0U}) {
    for (const std::size_t result : {1U, 2U, 0U}) {
      const SurfaceDeviation fresh = measure(mesh, curves[result], curves[drawn]);
      same(meter.measure(std::span(&curves[result], 1), std::span(&curves[drawn], 1)), fresh);
      PolylineDistance own(surface);
      own.set(std::span(&curves[drawn], 1));
      // The whole band at once: the same distances, at other samples.
      const SurfaceDeviation whole =
          meter.measure(std::span(&curves[result], 1), std::span(&curves[drawn], 1), own);
      EXPECT_NEAR(whole.to_drawn.max, fresh.to_drawn.max, 2e-3 * fresh.to_drawn.max);
      EXPECT_NEAR(whole.to_drawn.mean, fresh.to_drawn.mean, 2e-3 * fresh.to_drawn.max);
      EXPECT_EQ(whole.from_drawn.max, fresh.from_drawn.max);
      EXPECT_EQ(whole.from_drawn.mean, fresh.from_drawn.mean);
    }
  }
  // A measurement that throws leaves no trace.
  EXPECT_THROW(meter.measure(std::span(&curves[0], 1), std::vector{SurfaceCurve{}}), Error);
  const SurfaceCurve torn = vertex_curve(surface, ids({0, 1}), false);
  EXPECT_THROW(meter.measure(std::span(&curves[0], 1), std::span(&torn, 1)), Error);
  EXPECT_THROW(meter.measure(std::span(&torn, 1), std::span(&curves[0], 1)), Error);
  EXPECT_THROW(meter.measure({}, std::span(&curves[0], 1)), Error);
  EXPECT_THROW(meter.measure(std::span(&curves[0], 1), {}), Error);
  same(meter.measure(std::span(&curves[1], 1), std::span(&curves[0], 1)),
       measure(mesh, curves[1], curves[0]));
}

/// The lines run in other faces all along, each nearly on the edges between them.
TEST(SurfaceDeviation, OfLinesOnBothSidesOfTheSameEdgesIsMeasuredWithLittleWork) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(30, 20));
  const double off = 1e-4;
  const SurfaceCurve above = line(mesh, {{4.2, 10 + off, 0}, {26.3, 10 + off, 0}});
  const SurfaceCurve below = line(mesh, {{4.2, 10 - off, 0}, {26.3, 10 - off, 0}});
  Budget budget;
  budget.work = 100'000;
  DeviationMeter meter(mesh);
  const SurfaceDeviation d =
      meter.measure(std::span(&above, 1), std::span(&below, 1), Progress().with(budget));
  EXPECT_TRUE(d.is_exact());
  EXPECT_NEAR(d.to_drawn.max, 2 * off, 1e-9);
  EXPECT_LE(d.from_drawn.max, 2 * off + 1e-9);
}

TEST(SurfaceDeviation, OfSinglePoints) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(8, 8));
  const SurfaceCurve point = vertex_curve(mesh.surface(), ids({4 * 9 + 4}), false);
  const SurfaceCurve row = vertex_curve(mesh.surface(), ids({2 * 9 + 3, 2 * 9 + 4}), false);
  const SurfaceDeviation d = measure(mesh, point, row);
  EXPECT_NEAR(d.to_drawn.max, 2, 1e-12);
  EXPECT_NEAR(d.to_drawn.mean, 2, 1e-12);
  EXPECT_NEAR(d.from_drawn.max, std::sqrt(5.0), 1e-12);
  EXPECT_EQ(mesh.position(d.from_drawn.at), Point(3, 2, 0));
}

}  // namespace
}  // namespace talweg
