// Networks of borders: random partitions, and partitions where smoothed borders conflict.
#include "talweg/core/labels/label_network.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/network_soundness.hpp"
#include "core/reference_data.hpp"
#include "core/small_meshes.hpp"
#include "core/voronoi_labels.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

using test::expect_sound;
using test::expect_within;
using test::Labels;

LabelNetwork smoothed(const std::shared_ptr<const OpenedMesh>& mesh, const Labels& labels,
                      double tau, std::optional<double> bound = {}) {
  LabelNetworkOptions options;
  options.tau = tau;
  options.max_deviation = bound;
  return smooth_labels(mesh, labels, options);
}

struct Shape {
  const char* name;
  MeshLists lists;
};

std::vector<Shape> shapes() {
  return {{"ball", test::sphere(5)}, {"hills", test::hills(60)}, {"torus", test::torus(60, 120)}};
}

TEST(LabelNetwork, OfRandomPartitionsKeepsEveryRegionWhole) {
  for (const Shape& shape : shapes()) {
    const auto mesh = OpenedMesh::open(shape.lists);
    for (const std::size_t count : {2, 12, 60, 200}) {
      for (const unsigned seed : {1U, 2U}) {
        SCOPED_TRACE(testing::Message() << shape.name << ", " << count << ", seed " << seed);
        const Labels labels = test::voronoi_labels(mesh->mesh(), count, seed);
        const LabelNetwork network = smoothed(mesh, labels, 1);
        expect_sound(shape.lists, *mesh, labels, network);
        // With 200 regions a border has only a few edges.
        EXPECT_LE(network.total.after.total_curvature,
                  (count < 200 ? 0.2 : 0.3) * network.total.before.total_curvature);
      }
    }
  }
}

TEST(LabelNetwork, OfLabelsPerVertexToo) {
  for (const Shape& shape : shapes()) {
    const auto mesh = OpenedMesh::open(shape.lists);
    for (const std::size_t count : {2, 40}) {
      SCOPED_TRACE(testing::Message() << shape.name << ", " << count);
      const Labels labels =
          test::on_vertices(mesh->surface(), test::voronoi_labels(mesh->mesh(), count, 5));
      expect_sound(shape.lists, *mesh, labels, smoothed(mesh, labels, 1));
    }
  }
}

TEST(LabelNetwork, StaysWithinABound) {
  for (const Shape& shape : shapes()) {
    const auto mesh = OpenedMesh::open(shape.lists);
    for (const double edges : {0.3, 1.0, 2.0}) {
      SCOPED_TRACE(testing::Message() << shape.name << ", " << edges << " edges");
      const double bound = edges * mesh->mesh().mean_edge_length();
      const Labels labels = test::voronoi_labels(mesh->mesh(), 30, 4);
      const LabelNetwork network = smoothed(mesh, labels, 1, bound);
      expect_sound(shape.lists, *mesh, labels, network);
      expect_within(*mesh, labels, network, bound);
      EXPECT_EQ(network.total.max_deviation, bound);
    }
  }
}

TEST(LabelNetwork, ABorderBeyondTheBoundIsTightenedOnlyThere) {
  for (const Shape& shape : shapes()) {
    const auto mesh = OpenedMesh::open(shape.lists);
    const double bound = mesh->mesh().mean_edge_length();
    for (const std::size_t count : {2, 12}) {
      for (const unsigned seed : {1U, 2U, 3U}) {
        SCOPED_TRACE(testing::Message() << shape.name << ", " << count << ", seed " << seed);
        const Labels labels = test::voronoi_labels(mesh->mesh(), count, seed);
        const LabelNetwork network = smoothed(mesh, labels, 1, bound);
        expect_sound(shape.lists, *mesh, labels, network);
        expect_within(*mesh, labels, network, bound);
        EXPECT_EQ(network.as_drawn, 0U);
        // Borders that stay stiff have a ratio of 0.5 and more.
        EXPECT_LE(network.total.after.total_curvature, 0.2 * network.total.before.total_curvature);
      }
    }
  }
}

// Borders are smoothed several times, and the mesh is cut each time.
TEST(LabelNetwork, TimesAreOfAllRuns) {
  const auto mesh = OpenedMesh::open(test::hills(60));
  LabelNetworkOptions options;
  options.free_junctions = true;
  const Labels labels = test::voronoi_labels(mesh->mesh(), 40, 1);
  const Stopwatch watch;
  const StageTimes t = smooth_labels(mesh, labels, options).total.time_ms;
  const double elapsed = watch.ms();
  EXPECT_NEAR(t.total,
              t.load + t.open + t.solve + t.straighten + t.trace + t.relax + t.fair + t.measure,
              1e-6 * t.total);
  EXPECT_LE(t.total - t.open, elapsed);
  EXPECT_GE(t.total - t.open, elapsed / 2);  // at least half of the elapsed time
}

// Vertices without faces have no area, and do not appear in a cut mesh.
TEST(LabelNetwork, VerticesWithoutFacesAreNoParts) {
  MeshLists lists = test::grid(12, 8);
  lists.points.emplace_back(3, 3, 5);
  lists.points.emplace_back(4, 3, 5);
  const auto mesh = OpenedMesh::open(lists);
  Labels labels = test::on_vertices(mesh->surface(), test::voronoi_labels(mesh->mesh(), 2, 1));
  labels[labels.size() - 2] = labels.front();
  labels[labels.size() - 1] = 7;
  const LabelNetwork network = smoothed(mesh, labels, 1);
  ASSERT_EQ(network.regions.size(), 2U);  // no region of label 7
  for (const LabelRegion& region : network.regions) {
    EXPECT_EQ(region.parts_before, 1U) << region.label;
    EXPECT_EQ(region.parts_after, 1U) << region.label;
  }
}

/// A sheet of labels 0 and 1 with a region of label 2 inside.
template <class Rule>
Labels on_sheet(const OpenedMesh& mesh, const Rule& is_two) {
  Labels labels;
  for (std::size_t f = 0; f < mesh.surface().face_count(); ++f) {
    Point middle = Point::Zero();
    for (const VertexId v : mesh.surface().corners(FaceId{f})) middle += mesh.mesh().point(v) / 3;
    labels.push_back(is_two(f, middle) ? 2 : middle.y() < 10 ? 0 : 1);
  }
  return labels;
}

TEST(LabelNetwork, RegionsOfAFewFacesStay) {
  const MeshLists lists = test::grid(40, 20);
  const auto mesh = OpenedMesh::open(lists);
  // Single faces, beside the border, at it and away from it.
  for (const std::size_t face : {40U * 20U + 30U, 40U * 18U, 40U * 19U + 1U, 600U, 1200U}) {
    for (const double tau : {0.0, 0.25, 1.0}) {
      SCOPED_TRACE(testing::Message() << "face " << face << ", tau " << tau);
      const Labels labels = on_sheet(*mesh, [&](std::size_t f, const Point&) { return f == face; });
      const LabelNetwork network = smoothed(mesh, labels, tau);
      expect_sound(lists, *mesh, labels, network);
    }
  }
}

TEST(LabelNetwork, ALongThinRegionIsNotTornAndSaysThatItWasHeld) {
  // A wave, one square thick, much higher than the slack: straightening pulls both of its sides.
  const MeshLists lists = test::grid(60, 20);
  const auto mesh = OpenedMesh::open(lists);
  const auto wave = [](std::size_t, const Point& p) {
    const double at = 10 + 4 * std::sin(p.x() / 5);
    return p.x() > 4 && p.x() < 56 && std::abs(p.y() - at) < 0.9;
  };
  const Labels labels = on_sheet(*mesh, wave);
  for (const double tau : {0.0, 0.1, 1.0}) {
    SCOPED_TRACE(testing::Message() << "tau " << tau);
    const LabelNetwork network = smoothed(mesh, labels, tau);
    expect_sound(lists, *mesh, labels, network);
    if (tau > 0) continue;
    // Geodesics between the same two junctions would coincide.
    const auto region = std::find_if(network.regions.begin(), network.regions.end(),
                                     [](const LabelRegion& r) { return r.label == 2; });
    EXPECT_TRUE(region->held);
    EXPECT_GE(network.tightened + network.as_drawn, 1U);
  }
}

TEST(LabelNetwork, OfOneLoopAtTauZeroDoesNotLoseIt) {
  const MeshLists lists = test::grid(40, 20);
  const auto mesh = OpenedMesh::open(lists);
  const Labels labels = on_sheet(
      *mesh, [](std::size_t, const Point& p) { return (p - Point(20, 15, 0)).norm() < 3; });
  expect_sound(lists, *mesh, labels, smoothed(mesh, labels, 0));
}

TEST(LabelNetwork, MajorityLabelsAreThoseOfTheLargerShare) {
  const MeshLists lists = test::hills(60);
  const auto mesh = OpenedMesh::open(lists);
  const Labels labels = test::voronoi_labels(mesh->mesh(), 20, 7);
  const LabelNetwork network = smoothed(mesh, labels, 1);
  ASSERT_EQ(network.face_labels.size(), lists.triangles.size());
  std::map<std::pair<std::uint32_t, std::int64_t>, double> share;
  std::vector<double> whole(lists.triangles.size(), 0);
  for (std::size_t f = 0; f < network.cut_labels.size(); ++f) {
    MeshLists one;
    one.points = network.cut.lists.points;
    const Triangle& t = network.cut.lists.triangles[f];
    const Point& a = one.points[t[0]];
    const double size = (one.points[t[1]] - a).cross(one.points[t[2]] - a).norm() / 2;
    share[{network.cut.face_from[f], network.cut_labels[f]}] += size;
    whole[network.cut.face_from[f]] += size;
  }
  for (const auto& [at, size] : share) {
    if (size > 0.501 * whole[at.first]) {
      EXPECT_EQ(network.face_labels[at.first], at.second) << at.first;
    }
  }
}

TEST(LabelNetwork, IsTheSameEveryTime) {
  const auto mesh = OpenedMesh::open(test::hills(40));
  const Labels labels = test::voronoi_labels(mesh->mesh(), 20, 7);
  const LabelNetwork a = smoothed(mesh, labels, 1), b = smoothed(mesh, labels, 1);
  EXPECT_EQ(a.cut_labels, b.cut_labels);
  for (std::size_t c = 0; c < a.borders.size(); ++c) {
    EXPECT_TRUE(a.borders[c].border.curve.points == b.borders[c].border.curve.points);
  }
}

// With any budget, regions stay whole and borders stay within the bound.
TEST(LabelNetwork, WithABudgetIsSoundForAnyWork) {
  const auto lists = test::hills(40);
  const auto mesh = OpenedMesh::open(lists);
  const Labels labels = test::voronoi_labels(mesh->mesh(), 20, 7);
  LabelNetworkOptions options;
  options.free_junctions = true;
  for (const bool bounded : {false, true}) {
    const double bound = 0.5 * mesh->mesh().mean_edge_length();
    if (bounded) options.max_deviation = bound;
    options.budget = {};
    const LabelNetwork all = smooth_labels(mesh, labels, options);
    std::size_t ended = 0;
    for (std::uint64_t work = 1; work < 1'000'000'000; work = 8 * work) {
      SCOPED_TRACE(work);
      options.budget.work = work;
      const LabelNetwork network = smooth_labels(mesh, labels, options);
      expect_sound(lists, *mesh, labels, network);
      if (bounded) expect_within(*mesh, labels, network, bound);
      EXPECT_EQ(smooth_labels(mesh, labels, options).cut_labels, network.cut_labels);
      if (network.total.termination == Outcome::kConverged) {
        EXPECT_EQ(network.cut_labels, all.cut_labels);
        break;
      }
      ++ended;
      EXPECT_EQ(network.total.termination, Outcome::kLimit);
    }
    EXPECT_GT(ended, 3U);
  }
}

TEST(LabelNetwork, RefusesInvalidCalls) {
  const auto mesh = OpenedMesh::open(test::grid(12, 8));
  const auto code = [&](const Labels& labels, double tau, std::optional<double> bound) {
    try {
      smoothed(mesh, labels, tau, bound);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kOutOfMemory;
  };
  const Labels two = test::voronoi_labels(mesh->mesh(), 4, 1);
  EXPECT_EQ(code(two, -1, {}), ErrorCode::kBadUsage);
  EXPECT_EQ(code(two, 1, 0.0), ErrorCode::kBadUsage);
  EXPECT_EQ(code(Labels(3, 1), 1, {}), ErrorCode::kBadCurve);
  EXPECT_EQ(code(Labels(two.size(), 1), 1, {}), ErrorCode::kBadCurve);
}

TEST(LabelNetwork, CanBeCancelled) {
  const auto mesh = OpenedMesh::open(test::grid(12, 8));
  LabelNetworkOptions options;
  const Progress progress = [](const char*, double) { return false; };
  const LabelNetwork network =
      smooth_labels(mesh, test::voronoi_labels(mesh->mesh(), 4, 1), options, progress);
  EXPECT_TRUE(network.cancelled);
  EXPECT_TRUE(network.borders.empty());
}

TEST(LabelNetwork, OnARealMesh) {
  const std::filesystem::path path = test::mesh_folder() / "aneurysm_14k.ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << test::missing(path.stem().string());
  const MeshLists lists = test::read_reference_mesh(path);
  const auto mesh = OpenedMesh::open(lists);
  const double bound = mesh->mesh().mean_edge_length();
  for (const std::size_t count : {10, 100}) {
    SCOPED_TRACE(count);
    const Labels labels = test::voronoi_labels(mesh->mesh(), count, 9);
    const LabelNetwork network = smoothed(mesh, labels, 1, bound);
    expect_sound(lists, *mesh, labels, network);
    expect_within(*mesh, labels, network, bound);
    EXPECT_LE(network.total.after.total_curvature, 0.2 * network.total.before.total_curvature);
  }
}

TEST(LabelNetwork, NamesTheRegionWhoseBorderWouldCollapse) {
  const MeshLists lists = test::sphere(4);
  const auto opened = OpenedMesh::open(lists);
  Labels labels;
  for (const Triangle& t : lists.triangles) {
    const Point middle = lists.points[t[0]] + lists.points[t[1]] + lists.points[t[2]];
    labels.push_back(middle.normalized().z() > 0.9 ? 1 : 0);
  }
  // A loop collapses at tau = 0 and needs another try with a larger tau.
  const LabelNetwork network = smooth_labels(opened, labels, {.tau = 0});
  ASSERT_EQ(network.regions.size(), 2U);
  for (const LabelRegion& region : network.regions) {
    EXPECT_EQ(region.held, region.label == 1) << region.label;  // the smaller one
    EXPECT_EQ(region.parts_after, 1U);
    EXPECT_GT(region.area_after, 0.5 * region.area_before);
  }
  for (const LabelRegion& region : smooth_labels(opened, labels, {.tau = 1}).regions) {
    EXPECT_FALSE(region.held) << region.label;
  }
}

}  // namespace
}  // namespace talweg
