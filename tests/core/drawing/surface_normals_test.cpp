// Normals of a cube's corner, edge and face.
#include "talweg/core/drawing/surface_normals.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "talweg/talweg.hpp"

namespace talweg {
namespace {

/// Three sides of the unit cube around corner 0, facing outwards; each has a diagonal from the
/// corner.
MeshLists corner() {
  MeshLists lists;
  lists.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};
  lists.triangles = {{0, 4, 1}, {0, 2, 4}, {0, 5, 2}, {0, 3, 5}, {0, 6, 3}, {0, 1, 6}};
  return lists;
}

TEST(SurfaceNormals, AreThoseOfFacesEdgesAndAnglesOfACorner) {
  const SurfaceMesh mesh = SurfaceMesh::open(corner());
  const Surface& surface = mesh.surface();
  const Point down = normal_at(mesh, SurfacePoint::in_face(surface, FaceId{0U}, {0.2, 0.3, 0.5}));
  EXPECT_LT((down - Point(0, 0, -1)).norm(), 1e-15);
  const HalfedgeId h = surface.find_halfedge(VertexId{0U}, VertexId{2U});
  const Point edge = normal_at(mesh, SurfacePoint::on_edge(surface, edge_of(h), 0.5));
  EXPECT_LT((edge - Point(-1, 0, -1) / std::sqrt(2.0)).norm(), 1e-15);
  // The corner has six faces with angles of 45 degrees.
  const Point at = normal_at(mesh, SurfacePoint::at_vertex(surface, VertexId{0U}));
  EXPECT_LT((at - Point(-1, -1, -1) / std::sqrt(3.0)).norm(), 1e-15);
}

TEST(SurfaceNormals, OfACurveAreOneForEachPoint) {
  const SurfaceMesh mesh = SurfaceMesh::open(corner());
  const Surface& surface = mesh.surface();
  PlacedCurve curve = place(mesh, {false,
                                   {SurfacePoint::at_vertex(surface, VertexId{1U}),
                                    SurfacePoint::at_vertex(surface, VertexId{4U})}});
  set_normals(mesh, curve);
  ASSERT_EQ(curve.normals.size(), 2U);
  EXPECT_LT((curve.normals[1] - Point(0, 0, -1)).norm(), 1e-15);
}

}  // namespace
}  // namespace talweg
