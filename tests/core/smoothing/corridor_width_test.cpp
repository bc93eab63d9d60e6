#include "talweg/core/smoothing/corridor_width.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/core/smoothing/slack_field.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using test::grid;

constexpr std::uint32_t kColumns = 60;
constexpr double kTiny = 1e-12;  // relative: some hundred sums of lengths

VertexId at(std::uint32_t i, std::uint32_t j) { return VertexId{j * (kColumns + 1) + i}; }

struct Scale {
  double slack, length, width;
};
Scale scale_of(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  return {default_slack(mesh.surface(), curve), corridor_length(mesh, curve),
          width_of_loop(mesh, curve)};
}
void expect_same(const Scale& a, const Scale& b, double factor = 1) {
  EXPECT_NEAR(a.slack * factor, b.slack, kTiny * b.slack);
  EXPECT_NEAR(a.length * factor, b.length, kTiny * b.length);
  EXPECT_NEAR(a.width * factor, b.width, kTiny * (b.width + b.length));
}

/// From column to column over row 5 of a grid, `heights` in [0, 1) above it.
SurfaceCurve over_row(const Surface& surface, const std::vector<double>& heights) {
  SurfaceCurve curve;
  for (std::uint32_t i = 0; i < heights.size(); ++i) {
    const double here = heights[i];
    const auto low = static_cast<std::uint32_t>(at(i, 5).index());
    const auto high = static_cast<std::uint32_t>(at(i, 6).index());
    curve.points.push_back(here > 0 ? test::between(surface, low, high, here)
                                    : SurfacePoint::at_vertex(surface, at(i, 5)));
    if (i + 1 == heights.size()) break;
    // Where it crosses the diagonal from (i, 5) to (i + 1, 6).
    const double across = here / (1 - heights[i + 1] + here);
    if (across > 0) curve.points.push_back(test::between(surface, low, high + 1, across));
  }
  return curve;
}

/// Runs of `run` to the right, with steps of `step` up and down in between.
SurfaceCurve square_wave(const Surface& surface, std::uint32_t run, std::uint32_t step) {
  std::vector<VertexId> way;
  for (std::uint32_t k = 0; k * run < kColumns; ++k) {
    const std::uint32_t j = 3 + k % 2 * step;
    way.push_back(at(k * run, j));
    way.push_back(at((k + 1) * run, j));
  }
  return test::vertex_curve(surface, draw_edge_path(surface, way), false);
}

SurfaceCurve rectangle(const Surface& surface, std::uint32_t a, std::uint32_t b) {
  const VertexId corners[] = {at(2, 2), at(2 + a, 2), at(2 + a, 2 + b), at(2, 2 + b)};
  std::vector<VertexId> path;
  for (std::uint32_t i = 0; i < a; ++i) path.push_back(at(2 + i, 2));
  for (std::uint32_t j = 0; j < b; ++j) path.push_back(at(2 + a, 2 + j));
  for (std::uint32_t i = 0; i < a; ++i) path.push_back(at(2 + a - i, 2 + b));
  for (std::uint32_t j = 0; j < b; ++j) path.push_back(at(2, 2 + b - j));
  EXPECT_EQ(path.front(), corners[0]);
  return test::vertex_curve(surface, path, true);
}

SurfaceCurve with_middles(const Surface& surface, const SurfaceCurve& curve) {
  SurfaceCurve finer{curve.closed, {}};
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    finer.points.push_back(curve.points[i]);
    if (i + 1 == n && !curve.closed) break;
    const SurfacePoint &p = curve.points[i], &q = curve.points[(i + 1) % n];
    const FaceId face = common_face(surface, p, q);
    auto middle = coordinates_in(surface, p, face).barycentric;
    const auto end = coordinates_in(surface, q, face).barycentric;
    for (std::size_t k = 0; k < 3; ++k) middle[k] = (middle[k] + end[k]) / 2;
    finer.points.push_back(SurfacePoint::from_barycentric(surface, face, middle));
  }
  return finer;
}

class CorridorScale : public testing::Test {
 protected:
  const SurfaceMesh mesh = SurfaceMesh::open(grid(kColumns, 20));
  const Surface& surface = mesh.surface();
};

TEST_F(CorridorScale, ASquareWaveIsSevenTenthsOfItsStepWide) {
  for (const std::uint32_t step : {1U, 2U, 3U}) {
    const SurfaceCurve wave = square_wave(surface, step, step);
    EXPECT_NEAR(default_slack(surface, wave), 0.7 * step, kTiny) << step;
  }
  // The runs of 4 and steps of 2 are equally many but for one run more.
  EXPECT_NEAR(default_slack(surface, square_wave(surface, 4, 2)), 0.7 * 4, kTiny);
}

TEST_F(CorridorScale, AZigzagIsSevenTenthsOfItsSegmentsWide) {
  std::vector<double> heights(kColumns + 1, 0);
  for (std::size_t i = 1; i < heights.size(); i += 2) heights[i] = 0.5;
  const SurfaceCurve zigzag = over_row(surface, heights);
  EXPECT_NEAR(default_slack(surface, zigzag), 0.7 * std::hypot(1, 0.5), kTiny);
  // A centre of mass half way, and 60 columns.
  EXPECT_NEAR(corridor_length(mesh, zigzag), std::hypot(30, 0.25) / 4, 1e-9);
}

TEST_F(CorridorScale, AWaverOfLessThanATenthRadianIsStraight) {
  std::vector<double> heights(kColumns + 1, 0);
  for (std::size_t i = 1; i < heights.size(); i += 2) heights[i] = 0.04;  // turns by 0.08
  const SurfaceCurve straight = over_row(surface, heights);
  const double length = kColumns * std::hypot(1, 0.04);
  EXPECT_NEAR(default_slack(surface, straight), length / 24, 1e-9);
  for (double& h : heights) h *= 0.06 / 0.04;  // 0.12
  // Up to 0.2 rad segments count in proportion.
  EXPECT_NEAR(default_slack(surface, over_row(surface, heights)),
              0.7 * std::hypot(1, 0.06) * (2 * std::atan(0.06) / 0.2), 1e-9);
}

TEST_F(CorridorScale, RectanglesInClosedForm) {
  for (const auto& [a, b] : {std::pair(40U, 2U), std::pair(12U, 12U), std::pair(30U, 1U)}) {
    const Scale scale = scale_of(mesh, rectangle(surface, a, b));
    const double round = 2.0 * (a + b);
    EXPECT_NEAR(scale.slack, std::min(0.7 * a, round / 24), 1e-9);
    EXPECT_NEAR(scale.length, std::hypot(a, b) / 8, 1e-9);
    EXPECT_NEAR(scale.width, a * b / (2 * round), 1e-9);
  }
}

TEST_F(CorridorScale, ACircleInClosedForm) {
  // A ring of a tube is a regular polygon, and straight.
  const std::uint32_t n = 48;
  const SurfaceMesh tube = SurfaceMesh::open(test::tube(n, 9, 2));
  std::vector<VertexId> ring;
  for (std::uint32_t i = 0; i < n; ++i) ring.emplace_back(4 * n + i);
  const Scale scale = scale_of(tube, test::vertex_curve(tube.surface(), ring, true));
  const double half = std::numbers::pi / n;
  EXPECT_NEAR(scale.length, 0.25, 1e-9);
  EXPECT_NEAR(scale.width, std::cos(half) / 4, 1e-9);
  EXPECT_NEAR(scale.slack, 2 * n * std::sin(half) / 24, 1e-9);
}

TEST_F(CorridorScale, FollowsTheDrawingAndNotItsPoints) {
  const SurfaceCurve curves[] = {square_wave(surface, 2, 2), rectangle(surface, 12, 5)};
  MeshLists large = grid(kColumns, 20);
  for (Point& p : large.points) p *= 1e5;
  const SurfaceMesh larger = SurfaceMesh::open(large);
  for (const SurfaceCurve& curve : curves) {
    const Scale scale = scale_of(mesh, curve);
    const SurfaceCurve finer = with_middles(surface, curve);
    EXPECT_EQ(finer.points.size(), 2 * curve.points.size() - (curve.closed ? 0 : 1));
    expect_same(scale, scale_of(mesh, finer));
    expect_same(scale, scale_of(mesh, with_middles(surface, finer)));
    expect_same(scale, scale_of(larger, curve), 1e5);
    SurfaceCurve reversed = curve;
    std::reverse(reversed.points.begin(), reversed.points.end());
    expect_same(scale, scale_of(mesh, reversed));
  }
  for (std::size_t shift = 1; shift < curves[1].points.size(); ++shift) {
    SurfaceCurve shifted = curves[1];
    std::rotate(shifted.points.begin(), shifted.points.begin() + static_cast<std::ptrdiff_t>(shift),
                shifted.points.end());
    expect_same(scale_of(mesh, curves[1]), scale_of(mesh, shifted));
  }
}

TEST_F(CorridorScale, LongStraightRunsDoNotMakeItLarge) {
  // Twelve teeth between two runs of 24.
  std::vector<double> heights(kColumns + 1, 0);
  for (std::size_t i = 25; i < 37; i += 2) heights[i] = 0.5;
  EXPECT_NEAR(default_slack(surface, over_row(surface, heights)), 0.7 * std::hypot(1, 0.5), 1e-9);
  // Where there is nothing else it is bounded by the length.
  const SurfaceCurve row = over_row(surface, std::vector<double>(kColumns + 1, 0));
  EXPECT_NEAR(default_slack(surface, row), kColumns / 24.0, 1e-9);
}

TEST_F(CorridorScale, TwoPointsAndOne) {
  const SurfaceCurve two = test::vertex_curve(surface, std::vector{at(4, 4), at(5, 4)}, false);
  EXPECT_NEAR(default_slack(surface, two), 1 / 24.0, kTiny);
  EXPECT_NEAR(corridor_length(mesh, two), 0.5 / 4, kTiny);
  const SurfaceCurve one = test::vertex_curve(surface, std::vector{at(4, 4)}, false);
  EXPECT_EQ(default_slack(surface, one), 0);
  EXPECT_EQ(corridor_length(mesh, one), 0);
  EXPECT_EQ(width_of_loop(mesh, one), 0);
}

TEST_F(CorridorScale, RefusesACurveThatLeavesTheMesh) {
  const SurfaceCurve apart = test::vertex_curve(surface, std::vector{at(4, 4), at(9, 4)}, false);
  EXPECT_THROW(default_slack(surface, apart), Error);
}

TEST_F(CorridorScale, AFieldOfSlackIsLinearInEachFace) {
  std::vector<double> field;
  for (const Point& p : mesh.points()) field.push_back(1 + 0.25 * p.x() + 0.5 * p.y());
  std::vector<double> heights(kColumns + 1, 0);
  for (std::size_t i = 1; i < heights.size(); i += 2) heights[i] = 0.3;
  const SurfaceCurve curve = over_row(surface, heights);
  const std::vector<double> along = slack_along(surface, curve, field);
  ASSERT_EQ(along.size(), curve.points.size());
  for (std::size_t i = 0; i < along.size(); ++i) {
    const Point p = mesh.position(curve.points[i]);
    EXPECT_NEAR(along[i], 1 + 0.25 * p.x() + 0.5 * p.y(), 1e-12);
  }
}

TEST_F(CorridorScale, AFieldOfSlackMustFitTheMesh) {
  const SurfaceCurve curve = test::vertex_curve(surface, std::vector{at(4, 4), at(5, 4)}, false);
  const auto message = [&](const std::vector<double>& field) -> std::string {
    try {
      slack_along(surface, curve, field);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadUsage);
      return error.what();
    }
    return "";
  };
  std::vector<double> field(surface.vertex_count(), 1);
  EXPECT_EQ(message(field), "");
  EXPECT_EQ(message({1, 2}), "There are 2 slacks for 1281 vertices.");
  // What the curve does not touch is not looked at.
  field[at(20, 20).index()] = std::nan("");
  EXPECT_EQ(message(field), "");
  for (const double bad : {-1.0, HUGE_VAL, std::nan("")}) {
    field[at(5, 4).index()] = bad;
    EXPECT_EQ(message(field), "The slack of vertex 249 must be finite and >= 0.");
  }
}

/// A smooth drawing turns nowhere by much, however finely it is given; it does in all.
TEST_F(CorridorScale, SlackOfASmoothDrawingFollowsItsBends) {
  for (const std::uint32_t count :
       {10U, 60U}) {  // squares: also where it is not along edges at all
    MeshLists lists = grid(count, count);
    for (Point& p : lists.points) p *= 10.0 / count;
    const SurfaceMesh sheet = SurfaceMesh::open(lists);
    for (const int points : {200, 1000}) {
      std::vector<Point> circle;
      for (int k = 0; k < points; ++k) {
        const double angle = 2 * std::numbers::pi * k / points;
        circle.emplace_back(5.1 + 3 * std::cos(angle), 5.2 + 3 * std::sin(angle), 0);
      }
      const SurfaceCurve drawn =
          StraightLines(sheet.surface()).join(snap(sheet, {true, circle, {}}).points, true);
      // 0.7 of stretches that turn by 0.1, or one segment more, times that; the cap is 0.26 radii
      EXPECT_GT(default_slack(sheet.surface(), drawn), 0.0069 * 3) << points;
      EXPECT_LT(default_slack(sheet.surface(), drawn), 0.012 * 3) << points;
    }
  }
}

}  // namespace
}  // namespace talweg
