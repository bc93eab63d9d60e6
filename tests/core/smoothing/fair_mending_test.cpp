
#include <algorithm>
#include <array>
#include <iterator>
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

constexpr std::uint32_t kMendedColumns = 60;
constexpr double kMendedDegree = std::numbers::pi / 180;

/// A drawing that trembles, with a spike whose slack is too narrow for anything but a kink.
class FairMendingTest : public testing::Test {
 protected:
  using Way = std::vector<std::array<std::uint32_t, 2>>;
  struct Drawing {
    SurfaceCurve curve;
    SmoothingOptions options;
  };

  [[nodiscard]] Drawing through(const Way& corners, bool closed = false) const {
    std::vector<VertexId> way;
    for (const auto& [i, j] : corners) way.emplace_back(j * (kMendedColumns + 1) + i);
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
  /// From left to right, along these in the middle.
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
  [[nodiscard]] SmoothingResult taut(Drawing drawing) const {
    drawing.options.finish = Finish::kTaut;
    return smoothed(drawing);
  }
  [[nodiscard]] std::vector<SurfacePoint> kinks(const SurfaceCurve& curve) const {
    std::vector<SurfacePoint> kinks;
    const std::size_t n = curve.points.size();
    for (std::size_t i = curve.closed ? 0 : 1; i + (curve.closed ? 0 : 1) < n; ++i) {
      const double turn = turning_angle(surface, curve.points[(i + n - 1) % n], curve.points[i],
                                        curve.points[(i + 1) % n]);
      if (turn > 5 * kMendedDegree) kinks.push_back(curve.points[i]);
    }
    return kinks;
  }
  /// The warning of what is left taut, if there is one.
  [[nodiscard]] static std::string warning(const SmoothingResult& result) {
    std::vector<std::string> found;
    std::ranges::copy_if(
        result.report().warnings, std::back_inserter(found),
        [](const std::string& text) { return text.find("left taut") != std::string::npos; });
    return found.size() == 1 ? found.front() : "";
  }
  /// Its kinks are in the spike, and lie on the taut curve; that one has others.
  void expect_only_a_stretch_taut(const Drawing& drawing) const {
    const SmoothingResult fair = smoothed(drawing), straight = taut(drawing);
    EXPECT_NE(warning(fair).find("a stretch of it ("), std::string::npos) << warning(fair);
    PolylineDistance distance(surface);
    distance.set(straight.curves);
    std::size_t on_taut = 0;
    for (const SurfacePoint& kink : kinks(fair.curve())) {
      const Point at = mesh.position(kink);
      EXPECT_TRUE(is_narrow(at)) << at.transpose();
      EXPECT_LE(distance.at(kink).distance, 1e-9) << at.transpose();
      ++on_taut;
    }
    EXPECT_GE(on_taut, 1U);
    EXPECT_GT(kinks(straight.curve()).size(), on_taut + 2);
    EXPECT_LT(fair.report().bending_after, 0.8 * straight.report().bending_after);
  }

  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(kMendedColumns, 30));
  const SurfaceMesh& mesh = opened->mesh();
  const Surface& surface = opened->surface();
  const Drawing spike = through(trembling({{29, 24}, {30, 24}}));
};

TEST_F(FairMendingTest, OnlyWhatCannotBeFairIsLeftTaut) { expect_only_a_stretch_taut(spike); }

TEST_F(FairMendingTest, OfALoopToo) {
  Way way = trembling({{29, 24}, {30, 24}});
  way.push_back({54, 7});
  way.push_back({6, 7});
  expect_only_a_stretch_taut(through(way, true));
}

TEST_F(FairMendingTest, TheWarningSaysHowManyHowMuchAndWhere) {
  const std::string one = warning(smoothed(spike));
  EXPECT_NE(one.find(" % of its length, around (29."), std::string::npos) << one;
  EXPECT_NE(one.find("is left taut."), std::string::npos) << one;
  const Drawing two = through(trembling({{28, 20}, {29, 15}, {30, 15}, {32, 24}, {33, 24}}));
  const std::string more = warning(smoothed(two));
  EXPECT_NE(more.find(" stretches of it ("), std::string::npos) << more;
  EXPECT_NE(more.find("are left taut."), std::string::npos) << more;
}

TEST_F(FairMendingTest, IsTheSameEachTimeAndFromTheOtherEnd) {
  const SmoothingResult first = smoothed(spike);
  EXPECT_EQ(first.curve().points, smoothed(spike).curve().points);
  Drawing reversed = spike;
  std::ranges::reverse(reversed.curve.points);
  std::ranges::reverse(reversed.options.slack_at[0]);
  const SmoothingResult back = smoothed(reversed);
  std::vector<SurfacePoint> points = back.curve().points;
  std::ranges::reverse(points);
  EXPECT_EQ(first.curve().points, points);
  EXPECT_EQ(warning(first), warning(back));
}

}  // namespace
}  // namespace talweg
