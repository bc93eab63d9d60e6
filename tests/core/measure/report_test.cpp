#include "talweg/core/measure/report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/generated_meshes.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/named_measures.hpp"
#include "talweg/core/measure/result_report.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

/// A report with different numbers in the fields that are measured.
SmoothingReport numbered(double start) {
  SmoothingReport r;
  r.version = "1.2.3";
  r.potential = PotentialKind::kPaper;
  r.engine = Engine::kFull;
  r.termination = Outcome::kConverged;
  r.deviation = DeviationMeasure::kAlongSurface;
  double next = start;
  for (double SmoothingReport::*field :
       {&SmoothingReport::tau, &SmoothingReport::slack, &SmoothingReport::lifted_length_before,
        &SmoothingReport::lifted_length_after, &SmoothingReport::deviation_to_drawn_max,
        &SmoothingReport::deviation_to_drawn_mean, &SmoothingReport::deviation_from_drawn_max,
        &SmoothingReport::deviation_from_drawn_mean, &SmoothingReport::deviation_at_least,
        &SmoothingReport::mollification, &SmoothingReport::peak_memory_mib}) {
    r.*field = next++;
  }
  for (const NamedMeasure& measure : kNamedMeasures) {
    r.before.*measure.value = next++;
    r.after.*measure.value = next++;
  }
  r.before.signed_curvature = next++;
  r.after.signed_curvature = next++;
  for (std::size_t SmoothingReport::*field :
       {&SmoothingReport::faces, &SmoothingReport::vertices, &SmoothingReport::points_before,
        &SmoothingReport::points_after, &SmoothingReport::flips, &SmoothingReport::iterations,
        &SmoothingReport::faces_touched, &SmoothingReport::trace_fallbacks,
        &SmoothingReport::stretches_redrawn, &SmoothingReport::crossings_before,
        &SmoothingReport::crossings_after}) {
    r.*field = static_cast<std::size_t>(next++);
  }
  for (double StageTimes::*field : {&StageTimes::load, &StageTimes::open, &StageTimes::solve,
                                    &StageTimes::straighten, &StageTimes::trace, &StageTimes::relax,
                                    &StageTimes::fair, &StageTimes::measure, &StageTimes::total}) {
    r.time_ms.*field = next++;
  }
  r.deviation_at = Point(next, next + 1, next + 2);
  return r;
}

nlohmann::json parsed(const SmoothingReport& r) { return nlohmann::json::parse(to_json(r)); }

TEST(Report, HasEachNumberUnderItsStableName) {
  SmoothingReport r = numbered(1);
  r.closed = true;
  r.warnings = {"One.", "A \"quoted\" one."};
  const auto j = parsed(r);
  EXPECT_EQ(j["version"], r.version);
  EXPECT_EQ(j["tau"], r.tau);
  EXPECT_EQ(j["slack"], r.slack);
  EXPECT_EQ(j["closed"], true);
  EXPECT_EQ(j["faces"], r.faces);
  EXPECT_EQ(j["vertices"], r.vertices);
  EXPECT_EQ(j["points_before"], r.points_before);
  EXPECT_EQ(j["points_after"], r.points_after);
  EXPECT_EQ(j["length_before"], r.before.length);
  EXPECT_EQ(j["length_after"], r.after.length);
  EXPECT_EQ(j["lifted_length_before"], r.lifted_length_before);
  EXPECT_EQ(j["lifted_length_after"], r.lifted_length_after);
  EXPECT_EQ(j["curvature_before"], r.before.total_curvature);
  EXPECT_EQ(j["curvature_after"], r.after.total_curvature);
  EXPECT_EQ(j["curvature_max_before"], r.before.max_curvature);
  EXPECT_EQ(j["curvature_max_after"], r.after.max_curvature);
  EXPECT_EQ(j["bending_before"], r.before.bending);
  EXPECT_EQ(j["bending_after"], r.after.bending);
  EXPECT_EQ(j["window_turning_before"], r.before.window_turning);
  EXPECT_EQ(j["window_turning_after"], r.after.window_turning);
  EXPECT_EQ(j["window_turning_2_before"], r.before.window_turning_2);
  EXPECT_EQ(j["window_turning_2_after"], r.after.window_turning_2);
  EXPECT_EQ(j["tortuosity_before"], r.before.tortuosity);
  EXPECT_EQ(j["tortuosity_after"], r.after.tortuosity);
  EXPECT_EQ(j["deviation"], "surface");
  EXPECT_EQ(j["deviation_to_drawn_max"], r.deviation_to_drawn_max);
  EXPECT_EQ(j["deviation_to_drawn_mean"], r.deviation_to_drawn_mean);
  EXPECT_EQ(j["deviation_from_drawn_max"], r.deviation_from_drawn_max);
  EXPECT_EQ(j["deviation_from_drawn_mean"], r.deviation_from_drawn_mean);
  EXPECT_EQ(j["deviation_at"],
            nlohmann::json({r.deviation_at[0], r.deviation_at[1], r.deviation_at[2]}));
  EXPECT_EQ(j["flips"], r.flips);
  EXPECT_EQ(j["iterations"], r.iterations);
  EXPECT_EQ(j["faces_touched"], r.faces_touched);
  EXPECT_EQ(j["trace_fallbacks"], r.trace_fallbacks);
  EXPECT_EQ(j["mollification"], r.mollification);
  EXPECT_EQ(j["warnings"], nlohmann::json(r.warnings));
  const std::pair<const char*, double> times[] = {
      {"load", r.time_ms.load},   {"open", r.time_ms.open},
      {"solve", r.time_ms.solve}, {"straighten", r.time_ms.straighten},
      {"trace", r.time_ms.trace}, {"relax", r.time_ms.relax},
      {"fair", r.time_ms.fair},   {"measure", r.time_ms.measure},
      {"total", r.time_ms.total}};
  EXPECT_EQ(j["time_ms"].size(), std::size(times));
  for (const auto& [name, ms] : times) EXPECT_EQ(j["time_ms"][name], ms) << name;
  EXPECT_EQ(j["potential"], "paper");
  EXPECT_EQ(j["engine"], "full");
  EXPECT_EQ(j["termination"], "converged");
  EXPECT_EQ(j["stretches_redrawn"], r.stretches_redrawn);
  EXPECT_EQ(j["crossings_before"], r.crossings_before);
  EXPECT_EQ(j["crossings_after"], r.crossings_after);
  EXPECT_EQ(j["deviation_exact"], true);
  EXPECT_EQ(j["deviation_at_least"], r.deviation_at_least);
  EXPECT_EQ(j["peak_memory_mib"], r.peak_memory_mib);
  for (const char* name :
       {"slack_from", "left_out", "left_out_max", "max_deviation", "pins_added", "edge_length_near",
        "roughness_near", "missed_points", "missed_max", "missed_at", "farthest",
        "farthest_at_most", "farthest_at", "farthest_of", "moved", "decisive", "decisive_at"}) {
    EXPECT_TRUE(j.contains(name)) << name;
  }
}

TEST(Report, NumbersThatAreNotFiniteBecomeNull) {
  SmoothingReport r = numbered(1);
  r.deviation_to_drawn_max = kForever;
  r.deviation_from_drawn_mean = -kForever;
  r.before.length = std::numeric_limits<double>::quiet_NaN();
  r.deviation_at = Point::Constant(kForever);
  const auto j = parsed(r);
  EXPECT_TRUE(j["deviation_to_drawn_max"].is_null());
  EXPECT_TRUE(j["deviation_from_drawn_mean"].is_null());
  EXPECT_TRUE(j["length_before"].is_null());
  EXPECT_EQ(j["deviation_at"], nlohmann::json({nullptr, nullptr, nullptr}));
  EXPECT_EQ(j["deviation_to_drawn_mean"], r.deviation_to_drawn_mean);
}

/// The report on a result that is up to 2 from its drawing along the surface, and cuts off a part
/// that is 7 away.
SmoothingReport cutting_off() {
  SmoothingReport r;
  r.deviation = DeviationMeasure::kAlongSurface;
  r.deviation_to_drawn_max = 2;
  r.deviation_from_drawn_max = r.deviation_at_least = 7;
  r.deviation_at = Point(1, 2, 3);
  return r;
}

TEST(Farthest, IsTheLargerOfBothDirections) {
  SmoothingReport r = cutting_off();
  Farthest far = farthest(r);
  EXPECT_EQ(far.at_least, 7);
  EXPECT_EQ(far.at_most, 7);
  EXPECT_EQ(far.at, Point(1, 2, 3));
  EXPECT_EQ(far.of, FarthestOf::kDrawing);
  r.deviation_to_drawn_max = r.deviation_at_least = 8;
  far = farthest(r);
  EXPECT_EQ(far.at_least, 8);
  EXPECT_EQ(far.of, FarthestOf::kResult);
}

TEST(Farthest, TellsBounds) {
  SmoothingReport r = cutting_off();
  r.deviation_exact = false;
  r.deviation_at_least = 5;
  EXPECT_EQ(farthest(r).at_least, 5);
  EXPECT_EQ(farthest(r).at_most, 7);
  r = cutting_off();
  r.deviation = DeviationMeasure::kEuclidean;
  EXPECT_EQ(farthest(r).at_least, 7);
  EXPECT_EQ(farthest(r).at_most, kForever);  // along the surface it may be arbitrarily longer
}

TEST(Farthest, HasPointsThatAreMissed) {
  SmoothingReport r = cutting_off();
  r.missed_points = 1;
  r.missed_max = 9;
  r.missed_at = Point(4, 5, 6);
  Farthest far = farthest(r);
  EXPECT_EQ(far.at_least, 9);
  EXPECT_EQ(far.at_most, kForever);
  EXPECT_EQ(far.at, Point(4, 5, 6));
  EXPECT_EQ(far.of, FarthestOf::kPoint);
  r.missed_max = 3;
  far = farthest(r);
  EXPECT_EQ(far.at_least, 7);
  EXPECT_EQ(far.of, FarthestOf::kDrawing);
  r.deviation = DeviationMeasure::kNone;
  EXPECT_EQ(farthest(r).at_least, 3);
}

TEST(Farthest, IsUnknownIfNothingWasMeasured) {
  const auto j = parsed(SmoothingReport{});
  EXPECT_TRUE(j["farthest"].is_null());
  EXPECT_EQ(j["farthest_at"], nlohmann::json({nullptr, nullptr, nullptr}));
  EXPECT_EQ(j["farthest_of"], "none");
}

TEST(Farthest, OfSeveralCurvesIsThatOfTheWorst) {
  SmoothingReport a = cutting_off(), b = cutting_off();
  b.deviation_from_drawn_max = b.deviation_at_least = 1;
  b.missed_points = 2;
  b.missed_max = 9;
  b.missed_at = Point(4, 5, 6);
  warn_decisively(a, {"A."});
  warn_decisively(b, {"A."});
  warn_decisively(b, {"B.", Point(7, 8, 9)});
  for (const SmoothingReport& total : {total_of({a, b}), total_of({b, a})}) {
    EXPECT_EQ(farthest(total).at_least, 9);
    EXPECT_EQ(farthest(total).at, Point(4, 5, 6));
    EXPECT_EQ(farthest(total).of, FarthestOf::kPoint);
    EXPECT_EQ(total.missed_points, 2U);
    EXPECT_EQ(total.warnings, (std::vector<std::string>{"A.", "B."}));
    const auto j = parsed(total);
    EXPECT_EQ(j["decisive"], nlohmann::json({"A.", "B."}));
    EXPECT_EQ(j["decisive_at"], nlohmann::json({nullptr, nullptr, nullptr, 7, 8, 9}));
  }
}

TEST(Report, SeveralCurvesAreAnArrayBesideTheirTotal) {
  const std::vector<SmoothingReport> two = {numbered(1), numbered(100)};
  const auto one = nlohmann::json::parse(to_json(two[0], {two[0]}));
  EXPECT_FALSE(one.contains("curves"));
  const auto j = nlohmann::json::parse(to_json(total_of(two), two));
  ASSERT_EQ(j["curves"].size(), 2U);
  EXPECT_EQ(j["curves"][0], parsed(two[0]));
  EXPECT_EQ(j["curves"][1], parsed(two[1]));
}

TEST(Report, TotalsAreSumsMaximaAndMeansByLength) {
  SmoothingReport a = numbered(1), b = numbered(100);
  a.closed = true;
  a.after.length = 3;
  b.after.length = 1;
  a.deviation_to_drawn_mean = 1;
  b.deviation_to_drawn_mean = 5;
  a.warnings = {"x", "y"};
  b.warnings = {"y", "z"};
  b.termination = Outcome::kCollapsed;
  a.deviation_exact = false;
  const SmoothingReport total = total_of({a, b});
  EXPECT_FALSE(total.deviation_exact);
  EXPECT_EQ(total.deviation_at_least, b.deviation_at_least);
  EXPECT_FALSE(total.closed);
  EXPECT_EQ(total.points_before, a.points_before + b.points_before);
  EXPECT_EQ(total.points_after, a.points_after + b.points_after);
  EXPECT_EQ(total.before.length, a.before.length + b.before.length);
  EXPECT_EQ(total.after.length, 4);
  EXPECT_EQ(total.lifted_length_after, a.lifted_length_after + b.lifted_length_after);
  EXPECT_EQ(total.before.total_curvature, a.before.total_curvature + b.before.total_curvature);
  EXPECT_EQ(total.before.signed_curvature, a.before.signed_curvature + b.before.signed_curvature);
  EXPECT_EQ(total.after.max_curvature, b.after.max_curvature);
  EXPECT_EQ(total.before.bending, a.before.bending + b.before.bending);
  EXPECT_EQ(total.after.window_turning, b.after.window_turning);
  EXPECT_EQ(total.before.window_turning_2, b.before.window_turning_2);
  EXPECT_EQ(total.before.tortuosity, b.before.tortuosity);
  EXPECT_EQ(total.deviation_from_drawn_max, b.deviation_from_drawn_max);
  EXPECT_EQ(total.deviation_to_drawn_mean, 2);
  EXPECT_EQ(total.deviation_at, b.deviation_at);
  EXPECT_EQ(total.flips, a.flips);  // values of the whole run are equal in all reports
  EXPECT_EQ(total.warnings, (std::vector<std::string>{"x", "y", "z"}));
  EXPECT_EQ(total.termination, Outcome::kCollapsed);
  b.termination = Outcome::kCancelled;
  EXPECT_EQ(total_of({b, a}).termination, Outcome::kCancelled);
  EXPECT_EQ(total_of({a, b}).termination, Outcome::kCancelled);
  EXPECT_EQ(total_of({}).points_after, 0U);
  EXPECT_EQ(to_json(total_of({a})), to_json(a));
}

TEST(Report, TotalsOfInfiniteDistancesAreInfinite) {
  SmoothingReport a = numbered(1), b = numbered(100);
  b.deviation_to_drawn_max = b.deviation_to_drawn_mean = kForever;
  b.after.length = 0;  // and not NaN
  for (const SmoothingReport& total : {total_of({a, b}), total_of({b, a})}) {
    EXPECT_EQ(total.deviation_to_drawn_max, kForever);
    EXPECT_EQ(total.deviation_to_drawn_mean, kForever);
    EXPECT_EQ(total.deviation_at, b.deviation_at);
  }
}

TEST(Report, TotalsSayWhereADistanceIsOneThroughSpace) {
  SmoothingReport a = numbered(1), b = numbered(2);
  a.deviation = DeviationMeasure::kAlongSurface;
  b.deviation = DeviationMeasure::kEuclidean;
  EXPECT_EQ(total_of({a, b}).deviation, DeviationMeasure::kEuclidean);
  EXPECT_EQ(total_of({b, a}).deviation, DeviationMeasure::kEuclidean);
  EXPECT_EQ(total_of({a, a}).deviation, DeviationMeasure::kAlongSurface);
}

TEST(Report, TheMeasureOfDeviationIsAChoice) {
  const auto opened = OpenedMesh::open(test::sphere(4));
  const auto way = test::ids({0, 600, 3, 200});
  const SurfaceCurve drawn =
      test::vertex_curve(opened->surface(), draw_edge_path(opened->surface(), way), false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  SmoothingOptions options;
  const SmoothingReport surface = smoother.smooth(options).report();
  options.deviation = DeviationMeasure::kEuclidean;
  const SmoothingReport euclidean = smoother.smooth(options).report();
  options.deviation = DeviationMeasure::kNone;
  const SmoothingReport none = smoother.smooth(options).report();
  EXPECT_EQ(surface.deviation, DeviationMeasure::kAlongSurface);
  EXPECT_EQ(euclidean.deviation, DeviationMeasure::kEuclidean);
  EXPECT_EQ(none.deviation, DeviationMeasure::kNone);
  EXPECT_GT(euclidean.deviation_from_drawn_max, 0.01);
  const double slop = 2e-3 * opened->mesh().mean_edge_length();
  EXPECT_GE(surface.deviation_to_drawn_max, euclidean.deviation_to_drawn_max - slop);
  EXPECT_GE(surface.deviation_from_drawn_max, euclidean.deviation_from_drawn_max - slop);
  EXPECT_NEAR(surface.deviation_to_drawn_max, euclidean.deviation_to_drawn_max,
              0.05 * euclidean.deviation_to_drawn_max);
  EXPECT_EQ(none.deviation_to_drawn_max, kForever);
  EXPECT_TRUE(parsed(none)["deviation_from_drawn_mean"].is_null());
  EXPECT_EQ(surface.after.length, none.after.length);  // the result is the same
}

TEST(Report, SignsAndIndicesAreThoseOfTheCurveAsItWasDrawn) {
  const auto opened = OpenedMesh::open(test::sphere(4));
  const Surface& surface = opened->surface();
  const auto way = test::ids({0, 600, 3, 200});
  SurfaceCurve drawn = test::vertex_curve(surface, draw_edge_path(surface, way), false);
  for (const bool reversed : {false, true}) {
    if (reversed) std::reverse(drawn.points.begin(), drawn.points.end());
    CurveSmoother smoother(opened);
    smoother.set_curve(drawn);
    const SmoothingResult result = smoother.smooth(4);
    const SmoothingReport& report = result.report();
    const auto expect = [&](const CurveMeasures& reported, const SurfaceCurve& curve) {
      const CurveMeasures own = measure_curve(surface, curve, report.edge_length_near);
      EXPECT_GT(std::abs(own.signed_curvature), 0.1);
      EXPECT_NEAR(reported.signed_curvature, own.signed_curvature, 1e-9);
      ASSERT_GT(reported.max_at, 0U);
      ASSERT_LT(reported.max_at + 1, curve.points.size());
      const auto* at = &curve.points[reported.max_at];
      EXPECT_NEAR(turn_of(surface, at[-1], at[0], at[1]).from_straight, own.max_curvature, 1e-9);
    };
    expect(report.before, drawn);
    expect(report.after, result.curve());
  }
}

TEST(Report, CurvesOnPartsThatAreNotConnectedGetAWarning) {
  const SurfaceMesh mesh =
      SurfaceMesh::open(test::together(test::grid(4, 4), test::grid(4, 4), 100));
  DeviationMeter meter(mesh);
  SmoothingReport report = numbered(1);
  report_deviation(
      report, measure_deviation(DeviationMeasure::kAlongSurface, 1, meter, mesh,
                                test::vertex_curve(mesh.surface(), test::ids({6, 7, 8}), false),
                                test::vertex_curve(mesh.surface(), test::ids({31, 32}), false)));
  EXPECT_EQ(report.deviation_to_drawn_max, kForever);
  EXPECT_TRUE(report.deviation_at.allFinite());
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_NE(report.warnings[0].find("not connected"), std::string::npos);
  EXPECT_TRUE(parsed(report)["deviation_to_drawn_mean"].is_null());
}

}  // namespace
}  // namespace talweg
