// Joints blocked by another path are examined again when that path has moved away.
#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/flips/flip_out.hpp"
#include "talweg/intrinsic/flips/trace.hpp"

namespace talweg {
namespace {

using namespace test;

/// A fan around vertex 0 with rim vertices at these angles (degrees) on the unit circle.
TestMesh fan_at(const std::vector<double>& degrees) {
  TestMesh mesh;
  mesh.points.push_back({0, 0, 0});
  for (const double d : degrees) {
    mesh.points.push_back({std::cos(d * kPi / 180), std::sin(d * kPi / 180), 0});
  }
  const auto n = static_cast<std::uint32_t>(degrees.size());
  for (std::uint32_t k = 0; k < n; ++k) mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % n});
  return mesh;
}

TEST(FlipOutRelease, JointAtTheOuterEndOfARemovedSpike) {
  // The first path runs straight over the centre (150° to 330°), with a detour from the centre
  // around the triangle between 10° and 20°. The second path bends at the centre by the wedge from
  // 0° to 30°. This wedge is the sharpest, so it is tried first and is blocked by the triangle. The
  // triangle then becomes a spike and vanishes. The joint of the spike is on the rim; the centre is
  // its outer end.
  const TestMesh mesh = fan_at({0, 10, 20, 30, 90, 150, 210, 270, 330});
  constexpr std::size_t kCentre = 0, k0 = 1, k10 = 2, k20 = 3, k30 = 4, k150 = 6, k330 = 9;
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  const std::vector<EdgePath> paths = {path_through(t, {k150, kCentre, k10, k20, kCentre, k330}),
                                       path_through(t, {k0, kCentre, k30})};
  const FlipOutResult result = FlipOut(t).run(paths, {});
  EXPECT_NEAR(result.paths[0].length_after, 2, 1e-12);
  EXPECT_NEAR(result.paths[1].length_after, 2 * std::sin(kPi / 12), 1e-12);
  EXPECT_EQ(result.blocked, 0U);
}

TEST(FlipOutRelease, BlockedAreExactlyTheJointsThatStayBent) {
  // Walks that share edges, with others and with themselves, release joints at both outer ends of a
  // wedge. A joint that ends straight but is counted as blocked was released without another
  // examination.
  Random random(4);
  std::size_t bent = 0;
  for (int k = 0; k < 20000; ++k) {
    const Surface s = random_complex(random, 1 + random.below(20), random.uniform(0, 0.3));
    SignpostTriangulation t(s);
    std::vector<EdgePath> paths;
    for (std::size_t i = 1 + random.below(6); i > 0; --i) {
      const auto walk = random_walk(t, random, 1 + random.below(10));
      if (!walk.empty()) paths.push_back(EdgePath::make(t, walk, false));
    }
    const FlipOutResult result = FlipOut(t).run(paths, {});
    std::size_t joints = 0;
    bool converged = true;  // a walk out and back may collapse
    for (const auto& path : result.paths) {
      converged = converged && path.termination == Termination::kConverged;
      for (const double angle : side_angles(t, path.path)) joints += angle < kPi - 1e-5 ? 1 : 0;
    }
    if (converged) {
      ASSERT_EQ(result.blocked, joints) << k;
      bent += joints;
    }
    while (t.flip_count() > 0) t.undo_flip();
  }
  EXPECT_GT(bent, 1000U);
}

}  // namespace
}  // namespace talweg
