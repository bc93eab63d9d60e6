#include "talweg/heat/heat_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include <gtest/gtest.h>
#include <pthread.h>

#include "heat/test_surfaces.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using test::grid;
using test::sphere;
using test::TestMesh;
using Sources = std::vector<WeightedVertex>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Sources sources_at(std::initializer_list<std::size_t> vertices) {
  Sources sources;
  for (const std::size_t v : vertices) sources.push_back({VertexId{v}, 1.0});
  return sources;
}

bool all_finite_and_non_negative(const std::vector<double>& distance) {
  return std::all_of(distance.begin(), distance.end(),
                     [](double d) { return std::isfinite(d) && d >= 0; });
}

TEST(HeatDistance, ToALineIsExactWhereTheDiscreteSolutionIs) {
  // The columns have unequal widths. With half-lengths as weights the heat depends on y only, so in
  // every triangle its gradient is parallel to the gradient of |y - y0|. Equal weights would bend
  // the gradient in narrow columns.
  std::vector<double> width;
  for (int x = 0; x < 24; ++x) width.push_back(x % 8 < 4 ? 0.25 : 2.0);
  const std::size_t columns = width.size(), rows = 40;
  const Surface surface = test::torus(width, rows);
  Sources line, equal;
  for (std::size_t x = 0; x < columns; ++x) {
    const double left = width[(x + columns - 1) % columns];
    line.push_back({VertexId{x}, (left + width[x]) / 2});
    equal.push_back({VertexId{x}, 1.0});
  }
  const HeatDistance heat(surface);
  const std::vector<double> distance = heat.solve(line);
  for (std::size_t v = 0; v < distance.size(); ++v) {
    const std::size_t y = v / columns;
    EXPECT_NEAR(distance[v], static_cast<double>(std::min(y, rows - y)), 1e-10) << v;
  }
  double bent = 0;
  const std::vector<double> other = heat.solve(equal);
  for (std::size_t v = 0; v < distance.size(); ++v) {
    bent = std::max(bent, std::abs(other[v] - distance[v]));
  }
  EXPECT_GT(bent, 0.01);
}

/// The largest error of the distance to vertex 0 of the unit sphere.
double error_on_sphere(int rounds) {
  const TestMesh mesh = sphere(rounds);
  HeatOptions options;
  options.time_scale = 1;
  const auto distance = HeatDistance(mesh.surface(), options).solve(sources_at({0}));
  double error = 0;
  for (std::size_t v = 0; v < distance.size(); ++v) {
    const double chord = test::distance(mesh.positions[0], mesh.positions[v]);
    error = std::max(error, std::abs(distance[v] - 2 * std::asin(std::min(chord / 2, 1.0))));
  }
  return error;
}

TEST(HeatDistance, ConvergesOnTheSphere) {
  // The heat method is of first order in h; each mesh halves h.
  const double coarse = error_on_sphere(2), middle = error_on_sphere(3), fine = error_on_sphere(4);
  EXPECT_LT(middle, 0.75 * coarse);
  EXPECT_LT(fine, 0.75 * middle);
  EXPECT_LT(fine, 0.1);
}

TEST(HeatDistance, ToALineInAPlaneWithBoundary) {
  // The line runs from boundary to boundary, so the averaged solution is used. Away from the sides
  // the distance is |y - 20|.
  const TestMesh mesh = grid(60, 40);
  Sources line;
  for (std::size_t x = 0; x <= 60; ++x) line.push_back({VertexId{20 * 61 + x}, 1.0});
  const auto distance = HeatDistance(mesh.surface()).solve(line);
  for (std::size_t v = 0; v < distance.size(); ++v) {
    const auto& p = mesh.positions[v];
    if (p[0] < 15 || p[0] > 45) continue;
    EXPECT_NEAR(distance[v], std::abs(p[1] - 20), 0.5) << v;
  }
}

TEST(HeatDistance, BoundaryAverageKeepsAnObliqueLineStraight) {
  // A line at 45 degrees to the boundary. The Neumann solution alone bends towards the boundary and
  // is off by 0.5 along it; the averaged solution has only the error of the diffusion on the grid.
  Sources line;
  for (std::size_t i = 0; i <= 30; ++i) line.push_back({VertexId{62 * i + 15}, 1.0});
  HeatOptions options;
  options.time_scale = 1;
  const auto distance = HeatDistance(grid(60, 30).surface(), options).solve(line);
  for (std::size_t x = 19; x <= 31; ++x) {
    EXPECT_NEAR(distance[x], static_cast<double>(x - 15) / std::sqrt(2), 0.35) << x;
  }
}

TEST(HeatDistance, CurveGivesTheSameAsItsSources) {
  const Surface surface = sphere(2).surface();
  SurfaceCurve curve;
  const HalfedgeId h = surface.halfedge(VertexId{0});
  curve.points = {SurfacePoint::at_vertex(surface, VertexId{0}),
                  SurfacePoint::at_vertex(surface, surface.head(h))};
  const auto one_call = heat_distance(surface, curve);
  EXPECT_EQ(one_call, HeatDistance(surface).solve(curve_sources(surface, curve)));
  EXPECT_TRUE(all_finite_and_non_negative(one_call));
}

TEST(HeatDistance, WeightedMeanOverTheSourcesIsZeroAndClampIsAnOption) {
  const Surface surface = sphere(3).surface();
  const HeatDistance heat(surface);
  const Sources sources = {{VertexId{0}, 1.0}, {VertexId{1}, 3.0}};
  const auto raw = heat.solve(sources, {.zero_on_sources = true, .clamp = false});
  EXPECT_NEAR((raw[0] + 3 * raw[1]) / 4, 0, 1e-13);
  EXPECT_LT(*std::min_element(raw.begin(), raw.end()), -1e-3);  // near the heavier source
  const auto clamped = heat.solve(sources);
  for (std::size_t v = 0; v < raw.size(); ++v) EXPECT_EQ(clamped[v], std::max(raw[v], 0.0));
}

TEST(HeatDistance, ComponentsDoNotInfluenceEachOther) {
  const TestMesh ball = sphere(3), other = test::scaled(grid(9, 9), 1e5);
  const auto alone = HeatDistance(ball.surface()).solve(sources_at({0, 17}));
  const auto offset = ball.positions.size();

  const HeatDistance both(test::together(ball, other).surface());
  EXPECT_EQ(both.report().components, 2u);
  const auto one = both.solve(sources_at({0, 17}));
  const auto two = both.solve(sources_at({0, 17, offset + 44}));
  for (std::size_t v = 0; v < offset; ++v) {
    EXPECT_NEAR(one[v], alone[v], 1e-11) << v;
    EXPECT_NEAR(two[v], alone[v], 1e-11) << v;
  }
  for (std::size_t v = offset; v < one.size(); ++v) {
    EXPECT_EQ(one[v], kInfinity);
    EXPECT_TRUE(std::isfinite(two[v]));
  }
  EXPECT_EQ(two[offset + 44], 0);
}

TEST(HeatDistance, IsolatedVerticesAreUnreachableAndHarmless) {
  TestMesh mesh = sphere(2);
  const auto alone = HeatDistance(mesh.surface()).solve(sources_at({5}));
  const std::size_t isolated = mesh.positions.size();
  mesh.positions.push_back({7, 7, 7});
  const HeatDistance heat(mesh.surface());
  const auto distance = heat.solve(sources_at({5}));
  for (std::size_t v = 0; v < isolated; ++v) EXPECT_NEAR(distance[v], alone[v], 1e-12);
  EXPECT_EQ(distance[isolated], kInfinity);
  EXPECT_EQ(heat.solve(sources_at({isolated}))[isolated], 0);
  EXPECT_EQ(heat.solve(sources_at({isolated}))[0], kInfinity);
}

TEST(HeatDistance, IsScaleCovariant) {
  const TestMesh mesh = test::jittered(grid(20, 20), 0.3);
  const Sources sources = sources_at({150, 151, 300});
  const auto expected = HeatDistance(mesh.surface()).solve(sources);
  for (const double factor : {1e-8, 1e8}) {
    const auto distance = HeatDistance(test::scaled(mesh, factor).surface()).solve(sources);
    for (std::size_t v = 0; v < distance.size(); ++v) {
      EXPECT_NEAR(distance[v] / factor, expected[v], 1e-9) << v;
    }
  }
}

TEST(HeatDistance, SourceOnTheBoundary) {
  // With sources only on the boundary, the Neumann solution is used alone. The distance is |x| from
  // the left side; the columns are alike except for the corners.
  const TestMesh mesh = grid(40, 10);
  Sources side;
  for (std::size_t y = 0; y <= 10; ++y) {
    side.push_back({VertexId{41 * y}, y == 0 || y == 10 ? 0.5 : 1.0});
  }
  const auto distance = HeatDistance(mesh.surface()).solve(side);
  for (std::size_t v = 0; v < distance.size(); ++v) {
    EXPECT_NEAR(distance[v], mesh.positions[v][0], 0.2) << v;
  }
  // With a corner and an inner source the averaged solution is used.
  EXPECT_TRUE(all_finite_and_non_negative(
      HeatDistance(mesh.surface()).solve(sources_at({0, 41 * 5 + 20}))));
}

TEST(HeatDistance, FlatTrianglesAndNeedlesAnywhere) {
  // A vertex is moved onto a neighbour, or almost: two triangles get zero area, others become
  // needles.
  const TestMesh good = sphere(3);
  const auto expected = HeatDistance(good.surface()).solve(sources_at({0}));
  for (const double t : {1.0, 1 - 1e-13, 1 - 1e-6}) {
    for (const std::size_t moved : {0, 3, 100, 400}) {
      TestMesh mesh = good;
      const Surface surface = mesh.surface();
      const auto target = surface.head(surface.halfedge(VertexId{moved})).index();
      for (std::size_t k = 0; k < 3; ++k) {
        mesh.positions[moved][k] += t * (mesh.positions[target][k] - mesh.positions[moved][k]);
      }
      const HeatDistance heat(mesh.surface());
      const auto distance = heat.solve(sources_at({0}));
      ASSERT_TRUE(all_finite_and_non_negative(distance)) << t << " at " << moved;
      // The surface is unchanged elsewhere; the source itself may have moved by an edge.
      const double edge = heat.report().mean_edge_length[0];
      for (std::size_t v = 0; v < distance.size(); ++v) {
        EXPECT_NEAR(distance[v], expected[v], 2 * edge) << v << ", " << t << " at " << moved;
      }
    }
  }
}

TEST(HeatDistance, SurfacesWithANarrowNeck) {
  // Two sheets are joined by a neck of width w. Up to the flow through the neck, constants on
  // either side are in the kernel of the Laplacian, so its condition number grows like 1 / w.
  const std::size_t columns = 40, rows = 8, neck = 20;
  for (const double w : {1.0, 1e-3, 1e-6, 1e-9, 1e-12}) {
    TestMesh mesh = grid(columns, rows);
    Sources sources;
    for (std::size_t j = 0; j <= rows; ++j) {
      double& y = mesh.positions[j * (columns + 1) + neck][1];
      y = 4 + w * (y - 4);
      sources.push_back({VertexId{j * (columns + 1)}, 1.0});
    }
    const auto distance = HeatDistance(mesh.surface()).solve(sources);
    ASSERT_TRUE(all_finite_and_non_negative(distance)) << w;
    // Distances to the left side, through the neck. The sides of the sheet have no curvature and
    // the field fans out behind the neck; the heat method is off by a few edges there.
    for (std::size_t j = 0; j <= rows; ++j) {
      EXPECT_NEAR(distance[j * (columns + 1) + neck / 2], 10, 1) << w << ' ' << j;
      const double fan = w == 1 ? 0 : std::hypot(20.0, static_cast<double>(j) - 4) - 20;
      EXPECT_NEAR(distance[j * (columns + 1) + columns], 40 + fan, 4) << w << ' ' << j;
    }
  }
}

TEST(HeatDistance, CapsAndSurfacesWithoutExtent) {
  // Triangles with three points on a line.
  TestMesh caps = grid(8, 8);
  caps.positions[40] = {4, 3, 0};  // at the position of the lower neighbour: four flat triangles
  const HeatDistance heat(caps.surface());
  EXPECT_GT(heat.report().mollification[0], 0);
  EXPECT_LE(heat.report().mollification[0], 1e-5 * heat.report().mean_edge_length[0] * (1 + 1e-12));
  EXPECT_TRUE(all_finite_and_non_negative(heat.solve(sources_at({0, 31}))));
  // All vertices at one place: everything is at distance 0.
  const HeatDistance point(test::scaled(sphere(1), 0).surface());
  EXPECT_EQ(point.report().flat_triangles, 80u);
  for (const double d : point.solve(sources_at({3}))) EXPECT_EQ(d, 0);
}

TEST(HeatDistance, LongTorusIsExactBeyondUnderflow) {
  const std::size_t columns = 10000, rows = 3;
  const Surface surface = test::torus(std::vector<double>(columns, 1.0), rows);
  const auto distance = HeatDistance(surface).solve(sources_at({0, columns, 2 * columns}));
  for (std::size_t v = 0; v < distance.size(); ++v) {
    const std::size_t x = v % columns;
    // Condition number of a chain of n links, (2 n / π)², times ε, times n: 5e-5.
    EXPECT_NEAR(distance[v], static_cast<double>(std::min(x, columns - x)), 5e-5) << v;
  }
}

TEST(HeatDistance, LongStripWithBoundary) {
  const std::size_t columns = 5000, rows = 5, stride = columns + 1;
  for (const double jitter : {0.0, 0.2}) {
    const TestMesh mesh = test::jittered(grid(columns, rows), jitter);
    const HeatDistance heat(mesh.surface());
    for (const std::size_t start : {std::size_t{0}, std::size_t{10}}) {
      Sources column;
      for (std::size_t y = 0; y <= rows; ++y) column.push_back({VertexId{y * stride + start}, 1.0});
      const auto distance = heat.solve(column);
      ASSERT_TRUE(all_finite_and_non_negative(distance));
      for (std::size_t y = 0; y <= rows; ++y) {
        for (std::size_t x = start + 20; x <= columns; ++x) {
          const std::size_t v = y * stride + x;
          EXPECT_GT(distance[v], distance[v - 1]) << x << " " << y;
          const double exact = static_cast<double>(x - start);
          EXPECT_NEAR(distance[v], exact, 1 + 0.02 * exact) << x << " " << y;
        }
      }
    }
  }
}

#ifdef __GLIBC__
TEST(HeatDistance, WithoutAnotherThreadFactorsOneAfterTheOther) {
  // No thread can have a stack of this size.
  pthread_attr_t usual, huge;
  pthread_getattr_default_np(&usual);
  pthread_attr_init(&huge);
  pthread_attr_setstacksize(&huge, std::size_t{1} << 46);
  ASSERT_EQ(pthread_setattr_default_np(&huge), 0);
  const Surface surface = grid(12, 9).surface();
  HeatOptions options;
  options.threads = 2;
  const std::vector<double> distance = HeatDistance(surface, options).solve(sources_at({0}));
  pthread_setattr_default_np(&usual);
  EXPECT_EQ(distance, HeatDistance(surface, options).solve(sources_at({0})));
}
#endif

TEST(HeatDistance, SameBytesEveryTimeAndFromEveryThread) {
  const Surface surface = test::jittered(grid(40, 40), 0.3).surface();
  HeatOptions one_thread;
  one_thread.threads = 1;
  const HeatDistance heat(surface), again(surface, one_thread);
  const Sources sources = sources_at({33, 400, 801});
  const auto expected = heat.solve(sources);
  EXPECT_EQ(expected, again.solve(sources));
  std::vector<double> here, there;
  std::thread other([&] {
    for (int i = 0; i < 10; ++i) there = heat.solve(sources);
  });
  for (int i = 0; i < 10; ++i) here = heat.solve(sources);
  other.join();
  EXPECT_EQ(here, expected);
  EXPECT_EQ(there, expected);
}

TEST(HeatDistance, OnlyRatiosOfWeightsMatter) {
  const HeatDistance heat(sphere(3).surface());
  const auto a = heat.solve(Sources{{VertexId{4}, 1e-9}, {VertexId{90}, 2e-9}});
  const auto b = heat.solve(Sources{{VertexId{4}, 1e9}, {VertexId{90}, 1e9}, {VertexId{90}, 1e9}});
  for (std::size_t v = 0; v < a.size(); ++v) EXPECT_NEAR(a[v], b[v], 1e-11);
}

TEST(HeatDistance, ProgressIsReportedAndCancels) {
  const Surface surface = sphere(2).surface();
  double last = -1;
  int calls = 0;
  const auto done = HeatDistance::open(surface, {}, [&](const char*, double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    ++calls;
    return true;
  });
  EXPECT_TRUE(done.has_value());
  EXPECT_EQ(last, 1);
  for (int stop = 1; stop <= calls; ++stop) {
    int seen = 0;
    const auto cancelled =
        HeatDistance::open(surface, {}, [&](const char*, double) { return ++seen < stop; });
    EXPECT_FALSE(cancelled.has_value());
    EXPECT_EQ(seen, stop);
  }
}

template <class Call>
std::string error_of(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(HeatDistance, BadOptionsAndSourcesAreNamed) {
  const Surface surface = sphere(1).surface();
  const auto with = [&](auto change) {
    HeatOptions options;
    change(options);
    return error_of([&] { HeatDistance(surface, options); });
  };
  EXPECT_EQ(with([](HeatOptions& o) { o.time_scale = 0; }).find("time_scale"), 0u);
  EXPECT_EQ(with([](HeatOptions& o) { o.time_scale = std::nan(""); }).find("time_scale"), 0u);
  EXPECT_EQ(with([](HeatOptions& o) { o.mollification = 1; }).find("mollification"), 0u);
  EXPECT_EQ(with([](HeatOptions& o) { o.threads = 0; }).find("threads"), 0u);
  EXPECT_NE(error_of([] { HeatDistance(Surface{}); }), "no error");

  const HeatDistance heat(surface);
  const auto solving = [&](const Sources& sources) {
    return error_of([&] { (void)heat.solve(sources); });
  };
  EXPECT_NE(solving(sources_at({42})).find("vertex 42 is not on the mesh"), std::string::npos);
  EXPECT_NE(solving({{VertexId{7}, -1.0}}).find("vertex 7"), std::string::npos);
  EXPECT_NE(solving({{VertexId{7}, std::nan("")}}).find("vertex 7"), std::string::npos);
  EXPECT_NE(solving({}), "no error");
  EXPECT_NE(solving({{VertexId{7}, 0.0}}), "no error");
}

}  // namespace
}  // namespace talweg
