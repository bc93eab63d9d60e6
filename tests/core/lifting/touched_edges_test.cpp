// Edges that a straightened path can touch, for any lift.
#include "talweg/core/lifting/touched_edges.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/lifting/corridor.hpp"
#include "talweg/core/lifting/lifted_lengths.hpp"
#include "talweg/core/smoothing/corridor_width.hpp"
#include "talweg/core/strokes/stroke_slack.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::hills;

using test::ids;

// ---- bounds that need no distance ----

TEST(TouchedEdges, AreNoFartherThanWaysAlongThem) {
  const SurfaceMesh mesh = SurfaceMesh::open(hills(40));
  const Surface& surface = mesh.surface();
  const SurfaceCurve drawn = test::wave_on_hills(mesh);
  PolylineDistance distance(surface);
  distance.set(std::span(&drawn, 1));
  std::vector<VertexId> touched;
  for (std::uint32_t y = 10; y < 30; ++y) {
    for (std::uint32_t x = 2; x < 39; ++x) touched.emplace_back(y * 41 + x);
  }
  touched.emplace_back(surface.vertex_count() + 3);  // an inserted vertex
  const TouchedEdges edges = touched_edges(surface, touched, std::span(&drawn, 1));
  double farthest = 0, shortest = HUGE_VAL;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    const auto is_touched = [&](VertexId v) {
      return std::find(touched.begin(), touched.end(), v) != touched.end();
    };
    if (!is_touched(surface.tail(h)) && !is_touched(surface.head(h))) continue;
    shortest = std::min(shortest, surface.length(EdgeId{e}));
    farthest = std::max({farthest, distance.at_vertex(surface.tail(h)).distance,
                         distance.at_vertex(surface.head(h)).distance});
  }
  EXPECT_GE(edges.farthest, farthest);
  EXPECT_LT(edges.farthest, 2 * farthest);
  EXPECT_LE(edges.shortest, shortest);
  EXPECT_GT(edges.shortest, shortest / 4);
  // For a vertex that no touched edges connect to the drawing, no bound is known.
  EXPECT_EQ(touched_edges(surface, ids({0}), std::span(&drawn, 1)).farthest, HUGE_VAL);
}

TEST(TouchedEdges, NoLiftLengthensAnEdgeByMoreThanTheCorridorSays) {
  const SurfaceMesh mesh = SurfaceMesh::open(hills(40));
  const Surface& surface = mesh.surface();
  const SurfaceCurve open = test::wave_on_hills(mesh);
  const SurfaceCurve loop = test::drawn_near(
      mesh, test::circle(Point(20, 20, 0), Point(12, 0, 0), Point(0, 9, 0), 12), true);
  std::mt19937 random(3);
  std::uniform_int_distribution<std::size_t> any(0, surface.edge_count() - 1);
  const std::vector<std::vector<SurfaceCurve>> sets{{open}, {loop}, {open, loop}};
  for (const std::vector<SurfaceCurve>& drawn : sets) {
    PolylineDistance distance(surface);
    distance.set(drawn);
    for (const bool field : {false, true}) {
      std::vector<Corridor::Valley> valleys;
      for (const SurfaceCurve& curve : drawn) {
        Corridor::Valley& valley = valleys.emplace_back();
        valley.closed = curve.closed;
        valley.slack = slack_of_segments(surface, curve);
        valley.length = corridor_length(mesh, curve);
        valley.turns = 3;
        if (!field) continue;
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
          valley.slack_at.push_back(0.1 + 0.05 * static_cast<double>(i % 7));
        }
      }
      const Corridor corridor(distance, 0.02, valleys);
      for (int k = 0; k < 2000; ++k) {
        const EdgeId e{any(random)};
        const VertexId p = surface.tail(halfedge_of(e)), q = surface.head(halfedge_of(e));
        const double length = surface.length(e);
        const double far = std::max(distance.at_vertex(p).distance, distance.at_vertex(q).distance);
        const double lifted = lifted_length(length, corridor.at_vertex(p), corridor.at_vertex(q));
        EXPECT_LE(lifted / length - 1, corridor.largest_lengthening(far, length) + 1e-15);
      }
    }
  }
}

}  // namespace
}  // namespace talweg
