#include "talweg/core/smoothing/corridor_width.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/strokes/stroke_slack.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::grid;

constexpr std::uint32_t kColumns = 60;

constexpr double kTiny = 1e-12;  // relative: some hundred sums of lengths

VertexId at(std::uint32_t i, std::uint32_t j) { return VertexId{j * (kColumns + 1) + i}; }

struct Scale {
  double slack, length;
};

Scale scale_of(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  return {slack_of_segments(mesh.surface(), curve), corridor_length(mesh, curve)};
}

void expect_same(const Scale& a, const Scale& b, double factor = 1) {
  EXPECT_NEAR(a.slack * factor, b.slack, kTiny * b.slack);
  EXPECT_NEAR(a.length * factor, b.length, kTiny * b.length);
}

SurfaceCurve rectangle(const Surface& surface, std::uint32_t a, std::uint32_t b) {
  const VertexId corners[] = {at(2, 2), at(2 + a, 2), at(2 + a, 2 + b), at(2, 2 + b)};
  std::vector<VertexId> path;
  for (std::uint32_t i = 0; i < a; ++i) path.push_back(at(2 + i, 2));
  for (std::uint32_t j = 0; j < b; ++j) path.push_back(at(2 + a, 2 + j));
  for (std::uint32_t i = 0; i < a; ++i) path.push_back(at(2 + a - i, 2 + b));
  for (std::uint32_t j = 0; j < b; ++j) path.push_back(at(2, 2 + b - j));
  EXPECT_EQ(path.front(), corners[0]);
  return test::vertex_curve(surface, path, true);
}

SurfaceCurve with_middles(const Surface& surface, const SurfaceCurve& curve) {
  SurfaceCurve finer{curve.closed, {}};
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    finer.points.push_back(curve.points[i]);
    if (i + 1 == n && !curve.closed) break;
    const SurfacePoint &p = curve.points[i], &q = curve.points[(i + 1) % n];
    const FaceId face = common_face(surface, p, q);
    auto middle = coordinates_in(surface, p, face).barycentric;
    const auto end = coordinates_in(surface, q, face).barycentric;
    for (std::size_t k = 0; k < 3; ++k) middle[k] = (middle[k] + end[k]) / 2;
    finer.points.push_back(SurfacePoint::from_barycentric(surface, face, middle));
  }
  return finer;
}

class CorridorScale : public testing::Test {
 protected:
  const SurfaceMesh mesh = SurfaceMesh::open(grid(kColumns, 20));
  const Surface& surface = mesh.surface();
};

TEST_F(CorridorScale, RectanglesInClosedForm) {
  for (const auto& [a, b] : {std::pair(40U, 2U), std::pair(12U, 12U), std::pair(30U, 1U)}) {
    const Scale scale = scale_of(mesh, rectangle(surface, a, b));
    const double round = 2.0 * (a + b);
    EXPECT_NEAR(scale.slack, std::min(0.7 * a, round / 24), 1e-9);
    EXPECT_NEAR(scale.length, std::hypot(a, b) / 8, 1e-9);
  }
}

TEST_F(CorridorScale, ACircleInClosedForm) {
  // A ring of a tube is a regular polygon, and straight.
  const std::uint32_t n = 48;
  const SurfaceMesh tube = SurfaceMesh::open(test::tube(n, 9, 2));
  std::vector<VertexId> ring;
  for (std::uint32_t i = 0; i < n; ++i) ring.emplace_back(4 * n + i);
  const Scale scale = scale_of(tube, test::vertex_curve(tube.surface(), ring, true));
  const double half = std::numbers::pi / n;
  EXPECT_NEAR(scale.length, 0.25, 1e-9);
  EXPECT_NEAR(scale.slack, 2 * n * std::sin(half) / 24, 1e-9);
}

TEST_F(CorridorScale, FollowsTheDrawingAndNotItsPoints) {
  const SurfaceCurve curves[] = {test::square_wave(surface, kColumns, 2, 2),
                                 rectangle(surface, 12, 5)};
  MeshLists large = grid(kColumns, 20);
  for (Point& p : large.points) p *= 1e5;
  const SurfaceMesh larger = SurfaceMesh::open(large);
  for (const SurfaceCurve& curve : curves) {
    const Scale scale = scale_of(mesh, curve);
    const SurfaceCurve finer = with_middles(surface, curve);
    EXPECT_EQ(finer.points.size(), 2 * curve.points.size() - (curve.closed ? 0 : 1));
    expect_same(scale, scale_of(mesh, finer));
    expect_same(scale, scale_of(mesh, with_middles(surface, finer)));
    expect_same(scale, scale_of(larger, curve), 1e5);
    SurfaceCurve reversed = curve;
    std::reverse(reversed.points.begin(), reversed.points.end());
    expect_same(scale, scale_of(mesh, reversed));
  }
  for (std::size_t shift = 1; shift < curves[1].points.size(); ++shift) {
    SurfaceCurve shifted = curves[1];
    std::rotate(shifted.points.begin(), shifted.points.begin() + static_cast<std::ptrdiff_t>(shift),
                shifted.points.end());
    expect_same(scale_of(mesh, curves[1]), scale_of(mesh, shifted));
  }
}

TEST_F(CorridorScale, TwoPointsAndOne) {
  const SurfaceCurve two = test::vertex_curve(surface, std::vector{at(4, 4), at(5, 4)}, false);
  EXPECT_NEAR(slack_of_segments(surface, two), 1 / 24.0, kTiny);
  EXPECT_NEAR(corridor_length(mesh, two), 0.5 / 4, kTiny);
  const SurfaceCurve one = test::vertex_curve(surface, std::vector{at(4, 4)}, false);
  EXPECT_EQ(slack_of_segments(surface, one), 0);
  EXPECT_EQ(corridor_length(mesh, one), 0);
}

}  // namespace
}  // namespace talweg
