// The walls and limits of fairing.
#include "talweg/core/fairing/curve_fairing.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

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
    if (std::abs(left - right) > 0.01) continue;  // on a ridge the slopes differ
    EXPECT_NEAR(at.slope, (left + right) / 2, 1e-3) << f;
    EXPECT_NEAR(at.wall_slope, (high.wall - low.wall) / (2 * step), 2e-2) << f;
    EXPECT_NEAR(at.wall, 1.5 * at.slack, 1e-12);
    ++compared;
  }
  EXPECT_GT(compared, 500);
}

TEST(CurveFairing, ACurveIsTooLongWhereItsSamplesWouldBeTooMany) {
  const auto opened = OpenedMesh::open(test::grid(4, 4));
  const double edge = 2;  // without a band, samples are an eighth of an edge apart at the least
  StripCurvature curvature(opened->surface());
  const CurveFairing fairing(curvature, nullptr, edge, {});
  EXPECT_FALSE(fairing.is_too_long(1e5 * edge / 8));
  EXPECT_TRUE(fairing.is_too_long(1.001e5 * edge / 8));
}

// Chains among needles wound back and forth; each attempt was longer than the previous one, up to
// 20,000 times the length of the drawing.
TEST(CurveFairing, AChainFarTooLongIsRejected) {
  const auto opened = OpenedMesh::open(test::hills(40));
  const SurfaceCurve drawn = test::wave_on_hills(opened->mesh());
  const double length = curve_length(opened->surface(), drawn);
  const double edge = opened->mesh().mean_edge_length();
  PolylineDistance distance(opened->surface());
  distance.set(std::span(&drawn, 1));
  const DrawnBand band(distance, 0, {edge, {}, edge / 8, 1.5});
  StripCurvature curvature(opened->surface());
  const CurveTrace start = trace_of(opened->surface(), drawn);
  ProgressPoller poller({}, "fair");
  CurveFairing fairing(curvature, &band, edge, {});
  fairing.give_up_beyond(2 * length);
  const auto chain = fairing.from_curve(start, poller);
  ASSERT_TRUE(chain.has_value());
  EXPECT_LT(chain->length(), 2 * length);
  SampleTrail trail;
  EXPECT_TRUE(fairing.from_chain(*chain, trail, poller).has_value());
  fairing.give_up_beyond(chain->length() / 2);
  EXPECT_FALSE(fairing.from_curve(start, poller).has_value());
  EXPECT_FALSE(fairing.from_chain(*chain, trail, poller).has_value());
}

}  // namespace
}  // namespace talweg
