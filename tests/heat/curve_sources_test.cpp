#include "talweg/heat/curve_sources.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "heat/test_surfaces.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

class CurveSources : public testing::Test {
 protected:
  /// Vertices 0..3 along y = 0, 4..7 along y = 1, ...
  const Surface surface_ = test::grid(3, 3).surface();

  SurfacePoint at(std::size_t v) const { return SurfacePoint::at_vertex(surface_, VertexId{v}); }
  double weight(const std::vector<WeightedVertex>& sources, std::size_t v) const {
    for (const auto& source : sources) {
      if (source.vertex == VertexId{v}) return source.weight;
    }
    return 0;
  }
};

TEST_F(CurveSources, VertexPathGetsHalfLengths) {
  // 0 -> 1 -> 2 -> 6: lengths 1, 1, 1.
  const auto sources = curve_sources(surface_, {false, {at(0), at(1), at(2), at(6)}});
  const std::vector<WeightedVertex> expected = {
      {VertexId{0}, 0.5}, {VertexId{1}, 1.0}, {VertexId{2}, 1.0}, {VertexId{6}, 0.5}};
  EXPECT_EQ(sources, expected);
}

TEST_F(CurveSources, ClosedCurveCountsItsLastSegment) {
  const auto sources = curve_sources(surface_, {true, {at(0), at(1), at(5), at(4)}});
  ASSERT_EQ(sources.size(), 4u);
  for (const auto& source : sources) EXPECT_EQ(source.weight, 1.0);
}

TEST_F(CurveSources, SegmentAcrossAFaceSpreadsOverItsCorners) {
  // From the middle of edge 0-1 to the vertex opposite: λ of 0 and 1 fall from 1/2 to 0.
  const HalfedgeId h = surface_.find_halfedge(VertexId{0}, VertexId{1});
  const SurfacePoint middle = SurfacePoint::on_edge(surface_, edge_of(h), 0.5);
  const double length = std::hypot(0.5, 1.0);
  const auto sources = curve_sources(surface_, {false, {middle, at(5)}});
  EXPECT_NEAR(weight(sources, 0), length / 4, 1e-15);
  EXPECT_NEAR(weight(sources, 1), length / 4, 1e-15);
  EXPECT_NEAR(weight(sources, 5), length / 2, 1e-15);
}

TEST_F(CurveSources, WeightsSumToTheLengthWhereverPointsAreInserted) {
  const HalfedgeId h = surface_.find_halfedge(VertexId{5}, VertexId{6});
  const auto along = [&](double t) {
    return SurfacePoint::on_edge(surface_, edge_of(h), h == halfedge_of(edge_of(h)) ? t : 1 - t);
  };
  const auto coarse = curve_sources(surface_, {false, {at(5), at(6)}});
  const auto fine =
      curve_sources(surface_, {false, {at(5), along(0.1), along(0.15), along(0.9), at(6)}});
  for (const std::size_t v : {5, 6}) EXPECT_NEAR(weight(fine, v), weight(coarse, v), 1e-15);
}

TEST_F(CurveSources, TriangleCountsItsLastSegment) {
  // The shortest closed curve, around one face: the weight of a corner is half the sum of its two
  // sides.
  const auto corner = surface_.corners(FaceId{0});
  SurfaceCurve around{true, {}};
  for (const VertexId v : corner) around.points.push_back(SurfacePoint::at_vertex(surface_, v));
  const auto sources = curve_sources(surface_, around);
  const HalfedgeId h = surface_.halfedge(FaceId{0});
  const double a = surface_.length(edge_of(h));
  const double b = surface_.length(edge_of(surface_.next(h)));
  const double c = surface_.length(edge_of(surface_.prev(h)));
  EXPECT_NEAR(weight(sources, corner[0].index()), (a + c) / 2, 1e-15);
  EXPECT_NEAR(weight(sources, corner[1].index()), (a + b) / 2, 1e-15);
  EXPECT_NEAR(weight(sources, corner[2].index()), (b + c) / 2, 1e-15);
}

TEST_F(CurveSources, OnePointWeighsOne) {
  EXPECT_EQ(curve_sources(surface_, {false, {at(7)}}),
            (std::vector<WeightedVertex>{{VertexId{7}, 1.0}}));
  const SurfacePoint inside = SurfacePoint::in_face(surface_, FaceId{0}, {0.5, 0.25, 0.25});
  const auto sources = curve_sources(surface_, {false, {inside}});
  ASSERT_EQ(sources.size(), 3u);
  EXPECT_EQ(weight(sources, surface_.corners(FaceId{0})[0].index()), 0.5);
}

TEST_F(CurveSources, EmptyCurveAndPointsWithoutCommonFaceAreErrors) {
  EXPECT_THROW(curve_sources(surface_, {}), Error);
  try {
    curve_sources(surface_, {false, {at(0), at(1), at(15)}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
    EXPECT_NE(std::string(error.what()).find("Points 1 and 2"), std::string::npos);
  }
}

}  // namespace
}  // namespace talweg
