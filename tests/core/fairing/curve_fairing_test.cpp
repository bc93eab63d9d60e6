// Fair curves against circles, their walls, and what a drawing must never lose.
#include "talweg/core/fairing/curve_fairing.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/corridor_width.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kFive = 5 * kPi / 180;

/// The largest distance of a curve's points and the middles of its segments from a drawing.
double farthest(const SurfaceMesh& mesh, const SurfaceCurve& curve, const SurfaceCurve& drawn) {
  PolylineDistance distance(mesh.surface());
  distance.set(std::span(&drawn, 1));
  double most = 0;
  for (const SurfacePoint& p : curve.points) most = std::max(most, distance.at(p).distance);
  return most;
}

double bending(const SurfaceMesh& mesh, const SurfaceCurve& curve, double edge) {
  return measure_curve(mesh.surface(), curve, edge).bending;
}

TEST(DrawnBand, ItsSlopesAreThoseOfItsValues) {
  const auto opened = OpenedMesh::open(test::hills(40));
  const Surface& surface = opened->surface();
  const SurfaceCurve drawn = test::wave_on_hills(opened->mesh());
  PolylineDistance distance(surface);
  distance.set(std::span(&drawn, 1));
  std::vector<double> slack;
  for (std::size_t i = 0; i < drawn.points.size(); ++i) {
    slack.push_back(0.5 + 0.2 * std::sin(0.4 * static_cast<double>(i)));
  }
  const DrawnBand band(distance, 0, {0, slack, 0.01, 1.5});
  int compared = 0;
  for (std::size_t f = 0; f < surface.face_count(); f += 2) {
    const FaceFrame frame(surface, FaceId{f});
    const FaceCoordinates here{FaceId{f}, {0.31, 0.41, 0.28}};
    const PlanePoint way{0.6, 0.8};
    const auto rates = frame.rates(way);
    const double step = 1e-6;
    const auto moved = [&](double s) {
      FaceCoordinates at = here;
      for (std::size_t k = 0; k < 3; ++k) at.barycentric[k] += s * rates[k];
      return band.at(at, way);
    };
    const BandPlace low = moved(-step), at = moved(0), high = moved(step);
    const double left = (at.distance - low.distance) / step;
    const double right = (high.distance - at.distance) / step;
    if (std::abs(left - right) > 0.01) continue;  // a ridge
    EXPECT_NEAR(at.slope, (left + right) / 2, 1e-3) << f;
    EXPECT_NEAR(at.wall_slope, (high.wall - low.wall) / (2 * step), 2e-2) << f;
    EXPECT_NEAR(at.wall, 1.5 * at.slack, 1e-12);
    ++compared;
  }
  EXPECT_GT(compared, 500);
}

// A zigzag around a circle of the plane: the fair loop is that circle, but for the wall's width.
TEST(FairCurve, OfAJaggedCircleIsRoundAndOfItsSize) {
  const auto opened = OpenedMesh::open(test::grid(60, 60));
  for (const double radius : {6.0, 12.0, 22.0}) {
    const SurfaceCurve drawn = test::drawn_near(
        opened->mesh(), test::circle({30, 30, 0}, {radius, 0, 0}, {0, radius, 0}, 24), true);
    const SmoothingResult result = smooth_curve(opened, drawn, {});
    double most = 0, least = HUGE_VAL;
    for (const Point& p : positions_of(opened->mesh(), result.curve())) {
      most = std::max(most, (p - Point(30, 30, 0)).norm());
      least = std::min(least, (p - Point(30, 30, 0)).norm());
    }
    EXPECT_LT(most - least, 0.6 + 0.1 * radius) << radius;
    EXPECT_NEAR((most + least) / 2, radius, 0.6) << radius;
    EXPECT_NEAR(result.report().curvature_after, 2 * kPi, 0.5) << radius;
    EXPECT_LT(result.report().curvature_max_after, kFive) << radius;
    // A circle bends by h 2 pi / r.
    EXPECT_LT(result.report().bending_after, 1.5 * 2 * kPi / radius) << radius;
  }
}

TEST(FairCurve, KeepsToItsWallsForEveryTau) {
  const auto opened = OpenedMesh::open(test::hills(40));
  const SurfaceCurve drawn = test::wave_on_hills(opened->mesh());
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const double slack = smoother.slack()[0];
  double last = HUGE_VAL;
  for (const double tau : {0.125, 0.3, 0.5, 1.0, 1.7, 3.0, 8.0, 100.0}) {
    const SmoothingResult result = smoother.smooth(tau);
    const double far = farthest(opened->mesh(), result.curve(), drawn);
    EXPECT_LE(far, (1.25 + 0.25 / tau) * slack * (1 + 1e-9)) << tau;
    EXPECT_LE(far, last + 0.05 * result.report().edge_length_near) << tau;
    last = far;
    EXPECT_LT(result.report().curvature_max_after, kFive) << tau;
    EXPECT_TRUE(result.report().warnings.empty()) << result.report().warnings.front();
  }
}

TEST(FairCurve, BendsMuchLessThanTheTautOneAndNoMoreAtAnyPoint) {
  const auto opened = OpenedMesh::open(test::sphere(5));
  const SurfaceMesh& mesh = opened->mesh();
  const SurfaceCurve drawn =
      test::drawn_near(mesh, test::circle({0, 0, 0.5}, {0.8, 0.1, 0}, {0, 0.8, 0.1}, 24), true);
  SmoothingOptions taut;
  taut.finish = Finish::kTaut;
  const SmoothingResult straight = smooth_curve(opened, drawn, taut);
  const SmoothingResult fair = smooth_curve(opened, drawn, {});
  const double edge = fair.report().edge_length_near;
  EXPECT_LT(bending(mesh, fair.curve(), edge), 0.5 * bending(mesh, straight.curve(), edge));
  EXPECT_GT(straight.report().curvature_max_after, 2 * kFive);
  EXPECT_LT(fair.report().curvature_max_after, kFive);
}

// The drawing runs around three sides of a square that is far larger than its slack.
TEST(FairCurve, GoesWhereTheDrawingGoes) {
  const auto opened = OpenedMesh::open(test::grid(60, 60));
  const Point corners[] = {{5, 30, 0},  {25, 30, 0}, {25, 45, 0},
                           {35, 45, 0}, {35, 30, 0}, {55, 30, 0}};
  const SurfaceCurve drawn = test::drawn_near(opened->mesh(), corners, false);
  const SmoothingResult result = smooth_curve(opened, drawn, {});
  EXPECT_LT(result.report().deviation_from_drawn_max, 3 * result.report().slack);
  EXPECT_LT(result.report().curvature_max_after, kFive);
  EXPECT_EQ(result.curve().points.front(), drawn.points.front());
  EXPECT_EQ(result.curve().points.back(), drawn.points.back());
}

TEST(FairCurve, PassesItsPinsWithoutAKink) {
  const auto opened = OpenedMesh::open(test::hills(40));
  const SurfaceCurve drawn = test::wave_on_hills(opened->mesh());
  const std::vector<SurfacePoint> pins{drawn.points[9], drawn.points[20]};
  const SmoothingResult result = smooth_curve(opened, drawn, {}, {.pins = pins});
  const auto& points = result.curve().points;
  for (const SurfacePoint& pin : pins) {
    const auto at = std::find(points.begin(), points.end(), pin);
    ASSERT_NE(at, points.end());
    ASSERT_NE(at, points.begin());
    EXPECT_LT(turning_angle(opened->surface(), *(at - 1), *at, *(at + 1)), 2 * kFive);
  }
}

TEST(CurveFairing, ACurveIsTooLongWhereItsSamplesWouldBeTooMany) {
  const auto opened = OpenedMesh::open(test::grid(4, 4));
  const double edge = 2;  // without a band, samples are an eighth of an edge apart at the least
  StripCurvature curvature(opened->surface());
  const CurveFairing fairing(curvature, nullptr, edge, {});
  EXPECT_FALSE(fairing.is_too_long(1e5 * edge / 8));
  EXPECT_TRUE(fairing.is_too_long(1.001e5 * edge / 8));
}

// Among needles chains wound to and fro, each try longer than the one before, up to 20,000 times as
// long as what was drawn.
TEST(CurveFairing, AChainThatIsFarTooLongIsGivenUp) {
  const auto opened = OpenedMesh::open(test::hills(40));
  const SurfaceCurve drawn = test::wave_on_hills(opened->mesh());
  const double length = curve_length(opened->surface(), drawn);
  const double edge = opened->mesh().mean_edge_length();
  PolylineDistance distance(opened->surface());
  distance.set(std::span(&drawn, 1));
  const DrawnBand band(distance, 0, {edge, {}, edge / 8, 1.5});
  StripCurvature curvature(opened->surface());
  const CurveTrace start = trace_of(opened->surface(), drawn);
  Asker asker({}, "fair");
  CurveFairing fairing(curvature, &band, edge, {});
  fairing.give_up_beyond(2 * length);
  const auto chain = fairing.from_curve(start, asker);
  ASSERT_TRUE(chain.has_value());
  EXPECT_LT(chain->length(), 2 * length);
  SampleTrail trail;
  EXPECT_TRUE(fairing.from_chain(*chain, trail, asker).has_value());
  fairing.give_up_beyond(chain->length() / 2);
  EXPECT_FALSE(fairing.from_curve(start, asker).has_value());
  EXPECT_FALSE(fairing.from_chain(*chain, trail, asker).has_value());
}

TEST(FairCurve, StrandsBesideEachOtherDoNotCross) {
  const auto opened = OpenedMesh::open(test::grid(60, 60));
  std::vector<SurfaceCurve> curves;
  for (const double y : {20.0, 21.0, 22.0}) {
    std::vector<Point> points;
    for (int i = 0; i <= 25; ++i) {
      points.emplace_back(5 + 2 * i, y + (i % 2 == 0 ? 0.0 : 1.0), 0);
    }
    curves.push_back(test::drawn_near(opened->mesh(), points, false));
  }
  CurveSmoother smoother(opened);
  smoother.set_curves(curves);
  for (const double tau : {0.125, 0.5, 1.0, 4.0}) {
    const SmoothingResult result = smoother.smooth(tau);
    EXPECT_TRUE(crossing_curves(opened->surface(), result.curves).empty()) << tau;
  }
}

}  // namespace
}  // namespace talweg
