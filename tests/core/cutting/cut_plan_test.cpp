// A plan lists the changes of a cut; its cost does not grow with the rest of the mesh.
#include "talweg/core/cutting/cut_plan.hpp"

#include <string>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/core/cutting/vertex_origin.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

/// From the middle of the lower side over the diagonal into the second face of a square.
TEST(CutPlan, ByHand) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(1, 1));  // faces (0, 1, 3) and (0, 3, 2)
  const Surface& surface = mesh.surface();
  SurfaceCurve curve;
  curve.points = {between(surface, 0, 1, 0.5), between(surface, 0, 3, 0.5),
                  SurfacePoint::in_face(surface, FaceId{1}, {0.25, 0.25, 0.5})};
  const CutPlan plan = plan_cut(mesh, std::span(&curve, 1));
  EXPECT_EQ(plan.old_vertices, 4U);
  ASSERT_EQ(plan.points.size(), 3U);
  EXPECT_EQ(plan.points[2], Point(0.25, 0.75, 0));
  EXPECT_EQ(plan.faces, (std::vector<std::uint32_t>{0, 1}));
  ASSERT_EQ(plan.first.size(), 3U);
  EXPECT_EQ(plan.parts(0).size(), 3U);  // two points on its sides
  EXPECT_EQ(plan.parts(1).size(), 4U);  // one on a side, one inside
  ASSERT_EQ(plan.chains.size(), 1U);
  EXPECT_FALSE(plan.chains[0].closed);
  ASSERT_EQ(plan.chains[0].vertices.size(), 3U);
  const VertexOrigin first =
      origin_of(plan.vertex_from[plan.chains[0].vertices[0] - 4], mesh.surface());
  EXPECT_EQ(first.vertices[2], kNoVertex);
  EXPECT_EQ(first.weights[0], 0.5);
  EXPECT_EQ(first.weights[1], 0.5);
  EXPECT_EQ(first.vertices[0] + first.vertices[1], 1U);  // of vertices 0 and 1
}

TEST(CutPlan, OfACurveAlongEdgesHasOnlyAChain) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(2, 2));
  const SurfaceCurve curve = vertex_curve(mesh.surface(), ids({0, 1, 2}), false);
  const CutPlan plan = plan_cut(mesh, std::span(&curve, 1));
  EXPECT_TRUE(plan.points.empty());
  EXPECT_TRUE(plan.faces.empty());
  EXPECT_TRUE(plan.triangles.empty());
  EXPECT_EQ(plan.chains.at(0).vertices, (std::vector<std::uint32_t>{0, 1, 2}));
}

class CutPlanResolution : public testing::Test {
 protected:
  /// Numbers and distances of merged points, in squares of side 10.
  CutPlan plan(const SurfacePoint& point, double resolution) {
    SurfaceCurve curve;
    curve.points = {point};
    return plan_cut(mesh, std::span(&curve, 1), {.resolution = resolution});
  }
  SurfaceMesh mesh = [] {
    MeshLists lists = grid(2, 2);
    for (Point& p : lists.points) p *= 10;
    return SurfaceMesh::open(lists);
  }();
};

TEST_F(CutPlanResolution, IsADistanceAlongEdges) {
  const SurfacePoint at = between(mesh.surface(), 0, 1, 0.01);  // 0.1 away
  EXPECT_EQ(plan(at, 0.09).points.size(), 1U);
  const CutPlan merged = plan(at, 0.11);
  EXPECT_TRUE(merged.points.empty());
  EXPECT_EQ(merged.merged, 1U);
  EXPECT_NEAR(merged.largest_move, 0.1, 1e-12);
  EXPECT_EQ(merged.chains[0].vertices, std::vector<std::uint32_t>{0});
}

TEST_F(CutPlanResolution, IsADistanceInFaces) {
  // In the face (0, 1, 4), 0.1 above its lower side.
  const SurfacePoint at = SurfacePoint::in_face(mesh.surface(), FaceId{0}, {0.5, 0.49, 0.01});
  EXPECT_TRUE(std::holds_alternative<InFace>(plan(at, 0.09).vertex_from.at(0).where()));
  EXPECT_TRUE(std::holds_alternative<OnEdge>(plan(at, 0.11).vertex_from.at(0).where()));
  EXPECT_TRUE(plan(at, 100).points.empty());  // no edge is as long
}

TEST_F(CutPlanResolution, MergesPointsOfAFace) {
  SurfaceCurve curve;
  const Surface& surface = mesh.surface();
  curve.points = {SurfacePoint::in_face(surface, FaceId{0}, {0.5, 0.25, 0.25}),
                  SurfacePoint::in_face(surface, FaceId{0}, {0.49, 0.26, 0.25})};  // 0.1 apart
  EXPECT_EQ(plan_cut(mesh, std::span(&curve, 1), {.resolution = 0.09}).points.size(), 2U);
  EXPECT_EQ(plan_cut(mesh, std::span(&curve, 1), {.resolution = 0.11}).points.size(), 1U);
}

TEST(CutPlanRefuses, ElementsOfAnotherMesh) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(1, 1)), other = SurfaceMesh::open(grid(9, 9));
  for (const SurfacePoint& point :
       {SurfacePoint::at_vertex(other.surface(), VertexId{4}),
        SurfacePoint::on_edge(other.surface(), EdgeId{5}, 0.5),
        SurfacePoint::in_face(other.surface(), FaceId{2}, {0.25, 0.25, 0.5})}) {
    SurfaceCurve curve;
    curve.points = {SurfacePoint::at_vertex(mesh.surface(), VertexId{0}), point};
    try {
      plan_cut(mesh, std::span(&curve, 1));
      ADD_FAILURE() << "not refused";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
      EXPECT_STREQ(error.what(),
                   "Point 1 of curve 0 is not on this mesh: the curve belongs to another mesh.");
    }
  }
  EXPECT_THROW(plan_cut(mesh, {}, {.resolution = -1}), Error);
  EXPECT_THROW(plan_cut(mesh, {}, {.resolution = HUGE_VAL}), Error);
}

}  // namespace
}  // namespace talweg::test
