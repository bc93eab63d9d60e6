// Curves that cross or touch themselves and each other: smoothed, with the crossings they had.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/drawing/curve_embedding.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/core/smoothing/unrolled_mesh.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"

namespace talweg {
namespace {

using namespace test;
constexpr double kPi = std::numbers::pi;

/// Straight lines through these positions, put on the mesh.
SurfaceCurve through(const SurfaceMesh& mesh, std::vector<Point> points, bool closed) {
  const CurveInput input{closed, std::move(points), {}};
  return StraightLines(mesh.surface()).join(snap(mesh, input).points, closed);
}

/// Every third position is moved off by this much, to and fro.
void shake(std::vector<Point>& points, const Point& off) {
  for (std::size_t k = 0; k < points.size(); k += 3) points[k] += k % 2 == 0 ? off : Point(-off);
}

std::vector<Point> eight(const Point& centre, double size, std::size_t count) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = 2 * kPi * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    points.push_back(centre + size * Point(std::sin(t), std::sin(t) * std::cos(t), 0));
  }
  return points;
}

TEST(CrossingCurves, AFigureEightKeepsItsCrossing) {
  const auto opened = OpenedMesh::open(hills(40));
  std::vector<Point> points = eight(Point(20, 20, 0), 14, 90);
  shake(points, Point(0, 0.7, 0));
  const SurfaceCurve drawn = through(opened->mesh(), points, true);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  for (const double tau : {0.25, 1.0, 4.0}) {
    const SmoothingResult result = smoother.smooth(tau);
    const SmoothingReport& report = result.report();
    EXPECT_EQ(report.crossings_before, 1U);
    EXPECT_EQ(report.crossings_after, 1U);
    EXPECT_EQ(report.termination, Outcome::kConverged);
    EXPECT_LT(report.curvature_after, report.curvature_before / 4) << tau;
    EXPECT_LT(apart(opened->mesh(), drawn, result.curve()), tau < 1 ? 5 : 3) << tau;
  }
}

TEST(CrossingCurves, InThePlaneAFigureEightTurnsLittleMoreThanItMust) {
  const auto opened = OpenedMesh::open(grid(60, 60));
  std::vector<Point> points = eight(Point(30.2, 30.3, 0), 22, 120);
  shake(points, Point(0, 0.6, 0));
  CurveSmoother smoother(opened);
  smoother.set_curve(through(opened->mesh(), points, true));
  const SmoothingReport report = smoother.smooth(2.0).report();
  // Each loop of that curve turns by 3 pi / 2 (it crosses itself at a right angle).
  EXPECT_LT(report.curvature_after, 1.1 * 3 * kPi);
  EXPECT_GT(report.curvature_after, 0.9 * 3 * kPi);
  EXPECT_EQ(report.crossings_after, 1U);
}

/// Two turns around a tube, the second higher than the first.
std::vector<Point> twice_around() {
  std::vector<Point> points;
  for (int k = 0; k < 80; ++k) {
    const double t = 4 * kPi * k / 80;
    points.emplace_back(std::cos(t), std::sin(t), 4 - std::cos(t / 2) + (k % 2 == 0 ? 0.1 : -0.1));
  }
  return points;
}

TEST(CrossingCurves, TwiceAroundATube) {
  const auto opened = OpenedMesh::open(tube(48, 60, 8));
  CurveSmoother smoother(opened);
  smoother.set_curve(through(opened->mesh(), twice_around(), true));
  const SmoothingResult result = smoother.smooth(1.0);
  EXPECT_EQ(result.report().crossings_before, 1U);
  EXPECT_EQ(result.report().crossings_after, 1U);
  EXPECT_LT(result.report().curvature_after, result.report().curvature_before / 5);
  EXPECT_GT(result.report().length_after, 0.98 * 4 * kPi);
}

// The strip is closed where the drawing begins, unless it only dips into a face there.
TEST(CrossingCurves, WhereverTheDrawingBeginsNoTurnIsLost) {
  const MeshLists lists = tube(48, 60, 8);
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const SurfaceCurve drawn = through(mesh, twice_around(), true);
  const double whole = curve_length(mesh.surface(), drawn);
  for (std::size_t start = 0; start < drawn.points.size(); start += 16) {
    SurfaceCurve turned = drawn;
    std::rotate(turned.points.begin(), turned.points.begin() + static_cast<std::ptrdiff_t>(start),
                turned.points.end());
    const UnrolledMesh strip = unroll(mesh, std::span(&turned, 1), {true}, 2);
    // Not a whole copy of the mesh instead, on which the turns cannot be told apart.
    EXPECT_NE(strip.face_of.size(), lists.triangles.size()) << start;
    const SurfaceMesh laid = SurfaceMesh::open(strip.lists);
    const std::vector<SurfaceCurve> there =
        strip.unrolled(mesh, laid.surface(), std::span(&turned, 1));
    EXPECT_NEAR(curve_length(laid.surface(), there.front()), whole, 1e-9 * whole) << start;
  }
}

/// A plate of cubes of size 1 whose middle of every three by three is missing, so that it has as
/// many handles as holes; `size` must be a multiple of 3. The vertices of the upper side come
/// first.
MeshLists plate_with_holes(std::uint32_t size) {
  MeshLists lists;
  const std::uint32_t columns = size + 1, upper = columns * columns;
  for (const double z : {1.0, 0.0}) {
    for (std::uint32_t v = 0; v < upper; ++v)
      lists.points.emplace_back(v % columns, v / columns, z);
  }
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    lists.triangles.push_back({a, b, c});
    lists.triangles.push_back({a, c, d});
  };
  const auto is_there = [&](std::uint32_t x, std::uint32_t y) {  // also where x or y is -1
    return x < size && y < size && !(x % 3 == 1 && y % 3 == 1);
  };
  const auto wall = [&](std::uint32_t a, std::uint32_t b) { quad(b, a, a + upper, b + upper); };
  for (std::uint32_t y = 0; y < size; ++y) {
    for (std::uint32_t x = 0; x < size; ++x) {
      if (!is_there(x, y)) continue;
      const std::uint32_t a = y * columns + x, b = a + 1, c = b + columns, d = a + columns;
      quad(a, b, c, d);
      quad(d + upper, c + upper, b + upper, a + upper);
      if (!is_there(x, y - 1)) wall(a, b);
      if (!is_there(x + 1, y)) wall(b, c);
      if (!is_there(x, y + 1)) wall(c, d);
      if (!is_there(x - 1, y)) wall(d, a);
    }
  }
  return lists;
}

/// Along rows and columns of the vertices of a square grid, from one corner to the next.
std::vector<VertexId> along_grid(std::uint32_t columns,
                                 const std::vector<std::array<std::uint32_t, 2>>& corners) {
  std::vector<VertexId> way;
  auto [x, y] = corners.front();
  const auto step = [](std::uint32_t from, std::uint32_t to) {
    return from < to ? from + 1 : from > to ? from - 1 : from;
  };
  for (const auto& [to_x, to_y] : corners) {
    for (; x != to_x || y != to_y; x = step(x, to_x), y = step(y, to_y)) {
      way.emplace_back(y * columns + x);
    }
  }
  way.emplace_back(y * columns + x);
  return way;
}

// The ways around a handle come back to where they were, and not to another copy of it.
TEST(CrossingCurves, HandlesAreLaidOutOnce) {
  const MeshLists lists = plate_with_holes(36);
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  ASSERT_EQ(2 * mesh.surface().edge_count(), 3 * lists.triangles.size());  // it is closed
  const SurfaceCurve drawn = vertex_curve(
      mesh.surface(), along_grid(37, {{{3, 9}, {30, 9}, {30, 30}, {18, 30}, {18, 3}}}), false);
  const UnrolledMesh strip = unroll(mesh, std::span(&drawn, 1), {true}, 5);
  EXPECT_GT(strip.faces_of_strips, lists.triangles.size() / 2);
  EXPECT_LT(strip.faces_of_strips, 3 * lists.triangles.size() / 2);
}

// The strip is as wide as the result needs, wherever that leads.
TEST(CrossingCurves, ALegFarFromItsDrawingIsStraight) {
  const auto opened = OpenedMesh::open(grid(60, 60));
  const Surface& surface = opened->surface();
  const std::array curves = {
      vertex_curve(surface, along_grid(61, {{{5, 5}, {5, 35}, {45, 35}, {45, 5}}}), false),
      vertex_curve(surface, along_grid(61, {{{25, 20}, {25, 50}}}), false)};
  CurveOptions options;
  for (const SurfaceCurve& curve : curves) {
    options.way_points.push_back({curve.points.front()});
    options.way_points.push_back({curve.points.back()});
  }
  CurveSmoother smoother(opened);
  smoother.set_curves(curves, options);
  const SmoothingResult result = smoother.smooth(1.0);
  EXPECT_EQ(result.total.crossings_before, 1U);
  EXPECT_EQ(result.total.crossings_after, 0U);
  EXPECT_NEAR(result.reports[0].length_after, 40, 1e-9);
  EXPECT_NEAR(result.reports[1].length_after, 30, 1e-9);
}

TEST(CrossingCurves, CurvesThatCrossAreSmoothedAsIfAlone) {
  const auto opened = OpenedMesh::open(hills(40));
  const SurfaceCurve wave = wave_on_hills(opened->mesh());
  const std::array<Point, 4> down = {Point(17, 4, 0), Point(22, 14, 0), Point(18, 26, 0),
                                     Point(23, 36, 0)};
  const std::array curves = {wave, drawn_near(opened->mesh(), down, false)};
  CurveSmoother smoother(opened);
  smoother.set_curves(curves);
  const SmoothingResult result = smoother.smooth(1.0);
  EXPECT_EQ(result.total.crossings_before, 1U);
  EXPECT_EQ(result.total.crossings_after, 1U);
  for (std::size_t c = 0; c < 2; ++c) {
    const SmoothingResult alone = smooth_curve(opened, curves[c]);
    EXPECT_LT(apart(opened->mesh(), result.curves[c], alone.curve()), 1e-6);
    EXPECT_EQ(result.reports[c].points_before, alone.report().points_before);
  }
}

TEST(CrossingCurves, SpikesGoAndEndsStay) {
  const auto opened = OpenedMesh::open(grid(12, 12));
  // Along a row, up a column of it and back the same way, and on.
  const auto way = ids({66, 67, 68, 81, 94, 81, 68, 69, 70, 71, 70, 71, 72});
  const SurfaceCurve drawn = vertex_curve(opened->surface(), way, false);
  const SmoothingResult result = smooth_curve(opened, drawn);
  EXPECT_EQ(result.curve().points.front(), drawn.points.front());
  EXPECT_EQ(result.curve().points.back(), drawn.points.back());
  EXPECT_NEAR(result.report().length_after, 6, 1e-6);
  EXPECT_EQ(result.report().crossings_before, 0U);
}

bool warns_of(const SmoothingReport& report, const char* words) {
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

// Along a stem to a figure eight, around it, and back along the stem to where it began.
TEST(CrossingCurves, AnEndOnASpikeThatGoesStays) {
  const auto opened = OpenedMesh::open(hills(40));
  std::vector<Point> points{Point(20, 2, 0), Point(20, 10, 0)};
  for (const Point& p : eight(Point(20, 20, 0), 12, 48)) points.push_back(p);
  points.push_back(points[1]);
  points.push_back(points[0]);
  const SurfaceCurve drawn = through(opened->mesh(), points, false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  for (const double tau : {0.0, 0.25, 1.0, 4.0}) {
    const SmoothingResult result = smoother.smooth(tau);
    EXPECT_FALSE(result.curve().closed);
    EXPECT_EQ(result.curve().points.front(), drawn.points.front()) << tau;
    EXPECT_EQ(result.curve().points.back(), drawn.points.back()) << tau;
    EXPECT_GT(result.report().length_after, result.report().length_before / 2) << tau;
  }
}

TEST(CrossingCurves, APinOnASpikeIsLostAndTold) {
  const auto opened = OpenedMesh::open(grid(12, 12));
  const auto way = ids({66, 67, 68, 81, 94, 81, 68, 69, 70, 71});
  const SurfaceCurve drawn = vertex_curve(opened->surface(), way, false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn, {.pins = {drawn.points[1], drawn.points[4]}});
  const SmoothingReport report = smoother.smooth(1.0).report();
  EXPECT_TRUE(warns_of(report, "The pin (vertex 94) at (3, 7, 0) is lost"));
  EXPECT_FALSE(warns_of(report, "vertex 67"));
  smoother.set_pins(std::array{drawn.points[1], drawn.points[2]});
  EXPECT_FALSE(warns_of(smoother.smooth(1.0).report(), "is lost"));
}

TEST(CrossingCurves, TouchingItselfAtAVertexIsNoCrossing) {
  const auto opened = OpenedMesh::open(grid(16, 16));
  std::vector<Point> points;  // two loops side by side, that meet at (8, 8)
  for (const int side : {-1, 1}) {
    for (int k = 0; k < 24; ++k) {
      const double t = 2 * kPi * k / 24;
      points.emplace_back(8 + side * 3.5 * (1 - std::cos(t)), 8 - side * 3.5 * std::sin(t), 0);
    }
  }
  const SurfaceCurve drawn = through(opened->mesh(), points, true);
  const SmoothingReport report = smooth_curve(opened, drawn).report();
  EXPECT_EQ(report.crossings_before, 0U);
  EXPECT_LT(report.curvature_after, report.curvature_before * 1.01);
  EXPECT_LT(report.deviation_to_drawn_max, 2);
}

TEST(CrossingCurves, TheSameFromBothEndsAndWithThePapersMethod) {
  const auto opened = OpenedMesh::open(hills(40));
  std::vector<Point> points = eight(Point(20, 20, 0), 14, 90);
  const SurfaceCurve drawn = through(opened->mesh(), points, true);
  SurfaceCurve turned = drawn;
  std::reverse(turned.points.begin(), turned.points.end());
  const SurfaceCurve one = smooth_curve(opened, drawn).curve();
  EXPECT_LT(apart(opened->mesh(), one, smooth_curve(opened, turned).curve()), 1e-6);

  const SmoothingResult papers =
      smooth_curve(opened, drawn, {.tau = 1}, {.method = Method::kPaper});
  EXPECT_EQ(papers.report().crossings_after, 1U);
  EXPECT_LE(papers.report().lifted_length_after, papers.report().lifted_length_before);
}

TEST(CrossingCurves, DraggedAndHeldByPins) {
  const auto opened = OpenedMesh::open(hills(40));
  const SurfaceCurve drawn = through(opened->mesh(), eight(Point(20, 20, 0), 14, 60), true);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const std::array pins = {drawn.points[drawn.points.size() / 8]};
  smoother.set_pins(pins);
  const SurfaceCurve held = smoother.smooth(0.5).curve();
  EXPECT_NE(std::find(held.points.begin(), held.points.end(), pins[0]), held.points.end());

  const SurfaceCurve moved = through(opened->mesh(), eight(Point(21, 20, 0), 14, 60), true);
  const SmoothingResult preview = smoother.drag(0, moved);
  EXPECT_EQ(preview.report().engine, Engine::kPreview);
  EXPECT_EQ(preview.report().crossings_after, 1U);
}

/// Crossings of paths along the edges of a (4 x 4) sheet.
std::vector<std::size_t> crossings(const std::vector<std::vector<VertexId>>& ways) {
  const Surface surface = surface_of_lists(grid(4, 4));
  const SignpostTriangulation t(surface);
  std::vector<EdgePath> paths;
  for (const auto& way : ways) {
    const bool closed = way.front() == way.back();
    std::vector<HalfedgeId> h;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      h.push_back(surface.find_halfedge(way[i], way[i + 1]));
    }
    paths.push_back(EdgePath::make(t, h, closed));
  }
  return path_contacts(t, paths).crossings;
}

TEST(PathContacts, CountsWhatChangesSides) {
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(crossings({ids({10, 11, 12, 13, 14}), ids({2, 7, 12, 17, 22})}), Counts({1, 0}));
  // Together for an edge, in the same direction and against it; across and to the same side.
  EXPECT_EQ(crossings({ids({10, 11, 12, 13}), ids({6, 11, 12, 17})}), Counts({1, 0}));
  EXPECT_EQ(crossings({ids({10, 11, 12, 13}), ids({17, 12, 11, 6})}), Counts({1, 0}));
  EXPECT_EQ(crossings({ids({10, 11, 12, 13}), ids({6, 11, 12, 7})}), Counts({0, 0}));
  EXPECT_EQ(crossings({ids({10, 11, 12, 13}), ids({7, 12, 11, 6})}), Counts({0, 0}));
  // What ends on another does not cross it.
  EXPECT_EQ(crossings({ids({10, 11, 12, 13}), ids({2, 7, 12})}), Counts({0, 0}));
  EXPECT_EQ(crossings({ids({10, 11, 12, 13}), ids({2, 7, 12, 13})}), Counts({0, 0}));
  // One path, across itself.
  EXPECT_EQ(crossings({ids({10, 11, 12, 13, 18, 12, 17, 22})}), Counts({0}));
  EXPECT_EQ(crossings({ids({10, 11, 12, 13, 18, 17, 12, 7, 2})}), Counts({1}));
  // The same loop twice.
  EXPECT_EQ(crossings({ids({6, 7, 12, 6}), ids({6, 7, 12, 6})}), Counts({0, 0}));
}

/// A random walk along edges, with ways back and along what was walked before.
std::vector<VertexId> random_walk(const Surface& surface, std::mt19937& random, std::size_t n) {
  std::vector<VertexId> walk{VertexId{random() % surface.vertex_count()}};
  while (walk.size() < n) {
    std::vector<VertexId> next;
    const HalfedgeId first = surface.halfedge(walk.back());
    for (HalfedgeId h = first; h.valid();) {
      next.push_back(surface.head(h));
      if (!surface.has_face(h)) break;
      h = surface.turn_ccw(h);
      if (h == first) break;
    }
    walk.push_back(next[random() % next.size()]);
  }
  return walk;
}

// How often two paths cross does not depend on which others there are, though all passages of a
// vertex are counted at once.
TEST(PathContacts, OfASetAreThoseOfItsPairs) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(4, 4));
  std::mt19937 random(11);
  for (int run = 0; run < 20; ++run) {
    std::vector<SurfaceCurve> curves;
    for (int c = 0; c < 12; ++c) {
      curves.push_back(
          vertex_curve(mesh.surface(), random_walk(mesh.surface(), random, 12), false));
    }
    SignpostTriangulation triangulation(mesh.surface());
    const std::vector<EdgePath> paths = embed_curves(triangulation, curves).paths;
    const PathContacts all = path_contacts(triangulation, paths);
    std::vector<std::size_t> alone(paths.size()), sum(paths.size());
    std::vector<bool> tangled(paths.size());
    for (std::size_t p = 0; p < paths.size(); ++p) {
      const PathContacts own = path_contacts(triangulation, std::span(&paths[p], 1));
      sum[p] = alone[p] = own.crossings[0];
      tangled[p] = own.tangled[0];
    }
    for (std::size_t p = 0; p < paths.size(); ++p) {
      for (std::size_t q = p + 1; q < paths.size(); ++q) {
        const std::vector<EdgePath> pair{paths[p], paths[q]};
        const std::size_t crossings = path_contacts(triangulation, pair).crossings[0] - alone[p];
        sum[p] += crossings;
        if (crossings > 0) tangled[p] = tangled[q] = true;
      }
    }
    EXPECT_EQ(all.crossings, sum) << run;
    EXPECT_EQ(all.tangled, tangled) << run;
  }
}

}  // namespace
}  // namespace talweg
