// Results for meshes at the smallest and largest supported scales equal those at scale 1.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "talweg/talweg.hpp"

namespace talweg::test {
namespace {

/// Positions of a smoothed drawing across hills, and of the mesh cut along it, divided by the unit.
struct Scaled {
  std::vector<Point> smoothed, cut;
  double curvature = 0;
};

Scaled at_scale(double unit, Method method) {
  MeshLists lists = hills(40);
  for (Point& p : lists.points) p *= unit;
  const auto opened = OpenedMesh::open(lists);
  CurveSmoother smoother(opened);
  CurveOptions options;
  options.method = method;
  smoother.set_curve(wave_on_hills(opened->mesh()), options);
  const SmoothingResult result =
      method == Method::kCorridor ? smooth_within(smoother, 2 * opened->mesh().mean_edge_length())
                                  : smoother.smooth(1);
  Scaled scaled;
  scaled.curvature = result.total.after.total_curvature;
  scaled.smoothed = positions_of(opened->mesh(), result.curve());
  scaled.cut = cut_along(opened->mesh(), result.curves).lists.points;
  for (std::vector<Point>* points : {&scaled.smoothed, &scaled.cut}) {
    for (Point& p : *points) p /= unit;
  }
  return scaled;
}

TEST(ScaleLimits, ResultsAreThoseOfTheMeshInItsOwnUnit) {
  const double size = 100;  // larger than the hills
  for (const Method method : {Method::kCorridor, Method::kPaper}) {
    const Scaled expected = at_scale(1, method);
    ASSERT_GT(expected.smoothed.size(), 10U);
    for (const double unit : {1e-40, 1e40 / size}) {
      // A power of two, so that the mesh itself is not rounded.
      const Scaled found =
          at_scale(std::exp2(std::floor(std::log2(unit))) * (unit < 1 ? 2 : 1), method);
      EXPECT_NEAR(found.curvature, expected.curvature, 1e-9);
      ASSERT_EQ(found.smoothed.size(), expected.smoothed.size()) << unit;
      ASSERT_EQ(found.cut.size(), expected.cut.size()) << unit;
      for (std::size_t i = 0; i < found.smoothed.size(); ++i) {
        EXPECT_LT((found.smoothed[i] - expected.smoothed[i]).norm(), 1e-9 * size) << unit;
      }
      for (std::size_t i = 0; i < found.cut.size(); ++i) {
        EXPECT_LT((found.cut[i] - expected.cut[i]).norm(), 1e-9 * size) << unit;
      }
    }
  }
}

}  // namespace
}  // namespace talweg::test
