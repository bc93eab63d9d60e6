#include "talweg/core/lifting/relaxation.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/reference_data.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::between;
using test::grid;

double t_of(const SurfacePoint& p) { return std::get<OnEdge>(p.where()).t; }

double length_in_space(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  const auto points = positions_of(mesh, curve);
  double length = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) length += (points[i + 1] - points[i]).norm();
  if (curve.closed) length += (points.front() - points.back()).norm();
  return length;
}

/// A curve across a strip of unit squares from (0, 1/2) to (columns, 1/2), over the upright edges
/// and the diagonals, at the given heights.
SurfaceCurve across(const Surface& surface, std::uint32_t columns,
                    const std::vector<double>& height) {
  SurfaceCurve curve{false, {}};
  const std::uint32_t up = columns + 1;
  for (std::uint32_t k = 0; k < 2 * columns + 1; ++k) {
    const std::uint32_t a = k / 2;
    curve.points.push_back(between(surface, a, k % 2 == 0 ? a + up : a + up + 1, height[k]));
  }
  return curve;
}

std::vector<double> zigzag(std::uint32_t columns) {
  std::vector<double> height(2 * columns + 1, 0.5);
  for (std::size_t k = 1; k + 1 < height.size(); ++k) height[k] = k % 2 == 0 ? 0.35 : 0.65;
  return height;
}

TEST(Relaxation, StraightLinesStay) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(6, 1));
  // y = 1/4 + x / 12 meets the diagonal of square a at x = a + s, y = s.
  std::vector<double> height;
  for (int k = 0; k <= 12; ++k) {
    const double a = k / 2;
    height.push_back(k % 2 == 0 ? 0.25 + a / 12 : (0.25 + a / 12) / (1 - 1.0 / 12));
  }
  SurfaceCurve curve = across(mesh.surface(), 6, height);
  ASSERT_NEAR(measure_curve(mesh.surface(), curve).total_curvature, 0, 1e-13);
  relax(mesh, curve, {.rounds = 50});
  for (std::size_t k = 0; k < height.size(); ++k) {
    EXPECT_NEAR(t_of(curve.points[k]), t_of(across(mesh.surface(), 6, height).points[k]), 1e-13);
  }
}

TEST(Relaxation, StraightLinesAcrossABentEdgeStay) {
  MeshLists lists = grid(2, 1);
  for (Point& p : lists.points) {
    if (p.x() > 1.5) p = Point(1, p.y(), 1);
  }
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  // y = 0.3 + 0.2 x unfolded.
  const std::vector<double> height{0.3, 0.3 / 0.8, 0.5, 0.5 / 0.8, 0.7};
  SurfaceCurve curve = across(mesh.surface(), 2, height);
  const SurfaceCurve before = curve;
  relax(mesh, curve);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(t_of(curve.points[k]), t_of(before.points[k]), 1e-14);
  }
}

TEST(Relaxation, FixedPointsStay) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(6, 1));
  SurfaceCurve curve = across(mesh.surface(), 6, zigzag(6));
  const SurfaceCurve before = curve;
  const std::vector<SurfacePoint> fixed{curve.points[3], curve.points[8]};
  relax(mesh, curve, {.rounds = 20, .fixed = fixed});
  for (const std::size_t i : {std::size_t{3}, std::size_t{8}}) {
    EXPECT_EQ(curve.points[i], before.points[i]);
  }
  EXPECT_GT(std::abs(t_of(curve.points[5]) - t_of(before.points[5])), 0.05);
}

TEST(Relaxation, ZigzagsBecomeStraight) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(6, 1));
  SurfaceCurve curve = across(mesh.surface(), 6, zigzag(6));
  const CurveMeasures before = measure_curve(mesh.surface(), curve);
  relax(mesh, curve);
  const CurveMeasures after = measure_curve(mesh.surface(), curve);
  EXPECT_LT(after.total_curvature, 0.1 * before.total_curvature);
  EXPECT_LT(after.length, before.length);
  // The limit is the straight line between the fixed ends.
  relax(mesh, curve, {.rounds = 3000});
  EXPECT_NEAR(measure_curve(mesh.surface(), curve).length, 6, 1e-9);
  EXPECT_EQ(curve.points.front(), across(mesh.surface(), 6, zigzag(6)).points.front());
  EXPECT_EQ(curve.points.back(), across(mesh.surface(), 6, zigzag(6)).points.back());
}

TEST(Relaxation, LengthNeverGrowsAndPointsStayOnTheirEdges) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::sphere(3));
  const Surface& surface = mesh.surface();
  // A closed curve around the sphere through all faces that the plane x + 2y + 3z = 0.4 meets.
  SurfaceCurve curve{true, {}};
  const auto side = [&](VertexId v) { return mesh.point(v).dot(Point(1, 2, 3)) - 0.4; };
  HalfedgeId h{0};
  while (!(side(surface.tail(h)) > 0 && side(surface.head(h)) <= 0)) h = HalfedgeId{h.index() + 1};
  const HalfedgeId first = h;
  std::size_t k = 0;
  do {
    const double t = 0.5 + 0.45 * std::sin(7.0 * static_cast<double>(k++));
    curve.points.push_back(SurfacePoint::on_edge(surface, edge_of(h), t));
    const HalfedgeId next = surface.next(h);
    h = twin(side(surface.head(next)) > 0 ? next : surface.prev(h));
  } while (h != first);
  ASSERT_GT(curve.points.size(), 20U);

  const SurfaceCurve drawn = curve;
  double length = length_in_space(mesh, curve);
  for (int round = 0; round < 200; ++round) {
    relax(mesh, curve, {.rounds = 1});
    const double now = length_in_space(mesh, curve);
    EXPECT_LE(now, length * (1 + 1e-14)) << round;
    length = now;
  }
  for (std::size_t i = 0; i < drawn.points.size(); ++i) {
    EXPECT_EQ(std::get<OnEdge>(curve.points[i].where()).edge,
              std::get<OnEdge>(drawn.points[i].where()).edge);
    EXPECT_GT(t_of(curve.points[i]), 0);
    EXPECT_LT(t_of(curve.points[i]), 1);
  }
  EXPECT_LT(length, 0.9 * length_in_space(mesh, drawn));

  // The direction and the first point of the curve do not matter.
  SurfaceCurve other = drawn;
  std::reverse(other.points.begin(), other.points.end());
  std::rotate(other.points.begin(), other.points.begin() + 5, other.points.end());
  relax(mesh, other);
  std::rotate(other.points.rbegin(), other.points.rbegin() + 5, other.points.rend());
  std::reverse(other.points.begin(), other.points.end());
  curve = drawn;
  relax(mesh, curve);
  for (std::size_t i = 0; i < drawn.points.size(); ++i) {
    EXPECT_NEAR(t_of(other.points[i]), t_of(curve.points[i]), 1e-13);
  }
}

TEST(Relaxation, VerticesFacesAndEndsStay) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(3, 1));
  const Surface& s = mesh.surface();
  SurfaceCurve curve{
      false,
      {between(s, 0, 4, 0.2), SurfacePoint::in_face(s, FaceId{1}, {0.2, 0.3, 0.5}),
       between(s, 0, 5, 0.9), SurfacePoint::at_vertex(s, VertexId{1}), between(s, 2, 6, 0.4)}};
  const SurfaceCurve before = curve;
  relax(mesh, curve);
  for (const std::size_t k : {0U, 1U, 3U, 4U}) EXPECT_EQ(curve.points[k], before.points[k]);
  EXPECT_NE(curve.points[2], before.points[2]);
}

TEST(Relaxation, PointsOfOneEdgeKeepTheirOrder) {
  // Two passages of the edge 1 - 4 in opposite directions that pull towards each other.
  const SurfaceMesh mesh = SurfaceMesh::open(grid(2, 1));
  const Surface& s = mesh.surface();
  SurfaceCurve curve{
      false,
      {SurfacePoint::at_vertex(s, VertexId{0}), between(s, 1, 4, 0.8), between(s, 1, 5, 0.5),
       between(s, 1, 4, 0.2), SurfacePoint::at_vertex(s, VertexId{4})}};
  relax(mesh, curve, {.rounds = 100});
  const auto points = positions_of(mesh, curve);
  EXPECT_GT(points[1].y(), points[3].y());
}

TEST(Relaxation, CurvesOfASetDoNotCross) {
  // Two curves along a strip, one close above the other; both straighten.
  const SurfaceMesh mesh = SurfaceMesh::open(grid(6, 1));
  std::vector<double> low(13, 0.3);
  std::vector<double> high(13, 0.7);
  low.front() = low.back() = 0.6;
  high.front() = high.back() = 0.61;
  for (std::size_t k = 4; k < 9; ++k) high[k] = 0.31;
  std::vector<SurfaceCurve> curves{across(mesh.surface(), 6, low), across(mesh.surface(), 6, high)};
  relax(mesh, curves, {.rounds = 500});
  const auto below = positions_of(mesh, curves[0]);
  const auto above = positions_of(mesh, curves[1]);
  for (std::size_t k = 0; k < below.size(); ++k) EXPECT_LT(below[k].y(), above[k].y()) << k;
}

TEST(Relaxation, NothingToDoAndBadOptions) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(2, 1));
  SurfaceCurve curve{true, {between(mesh.surface(), 1, 4, 0.8)}};
  const SurfaceCurve before = curve;
  relax(mesh, curve);
  EXPECT_EQ(curve.points, before.points);
  curve.points.clear();
  relax(mesh, curve);
  EXPECT_THROW(relax(mesh, curve, {.rounds = -1}), Error);
}

TEST(Relaxation, ScaleAndPositionDoNotMatter) {
  MeshLists lists = grid(6, 1);
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  SurfaceCurve curve = across(mesh.surface(), 6, zigzag(6));
  const SurfaceCurve before = curve;
  relax(mesh, curve);
  for (const double scale : {1e-8, 1e8}) {
    MeshLists moved = lists;
    for (Point& p : moved.points) p = scale * (p + Point(3, 4, 5));
    SurfaceCurve same = before;
    relax(SurfaceMesh::open(moved), same);
    for (std::size_t k = 0; k < curve.points.size(); ++k) {
      EXPECT_NEAR(t_of(same.points[k]), t_of(curve.points[k]), 1e-13);
    }
  }
}

TEST(Relaxation, SmoothsTheReferenceResults) {
  for (const char* name : {"fandisk_14k", "aneurysm_14k"}) {
    const auto drawn = test::reference_curve(name);
    if (!drawn) GTEST_SKIP() << test::missing(name);
    double moved = 0;
    SurfaceCurve curve = test::reference_result_curve(*drawn, name, moved);
    const Surface& surface = drawn->mesh.surface();
    const CurveMeasures before = measure_curve(surface, curve);
    relax(drawn->mesh, curve);
    const CurveMeasures after = measure_curve(surface, curve);
    EXPECT_LT(after.total_curvature, before.total_curvature) << name;
    EXPECT_LT(after.length, before.length) << name;
  }
}

}  // namespace
}  // namespace talweg
