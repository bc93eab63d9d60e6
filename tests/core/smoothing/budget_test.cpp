// Smoothing with a budget: for every amount of work a whole result, and a report that holds.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

constexpr std::uint64_t kHuge = 1'000'000'000'000;

SmoothingOptions with_work(std::uint64_t work, double tau = 1) {
  SmoothingOptions options;
  options.tau = tau;
  options.budget.work = work;
  return options;
}

bool says(const SmoothingReport& report, const std::string& words) {
  return std::any_of(
      report.warnings.begin(), report.warnings.end(),
      [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

/// The entries of a report, without times and memory.
std::string without_times(SmoothingReport report) {
  report.time_ms = {};
  report.peak_memory_mib = 0;
  return to_json(report);
}

class SmoothingBudget : public testing::Test {
 protected:
  const std::shared_ptr<const OpenedMesh> hills = OpenedMesh::open(test::hills(40));
  const SurfaceCurve wave = test::wave_on_hills(hills->mesh());
  CurveSmoother smoother{hills};
  void SetUp() override { smoother.set_curve(wave); }

  [[nodiscard]] SmoothingResult anew(const SmoothingOptions& options) const {
    return smooth_curve(hills, wave, options);
  }
  void expect_whole(const SmoothingResult& result) const {
    const SurfaceCurve& curve = result.curve();
    EXPECT_EQ(curve.points.front(), wave.points.front());
    EXPECT_EQ(curve.points.back(), wave.points.back());
    EXPECT_GT(curve_length(hills->surface(), curve), 0);  // consecutive points share a face
    const SmoothingReport& report = result.report();
    const double exact = test::apart(hills->mesh(), curve, wave);
    const double told = std::max(report.deviation_to_drawn_max, report.deviation_from_drawn_max);
    EXPECT_GE(told, exact * (1 - 1e-3) - 1e-3);
    EXPECT_LE(report.deviation_at_least, exact * (1 + 1e-3) + 1e-3);
    if (report.deviation_exact) {
      EXPECT_NEAR(told, exact, 1e-3 * (1 + exact));
    }
  }
};

TEST_F(SmoothingBudget, GivesAWholeCurveForAnyWork) {
  const SmoothingResult all = anew({});
  std::size_t ended = 0;
  for (std::uint64_t work = 1; work < kHuge; work = 2 * work + 1) {
    SCOPED_TRACE(work);
    const SmoothingResult result = anew(with_work(work)), again = anew(with_work(work));
    expect_whole(result);
    EXPECT_EQ(result.curve().points, again.curve().points);
    EXPECT_EQ(without_times(result.report()), without_times(again.report()));
    const SmoothingReport& report = result.report();
    if (report.termination == Outcome::kConverged) {
      EXPECT_EQ(result.curve().points, all.curve().points);
      EXPECT_EQ(without_times(report), without_times(all.report()));
      break;
    }
    ++ended;
    EXPECT_EQ(report.termination, Outcome::kLimit);
    EXPECT_TRUE(says(report, "The budget was used up"));
    EXPECT_FALSE(says(report, "Straightening was given up"));
    EXPECT_LT(report.after.bending, report.before.bending);
  }
  EXPECT_GT(ended, 8U);
}

TEST_F(SmoothingBudget, OfHugeWorkOrTimeEqualsNoBudget) {
  for (const double tau : {0.0, 0.05, 1.0, 3.0}) {
    SmoothingOptions none = with_work(kHuge, tau), time = none;
    none.budget = {};
    time.budget = {};
    time.budget.seconds = 1e12;
    const SmoothingResult plain = anew(none);
    for (const SmoothingOptions& options : {with_work(kHuge, tau), time}) {
      const SmoothingResult result = anew(options);
      EXPECT_EQ(result.curve().points, plain.curve().points);
      EXPECT_EQ(without_times(result.report()), without_times(plain.report()));
    }
  }
}

// FairLadder keeps chains for later calls. Chains of a call that a budget ended early must not be
// kept.
TEST_F(SmoothingBudget, LeavesNothingBehind) {
  for (const double tau : {3.0, 1.0, 0.3, 0.05}) {
    SCOPED_TRACE(tau);
    for (const std::uint64_t work : {1U, 20'000U, 60'000U, 200'000U}) {
      smoother.smooth(with_work(work, tau));
      const SmoothingResult after = smoother.smooth(tau);
      SmoothingOptions plain;
      plain.tau = tau;
      EXPECT_EQ(after.curve().points, anew(plain).curve().points);
      EXPECT_EQ(after.report().termination, Outcome::kConverged);
    }
  }
}

TEST_F(SmoothingBudget, OfTimeThatIsUsedUpEndsEverything) {
  SmoothingOptions options;
  options.budget.seconds = 1e-9;
  const SmoothingResult result = smoother.smooth(options);
  expect_whole(result);
  EXPECT_EQ(result.report().termination, Outcome::kLimit);
  EXPECT_FALSE(result.report().deviation_exact);
  EXPECT_TRUE(says(result.report(), "The budget was used up"));
}

TEST_F(SmoothingBudget, OfDragging) {
  smoother.smooth(with_work(1));
  SurfaceCurve moved = wave;
  moved.points.erase(moved.points.end() - 3, moved.points.end());
  const SmoothingResult dragged = smoother.drag(0, moved, with_work(1));
  EXPECT_EQ(dragged.report().termination, Outcome::kLimit);
  EXPECT_EQ(dragged.curve().points.back(), moved.points.back());
  EXPECT_EQ(smoother.smooth(1).curve().points, anew({}).curve().points);
}

// A curve within the bound stays the best until more work finds a smoother curve.
TEST_F(SmoothingBudget, OfASearchWithinABound) {
  const double bound = 1;
  const SmoothingResult all = smooth_within(smoother, bound);
  ASSERT_EQ(all.report().termination, Outcome::kConverged);
  double curvature = HUGE_VAL;
  std::size_t ended = 0;
  for (std::uint64_t work = 1; work < kHuge; work *= 3) {
    SCOPED_TRACE(work);
    CurveSmoother fresh(hills);
    fresh.set_curve(wave);
    const SmoothingResult result = smooth_within(fresh, bound, with_work(work));
    expect_whole(result);
    const SmoothingReport& report = result.report();
    EXPECT_EQ(report.max_deviation, bound);
    const bool within =
        std::max(report.deviation_to_drawn_max, report.deviation_from_drawn_max) <= bound;
    EXPECT_EQ(says(report, "No curve within"), !within);
    EXPECT_TRUE(within || curvature == HUGE_VAL);
    if (report.termination == Outcome::kConverged) {
      EXPECT_EQ(result.curve().points, all.curve().points);
      break;
    }
    ++ended;
    EXPECT_EQ(report.termination, Outcome::kLimit);
    if (!within) continue;
    EXPECT_TRUE(says(report, "there may be a smoother curve"));
    if (report.deviation_exact) {
      EXPECT_LE(report.after.total_curvature, curvature);
      curvature = report.after.total_curvature;
    }
  }
  EXPECT_LT(curvature, HUGE_VAL);
  EXPECT_GT(ended, 5U);
}

constexpr std::uint32_t kNeedles = 800;

/// A sheet of needles, 4 by 6, and a drawing that goes around three sides of it.
MeshLists needle_sheet() {
  MeshLists lists = test::grid(kNeedles, 6);
  for (Point& p : lists.points) p.x() *= 4.0 / kNeedles;
  return lists;
}
SurfaceCurve around(const Surface& surface) {
  const auto at = [](std::uint32_t i, std::uint32_t j) { return VertexId{j * (kNeedles + 1) + i}; };
  const std::uint32_t left = kNeedles / 4, right = 3 * left;
  const VertexId way[] = {at(left, 1), at(left, 6), at(right, 6), at(right, 2)};
  return test::vertex_curve(surface, draw_edge_path(surface, way), false);
}

// A wide slack lets the result leave the drawing; exact distances would take many times as
// long as smoothing.
TEST(SparedDeviation, IsABoundWhereMeasuringWouldTakeFarLongerThanSmoothing) {
  const auto opened = OpenedMesh::open(needle_sheet());
  const SurfaceCurve drawn = around(opened->surface());
  SmoothingOptions options;
  options.slack = 4;
  const SmoothingResult spared = smooth_curve(opened, drawn, options);
  const SmoothingReport& report = spared.report();
  EXPECT_EQ(report.termination, Outcome::kConverged);
  EXPECT_FALSE(report.deviation_exact);
  EXPECT_TRUE(says(report, "exact deviation was not measured"));
  options.deviation = DeviationMeasure::kAlongSurface;
  const SmoothingReport exact = smooth_curve(opened, drawn, options).report();
  EXPECT_TRUE(exact.deviation_exact);
  EXPECT_GE(report.deviation_to_drawn_max, exact.deviation_to_drawn_max);
  EXPECT_GE(report.deviation_from_drawn_max, exact.deviation_from_drawn_max);
  EXPECT_LE(report.deviation_at_least, exact.deviation_at_least * (1 + 1e-3));
}

TEST(Budget, MustBePositive) {
  SmoothingOptions options;
  options.budget.work = 0;
  EXPECT_THROW(options.validate(), Error);
  options.budget = {};
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    options.budget.seconds = bad;
    EXPECT_THROW(options.validate(), Error) << bad;
  }
  options.budget.seconds = 1e-3;
  EXPECT_NO_THROW(options.validate());
}

}  // namespace
}  // namespace talweg
