#include "talweg/intrinsic/flips/flat_flips.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/flips/point_insertion.hpp"

namespace talweg {
namespace {

using namespace test;

/// Points alternating between two sides of face 0, as vertices joined in this order.
struct Zigzag {
  SignpostTriangulation triangulation;
  std::vector<HalfedgeId> path;

  Zigzag(const Surface& surface, std::size_t n) : triangulation(surface) {
    PointInsertion insertion(triangulation);
    std::vector<VertexId> vertices;
    for (std::size_t i = 0; i < n; ++i) {
      const double b = 0.1 + 0.4 * static_cast<double>(i) / static_cast<double>(n);
      const double c = i % 2 == 0 ? 0.1 : 0.4;
      vertices.push_back(
          insertion.insert(SurfacePoint::in_face(surface, FaceId{0}, {1 - b - c, b, c})));
    }
    for (std::size_t i = 0; i + 1 < n; ++i) insertion.connect(vertices[i], vertices[i + 1], path);
  }
};

TEST(FlatFlips, SegmentsThatCrossNoOtherNeedNoFurtherVertices) {
  const Surface surface = surface_of(grid(1, 1));
  constexpr std::size_t kPoints = 300;
  const Zigzag zigzag(surface, kPoints);
  EXPECT_EQ(zigzag.triangulation.inserted_count(), kPoints);
  EXPECT_EQ(zigzag.path.size(), kPoints - 1);
}

TEST(FlatFlips, TurnedEdgesHaveTheLengthBetweenTheirEnds) {
  const TestMesh mesh = grid(1, 1);
  const Surface surface = surface_of(mesh);
  const Zigzag zigzag(surface, 300);
  const SignpostTriangulation& t = zigzag.triangulation;
  const auto where = [&](HalfedgeId h) {
    return position(surface, mesh.points, t.location(t.tail(h)));
  };
  double area = 0;
  for (std::size_t i = 0; i < 2 * t.edge_count(); ++i) {
    const HalfedgeId h{i};
    EXPECT_NEAR(t.surface_length(edge_of(h)), distance(where(h), where(twin(h))), 1e-14);
    if (!t.has_face(h)) continue;
    EXPECT_EQ(t.next(t.next(t.next(h))), h);
    EXPECT_EQ(t.surface_face(h), t.surface_face(t.next(h)));
    const Point a = where(h), b = where(t.next(h)), c = where(t.prev(h));
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    EXPECT_GT(twice, 0);
    area += twice / 6;  // each face is counted at its three sides
  }
  EXPECT_NEAR(area, 1, 1e-12);
  for (std::size_t v = 0; v < t.vertex_count(); ++v) {
    const HalfedgeId own = t.halfedge(VertexId{v});
    EXPECT_EQ(t.tail(own), VertexId{v});
  }
}

TEST(FlatFlips, LeaveNothingBehind) {
  const Surface surface = surface_of(grid(1, 1));
  Zigzag zigzag(surface, 300);
  SignpostTriangulation& t = zigzag.triangulation;
  t.remove_inserted();
  ASSERT_EQ(2 * t.edge_count(), surface.halfedge_count());
  for (std::size_t i = 0; i < surface.halfedge_count(); ++i) {
    const HalfedgeId h{i};
    EXPECT_EQ(t.has_face(h), surface.halfedges()[i].next.valid());
    EXPECT_EQ(t.next(h), surface.halfedges()[i].next);
    EXPECT_EQ(t.tail(h), surface.tail(h));
    EXPECT_EQ(t.length(h), surface.length(edge_of(h)));
  }
  for (std::size_t v = 0; v < surface.vertex_count(); ++v)
    EXPECT_EQ(t.halfedge(VertexId{v}), surface.halfedge(VertexId{v}));
}

}  // namespace
}  // namespace talweg
