// talweg.draw, talweg.geodesic and talweg.distance against values from mathematics and the library.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/smoothing/corridor_width.hpp"

namespace talweg {
namespace {

using test::same_bits;

/// A plugin on a sheet of 30 x 20 squares; vertex (x, y) is x + 31 y.
class OnSheet : public testing::Test {
 protected:
  explicit OnSheet(const char* id) : instance_(test::plugin_of_this_build(id), services_) {
    test::set_mesh(instance_, lists_);
  }
  static std::uint32_t vertex(std::uint32_t x, std::uint32_t y) { return x + 31 * y; }
  static host::Curve through(std::vector<std::uint32_t> vertices, bool closed = false) {
    host::Curve curve;
    curve.closed = closed;
    curve.vertices = std::move(vertices);
    return curve;
  }
  std::string sentence(const std::vector<host::Curve>& curves) {
    try {
      instance_.set_curves(curves);
      instance_.run();
    } catch (const host::Error& error) {
      return error.what();
    }
    return "no error";
  }

  MeshLists lists_ = test::grid(30, 20);
  SurfaceMesh mesh_ = SurfaceMesh::open(lists_);
  host::Services services_{"test", "1"};
  host::Instance instance_;
};

struct DrawPlugin : OnSheet {
  DrawPlugin() : OnSheet("talweg.draw") {}
};

TEST_F(DrawPlugin, TellsWhichPointsWereGiven) {
  host::Curve positions;
  positions.positions = {{1.2, 1.3, 0}, {7.7, 4.1, 0}, {7.7, 4.1, 0}, {12, 15, 0}};
  host::Wanted wanted;
  wanted.point_fields = true;
  instance_.set("straight", 1.0);
  instance_.set_curves({positions, through({64, 400, 590})});
  const host::Results results = instance_.run(wanted);
  const auto given = [&](std::size_t c) {
    std::vector<std::array<double, 3>> at;
    const host::Curve& curve = results.curves.at(c);
    EXPECT_EQ(curve.fields.at(0).name, "given");
    for (std::size_t k = 0; k < curve.positions.size(); ++k) {
      if (curve.fields[0].values.at(k) == 1) at.push_back(curve.positions[k]);
    }
    return at;
  };
  EXPECT_GT(results.curves[0].positions.size(), 10U);
  ASSERT_EQ(given(0).size(), 3U);  // of the two in one place the first
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(given(0)[0][i], positions.positions[0][i], 1e-12);
    EXPECT_NEAR(given(0)[1][i], positions.positions[1][i], 1e-12);
    EXPECT_NEAR(given(0)[2][i], positions.positions[3][i], 1e-12);
  }
  ASSERT_EQ(given(1).size(), 3U);
  instance_.set("straight", 0.0);
  instance_.set("way", "edges");
  instance_.set_curves({through({64, 400, 590})});
  const host::Curve along_edges = instance_.run(wanted).curves.at(0);
  for (std::size_t k = 0; k < along_edges.vertices.size(); ++k) {
    const std::uint32_t v = along_edges.vertices[k];
    EXPECT_EQ(along_edges.fields[0].values[k], v == 64 || v == 400 || v == 590 ? 1 : 0) << v;
  }
}

TEST_F(DrawPlugin, DrawsShortestEdgePathsAsTheLibraryDoes) {
  instance_.set("way", "edges");
  instance_.set_curves({through({64, 400, 590}), through({31, 45, 300}, true)});
  const host::Results results = instance_.run();
  ASSERT_EQ(results.curves.size(), 2U);
  const auto open = draw_edge_path(mesh_.surface(), test::ids({64, 400, 590}));
  const auto closed = draw_edge_path(mesh_.surface(), test::ids({31, 45, 300}), true);
  EXPECT_TRUE(
      same_bits(results.curves[0], place(mesh_, test::vertex_curve(mesh_.surface(), open, false))));
  EXPECT_TRUE(same_bits(results.curves[1],
                        place(mesh_, test::vertex_curve(mesh_.surface(), closed, true))));
  EXPECT_EQ(results.number("points", 0), static_cast<double>(open.size()));
}

TEST_F(DrawPlugin, DrawsStraight) {
  instance_.set("straight", 1.0);
  instance_.set_curves({through({vertex(2, 3), vertex(26, 10)})});
  const host::Results results = instance_.run();
  EXPECT_NEAR(results.number("length"), std::hypot(24, 7), 1e-12);
  for (const auto& p : results.curves[0].positions) {
    EXPECT_NEAR((p[0] - 2) * 7, (p[1] - 3) * 24, 1e-9);
  }
}

TEST_F(DrawPlugin, PreviewsDrawTheLegsOfAMovedWayPointOnly) {
  const std::vector<std::uint32_t> way = {vertex(2, 3), vertex(14, 9), vertex(26, 4)};
  const std::vector<std::uint32_t> moved = {vertex(2, 3), vertex(15, 12), vertex(26, 4)};
  const auto ids = [](const std::vector<std::uint32_t>& v) { return test::ids(v); };
  EdgeDijkstra dijkstra(mesh_.surface());
  const std::vector<VertexId> path = dijkstra.draw(ids(way), false);
  const auto drawn = [&](const std::vector<VertexId>& vertices) {
    return place(mesh_, test::vertex_curve(mesh_.surface(), vertices, false));
  };
  instance_.set("way", "edges");
  instance_.set_curves({through(way)});
  instance_.set("preview", 1.0);
  EXPECT_TRUE(same_bits(instance_.run().curves[0], drawn(path)));  // nothing to keep yet
  instance_.set("preview", 0.0);
  instance_.run();
  instance_.set("preview", 1.0);
  instance_.set_curves({through(moved)});
  EXPECT_TRUE(
      same_bits(instance_.run().curves[0], drawn(dijkstra.redraw(path, ids(moved), 1, false))));
  instance_.set_curves({through({moved[0], moved[1], way[1]})});  // two have changed
  EXPECT_TRUE(same_bits(instance_.run().curves[0],
                        drawn(dijkstra.draw(ids({moved[0], moved[1], way[1]}), false))));
}

TEST_F(DrawPlugin, SaysWhichPointsItCannotJoin) {
  instance_.set("way", "edges");
  EXPECT_NE(sentence({through({5, 5})}).find("5"), std::string::npos);
  host::Curve between;
  between.positions = {{0, 0, 0}, {3.3, 4.4, 0}};
  EXPECT_NE(sentence({between}).find("Point 1 is not at a vertex"), std::string::npos);
  instance_.set("straight", 1.0);
  EXPECT_EQ(sentence({between}), "no error");
}

struct GeodesicPlugin : OnSheet {
  GeodesicPlugin() : OnSheet("talweg.geodesic") {}
};

TEST_F(GeodesicPlugin, OnASheetIsTheStraightLine) {
  instance_.set_curves({through({vertex(2, 3), vertex(9, 15), vertex(26, 10)})});
  const host::Results results = instance_.run({.point_fields = true});
  EXPECT_NEAR(results.number("length_after"), std::hypot(24, 7), 1e-9);
  EXPECT_EQ(results.text("termination"), "converged");
  EXPECT_EQ(results.find("tau"), nullptr);
  for (const double angle : results.curves[0].fields.at(0).values) EXPECT_LT(angle, 1e-7);
}

TEST_F(GeodesicPlugin, PassesThroughItsPins) {
  host::Curve bent = through({vertex(2, 3), vertex(9, 15), vertex(26, 10)});
  bent.pins = {1};
  instance_.set_curves({bent});
  const double length = std::hypot(7, 12) + std::hypot(17, 5);
  const host::Results pinned = instance_.run();
  EXPECT_NEAR(pinned.number("length_after"), length, 1e-9);
  const auto& vertices = pinned.curves[0].vertices;
  EXPECT_NE(std::find(vertices.begin(), vertices.end(), vertex(9, 15)), vertices.end());
  bent.pins.clear();
  instance_.set_curves({bent});
  instance_.set("through", 1.0);
  EXPECT_NEAR(instance_.run().number("length_after"), length, 1e-9);
}

TEST_F(GeodesicPlugin, ALoopAroundATubeIsAsLongAsTheTubeIsWide) {
  test::set_mesh(instance_, test::tube(40, 20, 5));
  // Up and down around the tube.
  host::Curve loop;
  loop.closed = true;
  loop.vertices = {5 * 40, 9 * 40 + 10, 5 * 40 + 20, 9 * 40 + 30};
  instance_.set_curves({loop});
  const host::Results results = instance_.run();
  const double polygon = 40 * 2 * std::sin(std::numbers::pi / 40);
  EXPECT_NEAR(results.number("length_after"), polygon, 1e-6 * polygon);
  EXPECT_GT(results.number("length_before"), 1.02 * polygon);
}

TEST_F(GeodesicPlugin, ALoopOnASheetCollapses) {
  instance_.set_curves(
      {through({vertex(5, 5), vertex(15, 5), vertex(15, 15), vertex(5, 15)}, true)});
  EXPECT_EQ(instance_.run().text("termination"), "collapsed");
}

struct DistancePlugin : OnSheet {
  DistancePlugin() : OnSheet("talweg.distance") {}
  host::Curve row(std::uint32_t y) {
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t x = 0; x <= 30; ++x) vertices.push_back(vertex(x, y));
    return through(std::move(vertices));
  }
};

TEST_F(DistancePlugin, ToARowOfASheetIsExact) {
  instance_.set_curves({row(8)});
  const host::Results results = instance_.run({.vertex_fields = true});
  ASSERT_EQ(results.fields.size(), 2U);
  EXPECT_EQ(results.fields[0].name, "distance");
  for (std::uint32_t v = 0; v < lists_.points.size(); ++v) {
    EXPECT_NEAR(results.fields[0].values[v], std::abs(lists_.points[v].y() - 8), 1e-12);
  }
  EXPECT_NEAR(results.number("distance_max"), 12, 1e-12);
}

TEST_F(DistancePlugin, TheCorridorIsFlatWithinItsSlack) {
  instance_.set_curves({row(8)});
  instance_.set("slack", 3.0);
  instance_.set("tau", 2.0);
  const host::Results results = instance_.run({.vertex_fields = true});
  // L of a row of 30 units: a quarter of 15. phi = L (10 tau max(0, d - 3) / L)^2.
  const double length = 15.0 / 4;
  for (std::uint32_t v = 0; v < lists_.points.size(); ++v) {
    const double beyond = std::max(0.0, std::abs(lists_.points[v].y() - 8) - 3);
    const double expected = length * std::pow(20 * beyond / length, 2);
    EXPECT_NEAR(results.fields[1].values[v], expected, 1e-9 * (1 + expected));
  }
}

TEST_F(DistancePlugin, ThePapersPotentialFollowsItsFormula) {
  instance_.set("potential", "paper");
  instance_.set("tau", 0.5);
  instance_.set_curves({row(8)});
  const host::Results results = instance_.run({.vertex_fields = true});
  const std::vector<double>& distance = results.fields[0].values;
  const double largest = *std::max_element(distance.begin(), distance.end());
  for (std::size_t v = 0; v < distance.size(); ++v) {
    const double expected = largest * std::pow(5 * distance[v] / largest, 2);
    EXPECT_NEAR(results.fields[1].values[v], expected, 1e-12 * largest * 25);
  }
  EXPECT_EQ(results.number("distance_max"), largest);
}

TEST_F(DistancePlugin, IsInfiniteOnComponentsWithoutCurves) {
  const MeshLists two = test::together(lists_, lists_, 100);
  for (const char* potential : {"corridor", "paper"}) {
    test::set_mesh(instance_, two);
    instance_.set("potential", potential);
    instance_.set_curves({row(8)});
    const host::Results results = instance_.run({.vertex_fields = true});
    for (std::size_t v = 0; v < two.points.size(); ++v) {
      EXPECT_EQ(std::isfinite(results.fields[0].values[v]), v < lists_.points.size());
      EXPECT_TRUE(std::isfinite(results.fields[1].values[v]));
    }
  }
}

}  // namespace
}  // namespace talweg
