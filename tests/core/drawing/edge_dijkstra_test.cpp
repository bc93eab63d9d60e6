#include <algorithm>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::grid;
using test::ids;
using test::surface_of_lists;

std::string message_of(const Surface& surface, const std::vector<VertexId>& through, bool closed) {
  try {
    draw_edge_path(surface, through, closed);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
    return error.what();
  }
  return "";
}

double length_of(const Surface& surface, const std::vector<VertexId>& path) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const HalfedgeId h = surface.find_halfedge(path[i], path[i + 1]);
    EXPECT_TRUE(h.valid());
    if (h.valid()) length += surface.length(edge_of(h));
  }
  return length;
}

bool is_simple(std::vector<VertexId> path) {
  std::sort(path.begin(), path.end());
  return std::adjacent_find(path.begin(), path.end()) == path.end();
}

TEST(Drawing, TakesTheShortestEdgePath) {
  const Surface surface = surface_of_lists(grid(5, 3));
  // Three diagonals and two straight steps, in any order.
  const auto path = draw_edge_path(surface, ids({0, 23}));
  EXPECT_EQ(path.size(), 6U);
  EXPECT_NEAR(length_of(surface, path), 3 * std::sqrt(2.0) + 2, 1e-12);
}

TEST(Drawing, AgreesWithBellmanFordOnASphere) {
  const Surface surface = surface_of_lists(test::sphere(3));
  std::vector<double> distance(surface.vertex_count(), 1e9);
  distance[7] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t h = 0; h < surface.halfedge_count(); ++h) {
      const HalfedgeId id{h};
      const double d = distance[surface.tail(id).index()] + surface.length(edge_of(id));
      if (d < distance[surface.head(id).index()]) {
        distance[surface.head(id).index()] = d;
        changed = true;
      }
    }
  }
  EdgeDijkstra dijkstra(surface);
  for (std::uint32_t v = 0; v < surface.vertex_count(); v += 5) {
    if (v == 7) continue;
    const auto path = dijkstra.draw(ids({7, v}), false);
    EXPECT_NEAR(length_of(surface, path), distance[v], 1e-12) << v;
  }
}

TEST(Drawing, TakesTheBestPairOfStartsAndEnds) {
  const Surface surface = surface_of_lists(test::sphere(2));
  EdgeDijkstra dijkstra(surface);
  std::mt19937 random(3);
  std::uniform_int_distribution<std::uint32_t> vertex(
      0, static_cast<std::uint32_t>(surface.vertex_count() - 1));
  std::uniform_real_distribution<double> way(0, 1);
  for (int k = 0; k < 300; ++k) {  // the last searches are those with landmarks
    std::vector<PathEnd> starts, ends;
    for (int i = 0; i < 3; ++i) {
      starts.push_back({VertexId{vertex(random)}, way(random)});
      ends.push_back({VertexId{vertex(random)}, way(random)});
    }
    double shortest = HUGE_VAL;
    for (const PathEnd& a : starts) {
      for (const PathEnd& b : ends) {
        double length = a.beyond + b.beyond;
        if (a.vertex != b.vertex) {
          length += length_of(surface, draw_edge_path(surface, std::vector{a.vertex, b.vertex}));
        }
        shortest = std::min(shortest, length);
      }
    }
    const std::vector<VertexId> path = dijkstra.between(starts, ends);
    const auto beyond = [](const std::vector<PathEnd>& of, VertexId v) {
      double least = HUGE_VAL;
      for (const PathEnd& end : of) {
        if (end.vertex == v) least = std::min(least, end.beyond);
      }
      return least;
    };
    EXPECT_NEAR(beyond(starts, path.front()) + length_of(surface, path) + beyond(ends, path.back()),
                shortest, 1e-12)
        << k;
  }
}

TEST(Drawing, KeepsItsWayPointsInOrderAndMeetsNoVertexTwice) {
  const Surface surface = surface_of_lists(test::sphere(3));
  const auto through = ids({0, 2, 1, 3});
  for (const bool closed : {false, true}) {
    const auto path = draw_edge_path(surface, through, closed);
    EXPECT_TRUE(is_simple(path));
    EXPECT_EQ(path.front(), through.front());
    std::size_t next = 0;
    for (const VertexId v : path) {
      if (next < through.size() && v == through[next]) ++next;
    }
    EXPECT_EQ(next, through.size());
    EXPECT_EQ(path.back() == through.back(), !closed);
    // Four quarters of the equator; a path along edges is at least as long as its chords.
    const double quarter = std::numbers::pi / 2;
    EXPECT_GT(length_of(surface, path), 2.9 * quarter);
  }
}

TEST(Drawing, LaterLegsGoAroundEarlierOnes) {
  const Surface surface = surface_of_lists(grid(4, 4));
  // Down the middle column from the top, then from its lower end to the right, then to the left
  // side.
  const auto path = draw_edge_path(surface, ids({22, 7, 13, 11}));
  EXPECT_TRUE(is_simple(path));
  EXPECT_EQ(path.back(), VertexId{11});
}

TEST(Drawing, EarlierLegsKeepOffLaterWayPoints) {
  const Surface surface = surface_of_lists(grid(4, 2));
  // The shortest path from 5 to 9 runs over 7, the last way-point.
  const auto path = draw_edge_path(surface, ids({5, 9, 7}));
  EXPECT_TRUE(is_simple(path));
  EXPECT_EQ(path.back(), VertexId{7});
}

TEST(Drawing, TwoWayPointsCanClose) {
  const Surface surface = surface_of_lists(grid(2, 2));
  for (const auto& through : {ids({0, 8}), ids({0, 1})}) {
    const auto path = draw_edge_path(surface, through, true);
    EXPECT_GE(path.size(), 3U);
    EXPECT_TRUE(is_simple(path));
    EXPECT_TRUE(surface.find_halfedge(path.back(), path.front()).valid());
  }
}

TEST(Drawing, SecondCallIsNotInfluencedByTheFirst) {
  const Surface surface = surface_of_lists(test::sphere(2));
  EdgeDijkstra dijkstra(surface);
  const auto first = dijkstra.draw(ids({0, 1, 2}), true);
  dijkstra.draw(ids({5, 4}), false);
  EXPECT_THROW(dijkstra.draw(ids({5, 5}), false), Error);
  EXPECT_EQ(dijkstra.draw(ids({0, 1, 2}), true), first);
}

TEST(Drawing, TiesGoToTheSmallerVertex) {
  // Two equally long paths from 0 to 3: over 1 and over 2.
  MeshLists lists;
  lists.points = {Point(0, 0, 0), Point(1, -1, 0), Point(1, 1, 0), Point(2, 0, 0)};
  lists.triangles = {{0, 1, 2}, {2, 1, 3}};
  EXPECT_EQ(draw_edge_path(surface_of_lists(lists), ids({0, 3})), ids({0, 1, 3}));
  EXPECT_EQ(draw_edge_path(surface_of_lists(lists), ids({3, 0})), ids({3, 1, 0}));
}

TEST(Drawing, RefusesInvalidWayPoints) {
  const Surface sheet = surface_of_lists(grid(3, 3));
  EXPECT_NE(message_of(sheet, ids({3}), false).find("at least 2"), std::string::npos);
  EXPECT_NE(message_of(sheet, {}, true).find("at least 2"), std::string::npos);
  EXPECT_NE(message_of(sheet, ids({3, 16}), false)
                .find("Way-point 16 is not a vertex: the mesh has 16 vertices, counted from 0."),
            std::string::npos);
  EXPECT_NE(message_of(sheet, ids({3, 5, 3}), false).find("Vertex 3"), std::string::npos);

  MeshLists two = grid(1, 1);
  two.triangles.push_back({4, 5, 6});
  for (int k = 0; k < 4; ++k) two.points.push_back(Point(5, k % 3, k));
  const Surface parts = surface_of_lists(two);
  const std::string other = message_of(parts, ids({1, 0, 5}), false);
  EXPECT_NE(other.find("Leg 2 from vertex 0 to vertex 5"), std::string::npos) << other;
  EXPECT_NE(other.find("different components"), std::string::npos) << other;
  // Vertex 7 is isolated.
  EXPECT_NE(message_of(parts, ids({0, 7}), false).find("components"), std::string::npos);

  // On a strip one square wide the first leg blocks the path.
  const Surface strip = surface_of_lists(grid(4, 1));
  const std::string barred = message_of(strip, ids({2, 7, 1, 3}), false);
  EXPECT_NE(barred.find("Leg 3"), std::string::npos) << barred;
  EXPECT_NE(barred.find("in its way"), std::string::npos) << barred;
}

/// The part of a path between two of its vertices; on a closed path it may pass the first vertex.
std::vector<VertexId> part_of(std::vector<VertexId> path, VertexId from, VertexId to) {
  std::rotate(path.begin(), std::find(path.begin(), path.end(), from), path.end());
  path.erase(std::find(path.begin(), path.end(), to) + 1, path.end());
  return path;
}

TEST(Redrawing, DrawsTheTwoLegsOnly) {
  const Surface surface = surface_of_lists(test::hills(40));
  std::mt19937 random(3);
  const auto vertex = [&](std::uint32_t x, std::uint32_t y) { return VertexId{y * 41 + x}; };
  for (const bool closed : {false, true}) {
    for (std::size_t moved = 0; moved < 6; ++moved) {
      SCOPED_TRACE(testing::Message() << "way-point " << moved << (closed ? ", closed" : ""));
      std::vector<VertexId> through = {vertex(5, 5),   vertex(20, 3),  vertex(35, 6),
                                       vertex(34, 33), vertex(19, 36), vertex(6, 34)};
      EdgeDijkstra dijkstra(surface);
      const auto path = dijkstra.draw(through, closed);
      through[moved] = VertexId{through[moved].index() + 41 * (1 + random() % 3) + 2};
      const auto redrawn = dijkstra.redraw(path, through, moved, closed);
      EXPECT_TRUE(is_simple(redrawn));
      EXPECT_EQ(redrawn.front(), through.front());
      // No other leg is in the way here, so each leg is shortest.
      EXPECT_NEAR(length_of(surface, redrawn),
                  length_of(surface, draw_edge_path(surface, through, closed)), 1e-9);
      for (std::size_t k = 0; k < through.size(); ++k) {
        const std::size_t next = (k + 1) % through.size();
        if (k == moved || next == moved || (!closed && next == 0)) continue;
        EXPECT_EQ(part_of(redrawn, through[k], through[next]),
                  part_of(path, through[k], through[next]));
      }
    }
  }
}

TEST(Redrawing, GoesAroundOtherLegs) {
  const Surface surface = surface_of_lists(grid(10, 10));
  EdgeDijkstra dijkstra(surface);
  // A leg from the left is a wall; a way-point is moved to its other side.
  auto through = ids({55, 61, 67, 12});
  const auto path = dijkstra.draw(through, false);
  through = ids({55, 61, 67, 93});
  const auto redrawn = dijkstra.redraw(path, through, 3, false);
  EXPECT_TRUE(is_simple(redrawn));
  EXPECT_EQ(redrawn.back(), VertexId{93});
}

TEST(Redrawing, RedrawsAllLegsIfOtherLegsAreInTheWay) {
  const Surface surface = surface_of_lists(grid(10, 10));
  EdgeDijkstra dijkstra(surface);
  auto through = ids({56, 64, 20, 12});
  const auto path = dijkstra.draw(through, false);
  through[3] = path[4];  // onto the first leg
  EXPECT_EQ(dijkstra.redraw(path, through, 3, false), draw_edge_path(surface, through, false));
  const auto other = ids({3, 60});  // other way-points than those of the path
  EXPECT_EQ(dijkstra.redraw(path, other, 1, false), draw_edge_path(surface, other, false));
}

TEST(Redrawing, HandlesTwoWayPointsOrNone) {
  const Surface surface = surface_of_lists(grid(10, 10));
  EdgeDijkstra dijkstra(surface);
  const auto path = dijkstra.draw(ids({0, 60}), false);
  EXPECT_EQ(dijkstra.redraw(path, ids({0, 63}), 1, false),
            draw_edge_path(surface, ids({0, 63}), false));
  const auto loop = dijkstra.draw(ids({0, 60}), true);
  EXPECT_EQ(dijkstra.redraw(loop, ids({0, 63}), 1, true),
            draw_edge_path(surface, ids({0, 63}), true));
  EXPECT_THROW(dijkstra.redraw(path, ids({0, 60}), 2, false), Error);
  EXPECT_THROW(dijkstra.redraw(path, ids({0, 999}), 1, false), Error);
}

}  // namespace
}  // namespace talweg
