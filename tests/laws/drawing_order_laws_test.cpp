// A result is bitwise the same if a curve is reversed, a loop begins at another point, or the
// curves of a set are listed in another order: for every tau, within a bound, with pins and with a
// slack field.
#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "laws/subjects.hpp"
#include "talweg/core/smoothing/max_deviation.hpp"

namespace talweg {
namespace {

using Points = std::vector<SurfacePoint>;

/// A drawing reversed or begun elsewhere, and the inverse transformation of results.
struct Redrawn {
  SurfaceCurve curve;
  std::vector<std::size_t> from;  // per point, its number in the first drawing
  bool reversed = false;

  Redrawn(const SurfaceCurve& drawn, double start, bool backwards)
      : curve{drawn.closed, {}}, reversed(backwards) {
    const std::size_t n = drawn.points.size();
    for (std::size_t k = 0; k < n; ++k) from.push_back(k);
    if (reversed) std::reverse(from.begin(), from.end());
    std::rotate(from.begin(),
                from.begin() + static_cast<std::ptrdiff_t>(start * static_cast<double>(n)),
                from.end());
    for (const std::size_t k : from) curve.points.push_back(drawn.points[k]);
  }

  [[nodiscard]] Points taken_back(Points result) const {
    if (reversed) std::reverse(result.begin(), result.end());
    return result;
  }
};

std::vector<Redrawn> others(const SurfaceCurve& drawn) {
  std::vector<Redrawn> all{{drawn, 0, true}};
  if (drawn.closed) {
    for (const double start : {0.21, 0.5, 0.83}) all.emplace_back(drawn, start, start > 0.8);
  }
  return all;
}

/// The report without times and memory.
std::string numbers_of(SmoothingReport report) {
  report.time_ms = {};
  report.peak_memory_mib = 0;
  return to_json(report);
}

class DrawingOrderLaw : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    subject_ = test::make_subject(GetParam());
    if (subject_.lists.points.empty()) GTEST_SKIP() << test::missing(GetParam());
    opened_ = OpenedMesh::open(subject_.lists);
    edge_ = opened_->mesh().mean_edge_length();
    for (const test::Subject::Drawing& drawing : subject_.drawings) {
      curves_.push_back(test::curve_of(opened_->surface(), drawing));
    }
  }

  using Smooth = std::function<SmoothingResult(CurveSmoother&, const Redrawn&)>;

  /// Expects the same result for every reversal and first point.
  void expect_same(const Smooth& smooth) {
    CurveSmoother smoother(opened_);
    for (const SurfaceCurve& drawn : curves_) {
      const SmoothingResult expected = smooth(smoother, Redrawn(drawn, 0, false));
      for (const Redrawn& other : others(drawn)) {
        const SmoothingResult found = smooth(smoother, other);
        EXPECT_EQ(other.taken_back(found.curve().points), expected.curve().points)
            << "begun at point " << other.from.front() << ", "
            << test::apart(opened_->mesh(), found.curve(), expected.curve()) / edge_
            << " mean edges apart";
        EXPECT_EQ(numbers_of(found.report()), numbers_of(expected.report()));
      }
    }
  }

  test::Subject subject_;
  std::shared_ptr<const OpenedMesh> opened_;
  double edge_ = 0;
  std::vector<SurfaceCurve> curves_;
};

TEST_P(DrawingOrderLaw, WithinABound) {
  for (const double bound : {0.5, 1.5}) {
    SCOPED_TRACE(testing::Message() << bound << " mean edges");
    expect_same([&](CurveSmoother& smoother, const Redrawn& drawn) {
      smoother.set_curve(drawn.curve);
      return smooth_within(smoother, bound * edge_);
    });
  }
}

TEST_P(DrawingOrderLaw, WithBothPotentials) {
  for (const Method method : {Method::kPaper, Method::kCorridor}) {
    for (const double tau : {0.0, 0.1, 0.7, 4.0}) {
      SCOPED_TRACE(testing::Message() << "tau " << tau);
      expect_same([&](CurveSmoother& smoother, const Redrawn& drawn) {
        smoother.set_curve(drawn.curve, {.method = method});
        return smoother.smooth(tau);
      });
    }
  }
}

TEST_P(DrawingOrderLaw, WithAPotentialOfTheCaller) {
  std::vector<double> potential;
  for (const Point& p : opened_->mesh().points()) {
    potential.push_back(edge_ * std::sin(p.sum() / (3 * edge_)));
  }
  expect_same([&](CurveSmoother& smoother, const Redrawn& drawn) {
    smoother.set_curve(drawn.curve);
    return smoother.smooth({}, potential, 1);
  });
}

TEST_P(DrawingOrderLaw, WithPinsAndASlackThatVaries) {
  expect_same([&](CurveSmoother& smoother, const Redrawn& drawn) {
    const std::size_t n = drawn.from.size();
    CurveOptions curve_options;
    SmoothingOptions options;
    options.slack_at.emplace_back();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = drawn.from[i];
      if (k == n / 3 || k == 2 * n / 3) curve_options.pins.push_back(drawn.curve.points[i]);
      options.slack_at[0].push_back(edge_ * (0.5 + 0.4 * std::sin(0.2 * static_cast<double>(k))));
    }
    smoother.set_curve(drawn.curve, curve_options);
    return smoother.smooth(options);
  });
}

// Curves along common edges: the order of the list must not decide which curve counts there and
// which lies on the left.
TEST_P(DrawingOrderLaw, OfASetOfCurvesThatTouch) {
  const Points& points = curves_.front().points;
  const auto part = [&](double from, double to) {
    const auto n = static_cast<double>(points.size());
    return SurfaceCurve{false,
                        {points.begin() + static_cast<std::ptrdiff_t>(from * n),
                         points.begin() + static_cast<std::ptrdiff_t>(to * n)}};
  };
  const std::vector<SurfaceCurve> set = {part(0, 0.6), part(0.3, 0.8), part(0.55, 1)};
  CurveSmoother smoother(opened_);
  const auto smooth = [&](const std::vector<std::size_t>& order) {
    std::vector<SurfaceCurve> curves;
    for (const std::size_t c : order) curves.push_back(set[c]);
    smoother.set_curves(curves);
    return smoother.smooth(0.7);
  };
  std::vector<std::size_t> order = {0, 1, 2};
  const SmoothingResult expected = smooth(order);
  const std::vector<double> slack = smoother.slack();
  while (std::next_permutation(order.begin(), order.end())) {
    const SmoothingResult found = smooth(order);
    for (std::size_t i = 0; i < order.size(); ++i) {
      EXPECT_EQ(found.curves[i].points, expected.curves[order[i]].points);
      EXPECT_EQ(numbers_of(found.reports[i]), numbers_of(expected.reports[order[i]]));
      EXPECT_EQ(smoother.slack()[i], slack[order[i]]);
      EXPECT_EQ(smoother.drawn()[i].points, set[order[i]].points);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, DrawingOrderLaw, ::testing::ValuesIn(test::subject_names()),
                         [](const auto& one) { return one.param; });

}  // namespace
}  // namespace talweg
