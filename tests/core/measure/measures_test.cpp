#include "talweg/core/measure/measures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/reference_data.hpp"
#include "core/small_meshes.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using test::between;
using test::grid;
using test::ids;
using test::surface_of_lists;
using test::vertex_curve;

constexpr double kHalfTurn = std::numbers::pi;

SurfacePoint vertex(const Surface& surface, std::size_t v) {
  return SurfacePoint::at_vertex(surface, VertexId{v});
}

TEST(Measures, AnglesInThePlane) {
  const Surface surface = surface_of_lists(grid(4, 4));
  // Straight, a right angle, a sharp and a blunt diagonal; 12 is in the middle.
  const auto turn = [&](std::size_t a, std::size_t c) {
    return turning_angle(surface, vertex(surface, a), vertex(surface, 12), vertex(surface, c));
  };
  EXPECT_NEAR(turn(11, 13), 0, 1e-14);
  EXPECT_NEAR(turn(11, 17), kHalfTurn / 2, 1e-14);
  EXPECT_NEAR(turn(6, 13), kHalfTurn / 4, 1e-14);
  EXPECT_NEAR(turn(6, 7), 3 * kHalfTurn / 4, 1e-14);
  EXPECT_NEAR(turn(11, 11), kHalfTurn, 1e-14);
  EXPECT_NEAR(turn(17, 11), kHalfTurn / 2, 1e-14);
}

TEST(Measures, SignedCurvatureOfALoopIsGaussAndBonnets) {
  const Surface sheet = surface_of_lists(grid(4, 4));
  const SurfaceCurve left = vertex_curve(sheet, ids({6, 7, 8, 13, 18, 17, 16, 11}), true);
  const SurfaceCurve right = vertex_curve(sheet, ids({11, 16, 17, 18, 13, 8, 7, 6}), true);
  EXPECT_NEAR(measure_curve(sheet, left).signed_curvature, 2 * kHalfTurn, 1e-13);
  EXPECT_NEAR(measure_curve(sheet, right).signed_curvature, -2 * kHalfTurn, 1e-13);
  // Along the boundary the inner angle counts: a turn about a corner of the sheet.
  EXPECT_NEAR(signed_turning(sheet, vertex(sheet, 5), vertex(sheet, 0), vertex(sheet, 1)),
              kHalfTurn / 2, 1e-14);
  EXPECT_NEAR(signed_turning(sheet, vertex(sheet, 1), vertex(sheet, 0), vertex(sheet, 5)),
              -kHalfTurn / 2, 1e-14);
}

TEST(Measures, StraightLineThroughTheSheetTurnsNowhere) {
  const Surface surface = surface_of_lists(grid(4, 2));
  // From (0, 0) along y = x / 2: over faces, edges and vertices.
  SurfaceCurve line{false,
                    {vertex(surface, 0), between(surface, 1, 6, 0.5), vertex(surface, 7),
                     between(surface, 8, 13, 0.5), vertex(surface, 14)}};
  const CurveMeasures measures = measure_curve(surface, line);
  EXPECT_NEAR(measures.length, std::sqrt(20.0), 1e-14);
  EXPECT_NEAR(measures.total_curvature, 0, 1e-13);
  EXPECT_NEAR(curve_length(surface, line), measures.length, 0);
}

TEST(Measures, TurnsOnEdgesAndInFaces) {
  const Surface surface = surface_of_lists(grid(2, 1));
  // (0, 0) → (1, 1/4) → (2, 1).
  const auto quarter = between(surface, 1, 4, 0.25);
  EXPECT_NEAR(turning_angle(surface, vertex(surface, 0), quarter, vertex(surface, 5)),
              std::atan(0.75) - std::atan(0.25), 1e-14);
  // Back on the same side, to (1/4, 1/4).
  EXPECT_NEAR(turning_angle(surface, vertex(surface, 0), quarter, between(surface, 0, 4, 0.25)),
              kHalfTurn - std::atan(0.25), 1e-14);
  // Along the edge itself, on and back.
  const auto on_edge = between(surface, 1, 4, 0.5);
  EXPECT_NEAR(turning_angle(surface, vertex(surface, 1), on_edge, vertex(surface, 4)), 0, 1e-14);
  EXPECT_NEAR(turning_angle(surface, vertex(surface, 4), on_edge, between(surface, 1, 4, 0.7)),
              kHalfTurn, 1e-14);
  // Inside face 0 with corners (0, 0), (1, 0), (1, 1).
  const auto inside = SurfacePoint::in_face(surface, FaceId{0}, {0.25, 0.5, 0.25});
  EXPECT_NEAR(turning_angle(surface, vertex(surface, 0), inside, vertex(surface, 1)),
              kHalfTurn - (kHalfTurn - std::atan(1.0 / 3) - kHalfTurn / 4), 1e-14);
  EXPECT_NEAR(turning_angle(surface, vertex(surface, 4), inside, vertex(surface, 4)), kHalfTurn,
              1e-14);
}

TEST(Measures, ConesTurnByTheSmallerSide) {
  // Opposite spokes of a fan have cone / 2 on both sides.
  for (const double cone : {1.5 * kHalfTurn, 2 * kHalfTurn, 3 * kHalfTurn}) {
    const Surface surface = test::fan(6, cone, true);
    for (std::size_t k = 1; k <= 3; ++k) {
      const double side = static_cast<double>(k) * cone / 6;
      const double turn =
          turning_angle(surface, vertex(surface, 1), vertex(surface, 0), vertex(surface, 1 + k));
      EXPECT_NEAR(turn, std::max(0.0, kHalfTurn - side), 1e-12) << cone << " " << k;
    }
  }
}

TEST(Measures, TheLargestTurnIsHalfTheDifferenceOfBothSides) {
  // Straight over a spike, and past a saddle vertex with 147 degrees on one side of 434.
  const Surface spike = test::fan(6, 1.3 * kHalfTurn, true);
  EXPECT_NEAR(turn_of(spike, vertex(spike, 1), vertex(spike, 0), vertex(spike, 4)).from_straight, 0,
              1e-12);
  const Surface saddle = test::fan(6, 3 * kHalfTurn, true);
  EXPECT_NEAR(
      turn_of(saddle, vertex(saddle, 1), vertex(saddle, 0), vertex(saddle, 3)).from_straight,
      kHalfTurn / 2, 1e-12);  // a half turn on one side, a whole one on the other
  const SurfaceCurve curve{false, {vertex(saddle, 1), vertex(saddle, 0), vertex(saddle, 3)}};
  EXPECT_NEAR(measure_curve(saddle, curve).max_curvature, kHalfTurn / 2, 1e-12);
  EXPECT_NEAR(measure_curve(saddle, curve).total_curvature, 0, 1e-12);
}

TEST(Measures, OnTheBoundaryOnlyTheInsideCounts) {
  // A quarter of a disc about a corner, and a boundary vertex with more than pi inside.
  const Surface corner = test::fan(2, kHalfTurn / 2, false);
  EXPECT_NEAR(turning_angle(corner, vertex(corner, 1), vertex(corner, 0), vertex(corner, 3)),
              kHalfTurn / 2, 1e-14);
  const Surface reflex = test::fan(4, 1.5 * kHalfTurn, false);
  EXPECT_NEAR(turning_angle(reflex, vertex(reflex, 1), vertex(reflex, 0), vertex(reflex, 5)), 0,
              1e-14);
  EXPECT_NEAR(turning_angle(reflex, vertex(reflex, 1), vertex(reflex, 0), vertex(reflex, 2)),
              kHalfTurn - 1.5 * kHalfTurn / 4, 1e-12);
  // Along a boundary edge and off it.
  const Surface sheet = surface_of_lists(grid(1, 1));
  const auto middle = between(sheet, 0, 1, 0.5);
  EXPECT_NEAR(turning_angle(sheet, vertex(sheet, 0), middle, vertex(sheet, 1)), 0, 1e-14);
  EXPECT_NEAR(turning_angle(sheet, vertex(sheet, 0), middle, vertex(sheet, 3)), std::atan(2.0),
              1e-14);
}

TEST(Measures, ClosedCurvesTurnByTwoPiInThePlane) {
  const Surface surface = surface_of_lists(grid(4, 4));
  const auto path = ids({6, 7, 8, 13, 18, 17, 16, 11});
  const CurveMeasures measures = measure_curve(surface, vertex_curve(surface, path, true));
  EXPECT_NEAR(measures.length, 8, 1e-14);
  EXPECT_NEAR(curve_length(surface, vertex_curve(surface, path, true)), 8, 1e-14);
  EXPECT_NEAR(measures.total_curvature, 2 * kHalfTurn, 1e-13);
  EXPECT_NEAR(measures.max_curvature, kHalfTurn / 2, 1e-14);
  EXPECT_EQ(measures.max_at, 0U);
  // Open, the same points miss the last segment and the two turns at its ends.
  const CurveMeasures open = measure_curve(surface, vertex_curve(surface, path, false));
  EXPECT_NEAR(open.length, 7, 1e-14);
  EXPECT_NEAR(curve_length(surface, vertex_curve(surface, path, false)), 7, 1e-14);
  EXPECT_NEAR(open.total_curvature, 1.5 * kHalfTurn, 1e-13);
}

TEST(Measures, TortuosityIsLengthOverTheDistanceOfTheEnds) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(4, 4));
  const Surface& surface = mesh.surface();
  const auto tortuosity = [&](std::initializer_list<std::uint32_t> path, bool closed) {
    return measure_curve(mesh, vertex_curve(surface, ids(path), closed), 1).tortuosity;
  };
  EXPECT_NEAR(tortuosity({5, 6, 7, 8}, false), 1, 1e-14);
  EXPECT_NEAR(tortuosity({5, 6, 7, 12}, false), 3 / std::sqrt(5.0), 1e-14);
  EXPECT_NEAR(tortuosity({6, 7, 8, 13, 18, 17, 16, 11}, false), 7, 1e-14);  // one short of a loop
  EXPECT_EQ(tortuosity({6, 7, 8, 13, 18, 17, 16, 11}, true), HUGE_VAL);
  EXPECT_EQ(tortuosity({6, 7, 12, 11, 6}, false), HUGE_VAL);
  EXPECT_EQ(tortuosity({6}, false), HUGE_VAL);
  // A Surface has no positions, so the distance of the ends is unknown.
  const SurfaceCurve line = vertex_curve(surface, ids({5, 6}), false);
  EXPECT_EQ(measure_curve(surface, line, 1).tortuosity, HUGE_VAL);
}

TEST(Measures, UnfoldsAcrossABentEdge) {
  // Two unit right triangles that share their hypotenuse, bent by any angle about it: the line
  // from corner to corner through the middle is straight.
  for (const double bend : {0.0, 0.5, 1.5, 3.0}) {
    MeshLists lists;
    const double h = std::sqrt(0.5);
    lists.points = {Point(-h, 0, 0), Point(h, 0, 0), Point(0, h, 0),
                    Point(0, -h * std::cos(bend), h * std::sin(bend))};
    lists.triangles = {{0, 1, 2}, {1, 0, 3}};
    const Surface surface = surface_of_lists(lists);
    const auto middle = between(surface, 0, 1, 0.5);
    const auto third = between(surface, 0, 1, 0.75);
    EXPECT_NEAR(turning_angle(surface, vertex(surface, 2), middle, vertex(surface, 3)), 0, 1e-14);
    EXPECT_NEAR(turning_angle(surface, vertex(surface, 2), third, vertex(surface, 3)),
                2 * std::atan(0.5), 1e-14);
  }
}

TEST(Measures, DegenerateTrianglesGiveNoNan) {
  // Zero-length edges, a zero-area face with three different points, a needle.
  MeshLists lists;
  lists.points = {Point(0, 0, 0), Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0),
                  Point(1, 1e-13, 0)};
  lists.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}};
  const Surface surface = surface_of_lists(lists);
  for (std::size_t a = 0; a < 5; ++a) {
    for (std::size_t b = 0; b < 5; ++b) {
      if (a == 2 || b == 2) continue;
      const double turn =
          turning_angle(surface, vertex(surface, a), vertex(surface, 2), vertex(surface, b));
      EXPECT_TRUE(turn >= 0 && turn <= kHalfTurn) << a << " " << b;
    }
  }
  const SurfaceCurve curve{false,
                           {between(surface, 0, 1, 0.5), between(surface, 1, 2, 0.5),
                            between(surface, 2, 3, 0.5), vertex(surface, 4)}};
  const CurveMeasures measures = measure_curve(surface, curve);
  EXPECT_TRUE(std::isfinite(measures.length) && std::isfinite(measures.total_curvature));
}

TEST(Measures, TinyCurvesAndPointsThatAreNoNeighbours) {
  const Surface surface = surface_of_lists(grid(2, 2));
  EXPECT_EQ(measure_curve(surface, {true, {}}).length, 0);
  EXPECT_EQ(measure_curve(surface, {true, {vertex(surface, 0)}}).total_curvature, 0);
  const SurfaceCurve jump{false, {vertex(surface, 0), vertex(surface, 1), vertex(surface, 8)}};
  try {
    measure_curve(surface, jump);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
    EXPECT_NE(std::string(error.what()).find("Points 1 and 2"), std::string::npos);
  }
}

TEST(Measures, ScaleAndReversal) {
  MeshLists lists = test::sphere(2);
  const Surface surface = surface_of_lists(lists);
  for (Point& p : lists.points) p *= 1e-8;
  const Surface small = surface_of_lists(lists);
  auto path = ids({0, 6, 2, 10, 1});
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (!surface.find_halfedge(path[i], path[i + 1]).valid()) {
      path.resize(i + 1);
      break;
    }
  }
  const auto numbers = measure_curve(surface, vertex_curve(surface, path, false));
  const auto scaled = measure_curve(small, vertex_curve(small, path, false));
  EXPECT_NEAR(scaled.length, numbers.length * 1e-8, 1e-22);
  EXPECT_NEAR(scaled.total_curvature, numbers.total_curvature, 1e-13);
  std::reverse(path.begin(), path.end());
  const auto back = measure_curve(surface, vertex_curve(surface, path, false));
  EXPECT_NEAR(back.total_curvature, numbers.total_curvature, 1e-13);
}

TEST(Measures, AgreesWithTheReferenceOnDrawnCurves) {
  for (const char* name :
       {"fandisk_14k", "aneurysm_14k", "armadillo_86k", "skull_100k", "tooth_ct_119k"}) {
    const auto reference = test::reference_curve(name);
    if (!reference) GTEST_SKIP() << test::missing(name);
    const auto numbers = test::reference_numbers(name, 1.0);
    const Surface& surface = reference->mesh.surface();
    const auto measures =
        measure_curve(surface, vertex_curve(surface, reference->path, reference->closed));
    const double length = numbers["length_before"];
    const double curvature = numbers["curvature_before"];
    EXPECT_NEAR(measures.length, length, 1e-8 * length) << name;
    EXPECT_NEAR(measures.total_curvature, curvature, 1e-4 * curvature) << name;
  }
}

TEST(Measures, AgreesWithTheReferenceOnResults) {
  for (const char* name : {"fandisk_14k", "aneurysm_14k", "armadillo_86k"}) {
    const auto drawn = test::reference_curve(name);
    if (!drawn) GTEST_SKIP() << test::missing(name);
    const auto numbers = test::reference_numbers(name, 1.0);
    double moved = 0;
    const SurfaceCurve result = test::reference_result_curve(*drawn, name, moved);
    EXPECT_LT(moved, 1e-6 * drawn->mesh.mean_edge_length()) << name;
    const auto measures = measure_curve(drawn->mesh.surface(), result);
    const double length = numbers["length_after"];
    const double curvature = numbers["curvature_after"];
    EXPECT_NEAR(measures.length, length, 1e-6 * length) << name;
    EXPECT_NEAR(measures.total_curvature, curvature, 1e-3 * curvature) << name;
  }
}

}  // namespace
}  // namespace talweg
