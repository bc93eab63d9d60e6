// Junctions move until their borders balance; ends slide along the boundary.
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/network_soundness.hpp"
#include "core/small_meshes.hpp"
#include "core/voronoi_labels.hpp"
#include "talweg/core/labels/label_network.hpp"

namespace talweg {
namespace {

using test::expect_sound;
using test::expect_within;
using test::Labels;

constexpr double kDegree = std::numbers::pi / 180;

template <class Rule>
Labels by_middle(const MeshLists& lists, const Rule& rule) {
  Labels labels;
  for (const Triangle& t : lists.triangles) {
    labels.push_back(
        rule(Point((lists.points[t[0]] + lists.points[t[1]] + lists.points[t[2]]) / 3)));
  }
  return labels;
}

/// The directions of the borders at their ends near `place`: from the end to the first point at
/// least `length` away.
std::vector<Point> directions_at(const SurfaceMesh& mesh, const LabelNetwork& network,
                                 const Point& place, double near, double length) {
  std::vector<Point> directions;
  for (const SmoothedBorder& border : network.borders) {
    std::vector<Point> points = positions_of(mesh, border.border.curve);
    for (int end = 0; end < 2; ++end, std::reverse(points.begin(), points.end())) {
      if ((points.front() - place).norm() > near) continue;
      for (const Point& p : points) {
        if ((p - points.front()).norm() < length) continue;
        directions.push_back((p - points.front()).normalized());
        break;
      }
    }
  }
  return directions;
}

double angle(const Point& a, const Point& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// A roof over a wall: the borders meet at 130, 115 and 115 degrees.
Labels roof(const MeshLists& lists) {
  return by_middle(lists, [](const Point& p) {
    const double height = 20 + 14.0 / 30 * (p.x() < 30 ? p.x() : 60 - p.x());
    return p.y() < height ? 0 : p.x() < 30 ? 1 : 2;
  });
}

TEST(LabelJunctions, OfThreeRegionsOnASheetEndAt120Degrees) {
  const MeshLists lists = test::grid(60, 60);
  const auto mesh = OpenedMesh::open(lists);
  const Labels labels = roof(lists);
  LabelNetworkOptions options{.max_deviation = 6};
  const LabelNetwork fixed = smooth_labels(mesh, labels, options);
  options.free_junctions = true;
  const LabelNetwork free = smooth_labels(mesh, labels, options);
  expect_sound(lists, *mesh, labels, free);
  expect_within(*mesh, labels, free, 6);
  EXPECT_EQ(fixed.moved, 0U);
  EXPECT_EQ(free.moved, 1U);
  const auto worst = [&](const LabelNetwork& network) {
    const auto d = directions_at(mesh->mesh(), network, Point(30, 34, 0), 6, 1);
    EXPECT_EQ(d.size(), 3U);
    double most = 0;
    for (std::size_t i = 0; i < d.size(); ++i) {
      most = std::max(most, std::abs(angle(d[i], d[(i + 1) % d.size()]) - 120 * kDegree));
    }
    return most;
  };
  EXPECT_GT(worst(fixed), 9 * kDegree);
  EXPECT_LT(worst(free), 4 * kDegree);
  EXPECT_LT(free.imbalance_after, 0.06);
  EXPECT_LT(free.total.after.length, fixed.total.after.length);
}

TEST(LabelJunctions, MoveNoFartherThanTheSlackWhereNoBoundIsGiven) {
  const MeshLists lists = test::grid(60, 60);
  const auto mesh = OpenedMesh::open(lists);
  // Borders at 90, 90 and 180 degrees pull far away.
  const Labels labels = by_middle(lists, [](const Point& p) {
    return p.y() < 30 ? 0 : p.x() < 30 ? 1 : 2;
  });
  for (const double slack : {0.5, 2.0}) {
    LabelNetworkOptions options{.slack = slack, .free_junctions = true};
    const LabelNetwork network = smooth_labels(mesh, labels, options);
    expect_sound(lists, *mesh, labels, network);
    ASSERT_EQ(network.moved, 1U);
    const Point at = positions_of(mesh->mesh(), network.borders[0].border.curve).back();
    const Point other = positions_of(mesh->mesh(), network.borders[0].border.curve).front();
    const Point home(30, 30, 0);
    const double move = std::min((at - home).norm(), (other - home).norm());
    EXPECT_LE(move, slack * (1 + 1e-9));
    EXPECT_GT(move, 0.9 * slack);
  }
}

TEST(LabelJunctions, OfSectorsOfABallEndAt120Degrees) {
  const MeshLists lists = test::sphere(6);
  const auto mesh = OpenedMesh::open(lists);
  // Sectors of 100, 120 and 140 degrees between the poles.
  const Labels labels = by_middle(lists, [](const Point& p) {
    const double longitude = std::atan2(p.y(), p.x()) / kDegree + 180;
    return longitude < 100 ? 0 : longitude < 220 ? 1 : 2;
  });
  LabelNetworkOptions options{.max_deviation = 12 * mesh->mesh().mean_edge_length()};
  options.free_junctions = true;
  const LabelNetwork free = smooth_labels(mesh, labels, options);
  expect_sound(lists, *mesh, labels, free);
  expect_within(*mesh, labels, free, *options.max_deviation);
  EXPECT_EQ(free.moved, 2U);
  const double h = mesh->mesh().mean_edge_length();
  for (const double pole : {-1.0, 1.0}) {
    const auto d = directions_at(mesh->mesh(), free, Point(0, 0, pole), 12 * h, h);
    ASSERT_EQ(d.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(angle(d[i], d[(i + 1) % 3]), 120 * kDegree, 4 * kDegree);
    }
  }
}

TEST(LabelJunctions, AnEndOnTheBoundaryBecomesPerpendicular) {
  const MeshLists lists = test::grid(60, 60);
  const auto mesh = OpenedMesh::open(lists);
  const Labels labels =
      by_middle(lists, [](const Point& p) { return p.y() < 25 + p.x() / 6 ? 0 : 1; });
  LabelNetworkOptions options{.max_deviation = 8};
  const auto slopes_at_ends = [&](const LabelNetwork& network) {
    std::vector<double> slopes;
    const auto points = positions_of(mesh->mesh(), network.borders[0].border.curve);
    for (const double x : {0.0, 60.0}) {
      for (const Point& d :
           directions_at(mesh->mesh(), network, points[x == 0 ? 0 : points.size() - 1], 1e-9, 1)) {
        slopes.push_back(std::abs(d.y()));
      }
    }
    return slopes;
  };
  const auto stay = slopes_at_ends(smooth_labels(mesh, labels, options));
  options.sliding_ends = true;
  const LabelNetwork network = smooth_labels(mesh, labels, options);
  expect_sound(lists, *mesh, labels, network);
  expect_within(*mesh, labels, network, 8);
  EXPECT_EQ(network.moved, 2U);
  const auto slide = slopes_at_ends(network);
  ASSERT_EQ(stay.size(), 2U);
  ASSERT_EQ(slide.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_GT(stay[i], std::sin(8 * kDegree));
    EXPECT_LT(slide[i], std::sin(2 * kDegree));
  }
}

TEST(LabelJunctions, OfRandomPartitionsStaySound) {
  for (const MeshLists& lists : {test::sphere(4), test::hills(40), test::torus(40, 80)}) {
    const auto mesh = OpenedMesh::open(lists);
    const double h = mesh->mesh().mean_edge_length();
    for (const std::size_t count : {12, 80}) {
      for (const double bound : {0.0, 3.0}) {
        SCOPED_TRACE(testing::Message() << lists.points.size() << ", " << count << ", " << bound);
        const Labels labels = test::voronoi_labels(mesh->mesh(), count, 3);
        LabelNetworkOptions options{.free_junctions = true, .sliding_ends = true};
        if (bound > 0) options.max_deviation = bound * h;
        const LabelNetwork network = smooth_labels(mesh, labels, options);
        expect_sound(lists, *mesh, labels, network);
        if (bound > 0) expect_within(*mesh, labels, network, bound * h);
        if (bound > 0) {
          EXPECT_LT(network.imbalance_after, 0.8 * network.imbalance_before);
        }
        EXPECT_GT(network.moved, 0U);
      }
    }
  }
}

TEST(LabelJunctions, OfLabelsPerVertexStaySoundToo) {
  const MeshLists lists = test::hills(60);
  const auto mesh = OpenedMesh::open(lists);
  const Labels labels =
      test::on_vertices(mesh->surface(), test::voronoi_labels(mesh->mesh(), 40, 5));
  const LabelNetwork network =
      smooth_labels(mesh, labels, {.free_junctions = true, .sliding_ends = true});
  expect_sound(lists, *mesh, labels, network);
  EXPECT_GT(network.moved, 0U);
}

}  // namespace
}  // namespace talweg
