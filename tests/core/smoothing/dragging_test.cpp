// Dragging a part of a drawing: near the result of the changed drawing, and unchanged elsewhere.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kSize = 160;
// In edges: the result may be another of several geodesics of about the same length in a valley.
constexpr double kSame = 1;

class Dragging : public testing::Test {
 protected:
  static std::shared_ptr<const OpenedMesh> hills() {
    static const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::hills(kSize));
    return opened;
  }
  [[nodiscard]] static SurfaceCurve through(const std::vector<std::array<std::uint32_t, 2>>& way,
                                            bool closed) {
    std::vector<VertexId> vertices;
    for (const auto& [x, y] : way) vertices.emplace_back(y * (kSize + 1) + x);
    const Surface& surface = hills()->surface();
    return test::vertex_curve(surface, draw_edge_path(surface, vertices, closed), closed);
  }
  /// From left to right up and down; way-point `moved` is `by` rows higher.
  static SurfaceCurve wave(std::size_t moved = 0, std::uint32_t by = 0, std::uint32_t row = 80) {
    std::vector<std::array<std::uint32_t, 2>> way;
    for (std::uint32_t k = 0; k < 19; ++k) way.push_back({8 + 8 * k, row + (k % 2 == 0 ? 0 : 5)});
    way[moved][1] += by;
    return through(way, false);
  }
  static SurfaceCurve ring(std::size_t moved = 0, std::int32_t by = 0) {
    std::vector<std::array<std::uint32_t, 2>> way;
    for (std::size_t k = 0; k < 24; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / 24;
      const double r = (k % 2 == 0 ? 60 : 56) + (k == moved ? by : 0);
      way.push_back({static_cast<std::uint32_t>(80 + r * std::cos(angle)),
                     static_cast<std::uint32_t>(80 + r * std::sin(angle))});
    }
    return through(way, true);
  }

  void set(const SurfaceCurve& curve) { smoother.set_curve(curve); }

  /// The full result for a moved drawing, with the slack of the drawing that is set.
  [[nodiscard]] SurfaceCurve in_full(const SurfaceCurve& moved, SmoothingOptions options) const {
    options.slack = smoother.slack().front();
    return smooth_curve(hills(), moved, options).curve();
  }
  static double apart(const SurfaceCurve& a, const SurfaceCurve& b) {
    return test::apart(hills()->mesh(), a, b);
  }
  /// The number of points of the first curve that the second has, bit for bit.
  static std::size_t shared(const SurfaceCurve& a, const SurfaceCurve& b) {
    return static_cast<std::size_t>(
        std::count_if(a.points.begin(), a.points.end(), [&](const SurfacePoint& p) {
          return std::find(b.points.begin(), b.points.end(), p) != b.points.end();
        }));
  }

  CurveSmoother smoother{hills()};
  const double edge = hills()->mesh().mean_edge_length();
};

TEST_F(Dragging, IsCloseToTheResultOfTheChangedDrawing) {
  for (const double tau : {0.3, 1.0, 2.7, 9.0}) {
    SCOPED_TRACE(testing::Message() << "tau " << tau);
    set(wave());
    const SurfaceCurve before = smoother.smooth(tau).curve();
    const SurfaceCurve moved = wave(9, 6);
    const SmoothingResult dragged = smoother.drag(0, moved, {.tau = tau});
    EXPECT_EQ(dragged.report().engine, Engine::kPreview);
    EXPECT_GT(apart(dragged.curve(), before), 2 * edge);
    EXPECT_LT(apart(dragged.curve(), in_full(moved, {.tau = tau})), kSame * edge);
    EXPECT_LT(dragged.report().deviation_to_drawn_max, 3 * edge);
    // Points far from the change are unchanged.
    EXPECT_GT(shared(before, dragged.curve()), before.points.size() / 4);
  }
}

/// Hosts list the painted points of a stroke. A moved stroke has other points, which are not in the
/// list.
TEST_F(Dragging, OfAStrokeWhosePointsWerePaintedIsTheSame) {
  set(wave());
  smoother.smooth(1);
  const SurfaceCurve moved = wave(9, 6);
  const SurfaceCurve expected = smoother.drag(0, moved).curve();
  smoother.set_curve(wave(), {.painted = wave().points});
  smoother.smooth(1);
  EXPECT_EQ(smoother.drag(0, moved).curve().points, expected.points);
}

TEST_F(Dragging, OfALoopAlsoAtItsSeam) {
  set(ring());
  const SurfaceCurve before = smoother.smooth(1).curve();
  for (const std::size_t k : {0, 1, 7, 12, 23}) {
    SCOPED_TRACE(testing::Message() << "way-point " << k);
    const SurfaceCurve moved = ring(k, -7);
    const SmoothingResult dragged = smoother.drag(0, moved);
    EXPECT_TRUE(dragged.curve().closed);
    EXPECT_GT(apart(dragged.curve(), before), 1.5 * edge);
    EXPECT_LT(apart(dragged.curve(), in_full(moved, {})), kSame * edge);
    EXPECT_GT(shared(before, dragged.curve()), before.points.size() / 3);
    EXPECT_LT(dragged.report().after.total_curvature,
              0.4 * dragged.report().before.total_curvature);
  }
}

TEST_F(Dragging, OfAnEnd) {
  set(wave());
  for (const std::size_t k : {0, 18}) {
    const SurfaceCurve moved = wave(k, 5);
    const SurfaceCurve dragged = smoother.drag(0, moved).curve();
    EXPECT_EQ(dragged.points.front(), moved.points.front());
    EXPECT_EQ(dragged.points.back(), moved.points.back());
    EXPECT_LT(apart(dragged, in_full(moved, {})), kSame * edge);
  }
}

TEST_F(Dragging, LeavesNoKinkWhereItJoins) {
  set(wave());
  const SmoothingReport before = smoother.smooth(1).report();
  const SurfaceCurve moved = wave(9, 6);
  const SurfaceCurve full = in_full(moved, {});
  const CurveMeasures expected = measure_curve(hills()->surface(), full);
  const CurveMeasures dragged = measure_curve(hills()->surface(), smoother.drag(0, moved).curve());
  EXPECT_LT(dragged.total_curvature, 1.1 * expected.total_curvature);
  EXPECT_LE(dragged.max_curvature,
            std::max(before.after.max_curvature, expected.max_curvature) + 0.2);
}

TEST_F(Dragging, ChangesNothingThatIsSet) {
  set(wave());
  const SurfaceCurve before = smoother.smooth(1).curve();
  const SurfaceCurve first = smoother.drag(0, wave(9, 3)).curve();
  const SurfaceCurve other = smoother.drag(0, wave(4, 6)).curve();
  EXPECT_EQ(smoother.drag(0, wave(9, 3)).curve().points, first.points);
  EXPECT_EQ(smoother.drag(0, wave(4, 6)).curve().points, other.points);
  EXPECT_EQ(smoother.drag(0, wave()).curve().points, before.points);
  EXPECT_EQ(smoother.drawn().front().points, wave().points);
  EXPECT_EQ(smoother.smooth(1).curve().points, before.points);
  CurveSmoother asked_nothing(hills());
  asked_nothing.set_curve(wave());
  EXPECT_EQ(asked_nothing.drag(0, wave(9, 3)).curve().points, first.points);
}

TEST_F(Dragging, OfOneCurveOfASetLeavesTheOthers) {
  const std::vector<SurfaceCurve> drawn = {wave(0, 0, 60), wave(0, 0, 80), wave(0, 0, 100)};
  smoother.set_curves(drawn);
  const SmoothingResult before = smoother.smooth(1);
  const SurfaceCurve moved = wave(9, 6, 80);
  const SmoothingResult dragged = smoother.drag(1, moved);
  ASSERT_EQ(dragged.curves.size(), 3U);
  EXPECT_EQ(dragged.curves[0].points, before.curves[0].points);
  EXPECT_EQ(dragged.curves[2].points, before.curves[2].points);
  EXPECT_EQ(dragged.reports[1].engine, Engine::kPreview);
  EXPECT_EQ(dragged.reports[0].engine, Engine::kLocal);
  CurveSmoother full(hills());
  full.set_curves(std::vector<SurfaceCurve>{drawn[0], moved, drawn[2]});
  EXPECT_LT(apart(dragged.curves[1], full.smooth({.slack = smoother.slack()[1]}).curves[1]),
            kSame * edge);
}

TEST_F(Dragging, IsKeptOffByAnotherStrandOfTheDrawing) {
  const SurfaceCurve drawn[] = {wave(0, 0, 80), wave(0, 0, 87)};
  smoother.set_curves(drawn);
  smoother.smooth(1);
  const SmoothingResult dragged = smoother.drag(0, wave(10, 3, 80));
  EXPECT_GT(apart(dragged.curves[0], dragged.curves[1]), 2 * edge);
  for (const Point& p : positions_of(hills()->mesh(), dragged.curves[0])) {
    EXPECT_TRUE(p.allFinite());
  }
}

TEST_F(Dragging, PassesThroughPins) {
  const SurfaceCurve drawn = wave();
  const SurfaceCurve moved = wave(9, 6);
  const std::size_t near = static_cast<std::size_t>(
      std::mismatch(drawn.points.begin(), drawn.points.end(), moved.points.begin()).first -
      drawn.points.begin());
  const SurfacePoint pin = drawn.points[near - 4];
  CurveOptions options;
  options.pins = {pin};
  smoother.set_curve(drawn, options);
  const SurfaceCurve dragged = smoother.drag(0, moved).curve();
  EXPECT_NE(std::find(dragged.points.begin(), dragged.points.end(), pin), dragged.points.end());
}

TEST_F(Dragging, OfAllOrForGeodesicsSmoothsEverything) {
  set(wave());
  const SurfaceCurve elsewhere = wave(0, 0, 50);
  EXPECT_LT(apart(smoother.drag(0, elsewhere).curve(), in_full(elsewhere, {})), kSame * edge);
  const SurfaceCurve moved = wave(9, 6);
  EXPECT_LT(apart(smoother.drag(0, moved, {.tau = 0}).curve(), in_full(moved, {.tau = 0})),
            1e-6 * edge);
}

TEST_F(Dragging, TakesASlackAlongTheDrawing) {
  const SurfaceCurve drawn = wave();
  set(drawn);
  const std::vector<double> constant(drawn.points.size(), smoother.slack().front());
  const SurfaceCurve moved = wave(9, 6);
  const SurfaceCurve plain = smoother.drag(0, moved).curve();
  EXPECT_LT(apart(smoother.drag(0, moved, {.slack_at = {constant}}).curve(), plain), 0.01 * edge);
}

TEST_F(Dragging, RefusesInvalidCalls) {
  const auto code_of = [&](std::size_t curve, const SurfaceCurve& moved, double tau) {
    try {
      smoother.drag(curve, moved, {.tau = tau});
    } catch (const Error& error) {
      EXPECT_GT(std::string(error.what()).size(), 10U);
      return std::optional(error.code());
    }
    return std::optional<ErrorCode>();
  };
  EXPECT_EQ(code_of(0, wave(), 1), ErrorCode::kBadUsage);  // no curve is set
  set(wave());
  EXPECT_EQ(code_of(1, wave(), 1), ErrorCode::kBadUsage);
  EXPECT_EQ(code_of(0, wave(), -1), ErrorCode::kBadUsage);
  SurfaceCurve twice = wave();
  twice.points.insert(twice.points.begin() + 60, twice.points[58]);
  EXPECT_EQ(code_of(0, twice, 1), ErrorCode::kBadCurve);
  EXPECT_FALSE(code_of(0, wave(9, 6), 1));  // as before the cancelled call
  CurveOptions paper;
  paper.method = Method::kPaper;
  smoother.set_curve(wave(), paper);
  EXPECT_EQ(code_of(0, wave(9, 6), 1), ErrorCode::kBadUsage);
}

}  // namespace
}  // namespace talweg
