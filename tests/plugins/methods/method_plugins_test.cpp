// The plugins of other methods against values from mathematics.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/report.hpp"
#include "talweg/core/version.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

/// A plugin on a mesh.
struct OnMesh {
  OnMesh(const char* id, const MeshLists& lists)
      : mesh(SurfaceMesh::open(lists)), instance(test::plugin_of_this_build(id), services) {
    test::set_mesh(instance, lists);
  }
  host::Results run(const std::vector<SurfaceCurve>& curves) {
    std::vector<host::Curve> given;
    for (const SurfaceCurve& curve : curves) given.push_back(test::as_host_curve(mesh, curve));
    instance.set_curves(given);
    return instance.run();
  }
  std::string sentence(const std::vector<SurfaceCurve>& curves) {
    try {
      run(curves);
    } catch (const host::Error& error) {
      return error.what();
    }
    return "no error";
  }

  SurfaceMesh mesh;
  host::Services services{"test", "1"};
  host::Instance instance;
};

SurfaceCurve edge_path(const SurfaceMesh& mesh, std::vector<std::uint32_t> way, bool closed) {
  return test::vertex_curve(mesh.surface(), draw_edge_path(mesh.surface(), test::ids(way), closed),
                            closed);
}

constexpr const char* kMethods[] = {"talweg.bipartition", "talweg.envelope", "talweg.midpoints"};

TEST(MethodPlugins, GiveAWholeReportAndCurvesInTheirOrder) {
  const test::Subject subject;
  for (const char* id : kMethods) {
    SCOPED_TRACE(id);
    if (std::string(id) == "talweg.bipartition") continue;  // takes no open curves
    OnMesh on(id, subject.lists);
    const host::Results results = on.run({subject.drawn});
    ASSERT_EQ(results.curves.size(), 1U);
    EXPECT_FALSE(results.curves[0].closed);
    const double before = measure_curve(on.mesh.surface(), subject.drawn).total_curvature;
    EXPECT_NEAR(results.number("curvature_before"), before, 1e-12 * before);
    EXPECT_LT(results.number("curvature_after"), 0.5 * before);
    EXPECT_LE(results.number("length_after"), results.number("length_before"));
    EXPECT_EQ(results.text("version"), version());
    for (const ReportEntry& entry : entries_of(SmoothingReport{})) {
      EXPECT_NE(results.find(entry.key.c_str()), nullptr) << entry.key;
    }
    EXPECT_EQ(results.curves[0].positions.front()[0],
              on.mesh.position(subject.drawn.points.front()).x());
    EXPECT_EQ(results.curves[0].positions.back()[0],
              on.mesh.position(subject.drawn.points.back()).x());
  }
}

// Lane and Riesenfeld's scheme of degree 2 is Chaikin's: in the plane its limit consists of
// parabolas between the midpoints of the polygon's sides.
TEST(MidpointsPlugin, OnAPlaneTendsToTheBSpline) {
  OnMesh on("talweg.midpoints", test::grid(20, 20));
  const auto at = [](std::uint32_t x, std::uint32_t y) { return x + 21 * y; };
  const SurfaceCurve square =
      edge_path(on.mesh, {at(4, 4), at(16, 4), at(16, 16), at(4, 16)}, true);
  on.instance.set("spacing", 12.0);
  on.instance.set("degree", 2.0);
  on.instance.set("levels", 7.0);
  const host::Results results = on.run({square});
  EXPECT_EQ(results.number("control_points"), 4);
  // Of a parabola with legs of 6 at a right angle: 12 times the integral of sqrt((1-t)^2 + t^2).
  const double parabola = 12 * (0.5 + std::asinh(1.0) / (2 * std::numbers::sqrt2));
  EXPECT_NEAR(results.number("length_after"), 4 * parabola, 1e-4 * parabola);
  EXPECT_NEAR(results.number("deviation_from_drawn_max"), 6 * std::numbers::sqrt2 / 4, 1e-2);
  EXPECT_NEAR(results.number("curvature_after"), 2 * std::numbers::pi, 1e-6);
}

TEST(MidpointsPlugin, KeepsAStraightLineAndItsEnds) {
  OnMesh on("talweg.midpoints", test::grid(20, 20));
  const SurfaceCurve line = edge_path(on.mesh, {21 * 5 + 2, 21 * 5 + 18}, false);
  const host::Results results = on.run({line});
  EXPECT_NEAR(results.number("length_after"), 16, 1e-12);
  EXPECT_NEAR(results.number("deviation_to_drawn_max"), 0, 1e-12);
}

TEST(MidpointsPlugin, RefusesInvalidParameters) {
  OnMesh on("talweg.midpoints", test::grid(4, 4));
  EXPECT_THROW(on.instance.set("spacing", 0.0), host::Error);
  on.instance.set("spacing", 1e-9);  // more points than memory has room for
  try {
    on.run({edge_path(on.mesh, {1, 13}, false)});
    FAIL() << "ran";
  } catch (const host::Error& error) {
    EXPECT_EQ(error.status(), TALWEG_BAD_USAGE);
    EXPECT_NE(std::string(error.what()).find("more than 20000 points"), std::string::npos);
  }
  EXPECT_THROW(on.instance.set("degree", 2.5), host::Error);
  EXPECT_THROW(on.instance.set("levels", 0.0), host::Error);
}

SurfaceCurve as_curve(const SurfaceMesh& mesh, const host::Curve& curve) {
  SurfaceCurve result{curve.closed, {}};
  for (std::size_t k = 0; k < curve.faces.size(); ++k) {
    result.points.push_back(SurfacePoint::from_barycentric(mesh.surface(), FaceId{curve.faces[k]},
                                                           curve.barycentrics[k]));
  }
  return result;
}

/// The largest distance along the surface of the curve's points to the drawn curves.
double farthest_point(const SurfaceMesh& mesh, const SurfaceCurve& curve,
                      const std::vector<SurfaceCurve>& drawn) {
  PolylineDistance distance(mesh.surface());
  distance.set(drawn);
  double most = 0;
  for (const SurfacePoint& p : curve.points) most = std::max(most, distance.at(p).distance);
  return most;
}

TEST(EnvelopePlugin, WithoutABoundIsTheGeodesic) {
  const test::Subject subject;
  OnMesh geodesic("talweg.geodesic", subject.lists), on("talweg.envelope", subject.lists);
  const double straight = geodesic.run({subject.drawn}).number("length_after");
  on.instance.set("envelope", 1000.0);
  on.instance.set("iterations", 100000.0);
  on.instance.set("tolerance", 1e-9);
  const host::Results results = on.run({subject.drawn});
  EXPECT_EQ(results.text("termination"), "converged");
  EXPECT_NEAR(results.number("length_after"), straight, 1e-4 * straight);
  EXPECT_GT(results.number("splits"), 0);
}

TEST(EnvelopePlugin, NoRoundMakesTheCurveLonger) {
  const test::Subject subject;
  OnMesh on("talweg.envelope", subject.lists);
  on.instance.set("tolerance", 0.0);
  double last = curve_length(on.mesh.surface(), subject.drawn);
  for (double rounds = 1; rounds <= 12; ++rounds) {
    on.instance.set("iterations", rounds);
    const host::Results results = on.run({subject.drawn});
    EXPECT_EQ(results.text("termination"), "limit");
    EXPECT_LT(results.number("length_after"), last);
    last = results.number("length_after");
  }
}

TEST(EnvelopePlugin, ItsPointsStayWithinTheEnvelope) {
  const test::Subject subject;
  OnMesh on("talweg.envelope", subject.lists);
  for (const double envelope : {0.05, 0.5, 2.0}) {
    on.instance.set("envelope", envelope);
    const host::Results results = on.run({subject.drawn});
    const SurfaceCurve curve = as_curve(on.mesh, results.curves[0]);
    EXPECT_LE(farthest_point(on.mesh, curve, {subject.drawn}), envelope * (1 + 1e-9));
    EXPECT_GT(results.number("deviation_to_drawn_max"), 0.5 * envelope);
  }
}

TEST(EnvelopePlugin, HoldsALoopOnAPlaneAndLetsItCollapseWithoutABound) {
  OnMesh on("talweg.envelope", test::grid(40, 40));
  const SurfaceCurve loop = test::drawn_near(
      on.mesh, test::circle(Point(20, 20, 0), Point(12, 0, 0), Point(0, 12, 0), 24), true);
  on.instance.set("envelope", 1.5);
  const host::Results held = on.run({loop});
  EXPECT_EQ(held.text("termination"), "converged");
  double least = 12;  // of the drawing's corners from the centre; its segments are at most sqrt(2)
  for (const Point& p : positions_of(on.mesh, loop)) {
    least = std::min(least, std::hypot(p.x() - 20, p.y() - 20));
  }
  const double inner = std::sqrt(least * least - 0.5) - 1.5;
  for (const auto& p : held.curves[0].positions) {
    EXPECT_GT(std::hypot(p[0] - 20, p[1] - 20), inner);
    EXPECT_LT(std::hypot(p[0] - 20, p[1] - 20), 13);
  }
  EXPECT_GE(held.number("length_after"), 2 * std::numbers::pi * inner);
  on.instance.set("envelope", 100.0);
  on.instance.set("tolerance", 0.0);
  on.instance.set("iterations", 1e5);
  const host::Results fallen = on.run({loop});
  EXPECT_EQ(fallen.text("termination"), "collapsed");
  EXPECT_LT(fallen.number("length_after"), 3 * std::sqrt(2.0));
}

TEST(EnvelopePlugin, SmoothsNoiseOnAGreatCircle) {
  OnMesh on("talweg.envelope", test::sphere(5));
  std::vector<Point> noisy = test::circle(Point(0, 0, 0), Point(0, 1, 0.3), Point(1, 0, 0), 40);
  for (std::size_t k = 0; k < noisy.size(); ++k) noisy[k].z() += k % 2 == 0 ? 0.05 : -0.05;
  const SurfaceCurve loop = test::drawn_near(on.mesh, noisy, true);
  on.instance.set("envelope", 0.12);
  const host::Results results = on.run({loop});
  EXPECT_LT(results.number("curvature_after"), 0.1 * results.number("curvature_before"));
  EXPECT_NEAR(results.number("length_after"), 2 * std::numbers::pi, 0.01 * 2 * std::numbers::pi);
  EXPECT_EQ(results.number("crossings_after"), 0);
}

TEST(EnvelopePlugin, CurvesDoNotPassEachOtherAndPinsStay) {
  OnMesh on("talweg.envelope", test::grid(30, 30));
  const auto at = [](std::uint32_t x, std::uint32_t y) { return x + 31 * y; };
  const SurfaceCurve upper = edge_path(on.mesh, {at(2, 20), at(15, 12), at(28, 20)}, false);
  const SurfaceCurve lower = edge_path(on.mesh, {at(2, 9), at(15, 11), at(28, 9)}, false);
  std::vector<host::Curve> given = {test::as_host_curve(on.mesh, upper),
                                    test::as_host_curve(on.mesh, lower)};
  for (std::size_t k = 0; k < upper.points.size(); ++k) {
    if (upper.points[k] == SurfacePoint::at_vertex(on.mesh.surface(), VertexId{at(15, 12)})) {
      given[0].pins = {static_cast<std::uint32_t>(k)};
    }
  }
  ASSERT_EQ(given[0].pins.size(), 1U);
  on.instance.set("envelope", 15.0);
  on.instance.set("tolerance", 1e-9);
  on.instance.set("iterations", 20000.0);
  on.instance.set_curves(given);
  const host::Results results = on.instance.run();
  EXPECT_EQ(results.number("crossings_after"), 0);
  // The pinned one is two straight lines, the other one straight.
  EXPECT_NEAR(results.number("length_after", 0), 2 * std::hypot(13, 8), 1e-3);
  EXPECT_NEAR(results.number("length_after", 1), 26, 1e-3);
}

TEST(EnvelopePlugin, RefusesInvalidParameters) {
  OnMesh on("talweg.envelope", test::grid(4, 4));
  EXPECT_THROW(on.instance.set("envelope", 0.0), host::Error);
  EXPECT_THROW(on.instance.set("weight", 1.5), host::Error);
  EXPECT_THROW(on.instance.set("iterations", 0.0), host::Error);
  EXPECT_THROW(on.instance.set("tolerance", -1.0), host::Error);
}

TEST(BipartitionPlugin, AStraightBorderStays) {
  // On this grid heat from a column depends on x alone, so phi is x itself: but for the sheet's
  // corners, whose masses are not a quarter of the others'.
  OnMesh on("talweg.bipartition", test::grid(20, 12));
  const SurfaceCurve column = edge_path(on.mesh, {9, 9 + 21 * 12}, false);
  const host::Results results = on.run({column});
  ASSERT_EQ(results.curves.size(), 1U);
  EXPECT_FALSE(results.curves[0].closed);
  for (const auto& p : results.curves[0].positions) EXPECT_NEAR(p[0], 9, 0.005);
  EXPECT_NEAR(results.curves[0].positions.front()[1], 0, 1e-12);
  EXPECT_NEAR(results.number("length_after"), 12, 1e-4);
  EXPECT_EQ(results.number("stray_curves"), 0);
  EXPECT_EQ(results.number("border_vertices"), 13);
}

SurfaceCurve noisy_equator(const SurfaceMesh& mesh) {
  std::vector<Point> noisy = test::circle(Point(0, 0, 0), Point(0, 1, 0), Point(1, 0, 0), 48);
  for (std::size_t k = 0; k < noisy.size(); ++k) noisy[k].z() += k % 2 == 0 ? 0.04 : -0.04;
  return test::drawn_near(mesh, noisy, true);
}

TEST(BipartitionPlugin, SmoothsNoiseOnAGreatCircle) {
  OnMesh on("talweg.bipartition", test::sphere(5));
  const SurfaceCurve loop = noisy_equator(on.mesh);
  double highest = 0;
  for (const Point& p : positions_of(on.mesh, loop)) {
    highest = std::max(highest, std::abs(p.z()));
  }
  double last = measure_curve(on.mesh.surface(), loop).total_curvature;
  for (const double passes : {5.0, 50.0, 500.0}) {
    on.instance.set("iterations", passes);
    const host::Results results = on.run({loop});
    EXPECT_TRUE(results.curves[0].closed);
    EXPECT_LT(results.number("curvature_after"), 0.7 * last);
    last = results.number("curvature_after");
    EXPECT_EQ(results.number("stray_curves"), 0);
    EXPECT_EQ(results.number("crossings_after"), 0);
    for (const auto& p : results.curves[0].positions) EXPECT_LT(std::abs(p[2]), highest);
    EXPECT_NEAR(results.number("length_after"), 2 * std::numbers::pi, 0.06);
  }
}

TEST(BipartitionPlugin, GivesEachLoopItsCurveRunningAsDrawn) {
  OnMesh on("talweg.bipartition", test::tube(40, 40, 10));
  const auto ring = [&](std::uint32_t row, bool backwards) {
    std::vector<VertexId> way;
    for (std::uint32_t i = 0; i < 40; ++i) {
      way.push_back(VertexId{40 * row + (backwards ? 39 - i : i)});
    }
    return test::vertex_curve(on.mesh.surface(), way, true);
  };
  const std::vector<SurfaceCurve> drawn = {ring(30, true), ring(9, false)};
  const host::Results results = on.run(drawn);
  ASSERT_EQ(results.curves.size(), 2U);
  const double rows[] = {30 * 10.0 / 39, 9 * 10.0 / 39};
  for (std::size_t c = 0; c < 2; ++c) {
    const auto& positions = results.curves[c].positions;
    for (const auto& p : positions) EXPECT_NEAR(p[2], rows[c], 0.03);
    // Counterclockwise seen from above, or not; from where the drawing begins.
    double turn = 0;
    for (std::size_t k = 0; k < positions.size(); ++k) {
      const auto &p = positions[k], &q = positions[(k + 1) % positions.size()];
      turn += std::asin(std::clamp(p[0] * q[1] - p[1] * q[0], -1.0, 1.0));
    }
    EXPECT_NEAR(turn, (c == 0 ? -2 : 2) * std::numbers::pi, 0.1);
    const Point first = on.mesh.position(drawn[c].points.front());
    EXPECT_LT(std::hypot(positions[0][0] - first.x(), positions[0][1] - first.y()), 0.2);
  }
}

TEST(BipartitionPlugin, RefusesCurvesWithoutTwoSides) {
  OnMesh on("talweg.bipartition", test::grid(20, 12));
  const auto at = [](std::uint32_t x, std::uint32_t y) { return x + 21 * y; };
  const std::string ends_inside = on.sentence({edge_path(on.mesh, {at(9, 0), at(9, 8)}, false)});
  EXPECT_NE(ends_inside.find("does not separate the mesh into two sides: at ("), std::string::npos);
  host::Curve small;  // within one face
  small.closed = true;
  small.positions = {{3.5, 3.1, 0}, {3.8, 3.1, 0}, {3.8, 3.4, 0}};
  on.instance.set_curves({small});
  try {
    on.instance.run();
    ADD_FAILURE();
  } catch (const host::Error& error) {
    EXPECT_NE(std::string(error.what()).find("too coarse"), std::string::npos) << error.what();
  }
  OnMesh around("talweg.bipartition", test::torus(24, 60));
  const auto meridian = [&](std::uint32_t row) {
    return edge_path(around.mesh, {24 * row, 24 * row + 8, 24 * row + 16}, true);
  };
  EXPECT_NE(around.sentence({meridian(5)}).find("two sides"), std::string::npos);
  EXPECT_EQ(around.sentence({meridian(5), meridian(35)}), "no error");
}

TEST(BipartitionPlugin, StartsFromTheNearestEdgesOfADrawingAcrossFaces) {
  OnMesh on("talweg.bipartition", test::grid(20, 12));
  host::Curve line;
  line.positions = {{9.5, 0, 0}, {9.5, 12, 0}};
  on.instance.set_curves({line});
  const host::Results results = on.instance.run();
  for (const auto& p : results.curves.at(0).positions) EXPECT_NEAR(p[0], 9.5, 0.6);
  EXPECT_NE(results.text("warnings").find("not run along mesh edges"), std::string::npos);
}

TEST(BipartitionPlugin, TheGuardGivesFacesOfSourcesADirection) {
  // Up along a diagonal and down along a side: all corners of the faces between are on the border.
  OnMesh on("talweg.bipartition", test::grid(40, 20));
  std::vector<VertexId> way;
  for (std::uint32_t x = 0; x < 40; ++x) {
    way.push_back(VertexId{x + 41 * 10});
    way.push_back(VertexId{x + 1 + 41 * 11});
  }
  const SurfaceCurve teeth = test::vertex_curve(on.mesh.surface(), way, false);
  const host::Results guarded = on.run({teeth});
  EXPECT_GT(guarded.number("source_faces"), 20);
  EXPECT_EQ(guarded.number("stray_curves"), 0);
  for (const auto& p : guarded.curves[0].positions) EXPECT_NEAR(p[1], 10.5, 0.6);
  EXPECT_LT(guarded.number("curvature_after"), 0.5 * guarded.number("curvature_before"));
  // Smoothing would hide the effect of the guard, so there is no smoothing here.
  on.instance.set("iterations", 0.0);
  const double with = on.run({teeth}).number("curvature_after");
  on.instance.set("guard", 0.0);
  EXPECT_LT(with, 0.2 * on.run({teeth}).number("curvature_after"));
}

TEST(BipartitionPlugin, ReportsCurvesOfTheLevelSetThatBelongToNoDrawing) {
  // Two squares and a way between them one row wide, which smoothing closes.
  OnMesh on("talweg.bipartition", test::grid(40, 20));
  std::vector<std::uint32_t> way;
  for (const auto& [x, y] : {std::pair{5, 5},
                             {13, 5},
                             {13, 9},
                             {25, 9},
                             {25, 5},
                             {33, 5},
                             {33, 13},
                             {25, 13},
                             {25, 10},
                             {13, 10},
                             {13, 13},
                             {5, 13}}) {
    way.push_back(static_cast<std::uint32_t>(x + 41 * y));
  }
  const host::Results results = on.run({edge_path(on.mesh, way, true)});
  ASSERT_EQ(results.curves.size(), 1U);
  EXPECT_EQ(results.number("stray_curves"), 1);
  EXPECT_NEAR(results.number("stray_length"), 32, 2);  // around a square
  EXPECT_NEAR(results.number("length_after"), 32, 2);
  EXPECT_NE(results.text("warnings").find("belongs to no drawn curve"), std::string::npos);
}

TEST(BipartitionPlugin, DoesNotDependOnTheScale) {
  MeshLists lists = test::sphere(4);
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const SurfaceCurve loop = noisy_equator(mesh);
  OnMesh on("talweg.bipartition", lists);
  const host::Results unit = on.run({loop});
  for (const double scale : {0x1p-20, 0x1p20}) {  // exact in every step
    MeshLists scaled = lists;
    for (Point& p : scaled.points) p *= scale;
    OnMesh other("talweg.bipartition", scaled);
    const host::Results results = other.run({loop});
    ASSERT_EQ(results.curves[0].positions.size(), unit.curves[0].positions.size());
    for (std::size_t k = 0; k < unit.curves[0].positions.size(); ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(results.curves[0].positions[k][i] / scale, unit.curves[0].positions[k][i],
                    1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace talweg
