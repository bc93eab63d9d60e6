#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/reference_data.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::grid;
using test::ids;
using test::sphere;

/// A zigzag from left to right through the middle of a grid.
SurfaceCurve zigzag(const SurfaceMesh& mesh, std::uint32_t columns, std::uint32_t rows) {
  std::vector<VertexId> path;
  const std::uint32_t middle = rows / 2;
  for (std::uint32_t i = 2; i + 2 <= columns; ++i) {
    const std::uint32_t j = middle + (i / 3) % 2;
    const VertexId v{j * (columns + 1) + i};
    if (!path.empty() && !mesh.surface().find_halfedge(path.back(), v).valid()) {
      path.emplace_back(j * (columns + 1) + i - 1);
    }
    path.push_back(v);
  }
  return test::vertex_curve(mesh.surface(), path, false);
}

bool same_bytes(const SurfaceMesh& mesh, const SurfaceCurve& a, const SurfaceCurve& b) {
  const std::vector<Point> p = positions_of(mesh, a), q = positions_of(mesh, b);
  return p.size() == q.size() && std::memcmp(p.data(), q.data(), p.size() * sizeof(Point)) == 0;
}

void expect_on_mesh(const Surface& surface, const SurfaceCurve& curve) {
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    EXPECT_TRUE(common_face(surface, curve.points[i], curve.points[i + 1]).valid()) << i;
  }
  if (curve.closed) {
    EXPECT_TRUE(common_face(surface, curve.points.back(), curve.points.front()).valid());
  }
}

TEST(CurveSmoother, TauZeroGivesTheStraightLineOnAPlane) {
  const auto opened = OpenedMesh::open(grid(30, 20));
  const SurfaceCurve drawn = zigzag(opened->mesh(), 30, 20);
  const SmoothingResult result = smooth_curve(opened, drawn, {.tau = 0});
  const std::vector<Point> points = positions_of(opened->mesh(), result.curve());
  const Point p = points.front(), q = points.back();
  EXPECT_EQ(p, opened->mesh().position(drawn.points.front()));
  EXPECT_EQ(q, opened->mesh().position(drawn.points.back()));
  EXPECT_NEAR(result.report().after.length, (q - p).norm(), 1e-12 * (q - p).norm());
  for (const Point& x : points) {
    EXPECT_NEAR((x - p).cross(q - p).norm() / (q - p).norm(), 0, 1e-10);
  }
  EXPECT_LT(result.report().after.total_curvature, 1e-9);
  EXPECT_EQ(result.report().termination, Outcome::kConverged);
}

TEST(CurveSmoother, MoreTauStaysCloser) {
  const auto opened = OpenedMesh::open(grid(60, 40));
  CurveSmoother smoother(opened);
  std::vector<VertexId> way;
  for (const std::uint32_t v : {2U + 61 * 5, 30U + 61 * 35, 58U + 61 * 5}) way.emplace_back(v);
  const auto path = draw_edge_path(opened->surface(), way);
  smoother.set_curve(test::vertex_curve(opened->surface(), path, false));
  double before = 1e300;
  for (const double tau : {0.0, 0.2, 0.5, 1.0, 2.0}) {
    const SmoothingReport report = smoother.smooth(tau).report();
    EXPECT_LT(report.deviation_from_drawn_max, before) << tau;
    EXPECT_LE(report.lifted_length_after, report.lifted_length_before) << tau;
    before = report.deviation_from_drawn_max;
  }
}

TEST(CurveSmoother, LazyAndWholeMeshPreparationGiveTheSameBytes) {
  const auto opened = OpenedMesh::open(sphere(5));
  const auto path = draw_edge_path(opened->surface(), ids({0, 900, 3000, 7}));
  CurveSmoother smoother(opened);
  for (const Method method : {Method::kCorridor, Method::kPaper}) {
    smoother.set_curve(test::vertex_curve(opened->surface(), path, false), {.method = method});
    for (const double tau : {0.0, 0.5, 2.0, 16.0}) {
      const SmoothingResult lazy = smoother.smooth({.tau = tau});
      const SmoothingResult whole = smoother.smooth({.tau = tau, .prepare_whole_mesh = true});
      EXPECT_TRUE(same_bytes(opened->mesh(), lazy.curve(), whole.curve())) << tau;
      const bool straightens = method == Method::kPaper || tau == 0;
      EXPECT_EQ(lazy.report().flips, straightens ? whole.report().flips : 0U);
      EXPECT_LT(lazy.report().faces_touched, whole.report().faces_touched);
      EXPECT_EQ(whole.report().faces_touched, opened->surface().face_count());
    }
  }
}

TEST(CurveSmoother, ARunLeavesNoTrace) {
  const auto opened = OpenedMesh::open(sphere(4));
  const auto path = draw_edge_path(opened->surface(), ids({0, 600, 3, 200}));
  const SurfaceCurve drawn = test::vertex_curve(opened->surface(), path, false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const SmoothingResult first = smoother.smooth(0.7);
  smoother.smooth(0.0);
  smoother.smooth(3.0);
  smoother.set_curve(first.curve());  // inserts points; the next drawing must not see them
  smoother.smooth(1.0);
  smoother.set_curve(drawn);
  EXPECT_TRUE(same_bytes(opened->mesh(), first.curve(), smoother.smooth(0.7).curve()));
}

TEST(CurveSmoother, StaysBelowTheHeightThatTheLiftedLengthAllows) {
  // To reach height φ on the way from p to q a path climbs and comes back: 2φ <= l + φ(p) + φ(q).
  const auto opened = OpenedMesh::open(sphere(5));
  const auto path = draw_edge_path(opened->surface(), ids({0, 2500, 3, 800}));
  CurveSmoother smoother(opened);
  smoother.set_curve(test::vertex_curve(opened->surface(), path, false),
                     {.method = Method::kPaper});
  double largest = 0;
  for (const double d : smoother.distance()) largest = std::max(largest, d);
  const Surface& surface = opened->surface();
  for (const double tau : {0.25, 1.0, 4.0}) {
    const SmoothingResult result = smoother.smooth(tau);
    const Potential phi({}, tau, largest);
    const auto height = [&](const SurfacePoint& p) {
      const FaceCoordinates at = coordinates_in(surface, p, any_face(surface, p));
      double value = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        value += at.barycentric[k] * phi(smoother.distance()[surface.corners(at.face)[k].index()]);
      }
      return value;
    };
    const auto& points = result.curve().points;
    const double bound =
        (result.report().lifted_length_before + height(points.front()) + height(points.back())) / 2;
    for (const SurfacePoint& p : points) EXPECT_LE(height(p), bound * (1 + 1e-9));
  }
}

TEST(CurveSmoother, KeepsPins) {
  const auto opened = OpenedMesh::open(grid(30, 20));
  const SurfaceCurve drawn = zigzag(opened->mesh(), 30, 20);
  const SurfacePoint pin = drawn.points[drawn.points.size() / 2 + 1];
  const SmoothingResult result = smooth_curve(opened, drawn, {.tau = 0}, {.pins = {pin}});
  EXPECT_NE(std::find(result.curve().points.begin(), result.curve().points.end(), pin),
            result.curve().points.end());
  EXPECT_THROW(smooth_curve(opened, drawn, {},
                            {.pins = {SurfacePoint::at_vertex(opened->surface(), VertexId{0})}}),
               Error);
}

TEST(CurveSmoother, StartsAndPassesInsideFacesAndEdges) {
  const auto opened = OpenedMesh::open(grid(20, 20));
  const Surface& surface = opened->surface();
  const auto at = [&](double x, double y) {
    const auto i = static_cast<std::uint32_t>(x), j = static_cast<std::uint32_t>(y);
    const double u = x - i, v = y - j;
    const bool lower = u >= v;
    const FaceId face{2 * (j * 20 + i) + (lower ? 0U : 1U)};
    const std::array<double, 3> b =
        lower ? std::array<double, 3>{1 - u, u - v, v} : std::array<double, 3>{1 - v, u, v - u};
    return SurfacePoint::from_barycentric(surface, face, b);
  };
  const std::vector<SurfacePoint> points = {at(2.3, 3.1), at(6.7, 9.2), at(12.5, 4.25),
                                            at(17.9, 16.3)};
  const SurfaceCurve drawn = StraightLines(surface).join(points, false);
  double expected = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    expected +=
        (opened->mesh().position(points[i]) - opened->mesh().position(points[i + 1])).norm();
  }
  EXPECT_NEAR(curve_length(surface, drawn), expected, 1e-11 * expected);

  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  for (const double tau : {0.0, 0.5, 3.0}) {
    const SmoothingResult result = smoother.smooth(tau);
    expect_on_mesh(surface, result.curve());
    EXPECT_EQ(result.curve().points.front(), drawn.points.front());
    EXPECT_EQ(result.curve().points.back(), drawn.points.back());
    EXPECT_LE(result.report().lifted_length_after, result.report().lifted_length_before);
    if (tau == 0) {
      const double direct =
          (opened->mesh().position(points.front()) - opened->mesh().position(points.back())).norm();
      EXPECT_NEAR(result.report().after.length, direct, 1e-10 * direct);
    }
  }
}

TEST(CurveSmoother, ALoopOnADiscEndsAsCollapsed) {
  const auto opened = OpenedMesh::open(grid(40, 40));
  const auto path = draw_edge_path(
      opened->surface(), ids({10 + 41 * 10, 30 + 41 * 11, 29 + 41 * 30, 11 + 41 * 29}), true);
  const SmoothingResult result =
      smooth_curve(opened, test::vertex_curve(opened->surface(), path, true), {.tau = 0});
  EXPECT_EQ(result.report().termination, Outcome::kCollapsed);
  EXPECT_GE(result.curve().points.size(), 3U);
  EXPECT_GT(result.report().after.length, 0);
  EXPECT_FALSE(result.report().warnings.empty());
  expect_on_mesh(opened->surface(), result.curve());
}

TEST(CurveSmoother, CurvesOfASetKeepApart) {
  const auto opened = OpenedMesh::open(grid(30, 30));
  const Surface& surface = opened->surface();
  // Two bows towards each other; straight lines between their ends would cross.
  const auto first = draw_edge_path(surface, ids({2 + 31 * 4, 15 + 31 * 14, 28 + 31 * 4}));
  const auto second = draw_edge_path(surface, ids({2 + 31 * 8, 15 + 31 * 17, 28 + 31 * 8}));
  const std::vector<SurfaceCurve> curves = {test::vertex_curve(surface, first, false),
                                            test::vertex_curve(surface, second, false)};
  CurveSmoother smoother(opened);
  smoother.set_curves(curves);
  const SmoothingResult result = smoother.smooth(0.0);
  ASSERT_EQ(result.curves.size(), 2U);
  ASSERT_EQ(result.reports.size(), 2U);
  EXPECT_NEAR(result.total.after.length,
              result.reports[0].after.length + result.reports[1].after.length, 1e-12);
  EXPECT_NEAR(result.reports[0].after.length, 26, 1e-9);
  EXPECT_NEAR(result.reports[1].after.length, 26, 1e-9);
}

TEST(CurveSmoother, ASetOverTwoComponentsIsTheTwoAlone) {
  // A small grid beside a grid ten times as large: each has its own characteristic length.
  const MeshLists small = grid(30, 20);
  MeshLists both = small;
  const auto shift = static_cast<std::uint32_t>(small.points.size());
  for (const Point& p : small.points) both.points.push_back(10 * p + Point(1000, 0, 0));
  for (Triangle t : small.triangles) {
    for (std::uint32_t& v : t) v += shift;
    both.triangles.push_back(t);
  }
  const auto alone = OpenedMesh::open(small);
  const auto opened = OpenedMesh::open(both);
  const SurfaceCurve first = zigzag(alone->mesh(), 30, 20);
  SurfaceCurve second{false, {}};
  for (const SurfacePoint& p : first.points) {
    const std::size_t v = std::get<AtVertex>(p.where()).vertex.index();
    second.points.push_back(SurfacePoint::at_vertex(opened->surface(), VertexId{v + shift}));
  }
  const double length = smooth_curve(alone, first, {.tau = 1}).report().after.length;
  CurveSmoother smoother(opened);
  smoother.set_curves(std::vector<SurfaceCurve>{first, second});
  const SmoothingResult result = smoother.smooth(1.0);
  EXPECT_NEAR(result.reports[0].after.length, length, 1e-9 * length);
  EXPECT_NEAR(result.reports[1].after.length, 10 * length, 1e-8 * length);
}

TEST(CurveSmoother, TakesADistanceAndAPotentialOfTheCallers) {
  const auto opened = OpenedMesh::open(grid(30, 20));
  const SurfaceCurve drawn = zigzag(opened->mesh(), 30, 20);
  const std::size_t n = opened->surface().vertex_count();
  std::vector<double> distance(n);
  for (std::size_t v = 0; v < n; ++v) distance[v] = std::abs(opened->mesh().points()[v].y() - 10);
  CurveSmoother smoother(opened);
  smoother.set_curves(std::span(&drawn, 1), distance);
  const SmoothingResult by_distance = smoother.smooth(0.4);

  const double largest = *std::max_element(distance.begin(), distance.end());
  const Potential phi({}, 0.4, largest);
  std::vector<double> potential(2 * n);  // the same height, turned in a plane
  for (std::size_t v = 0; v < n; ++v) {
    potential[2 * v] = 0.6 * phi(distance[v]);
    potential[2 * v + 1] = 0.8 * phi(distance[v]);
  }
  const SmoothingResult by_potential = smoother.smooth({}, potential, 2);
  EXPECT_NEAR(by_potential.report().lifted_length_before, by_distance.report().lifted_length_before,
              1e-12 * by_distance.report().lifted_length_before);
  EXPECT_NEAR(by_potential.report().lifted_length_after, by_distance.report().lifted_length_after,
              1e-10 * by_distance.report().lifted_length_after);
  EXPECT_EQ(by_potential.report().potential, PotentialKind::kCustom);
  potential.pop_back();
  EXPECT_THROW(smoother.smooth({}, potential, 2), Error);
  distance.pop_back();
  EXPECT_THROW(smoother.set_curves(std::span(&drawn, 1), distance), Error);
}

TEST(CurveSmoother, RefusesInvalidCurves) {
  const auto opened = OpenedMesh::open(grid(10, 10));
  const Surface& surface = opened->surface();
  CurveSmoother smoother(opened);
  EXPECT_THROW(smoother.smooth(1.0), Error) << "no curve set";
  const auto refuse = [&](std::initializer_list<std::uint32_t> path, bool closed) {
    EXPECT_THROW(smoother.set_curve(test::vertex_curve(surface, ids(path), closed)), Error);
    EXPECT_THROW(smoother.smooth(1.0), Error) << "a refused curve must not be set";
  };
  refuse({}, false);
  refuse({5}, false);
  refuse({5, 5}, false);
  refuse({5, 6, 5}, false);
  refuse({5, 50}, false);
  refuse({5, 6}, true);
  EXPECT_THROW(SurfacePoint::at_vertex(surface, VertexId{121}), Error);
  EXPECT_THROW(smoother.smooth(-1.0), Error);
  // A curl of one face, and the way on.
  EXPECT_TRUE(smoother.set_curve(test::vertex_curve(surface, ids({5, 6, 17, 5, 4}), false)));
  EXPECT_NEAR(smoother.smooth(1.0).report().after.length, 1, 1e-12);
}

TEST(CurveSmoother, CancelsAtAnyMoment) {
  const auto opened = OpenedMesh::open(sphere(4));
  const auto path = draw_edge_path(opened->surface(), ids({0, 600, 3, 200}));
  const SurfaceCurve drawn = test::vertex_curve(opened->surface(), path, false);
  CurveSmoother smoother(opened);
  for (int calls = 0; calls < 12; ++calls) {
    int left = calls;
    const Progress progress = [&](const char*, double) { return left-- > 0; };
    if (!smoother.set_curve(drawn, {}, progress)) continue;
    SmoothingOptions options;
    options.tau = 0;
    const SmoothingResult result = smoother.smooth(options, progress);
    expect_on_mesh(opened->surface(), result.curve());
    EXPECT_LE(result.report().lifted_length_after, result.report().lifted_length_before);
  }
  ASSERT_TRUE(smoother.set_curve(drawn));
  EXPECT_EQ(smoother.smooth(1.0).report().termination, Outcome::kConverged);
}

// ---- invariance: the same drawing transformed ----

struct Dressed {
  MeshLists lists;
  std::vector<std::uint32_t> new_id;  // of each old vertex
  double scale = 1;
};

MeshLists bumpy_sphere() {
  MeshLists lists = sphere(4);
  for (Point& p : lists.points) {
    p *= 1 + 0.15 * std::sin(5 * p.x() + 0.3) * std::cos(4 * p.y()) + 0.1 * std::sin(7 * p.z());
  }
  return lists;
}

double worst_difference(const SurfaceMesh& mesh, const SurfaceCurve& a, const SurfaceMesh& other,
                        const SurfaceCurve& b, double scale, const Point& shift) {
  const std::vector<Point> p = positions_of(mesh, a), q = positions_of(other, b);
  if (p.size() != q.size()) return HUGE_VAL;
  double worst = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    worst = std::max(worst, ((q[i] - shift) / scale - p[i]).norm());
  }
  return worst;
}

class Metamorphic : public ::testing::TestWithParam<double> {};

TEST_P(Metamorphic, ScaleShiftAndNumberingDoNotMatter) {
  const double tau = GetParam();
  const MeshLists lists = bumpy_sphere();
  const auto opened = OpenedMesh::open(lists);
  const auto path = draw_edge_path(opened->surface(), ids({0, 600, 3, 200}));
  const SurfaceCurve drawn = test::vertex_curve(opened->surface(), path, false);
  const SmoothingResult result = smooth_curve(opened, drawn, {.tau = tau});

  struct Case {
    const char* name;
    double scale;
    Point shift;
    double tolerance;  // for a mesh of size 1: rounding moves crossings
  };
  const Case cases[] = {{"1e8", 1e8, Point::Zero(), 1e-9},
                        {"1e-8", 1e-8, Point::Zero(), 1e-9},
                        {"5e6 away", 1, Point(5e6, -5e6, 5e6), 3e-5}};
  for (const Case& c : cases) {
    MeshLists moved = lists;
    for (Point& p : moved.points) p = c.scale * p + c.shift;
    const auto other = OpenedMesh::open(moved);
    const SmoothingResult same = smooth_curve(other, drawn, {.tau = tau});
    EXPECT_LE(worst_difference(opened->mesh(), result.curve(), other->mesh(), same.curve(), c.scale,
                               c.shift),
              c.tolerance)
        << c.name;
  }

  // Renumbered vertices and shuffled, turned faces.
  std::mt19937 random(7);
  std::vector<std::uint32_t> new_id(lists.points.size());
  for (std::uint32_t v = 0; v < new_id.size(); ++v) new_id[v] = v;
  std::shuffle(new_id.begin(), new_id.end(), random);
  MeshLists renumbered = lists;
  for (std::size_t v = 0; v < new_id.size(); ++v) renumbered.points[new_id[v]] = lists.points[v];
  for (Triangle& t : renumbered.triangles) {
    for (std::uint32_t& v : t) v = new_id[v];
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  }
  std::shuffle(renumbered.triangles.begin(), renumbered.triangles.end(), random);
  const auto other = OpenedMesh::open(renumbered);
  std::vector<VertexId> other_path;
  for (const VertexId v : path) other_path.emplace_back(new_id[v.index()]);
  const SmoothingResult same =
      smooth_curve(other, test::vertex_curve(other->surface(), other_path, false), {.tau = tau});
  EXPECT_LE(worst_difference(opened->mesh(), result.curve(), other->mesh(), same.curve(), 1,
                             Point::Zero()),
            1e-9);

  // The reversed drawing. Ties in the order of flips may be broken differently, so lengths are
  // compared.
  std::vector<VertexId> backwards(path.rbegin(), path.rend());
  const SmoothingOptions taut{.tau = tau, .finish = Finish::kTaut};
  const auto lifted_length = [&](const std::vector<VertexId>& along) {
    const SurfaceCurve curve = test::vertex_curve(opened->surface(), along, false);
    return smooth_curve(opened, curve, taut, {.cap_corners = true}).report().lifted_length_after;
  };
  EXPECT_NEAR(lifted_length(backwards) / lifted_length(path), 1, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Tau, Metamorphic, ::testing::Values(0.0, 0.5, 2.0));

// ---- against the reference programs, on real meshes ----

class Reference : public ::testing::TestWithParam<std::tuple<const char*, double>> {};

TEST_P(Reference, LiftedLengthsWithTheReferenceDistanceAgree) {
  const auto [name, tau] = GetParam();
  const auto reference = test::reference_curve(name);
  std::ifstream numbers(test::reference_folder() / "distance" / (std::string(name) + ".txt"));
  if (!reference || !numbers) {
    GTEST_SKIP() << test::missing("real meshes");
  }
  std::vector<double> distance;
  for (double d = 0; numbers >> d;) distance.push_back(d);
  const auto opened = OpenedMesh::open(reference->mesh);
  CurveSmoother smoother(opened);
  const SurfaceCurve drawn =
      test::vertex_curve(opened->surface(), reference->path, reference->closed);
  smoother.set_curves(std::span(&drawn, 1), distance);
  const SmoothingReport report = smoother.smooth(tau).report();
  const auto expected = test::reference_numbers(name, tau);
  // The file has nine digits.
  const double before = expected["lifted_length_before"], after = expected["lifted_length_after"];
  EXPECT_NEAR(report.lifted_length_before, before, 1e-8 * before);
  EXPECT_LE(report.lifted_length_after, after * (1 + 1e-6));
  EXPECT_EQ(report.termination, Outcome::kConverged);
  EXPECT_EQ(report.trace_fallbacks, 0U);
}

class OwnDistance : public ::testing::TestWithParam<const char*> {};

TEST_P(OwnDistance, SmoothsTheReferenceCurves) {
  const std::string name = GetParam();
  const std::string mesh = name.substr(0, name.find("_loop"));
  std::ifstream numbers(test::reference_folder() / "curves" / (name + ".txt"));
  if (!numbers) {
    GTEST_SKIP() << test::missing("real meshes");
  }
  const auto opened =
      OpenedMesh::open(test::read_reference_mesh(test::mesh_folder() / (mesh + ".ply")));
  std::vector<VertexId> path;
  for (std::size_t v = 0; numbers >> v;) path.emplace_back(v);
  const SurfaceCurve drawn = curve_through(opened->surface(), path);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  for (const double tau : {0.0, 0.5, 1.0, 2.0}) {
    const SmoothingResult result = smoother.smooth(tau);
    const SmoothingReport& report = result.report();
    expect_on_mesh(opened->surface(), result.curve());
    EXPECT_LE(report.lifted_length_after, report.lifted_length_before);
    EXPECT_TRUE(std::isfinite(report.after.total_curvature));
    EXPECT_EQ(report.trace_fallbacks, 0U);
    if (drawn.closed) {
      EXPECT_TRUE(report.termination == Outcome::kConverged ||
                  report.termination == Outcome::kCollapsed);
      EXPECT_GE(result.curve().points.size(), 3U);
    } else {
      EXPECT_EQ(report.termination, Outcome::kConverged);
      EXPECT_EQ(result.curve().points.front(), drawn.points.front());
      EXPECT_EQ(result.curve().points.back(), drawn.points.back());
    }
  }
}

/// A case that once took 19 minutes: one flip and one bound of the deviation asked for exact
/// distances far from these edges, over thousands of needles.
TEST(RealBuildings, ADrawingAlongLongEdgesAmongNeedles) {
  const std::filesystem::path path = test::mesh_folder() / "buildings_needles_400k.ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << test::missing(path.stem().string());
  const auto opened = OpenedMesh::open(repair(read_mesh(path)).lists);
  CurveInput input;
  input.points =
      std::vector<Point>{{90.1008, 55.6751, 9}, {90.1008, 55.6751, 0}, {116.669, 78.1875, 0}};
  const SurfaceCurve drawn{false, snap(opened->mesh(), input).points};
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  const SmoothingResult result = smoother.smooth(1.0);
  expect_on_mesh(opened->surface(), result.curve());
  EXPECT_EQ(result.report().termination, Outcome::kConverged);
  EXPECT_LT(result.report().after.total_curvature, result.report().before.total_curvature);
  EXPECT_LT(result.report().deviation_from_drawn_max, result.report().edge_length_near);
}

INSTANTIATE_TEST_SUITE_P(Real, OwnDistance,
                         ::testing::Values("fandisk_14k", "aneurysm_14k", "armadillo_86k",
                                           "armadillo_86k_loop_large", "armadillo_86k_loop_small",
                                           "skull_100k", "tooth_ct_119k", "brain_icbm_164k",
                                           "mouse_skull_984k"));

INSTANTIATE_TEST_SUITE_P(Real, Reference,
                         ::testing::Combine(::testing::Values("fandisk_14k", "aneurysm_14k",
                                                              "armadillo_86k"),
                                            ::testing::Values(0.5, 1.0, 2.0)));

}  // namespace
}  // namespace talweg
