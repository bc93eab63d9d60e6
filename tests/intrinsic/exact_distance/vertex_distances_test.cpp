// Distances at vertices, and the order of two ways.
#include "talweg/intrinsic/exact_distance/vertex_distances.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace talweg {
namespace {

TEST(NearestOnCurve, IsOrderedByDistanceCurveAndPlace) {
  const NearestOnCurve a{1, 2, 3};
  EXPECT_TRUE(a.is_nearer_than({1.5, 0, 0}));
  EXPECT_TRUE(a.is_nearer_than({1, 3, 0}));
  EXPECT_TRUE(a.is_nearer_than({1, 2, 4}));
  EXPECT_FALSE(a.is_nearer_than(a));
  EXPECT_TRUE(a.is_nearer_than(NearestOnCurve::none()));
}

TEST(NearestOnCurve, AlongAnEdgeComesFromTheNearerEnd) {
  const NearestOnCurve tail{1, 0, 5}, head{3, 1, 7};
  const NearestOnCurve by_tail = along_edge(tail, head, 4, 2),
                       by_head = along_edge(tail, head, 4, 3.5);
  EXPECT_EQ(by_tail.distance, 3);
  EXPECT_EQ(by_tail.arc_length, 5);
  EXPECT_EQ(by_head.distance, 3.5);
  EXPECT_EQ(by_head.curve, 1U);
}

TEST(NearestOnCurve, RoundingIsZero) {
  NearestOnCurve on_curve{1e-15, 0, 0}, beside{1e-13, 0, 0};
  on_curve.drop_rounding(1);
  beside.drop_rounding(1);
  EXPECT_EQ(on_curve.distance, 0);
  EXPECT_EQ(beside.distance, 1e-13);
}

TEST(VertexDistances, AreOnlyLowered) {
  VertexDistances distances(3);
  const VertexId v{1};
  EXPECT_TRUE(std::isinf(distances[v].distance));
  EXPECT_TRUE(distances.lower(v, {2, 0, 1}));
  EXPECT_FALSE(distances.lower(v, {3, 1, 1}));
  EXPECT_EQ(distances[v].curve, 0U);
  EXPECT_TRUE(distances.lower(v, {1, 1, 4}));
  EXPECT_EQ(distances[v].arc_length, 4);
  // A distance lower by rounding only is stored, but not reported as lower.
  EXPECT_FALSE(distances.lower(v, {std::nextafter(1.0, 0.0), 2, 0}));
  EXPECT_EQ(distances[v].curve, 2U);
  // A tiny negative distance from rounding becomes 0.
  EXPECT_TRUE(distances.lower(v, {-1e-17, 0, 0}));
  EXPECT_EQ(distances[v].distance, 0);
}

TEST(VertexDistances, ListTheReachedVertices) {
  VertexDistances distances(4);
  for (const std::size_t v : {2UL, 0UL, 2UL}) distances.lower(VertexId{v}, {1, 0, 0});
  ASSERT_EQ(distances.reached().size(), 2U);
  EXPECT_EQ(distances.reached()[0], VertexId{2});
  EXPECT_EQ(distances.reached()[1], VertexId{0});
  distances.clear();
  EXPECT_TRUE(distances.reached().empty());
  EXPECT_TRUE(std::isinf(distances[VertexId{2}].distance));
}

}  // namespace
}  // namespace talweg
