// Curves on a lopsided ellipsoid, with positions in another space, in another unit, or shifted.
#include "talweg/core/drawing/better_fit.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

/// An ellipsoid of size 20 around a centre; the half with y > 0 is half as deep.
MeshLists head(const Point& centre) {
  MeshLists lists = test::sphere(4);
  for (Point& p : lists.points) {
    p = Point(7 * p.x(), (p.y() > 0 ? 5 : 10) * p.y(), 10 * p.z()) + centre;
  }
  return lists;
}

/// A ring of positions on the side of low y.
std::vector<Point> ring(const SurfaceMesh& mesh, const Point& centre) {
  const ClosestPoint closest(mesh);
  std::vector<Point> points;
  for (int k = 0; k < 24; ++k) {
    const double a = 2 * std::numbers::pi * k / 24;
    const Point near = centre + Point(3 * std::cos(a), -8, 3 * std::sin(a));
    points.push_back(mesh.position(closest.nearest(near).point));
  }
  return points;
}

std::vector<Point> changed(std::vector<Point> points, const Point& factors, const Point& shift) {
  for (Point& p : points) p = factors.cwiseProduct(p) + shift;
  return points;
}

class BetterFit : public testing::Test {
 protected:
  [[nodiscard]] std::string of(const std::vector<Point>& points) const {
    return better_fit(mesh_, closest_, points);
  }
  const Point centre_{30, 40, -20};
  const SurfaceMesh mesh_ = SurfaceMesh::open(head(centre_));
  const ClosestPoint closest_{mesh_};
  const std::vector<Point> ring_ = ring(mesh_, centre_);
  const Point one_ = Point::Ones(), none_ = Point::Zero();
};

TEST_F(BetterFit, NamesTheChangeThatMakesADrawingFit) {
  const auto expect = [&](const Point& factors, const Point& shift, const char* words) {
    const std::string found = of(changed(ring_, factors, shift));
    EXPECT_TRUE(found.starts_with("would fit more than 1000 times better ")) << found;
    EXPECT_NE(found.find(words), std::string::npos) << found << "\n" << words;
  };
  expect({-1, -1, 1}, none_, "with x and y negated");
  expect(10 * one_, none_, "scaled by 0.1,");
  expect(1000 * one_, none_, "scaled by 0.001,");
  expect(25.4 * one_, none_, "scaled by 0.0393701,");
  expect(0.1 * one_, none_, "scaled by 10,");
  expect(0.001 * one_, none_, "scaled by 1000,");
  expect(one_ / 25.4, none_, "scaled by 25.4,");
  expect(one_, Point(-30, -37.5, 20), "moved by (30, 37.5, -20), the centre of the mesh's box");
  expect(one_, Point(30, 37.5, -20), "moved by (-30, -37.5, 20), the centre");
  expect(one_, Point(500000, 4600000, 0), "moved by (-500000, -4600000, 0)");
}

TEST_F(BetterFit, NamesTheAxisThatIsUp) {
  std::vector<Point> z_up, y_up;
  for (const Point& p : ring_) {
    z_up.emplace_back(p.x(), -p.z(), p.y());
    y_up.emplace_back(p.x(), p.z(), -p.y());
  }
  EXPECT_EQ(of(z_up),
            "would fit more than 1000 times better as (x, z, -y), as if z were up in the drawing "
            "and y in the mesh");
  EXPECT_EQ(of(y_up),
            "would fit more than 1000 times better as (x, -z, y), as if y were up in the drawing "
            "and z in the mesh");
}

TEST_F(BetterFit, IsNotSearchedForADrawingOnItsMesh) {
  EXPECT_EQ(of(ring_), "");
  EXPECT_EQ(of(changed(ring_, one_, Point(0.02, 0.02, -0.02))), "");
}

TEST_F(BetterFit, IsEmptyIfNoChangeFits) {
  EXPECT_EQ(of(changed(ring_, one_, Point(0, -4, 0))), "");
  EXPECT_EQ(of(changed(ring_, Point(1.3, 1.3, 1.3), none_)), "");
  EXPECT_EQ(of({}), "");
  EXPECT_EQ(of({Point(1e300, 0, 0)}), "");
}

TEST_F(BetterFit, GivesNoFalseAlarmOnSymmetricMeshes) {
  const SurfaceMesh ball = SurfaceMesh::open(test::sphere(4));  // about the origin
  const ClosestPoint closest(ball);
  std::vector<Point> around;
  for (int k = 0; k < 24; ++k) {
    const double a = 2 * std::numbers::pi * k / 24;
    around.emplace_back(0.8 * std::cos(a), 0.6, 0.8 * std::sin(a));
  }
  for (const double size : {1.0, 1.1, 1.5}) {
    EXPECT_EQ(better_fit(ball, closest, changed(around, size * one_, none_)), "") << size;
  }
  // A sheet through the origin, on which any small curve near the origin would lie.
  const SurfaceMesh sheet = SurfaceMesh::open(test::grid(20, 20));
  const ClosestPoint on_sheet(sheet);
  EXPECT_EQ(better_fit(sheet, on_sheet, std::vector<Point>{{5, 5, 2}, {9, 8, 2}, {12, 3, 2}}), "");
}

TEST_F(BetterFit, IsAWarningOrAPartOfTheRefusal) {
  CurveInput turned{true, changed(ring_, {-1, -1, 1}, none_), {}};
  try {
    snap(mesh_, turned);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_NE(
        what.find("in another unit or place; it would fit more than 1000 times better with x"),
        std::string::npos)
        << what;
  }
  // The same drawing and mesh around the origin, where the distances are shorter.
  const SurfaceMesh mesh = SurfaceMesh::open(head(none_));
  CurveInput near{true, changed(ring(mesh, none_), {-1, -1, 1}, none_), {}};
  near.control_points = true;
  EXPECT_NE(snap(mesh, near).better_fit.find("x and y negated"), std::string::npos);
  EXPECT_EQ(snap(mesh, CurveInput{true, ring(mesh, none_), {}}).better_fit, "");
}

}  // namespace
}  // namespace talweg
