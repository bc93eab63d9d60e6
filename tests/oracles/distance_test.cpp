// Distances against CGAL's exact distances: Talweg's exact distance agrees to rounding; the error
// of the heat method is bounded and decreases under refinement. The figures are in
// docs/development/testing.md.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/reference_data.hpp"
#include "core/small_meshes.hpp"
#include "exact_distance.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/heat/heat_distance.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

using test::ExactGeodesics;

/// The exact distance of every vertex to a curve along edges, with `pieces` sources per edge. The
/// distance is too large by at most (h / 2 pieces)² / 2 d at distance d, for edges of length h.
std::vector<double> exact_distance(const MeshLists& lists, const std::vector<VertexId>& path,
                                   bool closed, int pieces) {
  ExactGeodesics exact(lists);
  for (std::size_t i = 0; i < path.size(); ++i) {
    exact.add_source(path[i]);
    if (i + 1 == path.size() && !closed) break;
    for (int k = 1; k < pieces; ++k) {
      exact.add_source(path[i], path[(i + 1) % path.size()], static_cast<double>(k) / pieces);
    }
  }
  std::vector<double> distance;
  for (std::size_t v = 0; v < lists.points.size(); ++v) {
    distance.push_back(exact.distance(VertexId{v}));
  }
  return distance;
}

struct HeatError {
  double mean = 0;     // of the largest distance
  double largest = 0;  // of the largest distance
};

/// The error at the first exact.size() vertices with the paper's heat time (10 h²). The error with
/// the original heat time (h²) is printed, too.
HeatError heat_error(const Surface& surface, const SurfaceCurve& curve,
                     const std::vector<double>& exact) {
  const double scale = *std::max_element(exact.begin(), exact.end());
  HeatError errors[2];
  for (const int k : {0, 1}) {
    const auto heat = heat_distance(surface, curve, {.time_scale = k == 0 ? 10.0 : 1.0});
    for (std::size_t v = 0; v < exact.size(); ++v) {
      const double e = std::abs(heat[v] - exact[v]) / scale;
      errors[k].mean += e / static_cast<double>(exact.size());
      errors[k].largest = std::max(errors[k].largest, e);
    }
  }
  std::printf(
      "  %zu faces: mean %.2f %%, largest %.1f %% of the largest distance (s = 1: %.2f, %.1f)\n",
      surface.face_count(), 100 * errors[0].mean, 100 * errors[0].largest, 100 * errors[1].mean,
      100 * errors[1].largest);
  return errors[0];
}

/// Splits every triangle in four; old vertices keep their numbers, and the surface stays the same.
MeshLists halved(const MeshLists& lists) {
  const Surface surface = Surface::from_triangles(lists.points.size(), lists.triangles);
  MeshLists fine;
  fine.points = lists.points;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    fine.points.push_back(
        (lists.points[surface.tail(h).index()] + lists.points[surface.head(h).index()]) / 2);
  }
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const HalfedgeId h = surface.halfedge(FaceId{f});
    const auto middle = [&](HalfedgeId side) {
      return static_cast<std::uint32_t>(lists.points.size() + edge_of(side).index());
    };
    const std::uint32_t a = middle(h);
    const std::uint32_t b = middle(surface.next(h));
    const std::uint32_t c = middle(surface.prev(h));
    const Triangle& t = lists.triangles[f];
    fine.triangles.insert(fine.triangles.end(),
                          {{t[0], a, c}, {t[1], b, a}, {t[2], c, b}, {a, b, c}});
  }
  return fine;
}

/// The path on the refined mesh.
std::vector<VertexId> halved(const Surface& coarse, const std::vector<VertexId>& path,
                             bool closed) {
  std::vector<VertexId> fine;
  for (std::size_t i = 0; i < path.size(); ++i) {
    fine.push_back(path[i]);
    if (i + 1 == path.size() && !closed) break;
    const HalfedgeId h = coarse.find_halfedge(path[i], path[(i + 1) % path.size()]);
    fine.emplace_back(coarse.vertex_count() + edge_of(h).index());
  }
  return fine;
}

TEST(ExactOracle, KnowsThePlaneAndTheBox) {
  ExactGeodesics plane(test::grid(8, 6));
  plane.add_source(VertexId{0});
  EXPECT_NEAR(plane.distance(VertexId{6 * 9 + 8}), 10, 1e-12);
  ExactGeodesics box(test::box());  // opposite corners: two sides unfolded
  box.add_source(VertexId{0});
  EXPECT_NEAR(box.distance(VertexId{7}), std::sqrt(5.0), 1e-12);
  // A source between two vertices: from (0.25, 0) to (3, 4) in the plane.
  ExactGeodesics between(test::grid(8, 6));
  between.add_source(VertexId{0}, VertexId{1}, 0.25);
  EXPECT_NEAR(between.distance(VertexId{4 * 9 + 3}), std::hypot(2.75, 4), 1e-8);
}

class RealMesh : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const auto reference = test::reference_curve(GetParam());
    if (!reference) {
      GTEST_SKIP() << test::missing(GetParam());
    }
    lists_ = test::read_reference_mesh(test::mesh_folder() / (std::string(GetParam()) + ".ply"));
    path_ = reference->path;
    closed_ = reference->closed;
  }
  MeshLists lists_;
  std::vector<VertexId> path_;
  bool closed_ = false;
};

TEST_P(RealMesh, OurExactDistanceAgreesToRounding) {
  // The curves are single points, so that both programs measure from the same set.
  const SurfaceMesh mesh = SurfaceMesh::open(lists_);
  const Surface& surface = mesh.surface();
  ExactGeodesics exact(lists_);
  std::vector<SurfaceCurve> points;
  for (std::size_t i = 0; i < path_.size(); i += 40) {
    exact.add_source(path_[i]);
    points.push_back({false, {SurfacePoint::at_vertex(surface, path_[i])}});
  }
  PolylineDistance ours(surface);
  ours.set(points);
  double scale = 0;
  double worst = 0;
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
    const double expected = exact.distance(VertexId{v});
    scale = std::max(scale, expected);
    worst = std::max(worst, std::abs(ours.at_vertex(VertexId{v}).distance - expected));
  }
  std::printf("  largest difference %.1e of the largest distance\n", worst / scale);
  EXPECT_LE(worst, 1e-9 * scale);
}

TEST_P(RealMesh, HeatDistanceComesCloserUnderRefinement) {
  // Refinement keeps the surface, so the exact distance at old vertices is unchanged.
  const std::vector<double> exact = exact_distance(lists_, path_, closed_, 4);
  const SurfaceMesh coarse = SurfaceMesh::open(lists_);
  const SurfaceMesh fine = SurfaceMesh::open(halved(lists_));
  const HeatError before =
      heat_error(coarse.surface(), test::vertex_curve(coarse.surface(), path_, closed_), exact);
  const auto fine_path = halved(coarse.surface(), path_, closed_);
  const HeatError after =
      heat_error(fine.surface(), test::vertex_curve(fine.surface(), fine_path, closed_), exact);
  EXPECT_LE(before.mean, 0.1);
  EXPECT_LE(before.largest, 0.35);
  EXPECT_LE(after.mean, 0.7 * before.mean);
  EXPECT_LE(after.largest, 0.7 * before.largest);
}

INSTANTIATE_TEST_SUITE_P(All, RealMesh, ::testing::Values("fandisk_14k", "aneurysm_14k"),
                         [](const auto& one) { return std::string(one.param); });

TEST(HeatOracle, ConvergesOnThePlane) {
  // An oblique drawing with a corner, on sheets of 1 x 1.
  HeatError before;
  for (const std::uint32_t n : {12U, 24U, 48U}) {
    MeshLists lists = test::grid(n, n);
    for (Point& p : lists.points) p /= n;
    const SurfaceMesh mesh = SurfaceMesh::open(lists);
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
      return VertexId{j * n / 12 * (n + 1) + i * n / 12};
    };
    const std::vector<VertexId> ways = {at(2, 2), at(6, 6), at(10, 6)};
    const auto path = draw_edge_path(mesh.surface(), ways);
    const HeatError error =
        heat_error(mesh.surface(), test::vertex_curve(mesh.surface(), path, false),
                   exact_distance(lists, path, false, 8));
    if (n > 12) {
      EXPECT_LE(error.mean, 0.8 * before.mean);
      EXPECT_LE(error.largest, 0.85 * before.largest);
    }
    before = error;
  }
  EXPECT_LE(before.mean, 0.04);
}

TEST(HeatOracle, ConvergesOnTheSphere) {
  // Along the great circle y = 0, which the octahedron's subdivisions contain.
  HeatError before;
  for (const int levels : {3, 4, 5}) {
    const MeshLists lists = test::sphere(levels);
    const SurfaceMesh mesh = SurfaceMesh::open(lists);
    std::vector<std::pair<double, VertexId>> circle;
    for (std::size_t v = 0; v < lists.points.size(); ++v) {
      const Point& p = lists.points[v];
      if (p.y() == 0) circle.emplace_back(std::atan2(p.z(), p.x()), VertexId{v});
    }
    std::sort(circle.begin(), circle.end());
    std::vector<VertexId> path;
    for (const auto& [angle, v] : circle) path.push_back(v);
    const HeatError error =
        heat_error(mesh.surface(), test::vertex_curve(mesh.surface(), path, true),
                   exact_distance(lists, path, true, 8));
    if (levels > 3) {
      EXPECT_LE(error.mean, 0.5 * before.mean);
      EXPECT_LE(error.largest, 0.7 * before.largest);
    }
    before = error;
  }
  EXPECT_LE(before.mean, 0.001);
}

}  // namespace
}  // namespace talweg
