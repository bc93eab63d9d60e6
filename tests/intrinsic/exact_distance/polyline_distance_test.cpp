#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/test_surfaces.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/lines/face_frame.hpp"

namespace talweg {
namespace {

using test::Point;
using test::Random;
using test::TestMesh;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Point position_on(const TestMesh& mesh, const Surface& surface, const SurfacePoint& p) {
  const FaceId face = any_face(surface, p);
  const auto b = coordinates_in(surface, p, face).barycentric;
  const auto corners = surface.corners(face);
  Point x{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) x[i] += b[k] * mesh.points[corners[k].index()][i];
  }
  return x;
}

SurfacePoint random_point(Random& random, const Surface& surface) {
  const FaceId face{random.below(surface.face_count())};
  double a = random.uniform(), b = random.uniform();
  if (a + b > 1) a = 1 - a, b = 1 - b;
  switch (random.below(3)) {
    case 0:
      return SurfacePoint::at_vertex(surface, surface.corners(face)[random.below(3)]);
    case 1:
      return SurfacePoint::from_barycentric(surface, face, {a, 1 - a, 0});
    default:
      return SurfacePoint::from_barycentric(surface, face, {a, b, 1 - a - b});
  }
}

/// A random curve from face to face: inside a face, on an edge, or along an edge to a vertex.
SurfaceCurve random_walk(Random& random, const Surface& surface, std::size_t points) {
  SurfaceCurve curve;
  curve.points.push_back(random_point(random, surface));
  while (curve.points.size() < points) {
    const auto faces = faces_at(surface, curve.points.back());
    const FaceId face = faces[random.below(faces.size())];
    const double a = random.uniform(0.05, 0.45), b = random.uniform(0.05, 0.45);
    switch (random.below(3)) {
      case 0:
        curve.points.push_back(
            SurfacePoint::at_vertex(surface, surface.corners(face)[random.below(3)]));
        break;
      case 1: {
        std::array<double, 3> on_side = {1 - a, a, 0};
        std::rotate(on_side.begin(), on_side.begin() + random.below(3), on_side.end());
        curve.points.push_back(SurfacePoint::from_barycentric(surface, face, on_side));
        break;
      }
      default:
        curve.points.push_back(SurfacePoint::in_face(surface, face, {a, b, 1 - a - b}));
    }
  }
  return curve;
}

SurfaceCurve through_vertices(const Surface& surface, const std::vector<std::size_t>& vertices,
                              bool closed = false) {
  SurfaceCurve curve;
  curve.closed = closed;
  for (const std::size_t v : vertices) {
    curve.points.push_back(SurfacePoint::at_vertex(surface, VertexId{v}));
  }
  return curve;
}

double to_segment(const Point& x, const Point& p, const Point& q) {
  double dot = 0, squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    dot += (x[i] - p[i]) * (q[i] - p[i]);
    squared += (q[i] - p[i]) * (q[i] - p[i]);
  }
  const double t = squared > 0 ? std::clamp(dot / squared, 0.0, 1.0) : 0.0;
  Point y{};
  for (std::size_t i = 0; i < 3; ++i) y[i] = p[i] + t * (q[i] - p[i]);
  return test::distance(x, y);
}

std::vector<Point> positions(const TestMesh& mesh, const Surface& surface,
                             const SurfaceCurve& curve) {
  std::vector<Point> line;
  for (const SurfacePoint& p : curve.points) line.push_back(position_on(mesh, surface, p));
  if (curve.closed) line.push_back(line.front());
  return line;
}

double to_polyline(const Point& x, const std::vector<Point>& line) {
  double best = test::distance(x, line.front());
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    best = std::min(best, to_segment(x, line[i], line[i + 1]));
  }
  return best;
}

Point at_arc(const std::vector<Point>& line, double arc) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double length = test::distance(line[i], line[i + 1]);
    if (arc <= length && length > 0) {
      Point x{};
      for (std::size_t k = 0; k < 3; ++k) {
        x[k] = line[i][k] + arc / length * (line[i + 1][k] - line[i][k]);
      }
      return x;
    }
    arc -= length;
  }
  return line.back();
}

/// A window has an error of 1e-10 of an edge at each edge that it crosses, n edges add up to at
/// most n times this error.
constexpr double kExact = 1e-8;

void expect_plane_distances(const TestMesh& mesh, const Surface& surface, const SurfaceCurve& curve,
                            Random& random, double tolerance = kExact) {
  const auto line = positions(mesh, surface, curve);
  PolylineDistance distance(surface);
  distance.set({&curve, 1});
  for (int i = 0; i < 400; ++i) {
    const SurfacePoint p = random_point(random, surface);
    const Point x = position_on(mesh, surface, p);
    const auto nearest = distance.at(p);
    ASSERT_NEAR(nearest.distance, to_polyline(x, line), tolerance) << i;
    // The point of the curve at the reported arc length is at the reported distance.
    ASSERT_NEAR(test::distance(x, at_arc(line, nearest.arc_length)), nearest.distance,
                10 * tolerance);
  }
}

TEST(PolylineDistance, IsEuclideanInThePlane) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    const TestMesh mesh = test::grid(14, 11, 0.24, seed);
    const Surface surface = test::surface_of(mesh);
    SurfaceCurve curve = random_walk(random, surface, 1 + random.below(25));
    expect_plane_distances(mesh, surface, curve, random);
  }
}

TEST(PolylineDistance, KnowsACurveOfOnePointInItsOwnFace) {
  const TestMesh mesh = test::grid(4, 4);
  const Surface surface = test::surface_of(mesh);
  const FaceId face{7};
  const auto at = [&](double a, double b) {
    return SurfacePoint::from_barycentric(surface, face, {a, b, 1 - a - b});
  };
  PolylineDistance distance(surface);
  for (const SurfacePoint& point : {at(0.3, 0.3), at(0.4, 0.6)}) {
    for (const std::size_t copies : {1U, 2U}) {
      const SurfaceCurve curve{false, std::vector(copies, point)};
      distance.set({&curve, 1});
      EXPECT_EQ(distance.at(point).distance, 0);
      const SurfacePoint beside = at(0.31, 0.35);
      EXPECT_NEAR(
          distance.at(beside).distance,
          test::distance(position_on(mesh, surface, point), position_on(mesh, surface, beside)),
          1e-15);
    }
  }
}

/// within() must agree with distances at points along the edges.
TEST(PolylineDistance, FindsStretchesOfEdgesWithinALimit) {
  Random random(3);
  const TestMesh mesh = test::grid(9, 9, 0.24, 3);
  const Surface surface = test::surface_of(mesh);
  const SurfaceCurve curve = random_walk(random, surface, 9);
  PolylineDistance distance(surface), asked(surface);
  distance.set({&curve, 1});
  asked.set({&curve, 1});
  constexpr double kLimit = 1.3;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const auto parts = distance.within(EdgeId{e}, kLimit);
    for (int i = 0; i <= 40; ++i) {
      const double x = surface.length(EdgeId{e}) * i / 40;
      const bool inside = std::any_of(parts.begin(), parts.end(), [&](const Stretch& part) {
        return part.from <= x + kExact && x <= part.to + kExact;
      });
      const double found = asked.on_edge(EdgeId{e}, i / 40.0).distance;
      if (std::abs(found - kLimit) <= kExact) continue;
      EXPECT_EQ(inside, found < kLimit) << e << " " << i;
    }
  }
  EXPECT_LT(distance.front(), kLimit + 1);
}

/// A plane grid in whose triangles vertices were inserted next to a side (caps) or next to a corner
/// (needles), `small()` of the triangle's size away; some of them inside each other.
template <class Small>
TestMesh plane_with_bad_triangles(Random& random, bool caps, Small small) {
  TestMesh mesh = test::grid(8, 8, 0.2, random.below(1000));
  for (int i = 0; i < 120; ++i) {
    const std::size_t f = random.below(mesh.triangles.size());
    const Triangle t = mesh.triangles[f];
    const double s = small(), a = caps ? random.uniform(0.2, 0.8) * (1 - s) : s / 2;
    const std::array<double, 3> b = {caps ? s : 1 - s, a, caps ? 1 - s - a : s / 2};
    Point x{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t c = 0; c < 3; ++c) x[c] += b[k] * mesh.points[t[k]][c];
    }
    const auto v = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(x);
    mesh.triangles[f] = {t[0], t[1], v};
    mesh.triangles.push_back({t[1], t[2], v});
    mesh.triangles.push_back({t[2], t[0], v});
  }
  return mesh;
}

// A length rounded by 1 ulp (1e-16) moves the apex of a cap by up to sqrt(1e-16) = 1e-8, and
// rotates a side of a needle of width w by 1e-16 / w.
TEST(PolylineDistance, IsEuclideanOnPlanesOfCaps) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const auto small = [&] { return std::pow(10.0, -random.uniform(1, 14)); };
    const TestMesh mesh = plane_with_bad_triangles(random, true, small);
    const Surface surface = test::surface_of(mesh);
    expect_plane_distances(mesh, surface, random_walk(random, surface, 20), random, 1e-6);
  }
}

TEST(PolylineDistance, IsEuclideanOnPlanesOfNeedles) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const auto small = [&] { return std::pow(10.0, -random.uniform(1, 5)); };
    const TestMesh mesh = plane_with_bad_triangles(random, false, small);
    const Surface surface = test::surface_of(mesh);
    expect_plane_distances(mesh, surface, random_walk(random, surface, 20), random, 1e-6);
  }
}

TEST(PolylineDistance, IsEuclideanOnPlanesWithFacesOfNoArea) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const bool caps = seed % 2 == 0;
    const TestMesh mesh = plane_with_bad_triangles(random, caps, [] { return 0.0; });
    const Surface surface = test::surface_of(mesh);
    expect_plane_distances(mesh, surface, random_walk(random, surface, 20), random, 1e-6);
  }
}

TEST(PolylineDistance, PassesEdgesOfNoLength) {
  TestMesh mesh = test::grid(9, 9, 0.2, 3);
  for (const std::size_t v : {33UL, 35UL, 56UL, 74UL}) mesh.points[v + 1] = mesh.points[v];
  mesh.points[44] = mesh.points[34];
  const Surface surface = test::surface_of(mesh);
  Random random(3);
  const SurfaceCurve curve = through_vertices(surface, {11, 22, 23, 33, 34, 44, 54, 64});
  expect_plane_distances(mesh, surface, curve, random, 1e-7);
}

/// The straight line through (x, y) in the direction `angle`, from edge to edge of a plane mesh.
SurfaceCurve straight_line(const TestMesh& mesh, const Surface& surface, Point through,
                           double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  std::vector<std::pair<double, SurfacePoint>> crossed;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    const auto height = [&](VertexId v) {
      const Point& p = mesh.points[v.index()];
      return c * (p[1] - through[1]) - s * (p[0] - through[0]);
    };
    const double a = height(surface.tail(h)), b = height(surface.head(h));
    if (!(a * b < 0)) continue;
    const SurfacePoint at = SurfacePoint::on_edge(surface, EdgeId{e}, a / (a - b));
    const Point x = position_on(mesh, surface, at);
    crossed.emplace_back(c * (x[0] - through[0]) + s * (x[1] - through[1]), at);
  }
  std::sort(crossed.begin(), crossed.end(),
            [](const auto& p, const auto& q) { return p.first < q.first; });
  SurfaceCurve line;
  for (const auto& [along, at] : crossed) line.points.push_back(at);
  return line;
}

/// Rotates a plane mesh about the origin, so that its edge lengths are rounded.
TestMesh turned(TestMesh mesh, double angle) {
  for (Point& p : mesh.points) {
    p = {std::cos(angle) * p[0] - std::sin(angle) * p[1],
         std::sin(angle) * p[0] + std::cos(angle) * p[1], p[2]};
  }
  return mesh;
}

// The lines cross the upright edges of the grid almost at right angles. The window of a segment on
// an upright edge is then almost empty, or its source is far outside the face.
TEST(PolylineDistance, IsEuclideanNextToLinesThatAreAlmostPerpendicularToEdges) {
  const TestMesh flat = test::grid(30, 20);
  const double angles[] = {0, 1e-17, 1e-16, 1e-15, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6};
  for (const double turn : {0.0, 0.3, 1.1}) {
    const TestMesh mesh = turned(flat, turn);
    const Surface surface = test::surface_of(mesh);
    PolylineDistance distance(surface);
    for (const double upright : {0.0, test::kPi / 2}) {
      for (const double angle : angles) {
        for (const double gap : {0.05, 0.35, 1.0, 3.3}) {
          const double shift = 6.2 + gap;
          const SurfaceCurve lines[] = {
              straight_line(flat, surface, {6.2, 6.2, 0}, upright + angle),
              straight_line(flat, surface, {shift, shift, 0}, upright - angle)};
          distance.set(lines);
          std::vector<std::vector<Point>> at;
          for (const auto& line : lines) at.push_back(positions(flat, surface, line));
          for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
            const Point& x = flat.points[v];
            const double expected = std::min(to_polyline(x, at[0]), to_polyline(x, at[1]));
            ASSERT_NEAR(distance.at_vertex(VertexId{v}).distance, expected, kExact)
                << v << " turn " << turn << " angle " << angle << " gap " << gap;
          }
        }
      }
    }
  }
}

TEST(PolylineDistance, IsExactlyZeroOnTheCurve) {
  Random random(5);
  const Surface surface = test::surface_of(test::sphere(3));
  const SurfaceCurve curve = random_walk(random, surface, 40);
  PolylineDistance distance(surface);
  distance.set({&curve, 1});
  for (const SurfacePoint& p : curve.points) EXPECT_EQ(distance.at(p).distance, 0);
}

// A box of 6 x 6 x 6 unit cubes: unfolded over an edge it is a plane strip.
TEST(PolylineDistance, UnfoldsOverABoxEdge) {
  const TestMesh mesh = test::box(6, 6, 6);
  const Surface surface = test::surface_of(mesh);
  const auto vertex = [&](double x, double y, double z) {
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      if (mesh.points[v] == Point{x, y, z}) return v;
    }
    return std::size_t{0};
  };
  // On the top, a curve at x = 4 from y = 2 to y = 4.
  const SurfaceCurve curve =
      through_vertices(surface, {vertex(4, 2, 6), vertex(4, 3, 6), vertex(4, 4, 6)});
  PolylineDistance distance(surface);
  distance.set({&curve, 1});
  for (const double y : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}) {
    for (const double down : {1.0, 2.0, 3.0}) {
      const double across = std::max({2 - y, 0.0, y - 4});
      // Near the corner of the box the way over the side y = 0 or y = 6 may be shorter.
      const double expected = std::hypot(2 + down, across);
      const double got = distance.at_vertex(VertexId{vertex(6, y, 6 - down)}).distance;
      if (y >= 1 && y <= 5) {
        EXPECT_NEAR(got, expected, kExact) << y << " " << down;
      }
      EXPECT_LE(got, expected + kExact);
    }
  }
}

// On a cone the shortest path between two points is straight in the unrolled sector if the angle
// between the points is less than pi.
TEST(PolylineDistance, UnrollsACone) {
  const std::size_t n = 40, m = 10;
  const TestMesh mesh = test::cone(n, m, 1, 1.5);
  const Surface surface = test::surface_of(mesh);
  const double slant = test::distance(mesh.points[0], mesh.points[n * m]);
  const double step = 2 * std::asin(test::distance(mesh.points[0], mesh.points[1]) / (2 * slant));
  const SurfaceCurve curve = through_vertices(surface, {4 * n});
  PolylineDistance distance(surface);
  distance.set({&curve, 1});
  const double r0 = slant * 6 / 10;
  for (std::size_t ring = 0; ring < m; ++ring) {
    const double r = slant * (1 - static_cast<double>(ring) / m);
    for (std::size_t k = 0; k <= n / 2; ++k) {
      const double angle = step * static_cast<double>(k);
      ASSERT_LT(angle, test::kPi);
      // Paths that touch the outer rim of the mesh would leave it, so only chords of the polygon
      // are compared.
      const double chord = std::sqrt(r * r + r0 * r0 - 2 * r * r0 * std::cos(angle));
      EXPECT_NEAR(distance.at_vertex(VertexId{ring * n + k}).distance, chord, kExact);
    }
  }
}

TEST(PolylineDistance, BendsAroundTheCornersOfAHole) {
  // Cells 3..6 x 3..6 of 10 x 10 are missing; corners of the hole at 3 and 7.
  const TestMesh mesh = test::grid_without(
      10, 10, [](std::size_t i, std::size_t j) { return i >= 3 && i < 7 && j >= 3 && j < 7; });
  const Surface surface = test::surface_of(mesh);
  const auto id = [](std::size_t i, std::size_t j) { return i + 11 * j; };
  const SurfaceCurve curve = through_vertices(surface, {id(1, 5), id(1, 4), id(1, 3)});
  PolylineDistance distance(surface);
  distance.set({&curve, 1});
  // Behind the hole: paths from (1, 3) past the corners (3, 3) and (7, 3).
  EXPECT_NEAR(distance.at_vertex(VertexId{id(9, 4)}).distance, 6 + std::sqrt(5.0), kExact);
  EXPECT_NEAR(distance.at_vertex(VertexId{id(7, 4)}).distance, 7, kExact);
  // A path from (1, 5) past (3, 7).
  EXPECT_NEAR(distance.at_vertex(VertexId{id(4, 7)}).distance, 1 + std::hypot(2, 2), kExact);
  EXPECT_NEAR(distance.at_vertex(VertexId{id(3, 5)}).distance, 2, kExact);
}

TEST(PolylineDistance, BendsAtSaddles) {
  // Two boxes in an L: the ends of the inner edge are saddles of 5/4 turns.
  const TestMesh mesh = test::voxels(4, 4, 4, [](int i, int, int k) { return i < 2 || k < 2; });
  const Surface surface = test::surface_of(mesh);
  // Subdivision changes nothing, and the distance grows by no more than the way.
  const SurfaceCurve curve = through_vertices(surface, {0});
  PolylineDistance distance(surface);
  distance.set({&curve, 1});
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    const double a = distance.at_vertex(surface.tail(h)).distance;
    const double b = distance.at_vertex(surface.head(h)).distance;
    EXPECT_LE(std::abs(a - b), surface.length(EdgeId{e}) + kExact);
  }
}

/// A mesh with each triangle split in four at the midpoints of its edges. Curves get the midpoints,
/// too.
struct Refined {
  TestMesh mesh;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
};
Refined refine(const TestMesh& coarse) {
  Refined fine{{coarse.points, {}}, {}};
  const auto mid = [&](std::uint32_t a, std::uint32_t b) {
    const auto [it, fresh] = fine.middle.try_emplace(
        {std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(fine.mesh.points.size()));
    if (fresh) {
      Point p{};
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] = (coarse.points[a][k] + coarse.points[b][k]) / 2;
      }
      fine.mesh.points.push_back(p);
    }
    return it->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const std::uint32_t ab = mid(a, b), bc = mid(b, c), ca = mid(c, a);
    auto& t = fine.mesh.triangles;
    t.insert(t.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return fine;
}

TEST(PolylineDistance, DependsOnTheSurfaceAndNotOnItsTriangles) {
  const TestMesh meshes[] = {
      test::torus(24, 12, 3, 1), test::sphere(3), test::double_torus(2),
      test::voxels(4, 4, 4, [](int i, int, int k) { return i < 2 || k < 2; })};
  for (const TestMesh& mesh : meshes) {
    const Surface coarse = test::surface_of(mesh);
    const Refined refined = refine(mesh);
    const Surface fine = test::surface_of(refined.mesh);
    Random random(11);
    std::vector<std::size_t> path = {random.below(coarse.vertex_count())};
    while (path.size() < 15) {
      HalfedgeId h = coarse.halfedge(VertexId{path.back()});
      for (std::size_t turns = random.below(6); turns-- > 0;) h = coarse.turn_ccw(h);
      path.push_back(coarse.head(h).index());
    }
    const SurfaceCurve on_coarse = through_vertices(coarse, path);
    std::vector<std::size_t> longer = {path[0]};
    for (std::size_t i = 1; i < path.size(); ++i) {
      const auto a = static_cast<std::uint32_t>(path[i - 1]);
      const auto b = static_cast<std::uint32_t>(path[i]);
      longer.push_back(refined.middle.at({std::min(a, b), std::max(a, b)}));
      longer.push_back(b);
    }
    const SurfaceCurve on_fine = through_vertices(fine, longer);
    PolylineDistance a(coarse), b(fine);
    a.set({&on_coarse, 1});
    b.set({&on_fine, 1});
    for (std::size_t v = 0; v < coarse.vertex_count(); ++v) {
      const auto p = a.at_vertex(VertexId{v}), q = b.at_vertex(VertexId{v});
      ASSERT_NEAR(p.distance, q.distance, kExact);
    }
    for (const auto& [ends, v] : refined.middle) {
      const HalfedgeId h = coarse.find_halfedge(VertexId{ends.first}, VertexId{ends.second});
      ASSERT_NEAR(a.on_edge(edge_of(h), 0.5).distance, b.at_vertex(VertexId{v}).distance, kExact);
    }
  }
}

TEST(PolylineDistance, FaceValuesCarryTheirSlopes) {
  const Surface surface = test::surface_of(test::torus(24, 12, 3, 1));
  Random random(5);
  const SurfaceCurve curve = random_walk(random, surface, 12);
  PolylineDistance distance(surface);
  distance.set({&curve, 1});
  int smooth = 0;
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const FaceId face{f};
    const FaceFrame frame(surface, face);
    const double a = random.uniform(0.1, 0.4), b = random.uniform(0.1, 0.4), step = 1e-4;
    const PolylineDistance::Barycentric here{a, b, 1 - a - b};
    const double angle = random.uniform(0, 6);
    const PlanePoint direction{std::cos(angle), std::sin(angle)};
    const auto moved = [&](double s) {
      PolylineDistance::Barycentric p = here;
      for (std::size_t k = 0; k < 3; ++k) p[k] += s * frame.rates(direction)[k];
      return distance.at_face(face, p, direction);
    };
    const auto at = moved(0), low = moved(-step), high = moved(step);
    const auto nearest = distance.at(SurfacePoint::in_face(surface, face, here));
    EXPECT_EQ(at.value, nearest.distance);
    EXPECT_EQ(at.arc_length, nearest.arc_length);
    // The slopes jump where the nearest part of the curve changes.
    if (std::abs(high.slope - low.slope) > 100 * step) continue;
    if (std::abs(high.arc_slope - low.arc_slope) > 1e-6) continue;
    ++smooth;
    EXPECT_NEAR((high.value - low.value) / (2 * step), at.slope, 1e-3);
    EXPECT_NEAR((high.arc_length - low.arc_length) / (2 * step), at.arc_slope, 1e-6);
  }
  EXPECT_GT(smooth, static_cast<int>(surface.face_count() * 9 / 10));
}

TEST(PolylineDistance, BelowALimitIsTheDistanceOrInfinity) {
  const Surface surface = test::surface_of(test::torus(24, 12, 3, 1));
  Random random(6);
  const SurfaceCurve curve = random_walk(random, surface, 4);
  PolylineDistance all(surface), near(surface);
  all.set({&curve, 1});
  near.set({&curve, 1});
  int found = 0;
  for (int k = 0; k < 300; ++k) {
    const SurfacePoint point = random_point(random, surface);
    const double exact = all.at(point).distance, below = near.below(1.5, point);
    EXPECT_EQ(below, exact < 1.5 ? exact : kInfinity);
    found += exact < 1.5 ? 1 : 0;
  }
  EXPECT_GT(found, 20);
  EXPECT_LT(near.window_count(), all.window_count());
}

TEST(PolylineDistance, AnswersDoNotDependOnTheOrderOfQuestions) {
  const Surface surface = test::surface_of(test::torus(30, 14, 3, 1));
  Random random(8);
  const SurfaceCurve curves[] = {random_walk(random, surface, 12),
                                 random_walk(random, surface, 30)};
  const SurfaceCurve other = random_walk(random, surface, 50);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 1500; ++i) points.push_back(random_point(random, surface));

  PolylineDistance first(surface), second(surface);
  first.set(curves);
  second.set({&other, 1});
  second.at_vertex(VertexId{17});
  second.set(curves);
  std::vector<PolylineDistance::Nearest> answers;
  for (const SurfacePoint& p : points) answers.push_back(first.at(p));
  // Points in order of their distance: each query marches as little as possible.
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return answers[a].distance < answers[b].distance;
  });
  for (const std::size_t i : order) {
    const auto again = second.at(points[i]);
    EXPECT_EQ(again.distance, answers[i].distance);
    EXPECT_EQ(again.curve, answers[i].curve);
    EXPECT_EQ(again.arc_length, answers[i].arc_length);
  }
}

TEST(PolylineDistance, RoughlyIsExactNearbyAndAWayAlongEdgesBeyond) {
  const Surface surface = test::surface_of(test::torus(60, 28, 3, 1));
  Random random(13);
  const SurfaceCurve curve = random_walk(random, surface, 20);
  PolylineDistance rough(surface), late(surface), exact(surface);
  rough.set({&curve, 1});
  late.set({&curve, 1});
  late.reach(100);
  exact.set({&curve, 1});
  constexpr double kNear = 0.7, kFar = 1.5;
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < surface.vertex_count(); ++i) {
    const VertexId v{i};
    const double distance = exact.at_vertex(v).distance;
    const auto about = rough.at_vertex_bounded(v, kNear);
    const auto again = late.at_vertex_bounded(v, kNear);  // after a longer march
    EXPECT_EQ(about.distance, again.distance);
    EXPECT_EQ(about.arc_length, again.arc_length);
    EXPECT_EQ(about.distance, rough.at_vertex_bounded(v, kNear).distance);
    if (distance <= kNear) {
      EXPECT_EQ(about.distance, distance);
      continue;
    }
    EXPECT_GE(about.distance, distance);
    // At most the distance of any neighbour plus the edge to it.
    const HalfedgeId first = surface.halfedge(v);
    HalfedgeId h = first;
    do {
      const double way = rough.at_vertex_bounded(surface.head(h), kNear).distance;
      if (distance < kFar) {
        EXPECT_LE(about.distance, (way + surface.length(edge_of(h))) * (1 + kExact));
      }
      h = surface.turn_ccw(h);
    } while (h != first);
    ++beyond;
  }
  EXPECT_GT(beyond, 100U);
}

/// Distances along edges, by relaxation until nothing changes. Distances up to `exact` are given.
std::vector<double> along_edges(const Surface& surface, std::vector<double> known, double exact) {
  for (double& d : known) d = d <= exact ? d : std::numeric_limits<double>::infinity();
  for (bool again = true; again;) {
    again = false;
    for (std::size_t h = 0; h < 2 * surface.edge_count(); ++h) {
      const double way =
          known[surface.tail(HalfedgeId{h}).index()] + surface.length(edge_of(HalfedgeId{h}));
      double& head = known[surface.head(HalfedgeId{h}).index()];
      if (!(way < head * (1 - kExact))) continue;
      head = way;
      again = true;
    }
  }
  return known;
}

/// Exact distances cost minutes if thousands of needles lie in between (in a model of buildings one
/// flip took 19 minutes).
TEST(PolylineDistance, RoughlyIsAWayAlongEdgesHoweverFar) {
  const Surface surface = test::surface_of(test::torus(60, 28, 3, 1));
  Random random(14);
  const SurfaceCurve curve = random_walk(random, surface, 5);
  PolylineDistance rough(surface), exact(surface);
  exact.set({&curve, 1});
  std::vector<double> distances;
  for (std::size_t i = 0; i < surface.vertex_count(); ++i) {
    distances.push_back(exact.at_vertex(VertexId{i}).distance);
  }
  for (const double near : {0.3, 0.7}) {
    rough.set({&curve, 1});
    const std::vector<double> expected = along_edges(surface, distances, near);
    for (std::size_t i = 0; i < surface.vertex_count(); ++i) {
      const VertexId v{(i * 997) % surface.vertex_count()};  // far and near vertices alternate
      EXPECT_NEAR(rough.at_vertex_bounded(v, near).distance, expected[v.index()], 1e-9);
    }
    EXPECT_LT(4 * rough.window_count(), exact.window_count());
  }
}

TEST(PolylineDistance, RoughlyNeedsNoWideBand) {
  const Surface surface = test::surface_of(test::grid(200, 200, 0.2));
  const SurfaceCurve curve = through_vertices(surface, {100 + 201 * 100, 101 + 201 * 100});
  PolylineDistance rough(surface), exact(surface);
  rough.set({&curve, 1});
  exact.set({&curve, 1});
  const VertexId away{100 + 201 * 104};
  EXPECT_GE(rough.at_vertex_bounded(away, 1.5).distance, exact.at_vertex(away).distance);
  EXPECT_LT(2 * rough.window_count(), exact.window_count());
}

TEST(PolylineDistance, ScalesWithTheSurface) {
  TestMesh mesh = test::torus(24, 12, 3, 1);
  Random random(9);
  const Surface surface = test::surface_of(mesh);
  const SurfaceCurve curve = random_walk(random, surface, 20);
  for (Point& p : mesh.points) {
    for (double& x : p) x *= 0x1p-40;
  }
  const Surface small = test::surface_of(mesh);
  PolylineDistance a(surface), b(small);
  a.set({&curve, 1});
  b.set({&curve, 1});
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
    EXPECT_EQ(a.at_vertex(VertexId{v}).distance * 0x1p-40, b.at_vertex(VertexId{v}).distance);
  }
}

TEST(PolylineDistance, IsInfiniteWhereThereIsNoCurve) {
  TestMesh mesh = test::grid(3, 3);
  const auto n = static_cast<std::uint32_t>(mesh.points.size());
  const std::size_t faces = mesh.triangles.size();
  for (std::size_t i = 0; i < faces; ++i) {
    const Triangle t = mesh.triangles[i];
    mesh.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  for (std::size_t v = 0; v < n; ++v) mesh.points.push_back(mesh.points[v]);
  mesh.points.push_back({0, 0, 0});  // isolated
  const Surface surface = test::surface_of(mesh);
  PolylineDistance distance(surface);
  EXPECT_EQ(distance.at_vertex(VertexId{0}).distance, kInfinity);
  const SurfaceCurve curve = through_vertices(surface, {0, 1});
  distance.set({&curve, 1});
  EXPECT_DOUBLE_EQ(distance.at_vertex(VertexId{3}).distance, 2);
  EXPECT_EQ(distance.at_vertex(VertexId{n}).distance, kInfinity);
  EXPECT_EQ(distance.at_vertex(VertexId{2 * n}).distance, kInfinity);
  EXPECT_EQ(distance.at(SurfacePoint::in_face(surface, FaceId{faces}, {0.2, 0.3, 0.5})).distance,
            kInfinity);
  const SurfaceCurve lone = through_vertices(surface, {2 * n});
  distance.set({&lone, 1});
  EXPECT_EQ(distance.at_vertex(VertexId{2 * n}).distance, 0);
  EXPECT_EQ(distance.at_vertex(VertexId{0}).distance, kInfinity);
  distance.set({});
  EXPECT_EQ(distance.at_vertex(VertexId{0}).distance, kInfinity);
}

TEST(PolylineDistance, BelowDoesNotSearchComponentsWithoutACurve) {
  TestMesh mesh = test::grid(40, 40);
  const auto n = static_cast<std::uint32_t>(mesh.points.size());
  for (std::size_t v = 0; v < n; ++v) mesh.points.push_back(mesh.points[v]);
  for (std::size_t i = 0, faces = mesh.triangles.size(); i < faces; ++i) {
    const Triangle t = mesh.triangles[i];
    mesh.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  const Surface surface = test::surface_of(mesh);
  const SurfaceCurve curve = through_vertices(surface, {0, 1});
  PolylineDistance distance(surface);
  const SurfacePoint elsewhere[] = {
      SurfacePoint::at_vertex(surface, VertexId{n}),
      SurfacePoint::on_edge(surface, EdgeId{surface.edge_count() - 1}, 0.3),
      SurfacePoint::in_face(surface, FaceId{surface.face_count() - 1}, {0.2, 0.3, 0.5})};
  for (const SurfacePoint& point : elsewhere) {
    distance.set({&curve, 1});
    EXPECT_EQ(distance.below(1000, point), kInfinity);
    const std::size_t in_vain = distance.window_count();
    distance.reach(1000);
    EXPECT_LT(3 * in_vain, distance.window_count());
  }
}

TEST(PolylineDistance, NamesTheNearestOfSeveralCurves) {
  const Surface surface = test::surface_of(test::grid(10, 4));
  const auto id = [](std::size_t i, std::size_t j) { return i + 11 * j; };
  const SurfaceCurve curves[] = {
      through_vertices(surface, {id(1, 0), id(1, 1), id(1, 2), id(1, 3), id(1, 4)}),
      through_vertices(surface, {id(8, 1), id(9, 1), id(9, 2), id(8, 2)}, true)};
  PolylineDistance distance(surface);
  distance.set(curves);
  EXPECT_EQ(distance.curve_length(0), 4);
  EXPECT_EQ(distance.curve_length(1), 4);
  const auto near_first = distance.at_vertex(VertexId{id(3, 3)});
  EXPECT_EQ(near_first.curve, 0U);
  EXPECT_NEAR(near_first.distance, 2, kExact);
  EXPECT_NEAR(near_first.arc_length, 3, kExact);
  const auto near_second = distance.at_vertex(VertexId{id(9, 4)});
  EXPECT_EQ(near_second.curve, 1U);
  EXPECT_NEAR(near_second.distance, 2, kExact);
  EXPECT_NEAR(near_second.arc_length, 2, kExact);
  // Nearest to the closing segment, from (8, 2) to (8, 1), arc length 3 to 4.
  const auto closing =
      distance.on_edge(edge_of(surface.find_halfedge(VertexId{id(7, 1)}, VertexId{id(7, 2)})), 0.5);
  EXPECT_NEAR(closing.distance, 1, kExact);
  EXPECT_NEAR(closing.arc_length, 3.5, kExact);
}

TEST(PolylineDistance, KnowsTheArcLengthOfItsPoints) {
  const Surface surface = test::surface_of(test::grid(10, 4));
  const SurfaceCurve curves[] = {through_vertices(surface, {1, 2, 3, 4}),
                                 through_vertices(surface, {6, 7, 18, 17}, true)};
  PolylineDistance distance(surface);
  distance.set(curves);
  for (std::size_t c = 0; c < 2; ++c) {
    const auto arcs = distance.point_arcs(c);
    EXPECT_EQ(std::vector<double>(arcs.begin(), arcs.end()), (std::vector<double>{0, 1, 2, 3}));
  }
}

TEST(PolylineDistance, CostDependsOnTheTouchedPart) {
  const Surface surface = test::surface_of(test::grid(200, 200, 0.2));
  const SurfaceCurve curve = through_vertices(surface, {100 + 201 * 100, 101 + 201 * 100});
  PolylineDistance distance(surface);
  distance.set({&curve, 1});
  EXPECT_GT(distance.on_edge(edge_of(surface.halfedge(VertexId{100 + 201 * 102})), 0.5).distance,
            1);
  EXPECT_LT(distance.window_count(), 1000U);
}

TEST(PolylineDistance, RejectsInvalidCurves) {
  const Surface surface = test::surface_of(test::grid(3, 3));
  PolylineDistance distance(surface);
  SurfaceCurve curve = through_vertices(surface, {0, 1, 2});
  distance.set({&curve, 1});
  const SurfaceCurve empty;
  EXPECT_THROW(distance.set({&empty, 1}), Error);
  const SurfaceCurve apart = through_vertices(surface, {0, 2});
  EXPECT_THROW(distance.set({&apart, 1}), Error);
  // A curve that is refused leaves the distance unchanged.
  EXPECT_DOUBLE_EQ(distance.at_vertex(VertexId{3}).distance, 1);
}

}  // namespace
}  // namespace talweg
