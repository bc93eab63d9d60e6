#include "talweg/core/measure/coarse_distance.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

using test::grid;
using test::ids;
using test::vertex_curve;

CurveSegment side_of(const Surface& surface, FaceId face, std::size_t k) {
  const auto corners = surface.corners(face);
  return segment_between(surface, SurfacePoint::at_vertex(surface, corners[k]),
                         SurfacePoint::at_vertex(surface, corners[(k + 1) % 3]), face);
}

TEST(CoarseDistance, IsNeverLessThanTheDistance) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::hills(40));
  const Surface& surface = mesh.surface();
  const SurfaceCurve wave = test::wave_on_hills(mesh);
  PolylineDistance exact(surface);
  exact.set(std::span(&wave, 1));
  CoarseDistance coarse(surface, std::span(&wave, 1));
  for (std::size_t f = 0; f < surface.face_count(); f += 7) {
    const CurveSegment side = side_of(surface, FaceId{f}, f % 3);
    const CoarseDistance::OnSegment bound = coarse.on(side);
    EXPECT_GE(bound.first, exact.at(side.point(surface, 0)).distance * (1 - 1e-12));
    EXPECT_GE(bound.last, exact.at(side.point(surface, 1)).distance * (1 - 1e-12));
    for (const double t : {0.0, 0.3, 0.5, 0.9, 1.0}) {
      EXPECT_GE(bound.most, exact.at(side.point(surface, t)).distance * (1 - 1e-12));
    }
  }
}

// The row lies across all columns, so the way to it is straight along an edge.
TEST(CoarseDistance, IsTheDistanceWhereAnEdgeLeadsThere) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(8, 8));
  const Surface& surface = mesh.surface();
  const std::uint32_t row[] = {36, 37, 38, 39, 40, 41, 42, 43, 44};  // y = 4
  const SurfaceCurve line = vertex_curve(surface, ids(row), false);
  CoarseDistance coarse(surface, std::span(&line, 1));
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const CurveSegment side = side_of(surface, FaceId{f}, 0);
    const double first = std::abs(mesh.position(side.point(surface, 0)).y() - 4);
    const double last = std::abs(mesh.position(side.point(surface, 1)).y() - 4);
    EXPECT_NEAR(coarse.on(side).first, first, 1e-12);
    EXPECT_NEAR(coarse.on(side).last, last, 1e-12);
    EXPECT_GE(coarse.on(side).most, std::max(first, last) - 1e-12);
    EXPECT_LE(coarse.on(side).most, std::max(first, last) + std::sqrt(0.5));
  }
}

TEST(CoarseDistance, IsInfiniteOnAnotherPart) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::together(grid(2, 2), grid(2, 2), 9));
  const std::uint32_t edge[] = {0, 1};
  const SurfaceCurve line = vertex_curve(mesh.surface(), ids(edge), false);
  CoarseDistance coarse(mesh.surface(), std::span(&line, 1));
  EXPECT_LT(coarse.on(side_of(mesh.surface(), FaceId{7}, 0)).most, 4);
  EXPECT_EQ(coarse.on(side_of(mesh.surface(), FaceId{8}, 0)).most, HUGE_VAL);
}

}  // namespace
}  // namespace talweg
