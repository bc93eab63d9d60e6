// Drawings beside ridges whose place is known.
#include "talweg/core/ridges/ridge_snapping.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/rough_meshes.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/mesh/border_points.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"
#include "talweg/talweg.hpp"

namespace talweg::ridge_snapping_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
using Height = std::function<double(double x, double y)>;

/// A sheet of unit squares with these heights, whose inner vertices are up to `jitter` beside their
/// places, so that no edge runs along a ridge by chance.
MeshLists sheet(std::uint32_t columns, std::uint32_t rows, const Height& height, double jitter) {
  MeshLists lists = test::grid(columns, rows);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> off(-jitter, jitter);
  for (Point& p : lists.points) {
    const bool inside = p.x() > 0 && p.y() > 0 && p.x() < columns && p.y() < rows;
    if (inside) p += Point(off(random), off(random), 0);
    p.z() = height(p.x(), p.y());
  }
  return lists;
}

/// Two planes that meet at this angle above y = `middle`, rounded over `radius`.
Height roof(double angle, double middle, double radius) {
  const double slope = std::tan(angle / 2);
  return [=](double, double y) {
    return -slope * std::sqrt((y - middle) * (y - middle) + radius * radius);
  };
}

struct Distances {
  double mean = 0, largest = 0;
};

/// Distances of the points of a curve from a line, seen from above.
Distances from_line(const SurfaceMesh& mesh, const SurfaceCurve& curve,
                    const std::function<double(const Point&)>& away) {
  Distances distances;
  double length = 0;
  const std::vector<Point> at = positions_of(mesh, curve);
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    const double weight = (at[k + 1] - at[k]).norm();
    const double here = std::abs(away((at[k] + at[k + 1]) / 2));
    distances.mean += weight * here;
    distances.largest = std::max(distances.largest, here);
    length += weight;
  }
  distances.mean /= length;
  return distances;
}

struct Ridged {
  SurfaceCurve drawn;
  RidgedDrawing drawing;
  [[nodiscard]] const SurfaceCurve& curve() const { return drawing.curves.front(); }
  [[nodiscard]] const RidgeMoves& moves() const { return drawing.moves.front(); }
};

Ridged ridged(const SurfaceMesh& mesh, const std::vector<Point>& points, bool closed,
              const RidgeOptions& options, bool clicks = false,
              std::span<const std::size_t> pins = {}) {
  const SnappedCurve snapped = snap(mesh, CurveInput{closed, points, {}});
  Ridged result;
  result.drawn = StraightLines(mesh.surface()).join(snapped.points, closed);
  MarkedPoints taken;
  std::vector<SurfacePoint> fixed;
  for (const SurfacePoint& point : snapped.points) {
    if (clicks) taken.way_points.push_back({point, 0});
  }
  for (const std::size_t pin : pins) fixed.push_back(snapped.points[pin]);
  result.drawing =
      snapped_to_ridges(mesh, std::span(&result.drawn, 1), fixed, std::move(taken), options);
  return result;
}

RidgeOptions strength(double s) {
  RidgeOptions options;
  options.strength = s;
  return options;
}

/// A hand along y = `middle` that trembles by two edges and more.
std::vector<Point> trembling(double from, double to, double middle, const Height& height) {
  std::vector<Point> points;
  for (double x = from; x <= to; x += 0.5) {
    const double y = middle + 0.5 + 2 * std::sin(x / 3) + 0.6 * std::sin(1.7 * x);
    points.emplace_back(x, y, height(x, y));
  }
  return points;
}

TEST(RidgeField, IsTheAngleOfACreaseAndZeroOnPlanesSpheresAndCylinders) {
  const SurfaceMesh crease = SurfaceMesh::open(sheet(30, 20, roof(60 * kDegree, 10, 0), 0));
  RidgeField field(crease, RidgeKind::kBoth, 3, 0);
  const auto vertex = [](std::size_t i, std::size_t j) { return VertexId{j * 31 + i}; };
  EXPECT_NEAR(field.at(vertex(15, 10)), 60 * kDegree, 16 * kDegree);
  EXPECT_LT(field.at(vertex(15, 13)), 2 * kDegree);
  EXPECT_LT(field.at(vertex(15, 16)), 1e-6);
  const HalfedgeId along = crease.surface().find_halfedge(vertex(15, 10), vertex(16, 10));
  EXPECT_NEAR(field.along(edge_of(along)), 60 * kDegree, 1e-9);
  EXPECT_LT(RidgeField(crease, RidgeKind::kConcave, 3, 0).at(vertex(15, 10)), 6 * kDegree);
  EXPECT_EQ(RidgeField(crease, RidgeKind::kConcave, 3, 0).along(edge_of(along)), 0);

  const SurfaceMesh ball = SurfaceMesh::open(test::sphere(5));
  RidgeField round(ball, RidgeKind::kBoth, 3 * ball.mean_edge_length(), 0);
  const SurfaceMesh arch = SurfaceMesh::open(sheet(
      30, 20, [](double, double y) { return std::sqrt(400 - (y - 10) * (y - 10)); }, 0));
  RidgeField bent(arch, RidgeKind::kBoth, 3, 0);
  for (std::size_t v = 0; v < 50; ++v) EXPECT_LT(round.at(VertexId{37 * v}), 2 * kDegree);
  for (std::size_t i = 8; i < 22; ++i) EXPECT_LT(bent.at(vertex(i, 10)), 1 * kDegree);
}

TEST(RidgeSnapping, AStrokeThatTremblesAroundARidgeRunsAlongIt) {
  for (const double noise : {0.0, 0.1, 0.3}) {
    const Height height = roof(90 * kDegree, 20.37, 1);
    MeshLists lists = sheet(80, 40, height, 0.3);
    if (noise > 0) lists = test::roughened(std::move(lists), noise);
    const SurfaceMesh mesh = SurfaceMesh::open(lists);
    const Ridged result = ridged(mesh, trembling(8, 72, 20.37, height), false, strength(1));
    const auto away = [](const Point& p) { return p.y() - 20.37; };
    EXPECT_GT(from_line(mesh, result.drawn, away).mean, 1);
    EXPECT_LT(from_line(mesh, result.curve(), away).mean, noise < 0.2 ? 0.35 : 0.55) << noise;
    EXPECT_GT(result.moves().moved, 0.9);
    EXPECT_GT(result.moves().farthest, 2);
    EXPECT_LT(result.moves().farthest, 5);
    for (std::size_t k = 0; k + 1 < result.curve().points.size(); ++k) {
      ASSERT_TRUE(
          common_face(mesh.surface(), result.curve().points[k], result.curve().points[k + 1])
              .valid());
    }
  }
}

TEST(RidgeSnapping, OnASharpCreaseItLiesExactly) {
  const Height height = roof(60 * kDegree, 20, 0);
  const SurfaceMesh mesh = SurfaceMesh::open(sheet(80, 40, height, 0));
  const Ridged result = ridged(mesh, trembling(8, 72, 20, height), false, strength(1));
  // An end may stay where it was drawn if the drawing leaves the crease just before it.
  for (const Point& p : positions_of(mesh, result.curve())) {
    if (p.x() > 12 && p.x() < 68) {
      EXPECT_LT(std::abs(p.y() - 20), 1e-9) << p.transpose();
    }
  }
}

TEST(RidgeSnapping, ADrawingThatLiesOnTheRidgeIsToldToLieThere) {
  const Height height = roof(60 * kDegree, 20, 0);
  const SurfaceMesh mesh = SurfaceMesh::open(sheet(80, 40, height, 0));
  for (const double step : {1.0, 0.4}) {  // vertices of the crease, and points between them
    std::vector<Point> points;
    for (double x = 8; x <= 72; x += step) points.emplace_back(x, 20, height(x, 20));
    const Ridged result = ridged(mesh, points, false, strength(1));
    EXPECT_EQ(result.moves().moved, 0);
    EXPECT_EQ(result.moves().farthest, 0);
    EXPECT_GT(result.moves().already, 0.99);
    EXPECT_EQ(result.moves().sentence(2).find(
                  "100 % of curve 2 lie on ridges as they were drawn; nothing had to be moved"),
              0U)
        << result.moves().sentence(2);
  }
  // The first half on the crease, the second two edges beside it.
  std::vector<Point> points;
  for (double x = 8; x <= 72; x += 1) {
    const double y = x <= 40 ? 20 : 22;
    points.emplace_back(x, y, height(x, y));
  }
  const RidgeMoves moves = ridged(mesh, points, false, strength(1)).moves();
  EXPECT_NEAR(moves.already, 0.5, 0.1);
  EXPECT_NEAR(moves.moved, 0.5, 0.1);
  EXPECT_GT(moves.farthest, 2);
  EXPECT_NE(moves.sentence(0).find("lay on ridges already"), std::string::npos);
}

TEST(RidgeSnapping, EndsOfStrokesBesideACreaseMoveOntoIt) {
  const Height height = roof(60 * kDegree, 20, 0);
  const SurfaceMesh mesh = SurfaceMesh::open(sheet(80, 40, height, 0));
  for (const double off : {-1.4, -0.65, 0.5, 0.9, 1.5}) {
    std::vector<Point> points;
    for (double x = 9.1; x < 70; x += 0.5) points.emplace_back(x, 20 + off, height(x, 20 + off));
    const Ridged result = ridged(mesh, points, false, strength(1));
    for (const SurfacePoint& end : {result.curve().points.front(), result.curve().points.back()}) {
      EXPECT_LT(std::abs(mesh.position(end).y() - 20), 0.3) << off;
    }
    const std::vector<std::size_t> pins{0, points.size() - 1};
    const Ridged pinned = ridged(mesh, points, false, strength(1), false, pins);
    EXPECT_EQ(pinned.curve().points.front(), pinned.drawn.points.front());
    EXPECT_EQ(pinned.curve().points.back(), pinned.drawn.points.back());
  }
}

TEST(RidgeSnapping, AStrokeThatEndsBehindACreaseIsNotPulledBack) {
  const Height height = roof(60 * kDegree, 20, 0);
  const SurfaceMesh mesh = SurfaceMesh::open(sheet(80, 40, height, 0));
  for (const double beyond : {0.3, 0.8, 2.0, 5.0}) {
    std::vector<Point> points;
    const double end = 20 + beyond;
    for (double y = 4; y < end; y += 0.5) points.emplace_back(40.3, y, height(0, y));
    points.emplace_back(40.3, end, height(0, end));
    const Ridged result = ridged(mesh, points, false, strength(1));
    EXPECT_EQ(result.curve().points, result.drawn.points) << beyond;
  }
}

TEST(RidgeSnapping, WithoutARidgeTheDrawingStaysToTheLastBit) {
  const Height flat = [](double, double) { return 0; };
  const Height hill = roof(90 * kDegree, 20, 0);
  const RidgeOptions full = strength(1);
  RidgeOptions valleys = full;
  valleys.kind = RidgeKind::kConcave;
  RidgeOptions narrow = full;
  narrow.band = 1;
  const struct {
    Height height;
    RidgeOptions options;
    double middle;
  } cases[] = {{flat, full, 20},    {hill, strength(0), 20}, {hill, strength(0.05), 20},
               {hill, valleys, 20}, {hill, narrow, 30},      {hill, full, 34}};
  for (const auto& c : cases) {
    const SurfaceMesh mesh = SurfaceMesh::open(sheet(80, 40, c.height, 0.3));
    const Ridged result = ridged(mesh, trembling(8, 72, c.middle, c.height), false, c.options);
    EXPECT_EQ(result.curve().points, result.drawn.points);
    if (c.options.strength == 0) {
      EXPECT_TRUE(result.drawing.moves.empty());
    } else {
      EXPECT_EQ(result.moves().moved, 0);
      EXPECT_NE(result.moves().sentence(3).find("Curve 3 stays as it was drawn"),
                std::string::npos);
    }
  }
}

TEST(RidgeSnapping, WhereTheRidgeEndsTheDrawingGoesOn) {
  const Height height = [](double x, double y) {
    const double part = std::clamp((45 - x) / 10, 0.0, 1.0);
    return -part * std::abs(y - 20.37);
  };
  const SurfaceMesh mesh = SurfaceMesh::open(sheet(80, 40, height, 0.3));
  const Ridged result = ridged(mesh, trembling(8, 72, 20.37, height), false, strength(1));
  EXPECT_GT(result.moves().moved, 0.3);
  EXPECT_LT(result.moves().moved, 0.7);
  const PointLookup drawn(result.drawn.points);
  for (const SurfacePoint& point : result.curve().points) {
    if (mesh.position(point).x() > 47) {
      EXPECT_TRUE(drawn.contains(point));
    }
  }
  EXPECT_EQ(result.curve().points.back(), result.drawn.points.back());
}

/// A crown whose margin is the ring of this radius, at an angle as seen from (50, 50).
double margin(double angle) { return 35 + 4 * std::cos(3 * angle); }
double from_margin(const Point& p) {
  return std::hypot(p.x() - 50, p.y() - 50) - margin(std::atan2(p.y() - 50, p.x() - 50));
}
double crown(double x, double y) {
  const double away = from_margin({x, y, 0});
  return -0.7 * std::sqrt(away * away + 1);
}
Point at_margin(double angle, double off) {
  const double r = margin(angle) + off;
  const double x = 50 + r * std::cos(angle), y = 50 + r * std::sin(angle);
  return {x, y, crown(x, y)};
}

TEST(RidgeSnapping, ALoopAroundAMarginStaysALoop) {
  const SurfaceMesh mesh = SurfaceMesh::open(sheet(100, 100, crown, 0.3));
  std::vector<Point> points;
  for (int i = 0; i < 400; ++i) {
    const double angle = 2 * std::numbers::pi * i / 400;
    points.push_back(at_margin(angle, 2 * std::sin(20 * angle) + std::sin(47 * angle)));
  }
  const Ridged result = ridged(mesh, points, true, strength(0.7));
  EXPECT_TRUE(result.curve().closed);
  EXPECT_FALSE(result.curve().points.front() == result.curve().points.back());
  EXPECT_GT(from_line(mesh, result.drawn, from_margin).mean, 1.2);
  const Distances after = from_line(mesh, result.curve(), from_margin);
  EXPECT_LT(after.mean, 0.25);
  EXPECT_LT(after.largest, 1);
  double winding = 0;
  const std::vector<Point> at = positions_of(mesh, result.curve());
  for (std::size_t k = 0; k < at.size(); ++k) {
    const Point a = at[k] - Point(50, 50, 0), b = at[(k + 1) % at.size()] - Point(50, 50, 0);
    winding += std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
  }
  EXPECT_NEAR(winding, 2 * std::numbers::pi, 1e-9);
}

TEST(RidgeSnapping, ClicksMoveAlongPinsStayAndLegsArePainted) {
  const SurfaceMesh mesh = SurfaceMesh::open(sheet(100, 100, crown, 0.3));
  std::vector<Point> clicks;
  for (int i = 0; i < 12; ++i) {
    clicks.push_back(at_margin(2 * std::numbers::pi * i / 12, i % 2 == 0 ? 1.5 : -2));
  }
  const std::vector<std::size_t> pins{4};
  const Ridged result = ridged(mesh, clicks, true, strength(1), true, pins);
  ASSERT_EQ(result.drawing.points.way_points.size(), clicks.size());
  EXPECT_EQ(result.moves().clicks, clicks.size() - 1);
  EXPECT_GT(result.moves().farthest_click, 1.3);
  EXPECT_LT(result.moves().farthest_click, 4);
  const PointLookup on(result.curve().points);
  for (std::size_t k = 0; k < clicks.size(); ++k) {
    const SurfacePoint& now = result.drawing.points.way_points[k].point;
    EXPECT_TRUE(on.contains(now));
    const Point at = mesh.position(now);
    if (k == pins[0]) {
      EXPECT_LT((at - clicks[k]).norm(), 0.2);  // on the faces, which cut corners of the crown
    } else {
      EXPECT_LT(std::abs(from_margin(at)), 0.8) << k;
    }
  }
  // The legs are strokes now: the smoother is to keep near the ridge between the clicks.
  EXPECT_FALSE(only_way_points(result.drawing.curves, result.drawing.points));
}

/// Each click may move by a third of the way to the next, and the crease is two edges away.
TEST(RidgeSnapping, TellsHowFarDenseClicksCouldMove) {
  const SurfaceMesh mesh = SurfaceMesh::open(sheet(30, 30, roof(70 * kDegree, 15, 0), 0));
  std::vector<Point> clicks;
  for (int x = 4; x <= 26; ++x) clicks.emplace_back(x, 13, -2 * std::tan(35 * kDegree));
  const Ridged dense = ridged(mesh, clicks, false, strength(1), true);
  EXPECT_EQ(dense.moves().moved, 0);
  const std::string told = dense.moves().sentence(0);
  EXPECT_NE(told.find("lies within 0.333 mesh units of it"), std::string::npos) << told;
}

TEST(RidgeSnapping, EndsOnTheBorderStayOnIt) {
  const Height height = roof(90 * kDegree, 20.37, 0);
  const SurfaceMesh mesh = SurfaceMesh::open(sheet(60, 40, height, 0.3));
  const Ridged result = ridged(mesh, trembling(-2, 62, 20.37, height), false, strength(1));
  EXPECT_TRUE(is_on_boundary(mesh.surface(), result.drawn.points.front()));
  EXPECT_TRUE(is_on_boundary(mesh.surface(), result.drawn.points.back()));
  for (const SurfacePoint& end : {result.curve().points.front(), result.curve().points.back()}) {
    EXPECT_TRUE(is_on_boundary(mesh.surface(), end));
  }
  EXPECT_GT(result.moves().moved, 0.8);
}

TEST(RidgeSnapping, DoesNotDependOnUnits) {
  const Height height = roof(70 * kDegree, 20.37, 1);
  MeshLists lists = sheet(80, 40, height, 0.3);
  std::vector<Point> points = trembling(8, 72, 20.37, height);
  const Ridged here = ridged(SurfaceMesh::open(lists), points, false, strength(0.8));
  constexpr double kScale = 1 << 20;
  for (Point& p : lists.points) p *= kScale;
  for (Point& p : points) p *= kScale;
  const Ridged there = ridged(SurfaceMesh::open(lists), points, false, strength(0.8));
  EXPECT_EQ(here.curve().points, there.curve().points);
  EXPECT_DOUBLE_EQ(here.moves().farthest * kScale, there.moves().farthest);
}

TEST(RidgeSnapping, PointsThatCurvesShareStay) {
  const Height height = roof(90 * kDegree, 20.37, 0);
  const SurfaceMesh mesh = SurfaceMesh::open(sheet(80, 40, height, 0.3));
  const auto drawn = [&](const std::vector<Point>& points) {
    return StraightLines(mesh.surface())
        .join(snap(mesh, CurveInput{false, points, {}}).points, false);
  };
  const Point node{40, 23, height(40, 23)};
  const std::vector<SurfaceCurve> curves{
      drawn({{10, 22, height(10, 22)}, {25, 21, height(25, 21)}, node}),
      drawn({node, {55, 21, height(55, 21)}, {70, 22, height(70, 22)}})};
  const RidgedDrawing result = snapped_to_ridges(mesh, curves, {}, {}, strength(1));
  EXPECT_EQ(result.curves[0].points.back(), curves[0].points.back());
  EXPECT_EQ(result.curves[1].points.front(), curves[0].points.back());
  EXPECT_GT(result.moves[0].moved, 0.5);
}

TEST(RidgeSnapping, RefusesOptionsOutOfRange) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(4, 4));
  for (const double s : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(snapped_to_ridges(mesh, {}, {}, {}, strength(s)), Error);
  }
  for (const double band : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    RidgeOptions options = strength(1);
    options.band = band;
    EXPECT_THROW(snapped_to_ridges(mesh, {}, {}, {}, options), Error);
  }
  EXPECT_THROW(ridge_kind("rims"), Error);
}

TEST(RidgeSnapping, IsCancelled) {
  const Height height = roof(90 * kDegree, 20.37, 0);
  const SurfaceMesh mesh = SurfaceMesh::open(sheet(60, 40, height, 0.3));
  const SurfaceCurve curve = ridged(mesh, trembling(5, 55, 20.37, height), false, {}).drawn;
  int asked = 0;
  const Progress stop([&](const char*, double) { return ++asked < 5; });
  EXPECT_THROW(snapped_to_ridges(mesh, std::span(&curve, 1), {}, {}, strength(1), stop), Cancelled);
}

}  // namespace
}  // namespace talweg::ridge_snapping_test
