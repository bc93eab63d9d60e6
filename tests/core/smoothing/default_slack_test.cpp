// The default slack of a curve is the width of its drawing's trembling.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg::slack_test {
namespace {

using test::grid;

constexpr std::uint32_t kColumns = 60;

constexpr double kTiny = 1e-12;  // relative: some hundred sums of lengths

VertexId at(std::uint32_t i, std::uint32_t j) { return VertexId{j * (kColumns + 1) + i}; }

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
    // The crossing with the diagonal from (i, 5) to (i + 1, 6).
    const double across = here / (1 - heights[i + 1] + here);
    if (across > 0) curve.points.push_back(test::between(surface, low, high + 1, across));
  }
  return curve;
}

double slack_of(const std::shared_ptr<const OpenedMesh>& opened, const SurfaceCurve& curve) {
  CurveSmoother smoother(opened);
  smoother.set_curve(curve);
  return smoother.slack()[0];
}

class DefaultSlack : public testing::Test {
 protected:
  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(kColumns, 20));
  const SurfaceMesh& mesh = opened->mesh();
  const Surface& surface = opened->surface();
};

TEST_F(DefaultSlack, OfASquareWaveIsSevenTenthsOfItsStep) {
  for (const std::uint32_t step : {1U, 2U, 3U}) {
    const SurfaceCurve wave = test::square_wave(surface, kColumns, step, step);
    EXPECT_NEAR(slack_of(opened, wave), 0.7 * step, kTiny) << step;
  }
  // There is one more run of 4 than steps of 2.
  EXPECT_NEAR(slack_of(opened, test::square_wave(surface, kColumns, 4, 2)), 0.7 * 4, kTiny);
}

TEST_F(DefaultSlack, OfAZigzagThroughFacesIsHalfItsWidth) {
  std::vector<double> heights(kColumns + 1, 0);
  for (std::size_t i = 1; i < heights.size(); i += 2) heights[i] = 0.5;
  const SurfaceCurve zigzag = over_row(surface, heights);
  EXPECT_NEAR(slack_of(opened, zigzag), 0.25, 0.04);  // to either side of its middle
}

TEST_F(DefaultSlack, IsAtLeastATenthOfAnEdge) {
  std::vector<double> heights(kColumns + 1, 0);
  for (std::size_t i = 1; i < heights.size(); i += 2) heights[i] = 0.04;  // turns by 0.08
  const double edge = (2 + std::numbers::sqrt2) / 3;
  EXPECT_NEAR(slack_of(opened, over_row(surface, heights)), 0.1 * edge, 0.01);
}

TEST_F(DefaultSlack, LongStraightRunsDoNotMakeItLarge) {
  // Twelve teeth between two runs of 24.
  std::vector<double> heights(kColumns + 1, 0);
  for (std::size_t i = 25; i < 37; i += 2) heights[i] = 0.5;
  EXPECT_NEAR(slack_of(opened, over_row(surface, heights)), 0.7 * std::hypot(1, 0.5), 1e-9);
  // A straight drawing has the slack of its length's bound.
  const SurfaceCurve row = over_row(surface, std::vector<double>(kColumns + 1, 0));
  EXPECT_NEAR(slack_of(opened, row), kColumns / 24.0, 1e-9);
}

TEST_F(DefaultSlack, RefusesACurveThatLeavesTheMesh) {
  const SurfaceCurve apart = test::vertex_curve(surface, std::vector{at(4, 4), at(9, 4)}, false);
  EXPECT_THROW(slack_of(opened, apart), Error);
}

TEST_F(DefaultSlack, AFieldOfSlackIsLinearInEachFace) {
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

TEST_F(DefaultSlack, AFieldOfSlackMustFitTheMesh) {
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
  // Values at vertices away from the curve are not checked.
  field[at(20, 20).index()] = std::nan("");
  EXPECT_EQ(message(field), "");
  for (const double bad : {-1.0, HUGE_VAL, std::nan("")}) {
    field[at(5, 4).index()] = bad;
    EXPECT_EQ(message(field), "The slack of vertex 249 must be finite and >= 0.");
  }
}

/// A smooth drawing has no trembling, at any density of points.
TEST_F(DefaultSlack, OfASmoothDrawingIsSmall) {
  for (const std::uint32_t count :
       {10U, 60U}) {  // squares: also for a drawing that is not along edges
    MeshLists lists = grid(count, count);
    for (Point& p : lists.points) p *= 10.0 / count;
    const auto opened = OpenedMesh::open(lists);
    const SurfaceMesh& sheet = opened->mesh();
    for (const int points : {200, 1000}) {
      std::vector<Point> circle;
      for (int k = 0; k < points; ++k) {
        const double angle = 2 * std::numbers::pi * k / points;
        circle.emplace_back(5.1 + 3 * std::cos(angle), 5.2 + 3 * std::sin(angle), 0);
      }
      const SurfaceCurve drawn =
          StraightLines(sheet.surface()).join(snap(sheet, {true, circle, {}}).points, true);
      const double edge = 10.0 / count * (2 + std::numbers::sqrt2) / 3;
      const double round = 2 * std::numbers::pi * 3;
      EXPECT_LE(slack_of(opened, drawn), 1.2 * std::min(0.1 * edge, round / 240)) << points;
    }
  }
}

}  // namespace
}  // namespace talweg::slack_test
