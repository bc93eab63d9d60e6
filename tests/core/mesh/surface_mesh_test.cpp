#include "talweg/core/mesh/surface_mesh.hpp"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

/// The sentence of the Error(kBadMesh) of opening; empty if the mesh opens.
std::string refusal_of(const MeshLists& lists) {
  try {
    SurfaceMesh::open(lists);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadMesh);
    return error.what();
  }
  return "";
}

TEST(SurfaceMesh, LengthsAndPositions) {
  const SurfaceMesh mesh = SurfaceMesh::open(box());
  const Surface& surface = mesh.surface();
  ASSERT_EQ(surface.edge_count(), 18U);
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    EXPECT_DOUBLE_EQ(surface.length(EdgeId{e}),
                     (mesh.point(surface.tail(h)) - mesh.point(surface.head(h))).norm());
  }
  EXPECT_NEAR(mesh.mean_edge_length(), (12 + 6 * std::sqrt(2.0)) / 18, 1e-14);
}

TEST(SurfaceMesh, PositionsOfAllKindsOfPoints) {
  MeshLists lists;
  lists.points = {Point(0, 0, 0), Point(4, 0, 0), Point(0, 8, 0)};
  lists.triangles = {{0, 1, 2}};
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const Surface& surface = mesh.surface();
  const SurfacePoint corner = SurfacePoint::at_vertex(surface, VertexId{1});
  const SurfacePoint side = between(surface, 2, 1, 0.25);
  const SurfacePoint inside = SurfacePoint::in_face(surface, FaceId{0}, {0.25, 0.25, 0.5});
  EXPECT_EQ(mesh.position(corner), Point(4, 0, 0));
  EXPECT_EQ(mesh.position(side), Point(1, 6, 0));
  EXPECT_EQ(mesh.position(inside), Point(1, 4, 0));
  const std::vector<Point> all = positions_of(mesh, {false, {corner, side, inside}});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[2], Point(1, 4, 0));
}

TEST(SurfaceMesh, OpensOddButSoundMeshes) {
  EXPECT_EQ(refusal_of(with_isolated_vertices(grid(3, 2), 5)), "");
  EXPECT_EQ(refusal_of(together(torus(6, 5), grid(2, 2), 10)), "");
  EXPECT_EQ(refusal_of(together(grid(2, 2), grid(2, 2), 0)), "");  // the same place twice
  EXPECT_EQ(refusal_of(with_zero_area_face(grid(3, 2), 0)), "");
  EXPECT_EQ(refusal_of(with_needle(grid(3, 2), 0, Point(0, -1e-9, 0))), "");
}

TEST(SurfaceMesh, RefusesWithTheDefectItsCountAndItsPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal_of({}), "The mesh has no vertices.");
  EXPECT_EQ(refusal_of({{Point(0, 0, 0)}, {}}), "The mesh has vertices but no faces.");
  EXPECT_EQ(refusal_of(with_index_out_of_range(grid(3, 2), 4)),
            "1 face refers to vertices that do not exist (face 4 to vertex 12 of 12).");
  EXPECT_EQ(refusal_of(with_coordinate(grid(3, 2), 7, nan)),
            "1 vertex has a coordinate that is not a finite number of at most 1e+40 (vertex 7).");
  EXPECT_EQ(refusal_of(with_coordinate(with_coordinate(grid(3, 2), 7, -inf), 9, inf)),
            "2 vertices have a coordinate that is not a finite number of at most 1e+40 (first: "
            "vertex 7).");
  EXPECT_EQ(refusal_of(with_repeated_vertex(grid(3, 2))), "1 face uses a vertex twice (face 12).");
  EXPECT_EQ(refusal_of(with_duplicate_face(grid(3, 2), 5, false)),
            "1 face repeats the vertices of another face (face 12 repeats face 5).");
  EXPECT_EQ(refusal_of(with_duplicate_face(grid(3, 2), 5, true)),
            "1 face repeats the vertices of another face (face 12 repeats face 5).");
  EXPECT_EQ(refusal_of(with_fin(sphere(0), 0)),
            "1 edge has more than two faces (between vertices 0 and 2, faces 0, 4 and 8).");
  EXPECT_EQ(
      refusal_of(with_turned_face(sphere(0), 0)),
      "3 edges join two faces of opposite orientation (first: between vertices 0 and 2, faces "
      "0 and 4).");
  EXPECT_EQ(refusal_of(with_bow_tie(grid(3, 2), 6)),
            "1 vertex joins surface parts that share no edge there (bow-tie) (vertex 6).");
  EXPECT_NE(refusal_of(moebius(9)), "");
}

TEST(SurfaceMesh, TwoFacesBackToBackAreNoSurface) {
  MeshLists pillow;
  pillow.points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)};
  pillow.triangles = {{0, 1, 2}, {2, 1, 0}};
  EXPECT_EQ(refusal_of(pillow),
            "1 face repeats the vertices of another face (face 1 repeats face 0).");
}

TEST(SurfaceMesh, TinyAndHugeUnits) {
  for (const double unit : {1e-40, 1e-8, 1e8, 1e40}) {
    MeshLists lists = sphere(1);
    for (Point& p : lists.points) p *= unit;
    EXPECT_NEAR(SurfaceMesh::open(lists).mean_edge_length() / unit,
                SurfaceMesh::open(sphere(1)).mean_edge_length(), 1e-14);
  }
}

TEST(SurfaceMesh, TooLargeOrTooSmallMeshesAreRefusedWithLimitAndFoundValue) {
  const auto scaled = [](double unit) {
    MeshLists lists = grid(10, 10);
    for (Point& p : lists.points) p *= unit;
    return lists;
  };
  // Large: the extent, or the way from the origin.
  EXPECT_EQ(refusal_of(scaled(1e39)), "");
  for (const MeshLists& lists : {scaled(1.1e39), scaled(1e75), scaled(1e80)}) {
    EXPECT_NE(refusal_of(lists).find("1e+40"), std::string::npos) << refusal_of(lists);
  }
  EXPECT_NE(refusal_of(scaled(3e79)).find("the largest is 3e+80"), std::string::npos);
  EXPECT_NE(
      refusal_of(with_coordinate(grid(3, 2), 7, -2e40)).find("vertex 7; the largest is 2e+40"),
      std::string::npos);
  // Small: as a whole, or an edge. Edges without length are handled.
  EXPECT_EQ(refusal_of(scaled(1e-41)), "");
  for (const MeshLists& lists : {scaled(5e-42), scaled(1e-75), scaled(1e-80), scaled(1e-200)}) {
    EXPECT_NE(refusal_of(lists).find("must be 1e-40 at least"), std::string::npos)
        << refusal_of(lists);
  }
  EXPECT_NE(refusal_of(scaled(1e-80)).find("1.41e-79 large"), std::string::npos);
  const auto with_edge = [](double length) {
    MeshLists lists = grid(3, 2);
    lists.points[1] = Point(length, 0, 0);  // beside vertex 0 at the origin
    return lists;
  };
  EXPECT_EQ(refusal_of(with_edge(0)), "");
  EXPECT_EQ(refusal_of(with_edge(1.4e-45)), "");  // the least of 32 bits
  EXPECT_EQ(refusal_of(with_edge(1e-59)), "");
  EXPECT_NE(refusal_of(with_edge(2e-61)).find("2e-61 long"), std::string::npos);
}

TEST(SurfaceMesh, LengthsThatOverflowAreRefused) {
  MeshLists lists = grid(1, 1);
  for (Point& p : lists.points) p = (p - Point(0.5, 0.5, 0)) * 1.5e308;
  EXPECT_NE(refusal_of(lists), "");
}

}  // namespace
}  // namespace talweg::test
