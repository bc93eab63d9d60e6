// Through way-points, the result is a spline without kinks, for every tau.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

class WayPoints : public testing::Test {
 protected:
  explicit WayPoints(const MeshLists& lists) : opened(OpenedMesh::open(lists)) {}
  WayPoints() : WayPoints(test::grid(60, 60)) {}

  [[nodiscard]] const Surface& surface() const { return opened->mesh().surface(); }
  [[nodiscard]] SurfacePoint at(std::uint32_t x, std::uint32_t y) const {
    return SurfacePoint::at_vertex(surface(), VertexId{y * columns + x});
  }
  /// A drawing along edges through vertices, all of them way-points.
  void draw(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& clicks, bool closed) {
    std::vector<VertexId> ids;
    options.way_points.clear();
    for (const auto& [x, y] : clicks) {
      ids.emplace_back(y * columns + x);
      options.way_points.push_back({at(x, y)});
    }
    drawn = test::vertex_curve(surface(), draw_edge_path(surface(), ids, closed), closed);
  }
  [[nodiscard]] SmoothingResult smooth(double tau) const {
    return smooth_curve(opened, drawn, {.tau = tau}, options);
  }
  [[nodiscard]] double farthest_way_point(const SurfaceCurve& curve) const {
    PolylineDistance distance(surface());
    distance.set(std::span(&curve, 1));
    double most = 0;
    for (const WayPoint& way : options.way_points) {
      most = std::max(most, distance.at(way.point).distance);
    }
    return most;
  }

  static constexpr std::uint32_t columns = 61;
  const std::shared_ptr<const OpenedMesh> opened;
  CurveOptions options;
  SurfaceCurve drawn;
};

class WayPointsOnHills : public WayPoints {
 protected:
  WayPointsOnHills() : WayPoints(test::hills(60)) {}
};

const std::vector<std::pair<std::uint32_t, std::uint32_t>> kWave = {
    {5, 10}, {17, 30}, {30, 12}, {40, 33}, {54, 25}};

/// Clicks with rounded barycentric coordinates, as other programs compute them.
TEST_F(WayPointsOnHills, MayDifferFromVerticesByRounding) {
  const auto smooth_through = [&](double beside) {
    std::vector<SurfacePoint> clicks;
    for (const auto& [x, y] : kWave) {
      const FaceId face = faces_at(surface(), at(x, y)).front();
      std::array<double, 3> b = coordinates_in(surface(), at(x, y), face).barycentric;
      for (double& each : b) each = each == 1 ? 1 - 2 * beside : beside;
      clicks.push_back(beside > 0 ? SurfacePoint::in_face(surface(), face, b) : at(x, y));
    }
    CurveSmoother smoother(opened);
    smoother.set_curve(talweg::draw(surface(), clicks, {.straight = true}));
    return smoother.smooth(1).total;
  };
  const SmoothingReport there = smooth_through(0);
  for (const double beside : {1e-16, 1e-13, 1e-11, 1e-9}) {
    const SmoothingReport report = smooth_through(beside);
    EXPECT_TRUE(report.warnings.empty()) << beside << ": " << report.warnings.front();
    EXPECT_NEAR(report.before.total_curvature, there.before.total_curvature, 1e-6) << beside;
    EXPECT_NEAR(report.after.bending, there.after.bending, 1e-3 * there.after.bending) << beside;
  }
}

TEST_F(WayPointsOnHills, ArePassedForEveryTauWithoutAKink) {
  draw(kWave, false);
  double last = 0;
  for (const double tau : {0.01, 0.3, 1.0, 3.0, 20.0}) {
    const SmoothingResult result = smooth(tau);
    for (const WayPoint& way : options.way_points) {
      const auto& points = result.curve().points;
      EXPECT_NE(std::find(points.begin(), points.end(), way.point), points.end()) << tau;
    }
    const CurveMeasures measures = measure_curve(surface(), result.curve(), 1);
    EXPECT_LE(measures.max_curvature, 6 * kDegree) << tau;
    for (const std::string& warning : result.total.warnings) ADD_FAILURE() << tau << warning;
    if (last > 0) {
      EXPECT_LT(measures.length, last * 1.005) << tau;
    }  // tighter
    last = measures.length;
  }
}

TEST_F(WayPoints, TauZeroGivesStraightLegs) {
  draw(kWave, false);
  const SurfaceCurve legs = smooth(0).curve();
  double expected = 0;
  for (std::size_t k = 1; k < kWave.size(); ++k) {
    expected += std::hypot(double(kWave[k].first) - double(kWave[k - 1].first),
                           double(kWave[k].second) - double(kWave[k - 1].second));
  }
  EXPECT_NEAR(curve_length(surface(), legs), expected, 1e-9 * expected);
  EXPECT_GT(measure_curve(surface(), legs).max_curvature, 1);
}

TEST_F(WayPoints, ARegularPolygonIsRoundedToItsCircle) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> clicks;
  const double radius = 22;
  for (int k = 0; k < 12; ++k) {
    const double angle = 2 * std::numbers::pi * k / 12;
    clicks.emplace_back(std::lround(30 + radius * std::cos(angle)),
                        std::lround(30 + radius * std::sin(angle)));
  }
  draw(clicks, true);
  const SurfaceCurve result = smooth(1).curve();
  for (const SurfacePoint& point : result.points) {
    const Point p = opened->mesh().position(point);
    EXPECT_NEAR(std::hypot(p.x() - 30, p.y() - 30), radius,
                0.8);  // distances of clicks are up to 0.6
  }
  EXPECT_NEAR(curve_length(surface(), result), 2 * std::numbers::pi * radius, 1.5);
}

TEST_F(WayPoints, APointThatIsInsertedOnTheResultLeavesItAsItIs) {
  draw(kWave, false);
  const SurfaceCurve before = smooth(1).curve();
  const CurveOptions own = options;
  for (const double part : {0.2, 0.45, 0.7}) {
    drawn = before;
    options = own;
    const auto i = static_cast<std::size_t>(part * static_cast<double>(before.points.size()));
    options.way_points.push_back({before.points[i]});
    EXPECT_LE(test::apart(opened->mesh(), smooth(1).curve(), before), 0.1) << part;
  }
}

TEST_F(WayPointsOnHills, AToleranceIsUsedAndKept) {
  draw(kWave, false);
  const double exact = curve_length(surface(), smooth(1).curve());
  for (WayPoint& way : options.way_points) way.tolerance = 1.5;
  const SurfaceCurve loose = smooth(1).curve();
  EXPECT_LE(farthest_way_point(loose), 1.5);
  EXPECT_GT(farthest_way_point(loose), 0.3);
  EXPECT_LT(curve_length(surface(), loose), 0.98 * exact);
  EXPECT_EQ(loose.points.front(), drawn.points.front());
}

TEST_F(WayPointsOnHills, TheDirectionOfTheDrawingChangesNothing) {
  for (const bool closed : {false, true}) {
    draw({{8, 10}, {25, 8}, {50, 14}, {48, 50}, {10, 46}}, closed);
    SurfaceCurve forward = smooth(1).curve();
    std::reverse(drawn.points.begin(), drawn.points.end());
    SurfaceCurve backward = smooth(1).curve();
    std::reverse(backward.points.begin(), backward.points.end());
    if (closed) {
      const auto first =
          std::find(backward.points.begin(), backward.points.end(), forward.points.front());
      ASSERT_NE(first, backward.points.end());
      std::rotate(backward.points.begin(), first, backward.points.end());
    }
    EXPECT_EQ(forward.points, backward.points) << closed;
  }
}

TEST_F(WayPointsOnHills, APaintedStretchStaysNearItsDrawing) {
  draw({{5, 10}, {25, 25}, {33, 25}, {55, 40}}, false);
  const std::vector<SurfacePoint> between(
      std::find(drawn.points.begin(), drawn.points.end(), at(25, 25)) + 1,
      std::find(drawn.points.begin(), drawn.points.end(), at(33, 25)));
  ASSERT_FALSE(between.empty());
  options.painted = {between.front()};
  const SmoothingResult result = smooth(1);
  EXPECT_TRUE(result.total.warnings.empty());
  PolylineDistance distance(surface());
  distance.set(std::span(&result.curve(), 1));
  for (const SurfacePoint& point : between) {
    EXPECT_LE(distance.at(point).distance, 2 * result.total.slack) << result.total.slack;
  }
  EXPECT_LE(farthest_way_point(result.curve()), 1e-12);
  EXPECT_LE(measure_curve(surface(), result.curve()).max_curvature, 5.5 * kDegree);
}

TEST_F(WayPointsOnHills, AreDraggedToWhereTheyWouldBeSet) {
  std::vector<VertexId> clicks;
  clicks.reserve(kWave.size());
  for (const auto& [x, y] : kWave) clicks.emplace_back(y * columns + x);
  CurveSmoother smoother(opened), fresh(opened);
  smoother.set_curve(talweg::draw(surface(), clicks));
  const SurfaceCurve before = smoother.smooth(1).curve();
  for (int step = 0; step < 3; ++step) {
    clicks[2] = VertexId{clicks[2].index() + 1 + columns};
    const Drawing moved = talweg::draw(surface(), clicks);
    fresh.set_curve(moved);
    const SmoothingResult dragged = smoother.drag(0, moved);
    EXPECT_EQ(dragged.curve().points, fresh.smooth(1).curve().points);
    EXPECT_EQ(dragged.report().engine, Engine::kPreview);
  }
  EXPECT_EQ(smoother.smooth(1).curve().points, before.points);
}

TEST_F(WayPointsOnHills, EarlierDragsChangeNothing) {
  std::vector<VertexId> clicks;
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> at = {
      {6, 9}, {25, 8}, {50, 14}, {48, 50}, {10, 46}};
  for (const auto& [x, y] : at) clicks.emplace_back(y * columns + x);
  for (const bool closed : {false, true}) {
    CurveSmoother smoother(opened);
    smoother.set_curve(talweg::draw(surface(), clicks, {.closed = closed}));
    smoother.smooth(0.4);
    std::vector<VertexId> moved = clicks;
    const auto expect_as_fresh = [&](double tau) {
      const Drawing drawing = talweg::draw(surface(), moved, {.closed = closed});
      CurveSmoother fresh(opened);
      fresh.set_curve(drawing);
      EXPECT_EQ(smoother.drag(0, drawing, {.tau = tau}).curve().points,
                fresh.smooth(tau).curve().points)
          << closed << tau;
    };
    for (const std::size_t k : {2, 3, 0, 2}) {  // to and fro, the ends, too
      for (const int step : {3, -2, 5, -6}) {
        moved[k] = VertexId{moved[k].index() + static_cast<std::size_t>(step)};
        expect_as_fresh(step > 0 ? 1 : 0);
      }
    }
    moved.insert(moved.begin() + 2, VertexId{30 * columns + 30});
    expect_as_fresh(2.5);
    moved = clicks;
    expect_as_fresh(1);
    std::reverse(moved.begin(), moved.end());
    expect_as_fresh(1);
  }
}

TEST_F(WayPointsOnHills, EarlierTausChangeNothing) {
  draw(kWave, false);
  CurveSmoother asked(opened);
  asked.set_curve(drawn, options);
  const SmoothingOptions all[] = {{.tau = 1},
                                  {.tau = 0},
                                  {.tau = 1.5, .max_iterations = 3},
                                  {.tau = 1.5, .prepare_whole_mesh = true},
                                  {.tau = 1.5, .length_floor = 4},
                                  {.tau = 0.2, .finish = Finish::kTaut},
                                  {.tau = 7}};
  for (int round = 0; round < 2; ++round) {
    for (const SmoothingOptions& own : all) {
      EXPECT_EQ(asked.smooth(own).curve().points,
                smooth_curve(opened, drawn, own, options).curve().points)
          << own.tau;
    }
  }
  EXPECT_EQ(asked.smooth(1.5).curve().points,
            asked.smooth({.tau = 1.5, .prepare_whole_mesh = true}).curve().points);
  asked.set_pins(std::vector{drawn.points[drawn.points.size() / 2]});
  CurveOptions pinned = options;
  pinned.pins = {drawn.points[drawn.points.size() / 2]};
  EXPECT_EQ(asked.smooth(1).curve().points, smooth_curve(opened, drawn, {}, pinned).curve().points);
}

TEST_F(WayPoints, ABoundAppliesToStrokesOnly) {
  // A stroke that trembles by half an edge, and a leg whose drawing is a wide detour.
  SurfaceCurve detour{false, {}};
  for (std::uint32_t x = 4; x < 30; ++x) {
    detour.points.push_back(at(x, 20));
    detour.points.push_back(at(x + 1, 21));
  }
  for (std::uint32_t y = 22; y <= 40; ++y) detour.points.push_back(at(30, y));
  for (std::uint32_t y = 41; y-- > 20;) detour.points.push_back(at(31, y));
  detour.points.push_back(at(32, 20));
  drawn = detour;
  options.way_points = {{at(30, 21)}, {at(32, 20)}};
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn, options);
  const SmoothingResult plain = smoother.smooth(1);
  EXPECT_LT(plain.total.deviation_from_drawn_max, 3);  // the detour is 19 away
  const SmoothingResult within = smooth_within(smoother, 1.2);
  EXPECT_EQ(within.total.termination, talweg::Outcome::kConverged);
  EXPECT_LE(within.total.deviation_to_drawn_max, 1.2);
  EXPECT_LE(within.total.deviation_from_drawn_max, 1.2);
  EXPECT_LT(curve_length(surface(), within.curve()), 35);  // the leg is straight
}

TEST_F(WayPointsOnHills, TheDrawingBetweenThemMayBeFine) {
  draw(kWave, false);
  const SurfaceCurve before = smooth(1).curve();
  drawn = before;  // many points inside faces
  const SmoothingResult again = smooth(1);
  EXPECT_EQ(again.total.engine, Engine::kLocal);
  // Another drawing gives another start, so the results agree only as nearly as after inserting a
  // point.
  EXPECT_LE(test::apart(opened->mesh(), again.curve(), before), 0.1);
}

/// A cone with more than a full angle at its apex, vertex 0, in rings.
MeshLists saddle(std::uint32_t rings, std::uint32_t sectors, double height) {
  MeshLists lists;
  lists.points.emplace_back(0, 0, 0);
  for (std::uint32_t r = 1; r <= rings; ++r) {
    for (std::uint32_t s = 0; s < sectors; ++s) {
      const double angle = 2 * std::numbers::pi * s / sectors;
      lists.points.emplace_back(r * std::cos(angle), r * std::sin(angle),
                                r * height * std::cos(2 * angle));
    }
  }
  const auto id = [&](std::uint32_t r, std::uint32_t s) {
    return r == 0 ? 0 : 1 + (r - 1) * sectors + s % sectors;
  };
  for (std::uint32_t r = 0; r < rings; ++r) {
    for (std::uint32_t s = 0; s < sectors; ++s) {
      lists.triangles.push_back({id(r, s), id(r + 1, s), id(r + 1, s + 1)});
      if (r > 0) lists.triangles.push_back({id(r, s), id(r + 1, s + 1), id(r, s + 1)});
    }
  }
  return lists;
}

class WayPointsOnASaddle : public WayPoints {
 protected:
  WayPointsOnASaddle() : WayPoints(saddle(20, 24, 0.6)) {}
};

TEST_F(WayPointsOnASaddle, NoKinkIsLeftAtItsVertex) {
  // The shortest way between points that are not quite opposite bends at the apex.
  const auto on_ring = [](std::uint32_t r, std::uint32_t s) {
    return VertexId{1 + (r - 1) * 24 + s};
  };
  for (const std::uint32_t across : {11U, 12U, 13U}) {
    const std::vector<VertexId> clicks{on_ring(18, 2), on_ring(9, 1), on_ring(9, 1 + across),
                                       on_ring(18, 2 + across)};
    CurveSmoother smoother(opened);
    smoother.set_curve(talweg::draw(surface(), clicks));
    const SurfaceCurve result = smoother.smooth(1).curve();
    const CurveMeasures measures = measure_curve(surface(), result, 1);
    EXPECT_LE(measures.max_curvature, 5 * kDegree) << across;
    EXPECT_LE(measures.window_turning, 20 * kDegree) << across;
  }
}

TEST_F(WayPoints, StrokesBesideThemStayAsTheyAre) {
  draw(kWave, false);
  SurfaceCurve stroke{false, {}};
  for (std::uint32_t x = 4; x < 56; ++x) stroke.points.push_back(at(x, 50));
  CurveSmoother alone(opened), both(opened);
  alone.set_curve(stroke);
  both.set_curves(std::vector{drawn, stroke}, options);
  const SurfaceCurve expected = alone.smooth(1).curve();
  const SmoothingResult result = both.smooth(1);
  EXPECT_LE(test::apart(opened->mesh(), result.curves[1], expected), 1e-6);
  EXPECT_LE(test::apart(opened->mesh(), result.curves[0], smooth(1).curve()), 1e-6);
}

TEST_F(WayPoints, TwoOnALoopAreItsPins) {
  draw({{10, 10}, {50, 10}, {50, 50}, {10, 50}}, true);
  options.way_points = {{at(10, 10)}, {at(50, 50)}};
  const SmoothingResult result = smooth(1);
  EXPECT_LE(farthest_way_point(result.curve()), 1e-12);
  EXPECT_GT(result.total.slack, 0);
  EXPECT_GT(curve_length(surface(), result.curve()), 120);
}

TEST_F(WayPoints, PointsOffTheDrawingAreRefused) {
  draw(kWave, false);
  const auto message = [&](const CurveOptions& bad) -> std::string {
    try {
      smooth_curve(opened, drawn, {}, bad);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadUsage);
      return error.what();
    }
    return {};
  };
  CurveOptions off = options;
  off.way_points.push_back({at(1, 1)});
  EXPECT_NE(message(off).find("way-point at vertex 62"), std::string::npos) << message(off);
  CurveOptions painted = options;
  painted.painted = {at(1, 1)};
  EXPECT_NE(message(painted).find("painted point at vertex 62"), std::string::npos);
  CurveOptions negative = options;
  negative.way_points.front().tolerance = -1;
  EXPECT_NE(message(negative).find("tolerance"), std::string::npos);
}

}  // namespace
}  // namespace talweg
