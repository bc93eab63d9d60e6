// Without a lift no distance is computed, and a report measures far deviations through space.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::hills;

using test::ids;

/// A drawing over hills(size) that winds far away from the straight line between its ends.
SurfaceCurve winding(const SurfaceMesh& mesh, std::uint32_t size) {
  const auto at = [&](double x, double y) {
    return static_cast<std::uint32_t>(y * size) * (size + 1) + static_cast<std::uint32_t>(x * size);
  };
  const std::uint32_t way[] = {at(0.1, 0.5), at(0.3, 0.9), at(0.5, 0.1), at(0.7, 0.9),
                               at(0.9, 0.5)};
  return test::vertex_curve(mesh.surface(), draw_edge_path(mesh.surface(), ids(way)), false);
}

struct Outcome {
  SmoothingResult result;
  std::size_t asked = 0;
  std::size_t asked_of_distance = 0;  // of the heat method's stages
};

Outcome outcome_of(const std::shared_ptr<const OpenedMesh>& opened, const SurfaceCurve& drawn,
                   double tau, const CurveOptions& curve_options = {}) {
  Outcome outcome;
  SmoothingOptions options;
  options.tau = tau;
  const Progress progress = [&](const char* stage, double) {
    ++outcome.asked;
    const std::string name = stage;
    if (name == "laplacian" || name == "order" || name == "factor" || name == "solve") {
      ++outcome.asked_of_distance;
    }
    return true;
  };
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn, curve_options, progress);
  if (curve_options.method == Method::kCorridor) outcome.asked_of_distance = 0;
  outcome.asked = 0;
  outcome.result = smoother.smooth(options, progress);
  return outcome;
}

// Calls of the progress callback measure the work: see cancelling_test.cpp.
TEST(StraightResults, CostNoMoreThanStraightening) {
  const auto opened = OpenedMesh::open(hills(160));
  const SurfaceCurve drawn = winding(opened->mesh(), 160);
  const Outcome straight = outcome_of(opened, drawn, 0), unfelt = outcome_of(opened, drawn, 1e-6),
                felt = outcome_of(opened, drawn, 0.05);
  // FlipOut calls it once in 64 steps, and the distances along the edges that it has visited cost
  // no more. Further calls are one per stage, and those of the deviation through space.
  const std::size_t flip_out = straight.result.report().iterations / 32;
  EXPECT_LT(straight.asked, flip_out + 100);
  EXPECT_LT(unfelt.asked, 2 * flip_out + 100);
  EXPECT_GT(felt.asked, 2 * straight.asked);
}

TEST(StraightResults, EqualThoseOfAFlatPotentialAndOfTausWithoutEffect) {
  const auto opened = OpenedMesh::open(hills(60));
  const std::vector<double> flat(opened->surface().vertex_count(), 0.0);
  for (const bool paper : {false, true}) {
    CurveOptions options;
    if (paper) options.method = Method::kPaper;
    const SurfaceCurve drawn = winding(opened->mesh(), 60);
    CurveSmoother smoother(opened);
    smoother.set_curve(drawn, options);
    const auto expected = smoother.smooth({.tau = 0}, flat, 1).curve().points;
    EXPECT_EQ(smoother.smooth(0.0).curve().points, expected);
    EXPECT_EQ(smoother.smooth(1e-7).curve().points, expected);
    EXPECT_EQ(smoother.smooth({.tau = 1e-7, .prepare_whole_mesh = true}).curve().points, expected);
    EXPECT_NE(smoother.smooth(0.05).curve().points, expected);
  }
}

// At the smallest tau with an effect, the length differs from the geodesic's by about the ignored
// fraction of 1e-7.
TEST(StraightResults, ApproachLiftedResultsContinuously) {
  const auto opened = OpenedMesh::open(hills(60));
  CurveSmoother smoother(opened);
  smoother.set_curve(winding(opened->mesh(), 60));
  const SmoothingResult straight = smoother.smooth(0.0);
  for (double tau = 1e-6; tau < 0.05; tau *= 1.5) {
    const SmoothingResult lifted = smoother.smooth(tau);
    if (lifted.curve().points == straight.curve().points) continue;
    EXPECT_GT(tau, 1e-5);
    EXPECT_NEAR(lifted.report().after.length, straight.report().after.length,
                2e-7 * straight.report().after.length);
    return;
  }
  FAIL() << "no tau is felt";
}

TEST(StraightResults, OfThePapersMethodNeedNoFactors) {
  const auto opened = OpenedMesh::open(hills(40));
  const SurfaceCurve drawn = winding(opened->mesh(), 40);
  const CurveOptions now = {.method = Method::kPaper};
  const CurveOptions later = {.method = Method::kPaper, .distance_at_once = false};
  const Outcome straight = outcome_of(opened, drawn, 0, later);
  EXPECT_EQ(straight.asked_of_distance, 0U);
  EXPECT_EQ(straight.result.curve().points,
            outcome_of(opened, drawn, 0, now).result.curve().points);

  const auto again = OpenedMesh::open(hills(40));
  const Outcome lifted = outcome_of(again, drawn, 1, later);
  EXPECT_GT(lifted.asked_of_distance, 4U);
  EXPECT_EQ(lifted.result.curve().points, outcome_of(opened, drawn, 1, now).result.curve().points);

  CurveSmoother smoother(opened);
  smoother.set_curve(drawn, later);
  EXPECT_TRUE(smoother.distance().empty());
  EXPECT_FALSE(smoother.need_distance([](const char*, double) { return false; }));
  EXPECT_TRUE(smoother.distance().empty());
  EXPECT_TRUE(smoother.need_distance());
  CurveSmoother eager(opened);
  eager.set_curve(drawn, now);
  EXPECT_TRUE(std::equal(smoother.distance().begin(), smoother.distance().end(),
                         eager.distance().begin(), eager.distance().end()));
  EXPECT_THROW(CurveSmoother(opened).need_distance(), Error);
}

TEST(StraightResults, AreMeasuredThroughSpaceWhereTheyAreFar) {
  const auto opened = OpenedMesh::open(hills(60));
  const SurfaceCurve drawn = winding(opened->mesh(), 60);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  for (const double tau : {0.0, 0.02}) {
    const SmoothingResult far = smoother.smooth(tau);
    EXPECT_EQ(far.report().deviation, DeviationMeasure::kEuclidean);
    const Deviation apart = deviation(positions_of(opened->mesh(), far.curve()), false,
                                      positions_of(opened->mesh(), drawn), false);
    EXPECT_EQ(far.report().deviation_to_drawn_max, apart.to_drawn.max);
    EXPECT_EQ(far.report().deviation_from_drawn_mean, apart.from_drawn.mean);
    EXPECT_TRUE(std::any_of(
        far.report().warnings.begin(), far.report().warnings.end(),
        [](const std::string& w) { return w.find("through space") != std::string::npos; }));
  }
  SmoothingOptions options;
  options.tau = 0;
  options.deviation = DeviationMeasure::kAlongSurface;
  const SmoothingReport exact = smoother.smooth(options).report();
  EXPECT_EQ(exact.deviation, DeviationMeasure::kAlongSurface);
  EXPECT_GT(exact.deviation_from_drawn_max, 4 * exact.edge_length_near);
  EXPECT_EQ(smoother.smooth(1.0).report().deviation, DeviationMeasure::kAlongSurface);
}

TEST(StraightResults, AreMeasuredAlongTheSurfaceWhereTheyAreNear) {
  const auto opened = OpenedMesh::open(hills(40));
  const std::uint32_t way[] = {20 * 41 + 5, 20 * 41 + 15};
  const SurfaceCurve drawn =
      test::vertex_curve(opened->surface(), draw_edge_path(opened->surface(), ids(way)), false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const SmoothingResult near = smoother.smooth(0.0);
  EXPECT_EQ(near.report().deviation, DeviationMeasure::kAlongSurface);
  const SurfaceDeviation apart =
      DeviationMeter(opened->mesh()).measure(std::span(&near.curves[0], 1), std::span(&drawn, 1));
  EXPECT_EQ(near.report().deviation_to_drawn_max, apart.to_drawn.max);
  EXPECT_EQ(near.report().deviation_from_drawn_max, apart.from_drawn.max);
}

TEST(StraightResults, AMeasureBelowALimitIsTheWholeOneOrNone) {
  const SurfaceMesh mesh = SurfaceMesh::open(hills(40));
  const SurfaceCurve drawn = test::wave_on_hills(mesh);
  const std::uint32_t ends[] = {20 * 41 + 2, 20 * 41 + 38};
  const SurfaceCurve other =
      test::vertex_curve(mesh.surface(), draw_edge_path(mesh.surface(), ids(ends)), false);
  DeviationMeter meter(mesh);
  const std::span a(&drawn, 1), b(&other, 1);
  const SurfaceDeviation whole = meter.measure(a, b);
  const double most = whole.larger().max;
  for (const double share : {0.1, 0.5, 0.9, 0.999}) {
    EXPECT_FALSE(meter.measure_below(share * most, a, b).has_value()) << share;
  }
  const auto below = meter.measure_below(1.01 * most, a, b);
  ASSERT_TRUE(below.has_value());
  EXPECT_EQ(below->to_drawn.max, whole.to_drawn.max);
  EXPECT_EQ(below->from_drawn.max, whole.from_drawn.max);
  EXPECT_EQ(below->to_drawn.mean, whole.to_drawn.mean);
}

}  // namespace
}  // namespace talweg
