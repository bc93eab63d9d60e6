// A stroke that ends near its beginning is a loop.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/core/strokes/drawn_loops.hpp"
#include "talweg/talweg.hpp"

namespace talweg::loop_closing_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

class LoopClosing : public testing::Test {
 protected:
  /// An arc around the middle of a plane; the radius grows by `grows` along the arc.
  [[nodiscard]] SurfaceCurve arc(double from, double to, double grows = 0) {
    std::vector<Point> points;
    for (double angle = from; angle <= to + 1e-9; angle += 5) {
      const double radius = 6 + grows * (angle - from) / (to - from);
      points.emplace_back(10 + radius * std::cos(angle * kDegree),
                          10 + radius * std::sin(angle * kDegree), 0);
    }
    return lines.join(snap(opened->mesh(), {false, points, {}}).points, false);
  }
  std::optional<ClosedLoop> closed(const SurfaceCurve& stroke, bool always = false) {
    return closed_loop(opened->mesh(), stroke, lines, always);
  }
  [[nodiscard]] double length(const SurfaceCurve& curve) const {
    return curve_length(opened->surface(), curve);
  }

  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(20, 20));
  StraightLines lines{opened->surface()};
};

TEST_F(LoopClosing, AnEndThatStopsALittleShort) {
  const auto loop = closed(arc(0, 350));
  ASSERT_TRUE(loop);
  EXPECT_TRUE(loop->curve.closed);
  EXPECT_NEAR(length(loop->curve), 2 * std::numbers::pi * 6, 0.1);
  EXPECT_NEAR(loop->gap, 2 * 6 * std::sin(5 * kDegree), 0.01);
}

TEST_F(LoopClosing, AnEndThatRunsOverTheBeginning) {
  for (const double grows : {0.0, 0.4, -0.4}) {
    const auto loop = closed(arc(0, 385, grows));
    ASSERT_TRUE(loop) << grows;
    EXPECT_NEAR(length(loop->curve), 2 * std::numbers::pi * (6 + grows / 2), 0.7) << grows;
    EXPECT_GT(loop->cut, 1.5) << grows;
  }
}

TEST_F(LoopClosing, AHorseshoeStaysOpen) {
  EXPECT_FALSE(closed(arc(0, 300)));
  const auto loop = closed(arc(0, 300), true);  // unless the user asks for a loop
  ASSERT_TRUE(loop);
  EXPECT_TRUE(loop->curve.closed);
}

TEST_F(LoopClosing, ALargerGapStaysAndIsReported) {
  SnappedDrawing drawing;
  drawing.curves = {arc(0, 340)};
  drawing.may_be_loop = {true};
  const auto with_ends = [&](CurveEnds ends) {
    return with_loops_closed(opened->mesh(), drawing, lines, ends);
  };
  const SnappedDrawing as_drawn = with_ends(CurveEnds::kAsDrawn);
  EXPECT_FALSE(as_drawn.curves[0].closed);
  ASSERT_EQ(as_drawn.notes.size(), 1U);  // 2 · 6 · sin 10°
  EXPECT_EQ(as_drawn.notes[0],
            "The ends of a curve lie 2.08 mesh units apart; the curve is taken as open. If a "
            "loop is meant, close the curve.");
  EXPECT_TRUE(with_ends(CurveEnds::kOpen).notes.empty());
  EXPECT_TRUE(with_ends(CurveEnds::kClosed).curves[0].closed);
  drawing.curves = {arc(0, 300)};  // a horseshoe
  EXPECT_TRUE(with_ends(CurveEnds::kAsDrawn).notes.empty());
}

TEST_F(LoopClosing, AStrokeOutAndBackStaysOpen) {
  std::vector<Point> points;
  for (double x = 2; x <= 16; x += 0.5) points.emplace_back(x, 10, 0);
  for (double x = 16; x >= 2; x -= 0.5) points.emplace_back(x, 10.4, 0);
  const SurfaceCurve way = lines.join(snap(opened->mesh(), {false, points, {}}).points, false);
  EXPECT_FALSE(closed(way));
  EXPECT_FALSE(gap_of_near_loop(opened->mesh(), way));
}

TEST_F(LoopClosing, NoClickIsCutOff) {
  const SurfaceCurve stroke = arc(0, 385);
  SnappedCurve clicked{false, stroke.points};
  for (std::size_t k = 0; k < stroke.points.size(); k += 6) clicked.way_points.push_back({k, 0});
  const std::size_t last = stroke.points.size() - 1;
  clicked.way_points.push_back({last, 0});
  SnappedDrawing drawing;
  drawing.add(opened->mesh(), std::span(&clicked, 1), lines);
  EXPECT_FALSE(
      with_loops_closed(opened->mesh(), drawing, lines, CurveEnds::kAsDrawn).curves[0].closed);
  const SnappedDrawing loop = with_loops_closed(opened->mesh(), drawing, lines, CurveEnds::kClosed);
  EXPECT_TRUE(loop.curves[0].closed);
  for (const WayPoint& way : drawing.way_points) {
    EXPECT_NE(std::find(loop.curves[0].points.begin(), loop.curves[0].points.end(), way.point),
              loop.curves[0].points.end());
  }
}

TEST_F(LoopClosing, PaintedPointsThatAreCutOffAreDropped) {
  const SurfaceCurve stroke = arc(0, 385);
  SnappedCurve painted{false, stroke.points};
  for (std::size_t k = 0; k < stroke.points.size(); ++k) painted.painted.push_back(k);
  painted.may_be_loop = true;
  SnappedDrawing drawing;
  drawing.add(opened->mesh(), std::span(&painted, 1), lines);
  const SnappedDrawing loop =
      with_loops_closed(opened->mesh(), drawing, lines, CurveEnds::kAsDrawn);
  ASSERT_TRUE(loop.curves[0].closed);
  EXPECT_LT(loop.painted.size(), drawing.painted.size());
  EXPECT_GT(loop.painted.size(), drawing.painted.size() / 2);
  for (const SurfacePoint& point : loop.painted) {
    EXPECT_NE(std::find(loop.curves[0].points.begin(), loop.curves[0].points.end(), point),
              loop.curves[0].points.end());
  }
}

TEST_F(LoopClosing, EndsHaveThreeNames) {
  EXPECT_EQ(curve_ends("auto"), CurveEnds::kAsDrawn);
  EXPECT_EQ(curve_ends("closed"), CurveEnds::kClosed);
  EXPECT_EQ(curve_ends("open"), CurveEnds::kOpen);
  EXPECT_THROW(curve_ends("shut"), Error);
}

}  // namespace
}  // namespace talweg::loop_closing_test
