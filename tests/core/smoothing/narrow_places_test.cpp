// A curve with a narrow slack at a spike is fair there, too.
#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kNarrowColumns = 60;
constexpr double kNarrowDegree = std::numbers::pi / 180;

/// A drawing that trembles, with a spike whose slack is far below an edge.
class NarrowPlacesTest : public testing::Test {
 protected:
  using Way = std::vector<std::array<std::uint32_t, 2>>;
  struct Drawing {
    SurfaceCurve curve;
    SmoothingOptions options;
  };

  [[nodiscard]] Drawing through(const Way& corners, bool closed = false) const {
    std::vector<VertexId> way;
    for (const auto& [i, j] : corners) way.emplace_back(j * (kNarrowColumns + 1) + i);
    Drawing drawing{test::vertex_curve(surface, draw_edge_path(surface, way, closed), closed), {}};
    std::vector<double>& slack = drawing.options.slack_at.emplace_back();
    for (const SurfacePoint& point : drawing.curve.points) {
      slack.push_back(is_narrow(mesh.position(point)) ? 0.05 : 2);
    }
    return drawing;
  }
  [[nodiscard]] static bool is_narrow(const Point& at) {
    return at.x() > 27 && at.x() < 35 && at.y() > 13;
  }
  /// A trembling way from left to right, through `middle`.
  [[nodiscard]] static Way trembling(const Way& middle) {
    Way way;
    for (std::uint32_t k = 2; k <= 26; k += 2) way.push_back({k, 14 + k / 2 % 2});
    way.insert(way.end(), middle.begin(), middle.end());
    for (std::uint32_t k = 36; k <= 58; k += 2) way.push_back({k, 14 + k / 2 % 2});
    return way;
  }
  [[nodiscard]] SmoothingResult smoothed(const Drawing& drawing) const {
    CurveSmoother smoother(opened);
    smoother.set_curve(drawing.curve);
    return smoother.smooth(drawing.options);
  }
  [[nodiscard]] std::vector<SurfacePoint> kinks(const SurfaceCurve& curve) const {
    std::vector<SurfacePoint> kinks;
    const std::size_t n = curve.points.size();
    for (std::size_t i = curve.closed ? 0 : 1; i + (curve.closed ? 0 : 1) < n; ++i) {
      const double turn = turning_angle(surface, curve.points[(i + n - 1) % n], curve.points[i],
                                        curve.points[(i + 1) % n]);
      if (turn > 5 * kNarrowDegree) kinks.push_back(curve.points[i]);
    }
    return kinks;
  }
  /// The result is within its walls, and fair except at the narrow spike.
  void expect_fair(const Drawing& drawing) const {
    const SmoothingResult result = smoothed(drawing);
    for (const std::string& warning : result.report().warnings) {
      EXPECT_EQ(warning.find("is taut"), std::string::npos) << warning;
    }
    EXPECT_EQ(kinks(result.curve()).size(), 0U);
    EXPECT_LT(result.report().after.bending, 0.2 * result.report().before.bending);
    PolylineDistance distance(surface);
    distance.set(std::span(&drawing.curve, 1));
    for (const SurfacePoint& point : result.curve().points) {
      const Point at = mesh.position(point);
      const bool narrow = at.x() > 28 && at.x() < 34 && at.y() > 16;
      const double slack = narrow ? opened->mesh().mean_edge_length() / 8 : 2;
      EXPECT_LE(distance.at(point).distance, 1.5 * slack * (1 + 1e-9)) << at.transpose();
    }
  }

  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(kNarrowColumns, 30));
  const SurfaceMesh& mesh = opened->mesh();
  const Surface& surface = opened->surface();
  const Drawing spike = through(trembling({{29, 24}, {30, 24}}));
};

TEST_F(NarrowPlacesTest, ASpikeIsFair) { expect_fair(spike); }

TEST_F(NarrowPlacesTest, OfALoopToo) {
  Way way = trembling({{29, 24}, {30, 24}});
  way.push_back({54, 7});
  way.push_back({6, 7});
  expect_fair(through(way, true));
}

TEST_F(NarrowPlacesTest, TwoSpikesBesideEachOther) {
  expect_fair(through(trembling({{28, 20}, {29, 15}, {30, 15}, {32, 24}, {33, 24}})));
}

TEST_F(NarrowPlacesTest, IsTheSameEachTimeAndFromTheOtherEnd) {
  const SmoothingResult first = smoothed(spike);
  EXPECT_EQ(first.curve().points, smoothed(spike).curve().points);
  Drawing reversed = spike;
  std::ranges::reverse(reversed.curve.points);
  std::ranges::reverse(reversed.options.slack_at[0]);
  std::vector<SurfacePoint> points = smoothed(reversed).curve().points;
  std::ranges::reverse(points);
  EXPECT_EQ(first.curve().points, points);
}

}  // namespace
}  // namespace talweg
