// Meshes taken apart along curves, and the lids on what that leaves open.
#include "talweg/core/seam_opening.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/mesh_numbers.hpp"
#include "talweg/core/loop_filling.hpp"
#include "talweg/core/mesh_cutting.hpp"
#include "talweg/core/mesh_inspection.hpp"
#include "talweg/core/straight_lines.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using test::area;
using test::euler;
using test::volume;

Piece piece(const OpenedSeams& opened, std::size_t number) {
  std::vector<bool> wanted(opened.pieces, false);
  wanted[number] = true;
  return piece_of(opened, wanted);
}

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
  // All but its ends are there twice, and there is one hole more.
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
  EXPECT_EQ(lids.left_open, 1U);  // the rest of its rim was there before
}

TEST(SeamOpening, ALoopAroundATorusPartsNothingAndTwoDo) {
  const MeshLists lists = test::torus(32, 16);
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const auto meridian = [&](std::uint32_t k) {
    CutMesh::Chain chain{true, {}};
    for (std::uint32_t v = 0; v < lists.points.size(); ++v) {
      // Vertices are in rows; which way they run does not matter here.
      if (v % 32 == k) chain.vertices.push_back(v);
    }
    return chain;
  };
  const CutMesh::Chain one[] = {meridian(0)};
  const CutMesh::Chain two[] = {meridian(0), meridian(9)};
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

TEST(SeamOpening, RefusesChainsThatAreNone) {
  const MeshLists lists = test::grid(10, 10);
  const CutMesh::Chain jump[] = {{false, {0, 50}}}, outside[] = {{false, {0, 5000}}};
  EXPECT_THROW(open_seams(lists, jump), Error);
  EXPECT_THROW(open_seams(lists, outside), Error);
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
