// A front on one of two grids never reaches the other.
#include "talweg/intrinsic/exact_distance/curve_components.hpp"

#include <gtest/gtest.h>

#include "intrinsic/test_surfaces.hpp"

namespace talweg {
namespace {

TEST(CurveComponents, KeepTheFrontOutOfOtherComponents) {
  test::TestMesh mesh = test::grid(10, 10);
  const auto n = static_cast<std::uint32_t>(mesh.points.size());
  for (std::size_t i = 0, faces = mesh.triangles.size(); i < faces; ++i) {
    const Triangle t = mesh.triangles[i];
    mesh.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  for (std::size_t v = 0; v < n; ++v) mesh.points.push_back(mesh.points[v]);
  const Surface surface = test::surface_of(mesh);
  const VertexId here{n - 1}, there{2 * n - 1};
  WindowFront front(surface);
  CurveComponents components(surface);

  front.reset(0.25);
  front.start_at(VertexId{0}, {0, 0, 0});
  EXPECT_FALSE(components.keep_out(front, there));  // before the march
  while (!front.is_done() && !components.keep_out(front, there)) front.march();
  EXPECT_FALSE(front.is_done());
  EXPECT_FALSE(components.keep_out(front, here));

  front.reset(0.25);
  components.clear();
  front.start_at(there, {0, 0, 0});
  while (!front.is_done() && !components.keep_out(front, here)) front.march();
  EXPECT_FALSE(front.is_done());
  EXPECT_FALSE(components.keep_out(front, there));
}

}  // namespace
}  // namespace talweg
