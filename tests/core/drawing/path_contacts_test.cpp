// Contacts of paths along edges count as crossings where the paths change sides.
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
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using namespace test;

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

TEST(PathContacts, CountsPathsThatChangeSides) {
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(crossings({ids({10, 11, 12, 13, 14}), ids({2, 7, 12, 17, 22})}), Counts({1, 0}));
  // Paths that share an edge, in the same and in opposite directions: crossing, then staying on one
  // side.
  EXPECT_EQ(crossings({ids({10, 11, 12, 13}), ids({6, 11, 12, 17})}), Counts({1, 0}));
  EXPECT_EQ(crossings({ids({10, 11, 12, 13}), ids({17, 12, 11, 6})}), Counts({1, 0}));
  EXPECT_EQ(crossings({ids({10, 11, 12, 13}), ids({6, 11, 12, 7})}), Counts({0, 0}));
  EXPECT_EQ(crossings({ids({10, 11, 12, 13}), ids({7, 12, 11, 6})}), Counts({0, 0}));
  // A path that ends on another path does not cross it.
  EXPECT_EQ(crossings({ids({10, 11, 12, 13}), ids({2, 7, 12})}), Counts({0, 0}));
  EXPECT_EQ(crossings({ids({10, 11, 12, 13}), ids({2, 7, 12, 13})}), Counts({0, 0}));
  // One path that meets itself, without and with a crossing.
  EXPECT_EQ(crossings({ids({10, 11, 12, 13, 18, 12, 17, 22})}), Counts({0}));
  EXPECT_EQ(crossings({ids({10, 11, 12, 13, 18, 17, 12, 7, 2})}), Counts({1}));
  // The same loop twice.
  EXPECT_EQ(crossings({ids({6, 7, 12, 6}), ids({6, 7, 12, 6})}), Counts({0, 0}));
}

/// A random walk along edges, which may turn back and repeat edges.
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

// The number of crossings of two paths does not depend on the other paths, although all passages of
// a vertex are counted together.
TEST(PathContacts, OfASetAreTheSumOverPairs) {
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
