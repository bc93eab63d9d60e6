#include "talweg/core/openmesh/openmesh_adaptor.hpp"

#include <OpenMesh/Core/Mesh/Traits.hh>
#include <gtest/gtest.h>

#include "core/openmesh_meshes.hpp"

namespace talweg::test {
namespace {

TEST(OpenMeshAdaptor, DoublePointsFloatNormals) {
  const MeshLists lists = sphere(2);
  const MeshLists back = lists_of(openmesh_of<DoubleMesh>(lists));
  EXPECT_EQ(back.points, lists.points);
  EXPECT_EQ(back.triangles, lists.triangles);
  EXPECT_FALSE(back.single_precision);
}

TEST(OpenMeshAdaptor, FloatPoints) {
  const MeshLists lists = sphere(2);
  const MeshLists back = lists_of(openmesh_of<FloatMesh>(lists));
  ASSERT_EQ(back.points.size(), lists.points.size());
  for (std::size_t v = 0; v < lists.points.size(); ++v) {
    EXPECT_EQ(back.points[v], lists.points[v].cast<float>().cast<double>());
  }
  EXPECT_EQ(back.triangles, lists.triangles);
  EXPECT_TRUE(back.single_precision);
}

TEST(OpenMeshAdaptor, DeletedElementsAreSkipped) {
  FloatMesh mesh = openmesh_of<FloatMesh>(grid(3, 2));
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_halfedge_status();
  mesh.request_face_status();
  // The corner vertex 3 lies only in face 4 (2, 3, 7).
  mesh.delete_vertex(mesh.vertex_handle(3));
  OpenMeshIds ids;
  const SurfaceMesh opened = surface_of(mesh, &ids);
  EXPECT_EQ(opened.surface().vertex_count(), 11U);
  EXPECT_EQ(opened.surface().face_count(), 11U);
  EXPECT_FALSE(ids.id(mesh.vertex_handle(3)).valid());
  EXPECT_FALSE(ids.id(mesh.face_handle(4)).valid());
  for (unsigned v = 0; v < 12; ++v) {
    if (v == 3) continue;
    const VertexId id = ids.id(mesh.vertex_handle(v));
    EXPECT_EQ(id.index(), v < 3 ? v : v - 1);
    EXPECT_EQ(ids.handle(id), mesh.vertex_handle(v));
    EXPECT_EQ(opened.point(id).x(), static_cast<double>(mesh.point(mesh.vertex_handle(v))[0]));
  }
  for (unsigned f = 0; f < 12; ++f) {
    if (f == 4) continue;
    EXPECT_EQ(ids.handle(ids.id(mesh.face_handle(f))), mesh.face_handle(f));
  }
}

TEST(OpenMeshAdaptor, LaterEditsChangeNothing) {
  DoubleMesh mesh = openmesh_of<DoubleMesh>(grid(1, 1));
  const SurfaceMesh opened = surface_of(mesh);
  mesh.set_point(mesh.vertex_handle(0), OpenMesh::Vec3d(9, 9, 9));
  EXPECT_EQ(opened.point(VertexId{0}), Point(0, 0, 0));
}

TEST(OpenMeshAdaptor, ChecksApply) { EXPECT_THROW(surface_of(FloatMesh()), Error); }

}  // namespace
}  // namespace talweg::test
