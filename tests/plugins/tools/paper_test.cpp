// The meshes and drawings of ./run paper and of the benchmarks have the stated properties.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "talweg/core/drawing/curve_embedding.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "tools/paper/ball.hpp"
#include "tools/paper/hand.hpp"
#include "tools/paper/refinement.hpp"

namespace talweg::paper {
namespace {

double area_vector_z(const MeshLists& mesh) {
  double z = 0;
  for (const Triangle& t : mesh.triangles) {
    const Point a = mesh.points[t[1]] - mesh.points[t[0]],
                b = mesh.points[t[2]] - mesh.points[t[0]];
    z += 0.5 * a.cross(b).z();
  }
  return z;
}

long euler_number(const Surface& surface) {
  return static_cast<long>(surface.vertex_count()) - static_cast<long>(surface.edge_count()) +
         static_cast<long>(surface.face_count());
}

TEST(PaperMeshes, ASphereHasTwentyFacesPerSquaredFrequency) {
  for (const std::uint32_t n : {1U, 2U, 3U, 7U}) {
    const MeshLists mesh = sphere(n);
    EXPECT_EQ(mesh.triangles.size(), 20U * n * n);
    EXPECT_EQ(mesh.points.size(), 10U * n * n + 2);  // by Euler's formula
    EXPECT_EQ(euler_number(SurfaceMesh::open(mesh).surface()), 2);
    for (const Point& p : mesh.points) EXPECT_NEAR(p.norm(), 1, 1e-15);
  }
}

TEST(PaperMeshes, TheSpheresFacesLookOutwards) {
  const MeshLists mesh = sphere(12);
  double volume = 0;
  for (const Triangle& t : mesh.triangles) {
    volume += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]])) / 6;
  }
  // The volume of an inscribed polyhedron is smaller than the ball's by O(edge²).
  EXPECT_LT(volume, 4 * std::numbers::pi / 3);
  EXPECT_GT(volume, 0.97 * 4 * std::numbers::pi / 3);
}

TEST(PaperMeshes, ABumpyBallIsASurfaceAndReproducible) {
  const MeshLists once = bumpy_ball(9, 4), again = bumpy_ball(9, 4), other = bumpy_ball(9, 5);
  EXPECT_EQ(euler_number(SurfaceMesh::open(once).surface()), 2);
  EXPECT_EQ(once.points, again.points);
  EXPECT_NE(once.points, other.points);
}

TEST(PaperMeshes, ADiscIsFlatAndFillsItsPolygon) {
  constexpr std::uint32_t kRings = 5;
  const MeshLists mesh = disc(kRings);
  EXPECT_EQ(mesh.triangles.size(), 6U * kRings * kRings);
  EXPECT_EQ(euler_number(SurfaceMesh::open(mesh).surface()), 1);
  constexpr double kCorners = 6 * kRings;
  EXPECT_NEAR(area_vector_z(mesh), kCorners / 2 * std::sin(2 * std::numbers::pi / kCorners), 1e-13);
}

TEST(PaperMeshes, RefiningKeepsSurfaceAreaAndTopology) {
  const MeshLists coarse = disc(6);
  const auto right = [](const Point& p) { return p.x() > 0; };
  const MeshLists fine = refined(refined(coarse, right), right);
  EXPECT_EQ(euler_number(SurfaceMesh::open(fine).surface()), 1);
  EXPECT_NEAR(area_vector_z(fine), area_vector_z(coarse), 1e-13);
  const MeshLists whole = refined(coarse, [](const Point&) { return true; });
  EXPECT_EQ(whole.triangles.size(), 4 * coarse.triangles.size());
  const MeshLists none = refined(coarse, [](const Point&) { return false; });
  EXPECT_EQ(none.triangles, coarse.triangles);
}

TEST(PaperDrawings, ATourHasTheRequestedLengthAndRunsAlongEdges) {
  const auto mesh = OpenedMesh::open(bumpy_ball(20, 1));
  const SurfaceCurve curve = tour(*mesh, 150, 3);
  EXPECT_FALSE(curve.closed);
  EXPECT_EQ(curve.points.size(), 150U);
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const VertexId a = std::get<AtVertex>(curve.points[i].where()).vertex;
    const VertexId b = std::get<AtVertex>(curve.points[i + 1].where()).vertex;
    EXPECT_TRUE(mesh->surface().find_halfedge(a, b).valid());
  }
  EXPECT_NO_THROW(check_drawn(mesh->surface(), curve));
}

TEST(PaperDrawings, APaintedLoopPassesThePlacesInTheirOrder) {
  const MeshLists lists = sphere(16);
  const auto mesh = OpenedMesh::open(lists);
  const std::vector<Point> places{lists.points[700], lists.points[40], lists.points[1200]};
  const SurfaceCurve curve = painted(*mesh, lists, places, true);
  EXPECT_TRUE(curve.closed);
  std::vector<std::size_t> met;
  for (const SurfacePoint& p : curve.points) {
    const std::size_t v = std::get<AtVertex>(p.where()).vertex.index();
    if (v == 700 || v == 40 || v == 1200) met.push_back(v);
  }
  EXPECT_EQ(met, (std::vector<std::size_t>{700, 40, 1200}));
}

}  // namespace
}  // namespace talweg::paper
