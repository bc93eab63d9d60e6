// Straight walks and lines through strips, against the plane, cones, and each other.
#include "talweg/intrinsic/lines/strip_line.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/test_surfaces.hpp"
#include "talweg/intrinsic/lines/straight_walk.hpp"

namespace talweg {
namespace {

using test::kPi;
using test::Random;

test::Point place(const test::TestMesh& mesh, const Surface& surface, const FaceCoordinates& at) {
  test::Point p{0, 0, 0};
  const auto corners = surface.corners(at.face);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] += at.barycentric[k] * mesh.points[corners[k].index()][i];
    }
  }
  return p;
}

FaceCoordinates anywhere(const Surface& surface, Random& random) {
  double a = random.uniform(), b = random.uniform();
  if (a + b > 1) {
    a = 1 - a;
    b = 1 - b;
  }
  return moved_inside({FaceId{random.below(surface.face_count())}, {1 - a - b, a, b}});
}

PlanePoint direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// A random way of straight legs, each of length at most `longest`.
struct Way {
  FaceCoordinates from, to;
  FaceStrip strip;
};
Way any_way(const Surface& surface, Random& random, int legs, double longest) {
  Way way{anywhere(surface, random), {}, {}};
  way.to = way.from;
  for (int leg = 0; leg < legs; ++leg) {
    FaceStrip crossed;
    const PlanePoint d = direction(random.uniform(0, 2 * kPi));
    way.to = walk_straight(surface, way.to, d, random.uniform(0, longest), crossed).at;
    for (const HalfedgeId h : crossed) add_crossing(way.strip, h);
  }
  return way;
}

/// The direction in the plane of a direction in the frame of a face, on a flat mesh.
PlanePoint in_plane(const test::TestMesh& mesh, const Surface& surface, FaceId face, PlanePoint d) {
  const auto corners = surface.corners(face);
  const test::Point side = mesh.points[corners[1].index()] - mesh.points[corners[0].index()];
  const double length = test::norm(side);
  const PlanePoint x{side[0] / length, side[1] / length};
  return d.x * x + d.y * turned_left(x);
}

/// A fan around vertex 0 with a total angle; spokes of length 1. The fan is closed, or open at
/// spoke 1.
Surface fan(std::size_t faces, double angle, bool closed) {
  std::vector<Triangle> triangles;
  const std::size_t rim = closed ? faces : faces + 1;
  for (std::size_t f = 0; f < faces; ++f) {
    triangles.push_back(
        {0, static_cast<std::uint32_t>(1 + f), static_cast<std::uint32_t>(1 + (f + 1) % rim)});
  }
  Surface surface = Surface::from_triangles(1 + rim, triangles);
  std::vector<double> lengths(surface.edge_count(), 1);
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    if (surface.tail(h).index() != 0 && surface.head(h).index() != 0) {
      lengths[e] = 2 * std::sin(angle / static_cast<double>(2 * faces));
    }
  }
  surface.set_lengths(lengths);
  return surface;
}

/// The point of the fan at this angle from spoke 1.
FaceCoordinates on_fan(std::size_t faces, double whole, double radius, double angle) {
  const double wedge = whole / static_cast<double>(faces);
  const auto face = static_cast<std::size_t>(angle / wedge);
  const double in = angle - static_cast<double>(face) * wedge;
  const double c = radius * std::sin(in) / std::sin(wedge);
  const double b = radius * std::sin(wedge - in) / std::sin(wedge);
  return {FaceId{face}, {1 - b - c, b, c}};
}

/// The strip counterclockwise around the fan from one face to another.
FaceStrip around(const Surface& surface, FaceId from, FaceId to) {
  FaceStrip strip;
  for (FaceId face = from; face != to;) {
    const HalfedgeId h = surface.prev(surface.halfedge(face));  // its head is vertex 0
    strip.push_back(h);
    face = surface.face(twin(h));
  }
  return strip;
}

TEST(StraightWalk, IsStraightInThePlane) {
  const test::TestMesh mesh = test::grid(12, 9, 0.2);
  const Surface surface = surface_of(mesh);
  Random random(3);
  int inside = 0;
  for (int i = 0; i < 400; ++i) {
    const FaceCoordinates from = anywhere(surface, random);
    const PlanePoint d = direction(random.uniform(0, 2 * kPi));
    const double length = random.uniform(0, 6);
    FaceStrip crossed;
    const WalkEnd end = walk_straight(surface, from, d, length, crossed);
    const PlanePoint global = in_plane(mesh, surface, from.face, d);
    const test::Point p = place(mesh, surface, from), q = place(mesh, surface, end.at);
    EXPECT_NEAR(q[0], p[0] + end.walked * global.x, 1e-7);
    EXPECT_NEAR(q[1], p[1] + end.walked * global.y, 1e-7);
    const PlanePoint there = in_plane(mesh, surface, end.at.face, end.direction);
    EXPECT_NEAR(there.x, global.x, 1e-9);
    EXPECT_NEAR(there.y, global.y, 1e-9);
    FaceId face = from.face;
    for (const HalfedgeId h : crossed) {
      EXPECT_EQ(surface.face(h), face);
      face = surface.face(twin(h));
    }
    EXPECT_EQ(face, end.at.face);
    if (end.walked == length) {
      ++inside;
    } else {
      EXPECT_TRUE(std::min({q[0], q[1], 12 - q[0], 9 - q[1]}) < 1e-6);
    }
  }
  EXPECT_GT(inside, 100);
}

TEST(StraightWalk, StopsAtTheBoundaryAndStaysInside) {
  const test::TestMesh mesh = test::grid(3, 3);
  const Surface surface = surface_of(mesh);
  FaceStrip crossed;
  const WalkEnd end =
      walk_straight(surface, {FaceId{0}, {0.2, 0.4, 0.4}}, direction(0.3), 50, crossed);
  EXPECT_LT(end.walked, 4);
  for (const double b : end.at.barycentric) EXPECT_GT(b, 0);
  crossed.clear();
  const WalkEnd on = walk_straight(surface, end.at, end.direction, 1, crossed);
  EXPECT_LT(on.walked, 1e-6);
  EXPECT_TRUE(crossed.empty());
}

TEST(StripLine, JoinsTheEndsOfAnyWayInThePlane) {
  const test::TestMesh mesh = test::grid(12, 9, 0.2);
  const Surface surface = surface_of(mesh);
  StripLines lines(surface);
  Random random(5);
  for (int i = 0; i < 400; ++i) {
    auto [from, to, strip] = any_way(surface, random, 4, 4);
    const StripLine line = lines.join(from, to, strip);
    ASSERT_TRUE(line.found);
    const test::Point p = place(mesh, surface, from), q = place(mesh, surface, to);
    EXPECT_NEAR(line.length, test::distance(p, q), 1e-9);
    EXPECT_TRUE(line.bends.empty());
    const PlanePoint start = in_plane(mesh, surface, line.from.face, line.start);
    const PlanePoint end = in_plane(mesh, surface, line.to.face, line.end);
    if (line.length < 1e-6) continue;
    EXPECT_NEAR(start.x, (q[0] - p[0]) / line.length, 1e-7);
    EXPECT_NEAR(start.y, (q[1] - p[1]) / line.length, 1e-7);
    EXPECT_NEAR(end.x, start.x, 1e-9);
    EXPECT_NEAR(end.y, start.y, 1e-9);
    lines.trace(line.from, line.to, strip);
    ASSERT_EQ(lines.parts().size(), strip.size());
    for (std::size_t k = 0; k < strip.size(); ++k) {
      const test::Point& tail = mesh.points[surface.tail(strip[k]).index()];
      const test::Point& head = mesh.points[surface.head(strip[k]).index()];
      const double t = lines.parts()[k];
      const PlanePoint at{tail[0] + t * (head[0] - tail[0]) - p[0],
                          tail[1] + t * (head[1] - tail[1]) - p[1]};
      EXPECT_NEAR(cross(at, {q[0] - p[0], q[1] - p[1]}) / line.length, 0, 1e-9);
    }
  }
}

TEST(StripLine, KeepsToItsSideOfAConeUnlessTheOtherIsShorter) {
  constexpr std::size_t kFaces = 9;
  for (const double whole : {1.3 * kPi, 1.9 * kPi, 2 * kPi, 2.3 * kPi, 3.1 * kPi}) {
    const Surface surface = fan(kFaces, whole, true);
    StripLines lines(surface);
    for (double angle = 0.05; angle < whole - 0.1; angle += 0.11) {
      const double r = 0.4, s = 0.3;
      const FaceCoordinates from = on_fan(kFaces, whole, r, 0.02);
      const FaceCoordinates to = on_fan(kFaces, whole, s, 0.02 + angle);
      FaceStrip strip = around(surface, from.face, to.face);
      const StripLine line = lines.join(from, to, strip);
      ASSERT_TRUE(line.found);
      const double side = angle < kPi ? angle : whole - angle;
      const double expected =
          side < kPi ? std::sqrt(r * r + s * s - 2 * r * s * std::cos(side)) : r + s;
      EXPECT_NEAR(line.length, expected, 1e-9) << whole << " " << angle;
      EXPECT_EQ(line.bends.size(), side < kPi ? 0U : 1U) << whole << " " << angle;
    }
  }
}

TEST(StripLine, BendsAtTheBoundary) {
  const Surface surface = fan(8, 1.6 * kPi, false);
  StripLines lines(surface);
  const FaceCoordinates from = on_fan(8, 1.6 * kPi, 0.5, 0.1), to = on_fan(8, 1.6 * kPi, 0.5, 4.8);
  FaceStrip strip = around(surface, from.face, to.face);
  const StripLine line = lines.join(from, to, strip);
  ASSERT_TRUE(line.found);
  EXPECT_NEAR(line.length, 1, 1e-12);
  ASSERT_EQ(line.bends.size(), 1U);
  EXPECT_EQ(line.bends[0], VertexId{0});
  lines.trace(line.from, line.to, strip);
  for (const double part : lines.parts()) EXPECT_EQ(part, 1);  // vertex 0 is at every head
}

TEST(StripLine, OfAPointOnItsFirstEdgeBeginsBeyondIt) {
  const Surface surface = fan(6, 2 * kPi, true);
  StripLines lines(surface);
  const FaceCoordinates apex{FaceId{0}, {1, 0, 0}}, to = on_fan(6, 2 * kPi, 0.5, 4);
  FaceStrip strip = around(surface, apex.face, to.face);
  const StripLine line = lines.join(apex, to, strip);
  ASSERT_TRUE(line.found);
  EXPECT_TRUE(strip.empty());
  EXPECT_EQ(line.from.face, to.face);
  EXPECT_NEAR(line.length, 0.5, 1e-12);
}

TEST(StripLine, IsTheSameBackwards) {
  const Surface surface = fan(7, 3.3 * kPi, true);
  StripLines lines(surface);
  Random random(8);
  for (int i = 0; i < 300; ++i) {
    auto [from, to, strip] = any_way(surface, random, 5, 0.8);
    const StripLine line = lines.join(from, to, strip);
    FaceStrip back;
    for (std::size_t k = strip.size(); k > 0; --k) back.push_back(twin(strip[k - 1]));
    const StripLine other = lines.join(line.to, line.from, back);
    ASSERT_TRUE(line.found && other.found);
    EXPECT_NEAR(line.length, other.length, 1e-12);
    EXPECT_NEAR(line.start.x, -other.end.x, 1e-7);
    EXPECT_EQ(strip.size(), back.size());
  }
}

}  // namespace
}  // namespace talweg
