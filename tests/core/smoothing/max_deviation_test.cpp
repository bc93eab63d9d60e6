#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/reference_data.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::grid;

constexpr std::uint32_t kBoundColumns = 60;

/// A staircase-like line along row 12 of a grid with a spike of 2 by 10 edges in the middle.
SurfaceCurve with_spike(const Surface& surface) {
  std::vector<VertexId> way;
  const auto at = [](std::uint32_t i, std::uint32_t j) {
    return VertexId{j * (kBoundColumns + 1) + i};
  };
  for (std::uint32_t i = 4; i <= 28; i += 2) way.push_back(at(i, 12 + i / 2 % 2));
  for (const auto& [i, j] : {std::pair(29U, 12U), {29U, 22U}, {31U, 22U}, {31U, 12U}}) {
    way.push_back(at(i, j));
  }
  for (std::uint32_t i = 32; i <= 56; i += 2) way.push_back(at(i, 12 + i / 2 % 2));
  return test::vertex_curve(surface, draw_edge_path(surface, way), false);
}

class MaxDeviation : public testing::Test {
 protected:
  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(grid(kBoundColumns, 30));
  const SurfaceCurve drawn = with_spike(opened->surface());
};

/// The bound with the tolerance of DeviationMeter: 1e-3 of the distance or of a mean segment,
/// whichever is larger.
double with_meter(double bound) { return bound * (1 + 1e-3) + 1e-3; }

ErrorCode code_of(CurveSmoother& smoother, double bound, const SmoothingOptions& options = {}) {
  try {
    smooth_within(smoother, bound, options);
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()), "");
    return error.code();
  }
  ADD_FAILURE() << "nothing was refused";
  return ErrorCode::kOutOfMemory;
}

TEST_F(MaxDeviation, IsKeptInBothDirectionsAndCurvatureFallsAsItGrows) {
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  double last = 0;
  for (const double bound : {3.0, 1.0, 0.5, 0.1}) {
    SCOPED_TRACE(testing::Message() << "bound " << bound);
    const SmoothingResult result = smooth_within(smoother, bound);
    EXPECT_EQ(result.report().termination, Outcome::kConverged);
    EXPECT_EQ(result.report().max_deviation, bound);
    EXPECT_LE(test::apart(opened->mesh(), result.curve(), drawn), with_meter(bound));
    EXPECT_LE(result.report().after.total_curvature, result.report().before.total_curvature);
    EXPECT_GE(result.report().after.total_curvature, last * (1 - 1e-3));
    last = result.report().after.total_curvature;
  }
}

// Results of a fixed slack that lie within the bound have at least 1 / 1.1 of the curvature.
TEST_F(MaxDeviation, GivesNearlyTheLeastCurvatureOfAllSlacksWithinIt) {
  const auto hills = OpenedMesh::open(test::hills(40));
  const SurfaceCurve wave = test::wave_on_hills(hills->mesh());
  CurveSmoother smoother(hills);
  smoother.set_curve(wave);
  const double bound = 5;
  const SmoothingResult within = smooth_within(smoother, bound);
  EXPECT_LE(test::apart(hills->mesh(), within.curve(), wave), with_meter(bound));
  std::size_t tried = 0;
  for (const double slack : {0.5, 1.0, 2.0, 3.0, 4.0}) {
    for (const double tau : {1.0, 4.0}) {
      SmoothingOptions options;
      options.tau = tau;
      options.slack = slack;
      const SmoothingResult by_hand = smoother.smooth(options);
      if (test::apart(hills->mesh(), by_hand.curve(), wave) > bound) continue;
      ++tried;
      EXPECT_LE(within.report().after.total_curvature, 1.1 * by_hand.report().after.total_curvature)
          << slack << " " << tau;
    }
  }
  EXPECT_GE(tried, 6U);
}

TEST_F(MaxDeviation, ASpikeTakesItsTurns) {
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const SmoothingResult result = smooth_within(smoother, 1);
  // Up and down a spike of 10 from within 1 of its foot to within 1 of its top, at most 4 wide:
  // turns of nearly half a circle at the top and of a quarter at each foot.
  EXPECT_GT(result.report().after.total_curvature, 2 * std::numbers::pi * 0.8);
  // The zigzag beside the spike is smoothed away.
  EXPECT_LT(result.report().after.total_curvature, result.report().before.total_curvature / 3);
  // A bound as large as the spike allows the result to cut it off.
  const SmoothingResult wide = smooth_within(smoother, 11);
  EXPECT_LT(wide.report().after.total_curvature, 0.1);
  EXPECT_EQ(wide.report().pins_added, 0U);
}

TEST_F(MaxDeviation, IsKeptOnHills) {
  const auto hills = OpenedMesh::open(test::hills(40));
  const SurfaceCurve wave = test::wave_on_hills(hills->mesh());
  CurveSmoother smoother(hills);
  smoother.set_curve(wave);
  for (const double bound : {2.0, 0.7, 0.3}) {
    const SmoothingResult result = smooth_within(smoother, bound);
    EXPECT_EQ(result.report().termination, Outcome::kConverged) << bound;
    EXPECT_LE(test::apart(hills->mesh(), result.curve(), wave), with_meter(bound)) << bound;
  }
}

TEST_F(MaxDeviation, IsKeptByALoop) {
  const auto points = test::circle({30, 15, 0}, {20, 0, 0}, {0, 10, 0}, 16);
  const SurfaceCurve loop = test::drawn_near(opened->mesh(), points, true);
  CurveSmoother smoother(opened);
  smoother.set_curve(loop);
  for (const double bound : {3.0, 1.0, 0.5}) {
    SCOPED_TRACE(testing::Message() << "bound " << bound);
    const SmoothingResult result = smooth_within(smoother, bound);
    EXPECT_EQ(result.report().termination, Outcome::kConverged);
    EXPECT_TRUE(result.curve().closed);
    EXPECT_LE(test::apart(opened->mesh(), result.curve(), loop), with_meter(bound));
    EXPECT_GE(result.report().after.total_curvature, 2 * std::numbers::pi * (1 - 1e-9));
  }
}

TEST_F(MaxDeviation, TwoCurvesKeepItAgainstTheirOwnDrawings) {
  SurfaceCurve lower = drawn;
  for (SurfacePoint& p : lower.points) {  // six rows below
    const VertexId v = std::get<AtVertex>(p.where()).vertex;
    p = SurfacePoint::at_vertex(opened->surface(),
                                VertexId{v.index() - std::size_t{6} * (kBoundColumns + 1)});
  }
  lower.points.erase(lower.points.begin() + 20, lower.points.end());
  const std::vector<SurfaceCurve> both = {drawn, lower};
  CurveSmoother smoother(opened);
  smoother.set_curves(both);
  for (const double bound : {1.0, 0.5}) {
    const SmoothingResult result = smooth_within(smoother, bound);
    ASSERT_EQ(result.curves.size(), 2U);
    EXPECT_EQ(result.report().termination, Outcome::kConverged);
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_LE(test::apart(opened->mesh(), result.curves[c], both[c]), with_meter(bound));
      EXPECT_EQ(result.reports[c].max_deviation, bound);
    }
  }
}

// Pins are points of the drawing, so on the plane even a very small bound leaves the drawing
// itself.
TEST_F(MaxDeviation, OfNearlyZeroOnAPlaneGivesTheDrawing) {
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const SmoothingResult result = smooth_within(smoother, 1e-7);
  EXPECT_EQ(result.report().termination, Outcome::kConverged);
  EXPECT_LE(test::apart(opened->mesh(), result.curve(), drawn), 1e-7);
  ASSERT_FALSE(result.report().warnings.empty());
  EXPECT_NE(result.report().warnings.back().find("is smaller than the trembling of the drawing"),
            std::string::npos);
}

// Products of two such bounds are 0.
TEST_F(MaxDeviation, OfNearlyZeroEndsTheSearch) {
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const SmoothingResult result = smooth_within(smoother, 1e-200);
  EXPECT_LE(test::apart(opened->mesh(), result.curve(), drawn), 1e-7);
}

// A quarter of a circle in unit steps, to the right and down. With such a wide slack only pins hold
// the curve, and the search does not pin each of the 290 corners.
TEST_F(MaxDeviation, ThatCannotBeKeptIsReported) {
  const std::uint32_t n = 150;
  const auto sheet = OpenedMesh::open(grid(n, n));
  std::vector<VertexId> stairs;
  std::uint32_t i = 2, j = n - 3;
  for (; j > 2; (i * i + j * j < (n - 3) * (n - 3) ? ++i : --j))
    stairs.emplace_back(j * (n + 1) + i);
  const SurfaceCurve quarter = test::vertex_curve(sheet->surface(), stairs, false);
  CurveSmoother smoother(sheet);
  smoother.set_curve(quarter);
  SmoothingOptions options;
  options.slack = 20;
  const double bound = 1e-3;
  const SmoothingResult result = smooth_within(smoother, bound, options);
  const double apart = test::apart(sheet->mesh(), result.curve(), quarter);
  ASSERT_GT(apart, with_meter(bound));
  EXPECT_EQ(result.report().termination, Outcome::kDeviation);
  ASSERT_FALSE(result.report().warnings.empty());
  EXPECT_NE(result.report().warnings.back().find("of the drawing was found"), std::string::npos);
  // The result is the nearest curve found, far nearer than without pins.
  EXPECT_LT(apart, 2);
  EXPECT_TRUE(smoother.pins().empty());
}

TEST_F(MaxDeviation, PinsStayAndAreMet) {
  CurveSmoother smoother(opened);
  const std::vector<SurfacePoint> pins = {drawn.points[10], drawn.points[30]};
  smoother.set_curve(drawn, {.pins = pins});
  const auto expected = smoother.smooth(1).curve().points;
  const SmoothingResult result = smooth_within(smoother, 0.5);
  for (const SurfacePoint& pin : pins) {
    EXPECT_EQ(std::count(result.curve().points.begin(), result.curve().points.end(), pin), 1);
  }
  EXPECT_LE(test::apart(opened->mesh(), result.curve(), drawn), with_meter(0.5));
  EXPECT_EQ(std::vector(smoother.pins().begin(), smoother.pins().end()), pins);
  EXPECT_EQ(smoother.smooth(1).curve().points, expected);
}

TEST_F(MaxDeviation, UsesAGivenSlack) {
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  SmoothingOptions options;
  options.slack = 0.25;
  const SmoothingResult result = smooth_within(smoother, 1, options);
  EXPECT_LE(test::apart(opened->mesh(), result.curve(), drawn), with_meter(1));
  EXPECT_EQ(result.report().slack, 0.25);
}

TEST_F(MaxDeviation, EarlierCallsChangeNothing) {
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const auto once = smooth_within(smoother, 0.7).curve().points;
  smoother.smooth(3);
  EXPECT_EQ(smooth_within(smoother, 0.7).curve().points, once);
}

TEST_F(MaxDeviation, ACancelledSearchEndsAndLeavesThePins) {
  for (const int polls : {0, 3, 30, 200}) {
    CurveSmoother smoother(opened);
    smoother.set_curve(drawn, {.pins = {drawn.points[10]}});
    int left = polls;
    SmoothingOptions options;
    const Progress progress = [&](const char*, double) { return left-- > 0; };
    const SmoothingResult result = smooth_within(smoother, 0.5, options, progress);
    EXPECT_EQ(result.report().termination == Outcome::kCancelled, left < 0) << polls;
    ASSERT_EQ(smoother.pins().size(), 1U);
    EXPECT_EQ(smoother.pins()[0], drawn.points[10]);
  }
}

TEST_F(MaxDeviation, RefusesInvalidBounds) {
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  for (const double bad : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    EXPECT_EQ(code_of(smoother, bad), ErrorCode::kBadUsage);
  }
  SmoothingOptions options;
  options.slack = -1;
  EXPECT_EQ(code_of(smoother, 1, options), ErrorCode::kBadUsage);
}

TEST_F(MaxDeviation, RefusesASmootherWithoutACorridor) {
  CurveSmoother smoother(opened);
  SmoothingOptions with_slack;
  with_slack.slack = 0.5;
  for (const SmoothingOptions& options : {SmoothingOptions{}, with_slack}) {
    smoother.set_curve(drawn, {.method = Method::kPaper});
    for (const double bound : {0.5, 20.0}) {
      EXPECT_EQ(code_of(smoother, bound, options), ErrorCode::kBadUsage);
    }
    CurveSmoother empty(opened);
    EXPECT_EQ(code_of(empty, 1, options), ErrorCode::kBadUsage);
  }
}

TEST_F(MaxDeviation, OnRealMeshes) {
  for (const char* name : {"fandisk_14k", "aneurysm_14k"}) {
    const auto reference = test::reference_curve(name);
    if (!reference) GTEST_SKIP() << test::missing(name);
    const auto real = OpenedMesh::open(
        test::read_reference_mesh(test::mesh_folder() / (std::string(name) + ".ply")));
    const SurfaceCurve path =
        test::vertex_curve(real->surface(), reference->path, reference->closed);
    CurveSmoother smoother(real);
    smoother.set_curve(path);
    for (const double edges : {2.0, 0.7}) {
      const double bound = edges * real->mesh().mean_edge_length();
      const SmoothingResult result = smooth_within(smoother, bound);
      EXPECT_EQ(result.report().termination, Outcome::kConverged) << name << " " << edges;
      EXPECT_LE(test::apart(real->mesh(), result.curve(), path), bound * 1.002) << name;
      EXPECT_LT(result.report().after.total_curvature, result.report().before.total_curvature / 2)
          << name;
    }
  }
}

}  // namespace
}  // namespace talweg
