// A drawing that runs back over itself may miss what it was to pass, and then says so.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg {
namespace {

class MissedPoints : public testing::Test {
 protected:
  static constexpr std::uint32_t columns = 31;
  [[nodiscard]] static VertexId at(std::uint32_t x, std::uint32_t y) {
    return VertexId{y * columns + x};
  }
  /// Along edges through vertices, all of them way-points.
  [[nodiscard]] SmoothingResult smooth_through(const std::vector<VertexId>& clicks) const {
    const Surface& surface = opened->mesh().surface();
    CurveOptions options;
    for (const VertexId v : clicks) {
      options.way_points.push_back({SurfacePoint::at_vertex(surface, v)});
    }
    const SurfaceCurve drawn =
        test::vertex_curve(surface, draw_edge_path(surface, clicks, false), false);
    return smooth_curve(opened, drawn, {}, options);
  }
  [[nodiscard]] static std::vector<std::string> said(const SmoothingResult& result) {
    std::vector<std::string> said;
    std::ranges::copy_if(result.total.warnings, std::back_inserter(said), [](const auto& warning) {
      return warning.find("it was to pass") != std::string::npos;
    });
    return said;
  }
  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(30, 30));
};

TEST_F(MissedPoints, NothingIsSaidWhereAllArePassed) {
  EXPECT_TRUE(said(smooth_through({at(2, 2), at(10, 15), at(20, 8)})).empty());
}

TEST_F(MissedPoints, AWayBackOverItselfIsPassedOrSaid) {
  const std::vector<VertexId> clicks{at(2, 10), at(20, 10), at(5, 10), at(25, 20)};
  const SmoothingResult result = smooth_through(clicks);
  const auto& points = result.curve().points;
  const auto passes = [&](VertexId v) {
    const SurfacePoint point = SurfacePoint::at_vertex(opened->mesh().surface(), v);
    return std::ranges::find(points, point) != points.end();
  };
  const bool all = std::ranges::all_of(clicks, passes);
  const std::vector<std::string> warnings = said(result);
  ASSERT_EQ(warnings.size(), all ? 0 : 1);
  if (!all) {
    EXPECT_NE(warnings[0].find("misses "), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find("20, 10, 0"), std::string::npos) << warnings[0];  // the tip
  }
}

}  // namespace
}  // namespace talweg
