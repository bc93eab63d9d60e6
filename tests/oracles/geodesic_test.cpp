// Straightening at tau = 0 against CGAL's exact shortest paths.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/reference_data.hpp"
#include "core/small_meshes.hpp"
#include "exact_distance.hpp"
#include "stress/random.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg {
namespace {

using test::ExactGeodesics;

/// The edge path along one side of the strip of triangles of a shortest path, from its first vertex
/// to its last.
std::vector<VertexId> beside(const std::vector<ExactGeodesics::Passage>& passages, bool left) {
  std::vector<VertexId> path;
  for (const ExactGeodesics::Passage& p : passages) {
    const VertexId v = left ? p.left : p.right;
    if (path.empty() || path.back() != v) path.push_back(v);
  }
  return path;
}

/// A bent curve inside the strip: a quarter of the way from the shortest path to the midpoints of
/// the edges. No vertex lies between the two.
SurfaceCurve inside_strip(const Surface& surface,
                          const std::vector<ExactGeodesics::Passage>& passages) {
  SurfaceCurve curve;
  for (const auto& [left, right, from_left] : passages) {
    curve.points.push_back(left == right
                               ? SurfacePoint::at_vertex(surface, left)
                               : test::between(surface, static_cast<std::uint32_t>(left.index()),
                                               static_cast<std::uint32_t>(right.index()),
                                               0.75 * from_left + 0.25 * 0.5));
  }
  return curve;
}

/// Splits a face into three at these barycentrics.
void split_face(MeshLists& lists, std::size_t face, const std::array<double, 3>& at) {
  const Triangle t = lists.triangles[face];
  const auto v = static_cast<std::uint32_t>(lists.points.size());
  lists.points.push_back(at[0] * lists.points[t[0]] + at[1] * lists.points[t[1]] +
                         at[2] * lists.points[t[2]]);
  lists.triangles[face] = {t[0], t[1], v};
  lists.triangles.push_back({t[1], t[2], v});
  lists.triangles.push_back({t[2], t[0], v});
}

MeshLists mesh_named(const std::string& name) {
  if (name == "torus") return test::torus(24, 40);
  if (name == "box") return test::box();
  if (name == "tube") return test::tube(24, 20, 5);
  if (name == "sheet") {
    MeshLists lists = test::grid(24, 24);
    for (Point& p : lists.points) p.z() = 2 * std::sin(0.5 * p.x()) * std::cos(0.4 * p.y());
    return lists;
  }
  if (name == "needles") {  // and caps, in faces of a wavy sheet
    MeshLists lists = mesh_named("sheet");
    stress::Random random(5);
    for (int k = 0; k < 120; ++k) {
      const double e = random.scale(1e-7, 1e-2);
      const double near = random.one_in(2) ? 0.5 - e : 1 - 2 * e;
      split_face(lists, random.below(lists.triangles.size()), {1 - near - e, near, e});
    }
    return lists;
  }
  const auto file = test::mesh_folder() / (name + ".ply");
  return std::filesystem::exists(file) ? test::read_reference_mesh(file) : MeshLists{};
}

class Geodesic : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    lists_ = mesh_named(GetParam());
    if (lists_.points.empty()) {
      GTEST_SKIP() << test::missing(GetParam());
    }
    opened_ = OpenedMesh::open(lists_);
  }

  double straightened(CurveSmoother& smoother, const std::vector<VertexId>& path) {
    return straightened(smoother, test::vertex_curve(opened_->surface(), path, false));
  }
  double straightened(CurveSmoother& smoother, const SurfaceCurve& curve) {
    // With way-points at its ends the curve is not a stroke of a hand, so no point is left out.
    smoother.set_curve(curve,
                       {.cap_corners = false,
                        .way_points = {{curve.points.front(), 0}, {curve.points.back(), 0}}});
    return smoother.smooth(0.0).report().after.length;
  }

  MeshLists lists_;
  std::shared_ptr<const OpenedMesh> opened_;
};

TEST_P(Geodesic, NeverShorterThanTheShortestAndEqualFromInsideItsStrip) {
  const Surface& surface = opened_->surface();
  ExactGeodesics exact(lists_);
  CurveSmoother smoother(opened_);
  EdgeDijkstra dijkstra(surface);
  std::mt19937 random(17);
  const std::size_t n = surface.vertex_count();
  int pairs = 0;
  int bends = 0;
  int equal_from_dijkstra = 0;
  int sides = 0;
  int equal_from_strip = 0;
  for (int source = 0; source < 4; ++source) {
    const VertexId s{random() % n};
    exact.clear_sources();
    exact.add_source(s);
    for (int target = 0; target < 8; ++target) {
      const VertexId t{random() % n};
      if (t == s) continue;
      const double shortest = exact.distance(t);
      ++pairs;
      const double drawn = straightened(smoother, dijkstra.draw(std::vector{t, s}, false));
      EXPECT_GE(drawn, shortest * (1 - 1e-8)) << s.index() << " to " << t.index();
      equal_from_dijkstra += drawn <= shortest * (1 + 1e-8) ? 1 : 0;
      const auto passages = exact.path_from(t);
      const SurfaceCurve bent = inside_strip(surface, passages);
      bends += curve_length(surface, bent) > shortest * (1 + 1e-6) ? 1 : 0;
      const double inside = straightened(smoother, bent);
      EXPECT_NEAR(inside, shortest, 1e-8 * shortest) << s.index() << " to " << t.index();
      // A path that begins on a side of the strip may leave the strip over a vertex with angles
      // below pi on both sides; mostly it stays.
      for (const bool left : {true, false}) {
        const auto path = beside(passages, left);
        ASSERT_EQ(path.front(), t);
        ASSERT_EQ(path.back(), s);
        const double found = straightened(smoother, path);
        EXPECT_GE(found, shortest * (1 - 1e-8)) << s.index() << " to " << t.index();
        ++sides;
        equal_from_strip += found <= shortest * (1 + 1e-8) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(bends, 0) << "there was nothing to straighten";
  std::printf(
      "  %d pairs: equal from the shortest edge path %d; from a side of the strip %d of %d\n",
      pairs, equal_from_dijkstra, equal_from_strip, sides);
}

INSTANTIATE_TEST_SUITE_P(All, Geodesic,
                         ::testing::Values("sheet", "torus", "tube", "box", "needles",
                                           "fandisk_14k", "aneurysm_14k"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace talweg
