// Crossings of a curve, compared with the crossings of all pairs of segments.
#include "talweg/core/drawing/crossings.hpp"

#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kFaces = 6;

/// Zigzags in single faces, as loops and open curves; some share a point.
std::vector<SurfaceCurve> zigzags(const Surface& surface, std::size_t count, std::mt19937& random) {
  std::uniform_real_distribution<double> part(0.05, 1);
  std::vector<SurfaceCurve> curves;
  for (std::size_t c = 0; c < count; ++c) {
    SurfaceCurve& curve = curves.emplace_back();
    curve.closed = c % 3 == 0;
    const FaceId face{static_cast<std::uint32_t>(random() % kFaces)};
    for (std::size_t i = 0; i < 3 + random() % 12; ++i) {
      std::array<double, 3> b{};
      for (double& one : b) one = part(random);
      const double sum = b[0] + b[1] + b[2];
      for (double& one : b) one /= sum;
      curve.points.push_back(SurfacePoint::from_barycentric(surface, face, b));
    }
    if (c % 4 == 1) curve.points.front() = curves[c - 1].points.front();
  }
  return curves;
}

/// Whether each point and the next share a face. A curve that begins at another curve's point may
/// not: the point can lie in another face.
bool has_faces(const Surface& surface, const SurfaceCurve& curve) {
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < curve.points.size(); ++i) {
    const std::size_t next = (i + 1) % curve.points.size();
    if (!common_face(surface, curve.points[i], curve.points[next]).valid()) return false;
  }
  return true;
}

std::vector<SurfaceCurve> segments_of(const SurfaceCurve& curve) {
  std::vector<SurfaceCurve> segments;
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < curve.points.size(); ++i) {
    segments.push_back({false, {curve.points[i], curve.points[(i + 1) % curve.points.size()]}});
  }
  return segments;
}

std::vector<SurfacePoint> crossed_by_pairs(const Surface& surface,
                                           const std::vector<SurfaceCurve>& others,
                                           const SurfaceCurve& curve) {
  const std::vector<SurfaceCurve> own = segments_of(curve);
  std::vector<SurfaceCurve> all = own;
  for (const SurfaceCurve& other : others) {
    for (SurfaceCurve& segment : segments_of(other)) all.push_back(std::move(segment));
  }
  std::vector<SurfacePoint> crossed;
  for (std::size_t i = 0; i < own.size(); ++i) {
    bool any = false;
    for (std::size_t k = 0; k < all.size(); ++k) {
      any = any || (k != i && !crossing_curves(surface, std::vector{own[i], all[k]}).empty());
    }
    if (any) crossed.push_back(curve.points[i]);
  }
  return crossed;
}

TEST(CurvesByFace, AgreeWithPairsOfSegments) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(3, 1));
  const Surface& surface = mesh.surface();
  std::mt19937 random(5);
  for (int run = 0; run < 20; ++run) {
    std::vector<SurfaceCurve> curves = zigzags(surface, 9, random);
    std::erase_if(curves, [&](const SurfaceCurve& c) { return !has_faces(surface, c); });
    CurvesByFace by_face(surface, curves);
    for (std::size_t step = 0; step < 2 * curves.size(); ++step) {
      const std::size_t c = random() % curves.size();
      const SurfaceCurve instead = zigzags(surface, 1, random).front();
      std::vector<SurfaceCurve> others = curves;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(c));
      EXPECT_EQ(by_face.crossed_points(c, instead), crossed_by_pairs(surface, others, instead));
      EXPECT_EQ(by_face.crossed_points(c, curves[c]), crossed_by_pairs(surface, others, curves[c]));
      by_face.replace(c, instead);
      curves[c] = instead;
    }
  }
}

TEST(CurvesByFace, RefuseASegmentOutsideTheFaces) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(3, 1));
  const Surface& surface = mesh.surface();
  const SurfaceCurve across{false,
                            {SurfacePoint::at_vertex(surface, VertexId{0}),
                             SurfacePoint::at_vertex(surface, VertexId{3})}};
  EXPECT_THROW(CurvesByFace(surface, std::vector{across}), Error);
  EXPECT_THROW((void)CurvesByFace(surface, std::vector<SurfaceCurve>(1)).crossed_points(0, across),
               Error);
}

TEST(Crossings, AreFoundWithoutTouchingCurves) {
  const auto opened = OpenedMesh::open(test::grid(4, 4));
  const Surface& surface = opened->surface();
  const auto at = [&](std::uint32_t face, double a, double b) {
    return SurfacePoint::in_face(surface, FaceId{face}, {a, b, 1 - a - b});
  };
  const std::vector<SurfaceCurve> crossing = {{false, {at(3, 0.1, 0.2), at(3, 0.7, 0.2)}},
                                              {false, {at(3, 0.4, 0.1), at(3, 0.3, 0.6)}},
                                              {false, {at(5, 0.4, 0.1), at(5, 0.3, 0.6)}}};
  EXPECT_EQ(crossing_curves(surface, crossing), (std::vector<std::size_t>{0, 1}));
  const SurfacePoint shared = at(3, 0.3, 0.3);
  const std::vector<SurfaceCurve> touching = {{false, {at(3, 0.1, 0.2), shared, at(3, 0.2, 0.1)}},
                                              {false, {at(3, 0.6, 0.3), shared}}};
  EXPECT_TRUE(crossing_curves(surface, touching).empty());
}

}  // namespace
}  // namespace talweg
