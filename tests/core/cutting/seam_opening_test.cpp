// Meshes opened along curves, and lids on the resulting holes.
#include "talweg/core/cutting/seam_opening.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/cutting/seam_pieces.hpp"
#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/mesh_numbers.hpp"
#include "talweg/core/cutting/loop_filling.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/plane_filling.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using test::area;
using test::euler;
using test::piece;
using test::volume;

/// A smoothed loop around a unit sphere, jagged as it was drawn, about this high.
SurfaceCurve ring_on_sphere(const std::shared_ptr<const OpenedMesh>& opened, double z) {
  const double r = std::sqrt(1 - z * z);
  const auto points = test::circle({0, 0, z}, {r, 0, 0}, {0, r, 0}, 24);
  return smooth_curve(opened, test::drawn_near(opened->mesh(), points, true)).curve();
}

TEST(SeamOpening, ALoopPartsASphereInTwoDiscs) {
  const auto opened = OpenedMesh::open(test::sphere(4));
  const SurfaceCurve ring = ring_on_sphere(opened, 0.3);
  const CutMesh cut = cut_along(opened->mesh(), std::span(&ring, 1));
  const OpenedSeams seams = open_seams(cut.lists, cut.chains);
  ASSERT_EQ(seams.pieces, 2U);
  EXPECT_EQ(seams.lists.points.size(), cut.lists.points.size() + cut.chains[0].vertices.size());
  ASSERT_EQ(seams.left[0].size(), 1U);
  ASSERT_EQ(seams.right[0].size(), 1U);
  EXPECT_NE(seams.left[0], seams.right[0]);
  double together = 0, enclosed = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    Piece part = piece(seams, k);
    EXPECT_EQ(euler(part.lists), 1);  // a disc
    together += area(part.lists);
    const Lids lids = add_lids(part, seams, cut.chains);
    EXPECT_EQ(lids.filled, 1U);
    EXPECT_EQ(lids.triangles, cut.chains[0].vertices.size() - 2);
    EXPECT_EQ(euler(part.lists), 2);  // closed
    EXPECT_GT(volume(part.lists), 0);
    enclosed += volume(part.lists);
  }
  EXPECT_NEAR(together, area(cut.lists), 1e-12 * together);
  EXPECT_NEAR(enclosed, volume(cut.lists), 1e-9);  // the lids are the same, from both sides
  // The left of a loop that runs counterclockwise around z is above it.
  const Piece left = piece(seams, seams.left[0][0]);
  double top = -1;
  for (const Point& p : left.lists.points) top = std::max(top, p.z());
  EXPECT_NEAR(top, 1, 0.01);
}

TEST(SeamOpening, AnOpenCurveIsASlit) {
  const auto opened = OpenedMesh::open(test::hills(40));
  const SurfaceCurve curve = smooth_curve(opened, test::wave_on_hills(opened->mesh())).curve();
  const CutMesh cut = cut_along(opened->mesh(), std::span(&curve, 1));
  const OpenedSeams seams = open_seams(cut.lists, cut.chains);
  EXPECT_EQ(seams.pieces, 1U);
  EXPECT_EQ(seams.left[0], seams.right[0]);
  // All vertices except the ends are doubled, and the mesh has one more hole.
  EXPECT_EQ(seams.lists.points.size(), cut.lists.points.size() + cut.chains[0].vertices.size() - 2);
  EXPECT_EQ(euler(seams.lists), euler(cut.lists) - 1);
  Piece slit = piece(seams, 0);
  const Lids lids = add_lids(slit, seams, cut.chains);  // a lid would have no area
  EXPECT_EQ(lids.filled, 0U);
  EXPECT_EQ(lids.left_open, 1U);
}

TEST(SeamOpening, FromBoundaryToBoundaryItPartsASheet) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(10, 10));
  StraightLines lines(mesh.surface());
  const SurfaceCurve curve = lines.join(std::vector{test::between(mesh.surface(), 3, 4, 0.5),
                                                    test::between(mesh.surface(), 117, 118, 0.25)},
                                        false);
  const CutMesh cut = cut_along(mesh, std::span(&curve, 1));
  const OpenedSeams seams = open_seams(cut.lists, cut.chains);
  ASSERT_EQ(seams.pieces, 2U);
  Piece part = piece(seams, 0);
  EXPECT_EQ(euler(part.lists), 1);
  const Lids lids = add_lids(part, seams, cut.chains);
  EXPECT_EQ(lids.filled, 0U);
  EXPECT_EQ(lids.left_open, 1U);  // the rest of the rim is the old boundary
}

TEST(SeamOpening, ALoopAroundATorusPartsNothingAndTwoDo) {
  const MeshLists lists = test::torus(32, 16);
  const auto meridian = [&](std::uint32_t k) {
    CutMesh::Chain chain{true, {}};
    for (std::uint32_t v = 0; v < lists.points.size(); ++v) {
      // Vertices are in rows; their direction does not matter here.
      if (v / 32 == k) chain.vertices.push_back(v);
    }
    return chain;
  };
  const CutMesh::Chain one[] = {meridian(0)};
  const CutMesh::Chain two[] = {meridian(0), meridian(5)};
  EXPECT_EQ(open_seams(lists, one).pieces, 1U);
  const OpenedSeams tubes = open_seams(lists, two);
  EXPECT_EQ(tubes.pieces, 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    Piece part = piece(tubes, k);
    EXPECT_EQ(euler(part.lists), 0);
    EXPECT_EQ(add_lids(part, tubes, two).filled, 2U);
    EXPECT_EQ(euler(part.lists), 2);
  }
}

TEST(SeamOpening, CurvesThatCrossPartASheetInFour) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(10, 10));
  StraightLines lines(mesh.surface());
  const auto across = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    return lines.join(std::vector{test::between(mesh.surface(), a, b, 0.4),
                                  test::between(mesh.surface(), c, d, 0.7)},
                      false);
  };
  const std::vector<SurfaceCurve> curves = {across(3, 4, 117, 118), across(44, 55, 76, 87)};
  const CutMesh cut = cut_along(mesh, curves);
  EXPECT_EQ(open_seams(cut.lists, cut.chains).pieces, 4U);
}

TEST(SeamOpening, AChainOfOneVertexOpensNothing) {
  const MeshLists lists = test::grid(10, 10);
  for (const bool closed : {false, true}) {
    const CutMesh::Chain point[] = {{closed, {50}}};
    const OpenedSeams seams = open_seams(lists, point);
    EXPECT_EQ(seams.pieces, 1U);
    EXPECT_EQ(seams.lists.points.size(), lists.points.size());
    EXPECT_TRUE(seams.left[0].empty());
    Piece whole = piece(seams, 0);
    EXPECT_EQ(add_lids(whole, seams, point).filled, 0U);
  }
}

TEST(SeamOpening, RefusesInvalidChains) {
  const MeshLists lists = test::grid(10, 10);
  const CutMesh::Chain jump[] = {{false, {0, 50}}}, outside[] = {{false, {0, 5000}}};
  EXPECT_THROW(open_seams(lists, jump), Error);
  EXPECT_THROW(open_seams(lists, outside), Error);
}

TEST(SeamOpening, RefusesAChainWhereTheMeshIsNoSurface) {
  MeshLists lists = test::grid(10, 10);
  const CutMesh::Chain chain[] = {{false, {45, 46}}};
  const MeshLists turned = test::with_turned_face(lists, 80);  // beside vertex 45
  EXPECT_THROW(open_seams(turned, chain), Error);
  lists.triangles.push_back({0, 1, 5000});
  EXPECT_THROW(open_seams(lists, chain), Error);
}

/// A box with a square shaft through it, along z from 0 to 3, with rows of vertices at each whole
/// z.
MeshLists pipe() {
  MeshLists lists;
  const double outer[4][2] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const double inner[4][2] = {{1, 1}, {3, 1}, {3, 3}, {1, 3}};
  const auto wall = [&](const double(&corners)[4][2], bool outwards) {
    const auto first = static_cast<std::uint32_t>(lists.points.size());
    for (int z = 0; z < 4; ++z) {
      for (const auto& xy : corners) lists.points.emplace_back(xy[0], xy[1], z);
    }
    for (std::uint32_t z = 0; z < 3; ++z) {
      for (std::uint32_t k = 0; k < 4; ++k) {
        const std::uint32_t a = first + 4 * z + k, b = first + 4 * z + (k + 1) % 4;
        Triangle lower{a, b, b + 4}, upper{a, b + 4, a + 4};
        if (!outwards) {
          std::swap(lower[1], lower[2]);
          std::swap(upper[1], upper[2]);
        }
        lists.triangles.push_back(lower);
        lists.triangles.push_back(upper);
      }
    }
  };
  wall(outer, true);
  wall(inner, false);
  for (std::uint32_t k = 0; k < 4; ++k) {  // floor and ceiling
    const std::uint32_t o = k, p = (k + 1) % 4, i = 16 + k, j = 16 + (k + 1) % 4;
    lists.triangles.push_back({o, i, p});
    lists.triangles.push_back({p, i, j});
    lists.triangles.push_back({o + 12, p + 12, i + 12});
    lists.triangles.push_back({p + 12, j + 12, i + 12});
  }
  return lists;
}

TEST(Lids, BetweenNestedRimsInOnePlaneAreWithHoles) {
  const MeshLists lists = pipe();
  ASSERT_EQ(euler(lists), 0);
  EXPECT_NEAR(volume(lists), 36, 1e-12);
  const CutMesh::Chain rings[] = {{true, {4, 5, 6, 7}}, {true, {20, 21, 22, 23}}};
  const OpenedSeams seams = open_seams(lists, rings);
  ASSERT_EQ(seams.pieces, 2U);
  Piece lower = piece(seams, seams.right[0][0]), upper = piece(seams, seams.left[0][0]);
  for (Piece* part : {&lower, &upper}) {
    const Lids lids = add_lids(*part, seams, rings, LidKind::kPlanar);
    EXPECT_EQ(lids.filled, 2U);
    EXPECT_EQ(lids.planar, 2U);
    EXPECT_EQ(lids.triangles, 8U);
    EXPECT_EQ(euler(part->lists), 0);  // still with a shaft
  }
  EXPECT_NEAR(volume(lower.lists), 12, 1e-12);
  EXPECT_NEAR(volume(upper.lists), 24, 1e-12);
  // With kLeastArea each rim has a separate lid. The two lids would overlap, so the outer lid is
  // moved away.
  Piece other = piece(seams, seams.right[0][0]);
  const Lids apart = add_lids(other, seams, rings, LidKind::kLeastArea);
  EXPECT_EQ(apart.filled, 2U);
  EXPECT_EQ(apart.with_inner, 1U);
  EXPECT_EQ(euler(other.lists), 2);  // the shaft's end is closed inside of the block
  // Both sides of a seam in one mesh: the rims lie on each other, and both get lids.
  Piece both = piece_of(seams, {true, true});
  const Lids lids = add_lids(both, seams, rings);
  EXPECT_EQ(lids.planar, 4U);
  EXPECT_NEAR(volume(both.lists), 36, 1e-12);
  EXPECT_EQ(euler(both.lists), 0);
}

TEST(Lids, OfATorusCutOnceAreTwo) {
  const MeshLists lists = test::torus(32, 16);
  CutMesh::Chain ring{true, {}};
  for (std::uint32_t v = 64; v < 96; ++v) ring.vertices.push_back(v);
  const OpenedSeams seams = open_seams(lists, std::span(&ring, 1));
  Piece tube = piece(seams, 0);
  const Lids lids = add_lids(tube, seams, std::span(&ring, 1));
  EXPECT_EQ(lids.filled, 2U);
  EXPECT_EQ(lids.planar, 2U);
  EXPECT_EQ(euler(tube.lists), 2);
  EXPECT_NEAR(volume(tube.lists), volume(lists), 1e-12);
}

TEST(Lids, MustBePlaneIfPlaneLidsAreRequested) {
  const auto opened = OpenedMesh::open(test::sphere(4));
  const auto points = test::circle({0, 0, 0}, {0.9, 0, 0.4}, {0, 1, 0}, 24);
  SurfaceCurve ring = test::drawn_near(opened->mesh(), points, true);  // along edges: jagged
  const CutMesh cut = cut_along(opened->mesh(), std::span(&ring, 1));
  const OpenedSeams seams = open_seams(cut.lists, cut.chains);
  Piece part = piece(seams, 0);
  try {
    add_lids(part, seams, cut.chains, LidKind::kPlanar);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
    EXPECT_NE(std::string(error.what()).find("is not planar"), std::string::npos) << error.what();
  }
  const Lids lids = add_lids(part, seams, cut.chains);
  EXPECT_EQ(lids.filled, 1U);
  EXPECT_EQ(lids.planar, 0U);
}

TEST(PlaneFilling, OfALongPolygonIsThePolygon) {
  // A star of 2000 points with a round hole, in a slanted plane far from the origin.
  const Point u = Point(1, 2, 0.5).normalized(), v = u.unitOrthogonal(), centre(1e4, -2e4, 5e3);
  std::vector<Point> points;
  std::vector<Loop> loops(2);
  const auto add = [&](Loop& loop, double angle, double r) {
    loop.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(centre + r * std::cos(angle) * u + r * std::sin(angle) * v);
  };
  for (int k = 0; k < 2000; ++k) {
    const double angle = 2 * std::numbers::pi * k / 2000;
    add(loops[0], angle, 2 + std::sin(5 * angle));
  }
  for (int k = 0; k < 300; ++k) add(loops[1], -2 * std::numbers::pi * k / 300, 0.5);
  const auto area_of = [&](const Loop& loop) {
    Point sum = Point::Zero();
    for (std::size_t k = 0; k < loop.size(); ++k) {
      sum += (points[loop[k]] - centre).cross(points[loop[(k + 1) % loop.size()]] - centre) / 2;
    }
    return sum.norm();
  };
  EXPECT_LT(distance_from_plane(points, loops[0]), 1e-9);
  const auto groups = plane_groups(points, loops);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0], (std::vector<std::size_t>{0, 1}));
  const auto lid = fill_plane(points, loops);
  ASSERT_TRUE(lid.has_value());
  EXPECT_EQ(lid->size(), 2300U);
  EXPECT_NEAR(area({points, *lid}), area_of(loops[0]) - area_of(loops[1]), 1e-6);
  // A polygon that crosses itself has no filling.
  std::swap(loops[0][3], loops[0][40]);
  EXPECT_FALSE(fill_plane(points, loops).has_value());
}

TEST(LoopFilling, OfAPlanePolygonIsThePolygon) {
  // An L of area 3, and a star of many points.
  std::vector<Point> points = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  std::vector<std::uint32_t> loop = {0, 1, 2, 3, 4, 5};
  const auto area_of = [&](const std::vector<Triangle>& triangles) {
    return area({points, triangles});
  };
  auto lid = fill_loop(points, loop);
  EXPECT_EQ(lid.size(), 4U);
  EXPECT_NEAR(area_of(lid), 3, 1e-12);
  points.clear();
  loop.clear();
  double expected = 0;
  for (std::uint32_t k = 0; k < 1000; ++k) {
    const double angle = 2 * std::numbers::pi * k / 1000, r = 2 + std::sin(5 * angle);
    points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.5);
    loop.push_back(k);
  }
  for (std::size_t k = 0; k < 1000; ++k) {
    const Point &p = points[k], &q = points[(k + 1) % 1000];
    expected += (p.x() * q.y() - p.y() * q.x()) / 2;
  }
  lid = fill_loop(points, loop);
  EXPECT_EQ(lid.size(), 998U);
  EXPECT_NEAR(area_of(lid), expected, 1e-3 * expected);
  EXPECT_TRUE(fill_loop(points, std::span(loop).first(2)).empty());
}

}  // namespace
}  // namespace talweg
