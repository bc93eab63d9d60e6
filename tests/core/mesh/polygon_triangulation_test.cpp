#include "talweg/core/mesh/polygon_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/mesh_numbers.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/mesh_reader.hpp"

namespace talweg::test {
namespace {

using Corners = std::vector<Point>;

/// The lists of one polygon, triangulated.
MeshLists triangulated(const Corners& corners) {
  MeshLists lists;
  lists.points = corners;
  std::vector<std::uint32_t> ids;
  for (std::uint32_t v = 0; v < corners.size(); ++v) ids.push_back(v);
  add_polygon(lists, ids);
  triangulate_polygons(lists);
  return lists;
}

Corners flat(const std::vector<std::array<double, 2>>& places) {
  Corners corners;
  for (const auto& [x, y] : places) corners.push_back({x, y, 0});
  return corners;
}

/// The polygon with corner k first.
Corners begun_at(Corners corners, std::size_t k) {
  std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(k), corners.end());
  return corners;
}

/// The polygon in an oblique plane far from the origin.
Corners moved(Corners corners) {
  const Point x = Point(2, -1, 2) / 3, y = Point(2, 2, -1) / 3;  // at right angles, of length 1
  for (Point& p : corners) p = Point(500000, 4000000, 100) + p.x() * x + p.y() * y;
  return corners;
}

std::size_t flat_triangles(const MeshLists& lists) {
  return static_cast<std::size_t>(
      std::count_if(lists.triangles.begin(), lists.triangles.end(), [&](const Triangle& t) {
        const Point& a = lists.points[t[0]];
        return (lists.points[t[1]] - a).cross(lists.points[t[2]] - a).norm() < 1e-9;
      }));
}

/// Checks the number of triangles, and that their areas are positive and sum to the polygon's area:
/// triangles turned over would make the sum larger.
void expect_covered(const Corners& corners, double expected) {
  const MeshLists lists = triangulated(corners);
  EXPECT_EQ(lists.triangles.size(), corners.size() - 2);
  EXPECT_NEAR(area(lists), expected, 1e-9 * expected);
  EXPECT_EQ(flat_triangles(lists), 0U);
  EXPECT_EQ(lists.polygon_shapes.crossing, 0U);
}

const Corners kL = flat({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});

TEST(PolygonTriangulation, AnLIsTriangulatedInsideFromEachCornerEitherWayRound) {
  for (std::size_t k = 0; k < 6; ++k) {
    Corners corners = begun_at(kL, k);
    EXPECT_EQ(triangulated(corners).polygon_shapes.concave, 1U);
    expect_covered(corners, 3);
    expect_covered(moved(corners), 3);
    std::reverse(corners.begin(), corners.end());
    expect_covered(corners, 3);
  }
}

TEST(PolygonTriangulation, AFanThatCoversItsPolygonStays) {
  const std::vector<Triangle> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  const Corners pentagon = flat({{0, 0}, {2, 0}, {3, 1}, {1, 3}, {-1, 1}});
  EXPECT_EQ(triangulated(pentagon).triangles, fan);
  EXPECT_EQ(triangulated(pentagon).polygon_shapes.concave, 0U);
  // The fan from the reflex corner covers the L.
  const std::vector<Triangle> of_l{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  EXPECT_EQ(triangulated(begun_at(kL, 3)).triangles, of_l);
  // A corner on a side does not turn.
  const Corners on_side = flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}});
  EXPECT_EQ(triangulated(on_side).triangles, fan);
  EXPECT_EQ(triangulated(on_side).polygon_shapes.concave, 0U);
}

TEST(PolygonTriangulation, TheFirstTriangleBeginsWithTheFirstSide) {
  for (std::size_t k = 0; k < 6; ++k) {
    const Triangle first = triangulated(begun_at(kL, k)).triangles[0];
    EXPECT_EQ(first[0], 0U);
    EXPECT_EQ(first[1], 1U);
  }
}

/// A base of 1 below `teeth` teeth of width 1 and height 1 that are 1 apart.
Corners comb(std::size_t teeth) {
  Corners corners;
  const auto end = static_cast<double>(2 * teeth - 1);
  corners.push_back({0, 0, 0});
  corners.push_back({end, 0, 0});
  for (double x = end; x > 0; x -= 2) {
    corners.push_back({x, 2, 0});
    corners.push_back({x - 1, 2, 0});
    if (x > 1) {
      corners.push_back({x - 1, 1, 0});
      corners.push_back({x - 2, 1, 0});
    }
  }
  return corners;
}

TEST(PolygonTriangulation, ManyCornersTakeNoTimeToSpeakOf) {
  constexpr std::size_t kTeeth = 25000;  // 100,000 corners
  Corners corners = comb(kTeeth);
  EXPECT_EQ(corners.size(), 4 * kTeeth);
  const double expected = 2 * kTeeth - 1 + kTeeth;
  expect_covered(corners, expected);
  for (Point& p : corners) p = {-p.y(), p.x(), 0};
  expect_covered(corners, expected);
}

/// A corridor of width 1 between two spirals whose turns are 2 apart.
Corners spiral(std::size_t steps) {
  Corners out, in;
  for (std::size_t k = 0; k <= steps; ++k) {
    const double angle = 0.05 * static_cast<double>(k), radius = 3 + angle / std::numbers::pi;
    out.push_back({(radius + 1) * std::cos(angle), (radius + 1) * std::sin(angle), 0});
    in.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  out.insert(out.end(), in.rbegin(), in.rend());
  return out;
}

double shoelace(const Corners& corners) {
  double twice = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point& p = corners[k];
    const Point& q = corners[(k + 1) % corners.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return twice / 2;
}

TEST(PolygonTriangulation, SpiralsAndRandomStars) {
  const Corners corners = spiral(20000);
  expect_covered(corners, shoelace(corners));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> radius(0.2, 1);
  for (std::size_t n : {5, 8, 20, 100, 3000}) {
    Corners star;
    for (std::size_t k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
      const double r = radius(random);
      star.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
    expect_covered(star, shoelace(star));
    EXPECT_NEAR(area(triangulated(moved(star))), shoelace(star), 1e-8);
  }
}

TEST(PolygonTriangulation, ALongDiagonalStripTakesNoTimeToSpeakOf) {
  // Between y = x - 1 and y = x + 1, with teeth 1 wide: thin ears across it would reach far.
  constexpr int kColumns = 50000;
  Corners strip;
  for (int x = 0; x < kColumns; ++x) strip.push_back({1.0 * x, x - 1.0, 0});
  for (int x = kColumns - 1; x >= 0; --x)
    strip.push_back({1.0 * x, x + (x % 2 == 0 ? 1.0 : 2.0), 0});
  expect_covered(strip, shoelace(strip));
}

TEST(PolygonTriangulation, AHoleBehindABridge) {
  // A square of 4 with a hole of 2, joined by a bridge from corner to corner, there and back.
  const Corners corners =
      flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
  expect_covered(corners, 12);
}

TEST(PolygonTriangulation, CornersOnSidesLeaveNoFlatTriangle) {
  // An L with a corner in the middle of each side of 2, from where a fan does not cover it.
  expect_covered(flat({{2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}, {0, 0}, {1, 0}, {2, 0}}), 3);
}

TEST(PolygonTriangulation, CrossingPolygonsStayFans) {
  const std::vector<Triangle> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  Corners pentagram;
  for (int k = 0; k < 5; ++k) {
    const double angle = 2 * std::numbers::pi * (2 * k % 5) / 5;
    pentagram.push_back({std::cos(angle), std::sin(angle), 0});
  }
  for (const Corners& corners : {pentagram, flat({{0, 0}, {2, 2}, {2, 0}, {0, 1}, {-1, 1}})}) {
    const MeshLists lists = triangulated(corners);
    EXPECT_EQ(lists.triangles, fan);
    EXPECT_EQ(lists.polygon_shapes.crossing, 1U);
  }
  // Without area, at one place, and with a corner that is not a number.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Corners& corners : {flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}),
                                 flat({{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}}),
                                 flat({{0, 0}, {nan, 0}, {2, 0}, {3, 0}, {4, 1}})}) {
    const MeshLists lists = triangulated(corners);
    EXPECT_EQ(lists.triangles, fan);
    EXPECT_EQ(lists.polygon_shapes.crossing, 1U);
    EXPECT_EQ(lists.polygon_shapes.largest_distance, 0);
  }
}

TEST(PolygonTriangulation, TellsHowFarFromPlanePolygonsAre) {
  MeshLists lists = triangulated(flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(lists.polygon_shapes.not_plane, 0U);
  // The plane is z = 0, and each corner is 0.25 away from it, of a size of 2.
  lists = triangulated({{0, 0, 0.25}, {2, 0, -0.25}, {2, 2, 0.25}, {0, 2, -0.25}});
  EXPECT_EQ(lists.polygon_shapes.not_plane, 1U);
  EXPECT_NEAR(lists.polygon_shapes.largest_distance, 0.125, 1e-15);
}

class PolygonFiles : public testing::Test {
 protected:
  static constexpr const char* kCorners =
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 3 0 0\nv 3 1 0.5\n";
};

TEST_F(PolygonFiles, CornersKeepTheirTextureCoordinatesAndFacesTheirNumbers) {
  // The texture coordinates of vertex k are number 8 - k; the faces come before the vertices.
  const std::string text = std::string("f 7 8 3\nf 2/7 3/6 4/5 5/4 6/3 1/8\nf 2 7 8 3\n") +
                           kCorners +
                           "vt 8 0\nvt 7 0\nvt 6 0\nvt 5 0\nvt 4 0\nvt 3 0\nvt 2 0\n"
                           "vt 1 0\n";
  MeshAttributes attributes;
  const MeshLists lists = read_mesh("a.obj", text, attributes);
  EXPECT_EQ(lists.polygon_count, 2U);
  ASSERT_EQ(lists.triangles.size(), 1U + 4U + 2U);
  EXPECT_EQ(lists.polygon_shapes.concave, 1U);
  EXPECT_EQ(lists.polygon_shapes.not_plane, 1U);
  EXPECT_EQ(lists.polygon_shapes.largest_face, 2U);
  double of_l = 0;
  for (std::size_t f = 1; f < 5; ++f) {
    const auto& [a, b, c] = lists.triangles[f];
    const Point cross =
        (lists.points[b] - lists.points[a]).cross(lists.points[c] - lists.points[a]);
    EXPECT_GT(cross.z(), 0);
    of_l += cross.z() / 2;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(attributes.texture.values[2 * attributes.texture.corners[f][k]],
                lists.triangles[f][k] + 1);
    }
  }
  EXPECT_DOUBLE_EQ(of_l, 3);
  EXPECT_EQ(read_mesh("a.obj", text).triangles, lists.triangles);
}

TEST_F(PolygonFiles, OutlineGivesThePolygonBack) {
  const MeshLists lists = read_mesh("a.obj", std::string(kCorners) + "f 2 3 4 5 6 1\nf 2 7 8 3\n");
  const auto vertices = [&](std::vector<std::uint32_t> triangles) {
    std::vector<std::uint32_t> ids;
    for (const PolygonCorner& at : outline(lists.triangles, triangles)) {
      ids.push_back(lists.triangles[at.triangle][at.corner]);
    }
    return ids;
  };
  EXPECT_EQ(vertices({0, 1, 2, 3}), (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 0}));
  EXPECT_EQ(vertices({4, 5}), (std::vector<std::uint32_t>{1, 6, 7, 2}));
  EXPECT_EQ(vertices({4}).size(), 3U);
  EXPECT_TRUE(vertices({}).empty());
  EXPECT_TRUE(vertices({4, 4}).empty());
  // A ring around a vertex has it inside; triangles that only touch are two discs.
  const std::vector<Triangle> ring{{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, touching{{0, 1, 2}, {2, 3, 4}};
  const std::vector<std::uint32_t> three{0, 1, 2}, two{0, 1};
  EXPECT_TRUE(outline(ring, three).empty());
  EXPECT_TRUE(outline(touching, two).empty());
}

}  // namespace
}  // namespace talweg::test
