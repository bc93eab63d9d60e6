#include "talweg/core/drawing/curve_embedding.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"

namespace talweg {
namespace {

/// A point closer to a mesh edge than the tolerance falls on the edge. The next point of the curve
/// makes tiny faces there, so a second insertion of the point would give another vertex.
TEST(CurveEmbedding, APinIsTheVertexThatItsPointBecame) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(2, 2));
  const Surface& surface = mesh.surface();
  const auto above_diagonal = [&](double height) {
    return SurfacePoint::from_barycentric(surface, FaceId{0},
                                          {0.5 - height / 2, height, 0.5 - height / 2});
  };
  const SurfacePoint pin = above_diagonal(5e-11);
  const SurfaceCurve curve{false,
                           {above_diagonal(0.5), pin, above_diagonal(1e-6),
                            SurfacePoint::at_vertex(surface, VertexId{1})}};
  SignpostTriangulation triangulation(surface);
  const EmbeddedCurves embedded =
      embed_curves(triangulation, std::span(&curve, 1), std::span(&pin, 1));
  ASSERT_EQ(embedded.pinned.size(), 1U);
  const auto& way = embedded.paths.front().halfedges();
  EXPECT_EQ(
      std::count_if(way.begin(), way.end(),
                    [&](HalfedgeId h) { return triangulation.head(h) == embedded.pinned.front(); }),
      1);
}

}  // namespace
}  // namespace talweg
