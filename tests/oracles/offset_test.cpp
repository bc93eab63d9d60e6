// The points of offsets against CGAL's exact distances.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/reference_data.hpp"
#include "exact_distance.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/offset/offset_curves.hpp"

namespace talweg {
namespace {

class OffsetOracle : public ::testing::TestWithParam<const char*> {};

TEST_P(OffsetOracle, PointsHaveTheDistance) {
  const auto reference = test::reference_curve(GetParam());
  if (!reference) GTEST_SKIP() << test::missing(GetParam());
  const MeshLists lists =
      test::read_reference_mesh(test::mesh_folder() / (std::string(GetParam()) + ".ply"));
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const Surface& surface = mesh.surface();
  // The curves are single points, so that both programs measure from the same set.
  test::ExactGeodesics exact(lists);
  std::vector<SurfaceCurve> points;
  for (std::size_t i = 0; i < reference->path.size(); i += 20) {
    exact.add_source(reference->path[i]);
    points.push_back({false, {SurfacePoint::at_vertex(surface, reference->path[i])}});
  }
  const double h = mesh.mean_edge_length();
  OffsetOptions options;
  options.distances = {2.3 * h, 7.1 * h, 20 * h};
  const OffsetResult result = offset_curves(mesh, points, options);
  ASSERT_GE(result.curves.size(), 3U);
  double worst = 0;
  std::size_t asked = 0;
  for (const OffsetCurve& made : result.curves) {
    for (std::size_t i = 0; i < made.curve.points.size(); i += 7) {
      const FaceId face = any_face(surface, made.curve.points[i]);
      const auto at = coordinates_in(surface, made.curve.points[i], face);
      const double found = exact.distance(face, surface.corners(face), at.barycentric);
      worst = std::max(worst, std::abs(found - made.distance));
      ++asked;
    }
  }
  std::printf("  %zu curves, %zu points, off by %.1e of an edge\n", result.curves.size(), asked,
              worst / h);
  EXPECT_LE(worst, 1e-8 * h);
}

INSTANTIATE_TEST_SUITE_P(All, OffsetOracle, ::testing::Values("fandisk_14k", "aneurysm_14k"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace talweg
