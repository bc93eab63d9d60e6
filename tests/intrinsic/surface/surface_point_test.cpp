#include "talweg/intrinsic/surface/surface_point.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "intrinsic/test_surfaces.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using namespace test;

template <class Action>
void expect_refused(Action action) {
  try {
    action();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
  }
}

TEST(SurfacePoint, OnlyProperPointsCanBeBuilt) {
  const Surface s = surface_of(grid(2, 2));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { SurfacePoint::at_vertex(s, VertexId{9}); });
  expect_refused([&] { SurfacePoint::at_vertex(s, VertexId{}); });
  expect_refused([&] { SurfacePoint::on_edge(s, EdgeId{16}, 0.5); });
  for (const double t : {0.0, 1.0, -0.1, 1.1, nan}) {
    expect_refused([&] { SurfacePoint::on_edge(s, EdgeId{0}, t); });
  }
  expect_refused([&] { SurfacePoint::in_face(s, FaceId{8}, {0.2, 0.3, 0.5}); });
  expect_refused([&] { SurfacePoint::in_face(s, FaceId{0}, {0.0, 0.5, 0.5}); });
  expect_refused([&] { SurfacePoint::in_face(s, FaceId{0}, {-0.1, 0.6, 0.5}); });
  expect_refused([&] { SurfacePoint::in_face(s, FaceId{0}, {0.2, 0.2, 0.2}); });
  expect_refused([&] { SurfacePoint::in_face(s, FaceId{0}, {nan, 0.5, 0.5}); });
  EXPECT_TRUE(SurfacePoint::at_vertex(s, VertexId{8}).is_vertex());
  EXPECT_EQ(SurfacePoint::on_edge(s, EdgeId{3}, 0.25), SurfacePoint::on_edge(s, EdgeId{3}, 0.25));
  EXPECT_FALSE(SurfacePoint::on_edge(s, EdgeId{3}, 0.25) ==
               SurfacePoint::on_edge(s, EdgeId{3}, 0.5));
}

TEST(SurfacePoint, BarycentricsAreClassified) {
  const Surface s = surface_of(grid(2, 2));
  for (std::size_t f = 0; f < s.face_count(); ++f) {
    const FaceId face{f};
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<double, 3> b{};
      b[k] = 1;
      EXPECT_EQ(SurfacePoint::from_barycentric(s, face, b),
                SurfacePoint::at_vertex(s, s.corners(face)[k]));
      b[k] = 0.75;
      b[(k + 1) % 3] = 0.25;
      const SurfacePoint p = SurfacePoint::from_barycentric(s, face, b);
      const auto* e = std::get_if<OnEdge>(&p.where());
      ASSERT_NE(e, nullptr);
      EXPECT_EQ(coordinates_in(s, p, face).barycentric, b);
    }
    const std::array<double, 3> inside = {0.5, 0.125, 0.375};
    EXPECT_EQ(SurfacePoint::from_barycentric(s, face, inside),
              SurfacePoint::in_face(s, face, inside));
  }
}

TEST(SurfacePoint, BarycentricsWithinToleranceCountAsZero) {
  const Surface s = surface_of(grid(1, 1));
  const FaceId f{0};
  EXPECT_TRUE(SurfacePoint::from_barycentric(s, f, {1 + 1e-13, -1e-13, 0}).is_vertex());
  const SurfacePoint edge = SurfacePoint::from_barycentric(s, f, {0.5, 0.5, 5e-13});
  EXPECT_TRUE(std::holds_alternative<OnEdge>(edge.where()));
  const SurfacePoint inner = SurfacePoint::from_barycentric(s, f, {0.5, 0.5 - 1e-9, 1e-9});
  EXPECT_TRUE(std::holds_alternative<InFace>(inner.where()));
  EXPECT_TRUE(SurfacePoint::from_barycentric(s, f, {0.98, 0.01, 0.01}, 0.05).is_vertex());
  // Coordinates below the rounding of 1, with a tolerance of 0.
  EXPECT_NO_THROW(SurfacePoint::from_barycentric(s, f, {1, 1e-20, 1e-20}, 0));
  EXPECT_NO_THROW(SurfacePoint::from_barycentric(s, f, {1, 1e-20, 0}, 0));
  expect_refused([&] { SurfacePoint::from_barycentric(s, f, {0.5, 0.6, -0.1}); });
  expect_refused([&] { SurfacePoint::from_barycentric(s, f, {0.5, 0.5, 0.5}); });
  expect_refused([&] { SurfacePoint::from_barycentric(s, f, {0, 0, 0}); });
  expect_refused([&] { SurfacePoint::from_barycentric(s, FaceId{2}, {1, 0, 0}); });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { SurfacePoint::from_barycentric(s, f, {nan, 0.5, 0.5}); });
}

TEST(SurfacePoint, FacesAndCommonFaces) {
  const Surface s = surface_of(grid(2, 2));
  const SurfacePoint middle = SurfacePoint::at_vertex(s, VertexId{4});
  EXPECT_EQ(faces_at(s, middle).size(), 6U);
  EXPECT_EQ(faces_at(s, SurfacePoint::at_vertex(s, VertexId{2})).size(), 1U);
  const EdgeId diagonal = edge_of(s.find_halfedge(VertexId{0}, VertexId{4}));
  const SurfacePoint on = SurfacePoint::on_edge(s, diagonal, 0.5);
  EXPECT_EQ(faces_at(s, on), (std::vector<FaceId>{FaceId{0}, FaceId{1}}));
  EXPECT_EQ(common_face(s, middle, on), FaceId{0});
  EXPECT_EQ(any_face(s, middle), FaceId{0});
  const SurfacePoint far = SurfacePoint::in_face(s, FaceId{7}, {0.2, 0.3, 0.5});
  EXPECT_FALSE(common_face(s, on, far).valid());
  EXPECT_EQ(common_face(s, middle, far), FaceId{7});
  expect_refused([&] { coordinates_in(s, on, FaceId{5}); });
  expect_refused([&] { coordinates_in(s, far, FaceId{0}); });
  const Surface lonely = Surface::from_triangles(4, std::vector<Triangle>{{0, 1, 2}});
  EXPECT_TRUE(faces_at(lonely, SurfacePoint::at_vertex(lonely, VertexId{3})).empty());
  EXPECT_FALSE(any_face(lonely, SurfacePoint::at_vertex(lonely, VertexId{3})).valid());
}

TEST(SurfacePoint, EdgeParameterRunsAlongItsHalfedgeInBothFaces) {
  const TestMesh mesh = grid(2, 2, 0.2);
  const Surface s = surface_of(mesh);
  for (std::size_t e = 0; e < s.edge_count(); ++e) {
    const SurfacePoint p = SurfacePoint::on_edge(s, EdgeId{e}, 0.3);
    const Point& a = mesh.points[s.tail(halfedge_of(EdgeId{e})).index()];
    const Point& b = mesh.points[s.head(halfedge_of(EdgeId{e})).index()];
    for (const FaceId f : faces_at(s, p)) {
      const auto weights = coordinates_in(s, p, f).barycentric;
      const auto corners = s.corners(f);
      for (std::size_t x = 0; x < 3; ++x) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += weights[k] * mesh.points[corners[k].index()][x];
        EXPECT_NEAR(sum, 0.7 * a[x] + 0.3 * b[x], 1e-15);
      }
    }
  }
}

TEST(SurfacePoint, DistanceInFaceIsEuclidean) {
  const TestMesh mesh = grid(3, 3, 0.2);
  const Surface s = surface_of(mesh);
  Random random(3);
  for (int k = 0; k < 1000; ++k) {
    const FaceId f{random.below(s.face_count())};
    FaceCoordinates c[2] = {{f, {}}, {f, {}}};
    Point p[2] = {};
    for (int i = 0; i < 2; ++i) {
      const double u = random.uniform(), v = random.uniform(0, 1 - u);
      c[i].barycentric = {u, v, 1 - u - v};
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t x = 0; x < 3; ++x) {
          p[i][x] += c[i].barycentric[j] * mesh.points[s.corners(f)[j].index()][x];
        }
      }
    }
    // d² is a sum of terms of size 1, each exact to a few ulp.
    const double d = distance(p[0], p[1]);
    EXPECT_NEAR(distance_in_face(s, c[0], c[1]) * distance_in_face(s, c[0], c[1]), d * d, 1e-14);
  }
}

TEST(SurfacePoint, PointsOfOneElementHaveItInCommon) {
  using Kind = SurfaceElement::Kind;
  const Surface s = surface_of(grid(2, 2));
  const SurfaceElement vertex = element_of(SurfacePoint::at_vertex(s, VertexId{3}));
  const SurfaceElement edge = element_of(SurfacePoint::on_edge(s, EdgeId{3}, 0.2));
  const SurfaceElement face = element_of(SurfacePoint::in_face(s, FaceId{3}, {0.2, 0.3, 0.5}));
  EXPECT_EQ(vertex, (SurfaceElement{Kind::kVertex, 3}));
  EXPECT_EQ(edge, (SurfaceElement{Kind::kEdge, 3}));
  EXPECT_EQ(face, (SurfaceElement{Kind::kFace, 3}));
  EXPECT_EQ(element_of(SurfacePoint::on_edge(s, EdgeId{3}, 0.7)), edge);
  EXPECT_EQ(element_of(SurfacePoint::in_face(s, FaceId{3}, {0.5, 0.3, 0.2})), face);
  EXPECT_LT(vertex, edge);
  EXPECT_LT(edge, face);
  EXPECT_LT(edge, element_of(SurfacePoint::on_edge(s, EdgeId{4}, 0.1)));
}

}  // namespace
}  // namespace talweg
