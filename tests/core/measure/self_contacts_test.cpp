#include "talweg/core/measure/self_contacts.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using test::grid;
using test::ids;
using test::vertex_curve;

/// A sheet of 20 x 20 squares, and curves drawn on it straight from point to point.
class Contacts : public testing::Test {
 protected:
  [[nodiscard]] SurfaceCurve line(std::vector<Point> points, bool closed) const {
    CurveInput input;
    input.closed = closed;
    input.points = std::move(points);
    const SnappedCurve snapped = snap(mesh_, input);
    return StraightLines(mesh_.surface()).join(snapped.points, closed);
  }
  [[nodiscard]] SurfaceCurve path(std::initializer_list<std::uint32_t> vertices,
                                  bool closed) const {
    return vertex_curve(mesh_.surface(), ids(vertices), closed);
  }
  [[nodiscard]] std::vector<SelfContact> of(const SurfaceCurve& curve) const {
    return self_contacts(mesh_.surface(), std::span(&curve, 1));
  }
  [[nodiscard]] SurfaceCurve reversed(SurfaceCurve curve) const {
    std::reverse(curve.points.begin(), curve.points.end());
    return curve;
  }
  /// The same loop with another first point.
  [[nodiscard]] SurfaceCurve turned(SurfaceCurve curve, std::size_t by) const {
    std::rotate(curve.points.begin(), curve.points.begin() + std::ptrdiff_t(by),
                curve.points.end());
    return curve;
  }
  void expect(const SurfaceCurve& curve, std::size_t places, std::size_t stretches) const {
    for (std::size_t by = 0; by < (curve.closed ? curve.points.size() : 1); ++by) {
      for (const SurfaceCurve& other : {turned(curve, by), reversed(turned(curve, by))}) {
        const auto found = of(other);
        EXPECT_EQ(found.size(), places) << by;
        EXPECT_EQ(std::count_if(found.begin(), found.end(), [](auto& c) { return c.stretch; }),
                  std::ptrdiff_t(stretches))
            << by;
      }
    }
  }

  SurfaceMesh mesh_ = SurfaceMesh::open(grid(20, 20));
};

TEST_F(Contacts, SimpleCurvesHaveNone) {
  expect(line({{1.3, 1.2, 0}, {9.1, 4.4, 0}, {3.2, 15.7, 0}}, false), 0, 0);
  expect(line({{1.3, 1.2, 0}, {9.1, 4.4, 0}, {3.2, 15.7, 0}}, true), 0, 0);
  expect(path({0, 1, 2, 3}, false), 0, 0);
  expect(path({22, 23, 44, 43}, true), 0, 0);
  expect(line({{1.3, 1.2, 0}, {1.4, 1.25, 0}}, false), 0, 0);  // within a face
  SurfaceCurve point = path({5}, false);
  EXPECT_TRUE(of(point).empty());
  point.points.push_back(point.points.front());  // a segment without length
  EXPECT_TRUE(of(point).empty());
}

TEST_F(Contacts, AFigureEightHasOne) {
  // Its crossing is inside a face, on an edge, and at a vertex.
  for (const Point& at : {Point(10.4, 10.3, 0), Point(10.5, 10, 0), Point(10, 10, 0)}) {
    const SurfaceCurve eight = line(
        {at + Point(-7, -4, 0), at + Point(7, 4, 0), at + Point(7, -4, 0), at + Point(-7, 4, 0)},
        true);
    expect(eight, 1, 0);
    const auto found = of(eight);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_LT((mesh_.position(found[0].at) - at).norm(), 1e-9);
    EXPECT_EQ(found[0].curve, 0U);
  }
}

TEST_F(Contacts, ALoopThatTouchesAVertexTwiceHasOne) {
  // Two squares with a corner in common, walked around without crossing, and crossing.
  expect(path({110, 131, 152, 153, 132, 131, 130, 109}, true), 1, 0);
  // From one side only: a wedge down to vertex 131 and up again, a line through it.
  const SurfaceCurve wedge = line({{2.3, 9.7, 0}, {5, 6, 0}, {7.7, 9.9, 0}}, false);
  const SurfaceCurve below = line({{2.3, 2.2, 0}, {5, 6, 0}, {7.7, 2.1, 0}}, false);
  EXPECT_EQ(self_contacts(mesh_.surface(), std::vector{wedge, below}).size(), 1U);
}

TEST_F(Contacts, TouchingAnEdgeFromBothSidesIsOne) {
  // The curves stay on different sides of the row y = 6; they share the point (5.5, 6) and no face
  // near it.
  const SurfaceCurve above = line({{5.2, 6.8, 0}, {5.5, 6, 0}, {5.6, 6.9, 0}}, false);
  const SurfaceCurve below = line({{5.3, 5.1, 0}, {5.5, 6, 0}, {5.8, 5.2, 0}}, false);
  const auto found = self_contacts(mesh_.surface(), std::vector{above, below});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].stretch);
  EXPECT_LT((mesh_.position(found[0].at) - Point(5.5, 6, 0)).norm(), 1e-9);
}

TEST_F(Contacts, TheWayBackAlongItselfIsOneStretch) {
  expect(path({100, 101, 102, 101, 100}, false), 1, 1);
  expect(path({100, 101, 102, 103, 102, 101}, true), 1, 1);
  expect(line({{3.1, 4.2, 0}, {12.7, 9.4, 0}, {3.1, 4.2, 0}}, false), 1, 1);
  // Half the way back.
  const SurfaceCurve half = line({{2, 4.5, 0}, {12, 4.5, 0}, {7, 4.5, 0}}, false);
  const auto found = of(half);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].stretch);
  EXPECT_LT((mesh_.position(found[0].at) - Point(7, 4.5, 0)).norm(), 1e-9);
  // Twice around a square.
  expect(path({22, 23, 44, 43, 22, 23, 44, 43}, true), 1, 1);
}

TEST_F(Contacts, TwoStretchesAndACrossingAreThree) {
  // A closed curve: along y = 5 from x = 2 to 6, and again from x = 10 to 14, and a crossing.
  const SurfaceCurve a = line({{1, 5.5, 0}, {16, 5.5, 0}}, false);
  const SurfaceCurve b = line(
      {{2, 5.5, 0}, {6, 5.5, 0}, {8, 8.5, 0}, {10, 5.5, 0}, {14, 5.5, 0}, {15, 7, 0}, {15.5, 3, 0}},
      false);
  const auto found = self_contacts(mesh_.surface(), std::vector{a, b});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_TRUE(found[0].stretch);
  EXPECT_TRUE(found[1].stretch);
  EXPECT_FALSE(found[2].stretch);
  EXPECT_LT((mesh_.position(found[0].at) - Point(2, 5.5, 0)).norm(), 1e-9);
  EXPECT_LT((mesh_.position(found[1].at) - Point(10, 5.5, 0)).norm(), 1e-9);
  EXPECT_TRUE(of(a).empty());
  EXPECT_TRUE(of(b).empty());
}

TEST_F(Contacts, CrossingAStretchIsNoPlaceOfItsOwn) {
  const SurfaceCurve a = line({{1, 5.5, 0}, {16, 5.5, 0}}, false);
  const SurfaceCurve across = line({{8.3, 2.2, 0}, {8.4, 9.1, 0}}, false);
  EXPECT_EQ(self_contacts(mesh_.surface(), std::vector{a, reversed(a), across}).size(), 1U);
  EXPECT_EQ(self_contacts(mesh_.surface(), std::vector{across, a}).size(), 1U);
}

TEST_F(Contacts, AStarOfDiagonalsHasAsManyAsTheFormulaSays) {
  // {n/2}: n crossings for n >= 5; drawn over many faces, and within one.
  for (const auto& [size, middle] :
       {std::pair(8.0, Point(10.1, 9.9, 0)), std::pair(0.1, Point(10.6, 10.2, 0))}) {
    for (const int n : {5, 7, 9, 11}) {
      std::vector<Point> corners;
      for (int i = 0; i < n; ++i) {
        const double angle = 4 * std::numbers::pi * i / n + 0.1;
        corners.push_back(middle + size * Point(std::cos(angle), std::sin(angle), 0));
      }
      EXPECT_EQ(of(line(corners, true)).size(), std::size_t(n)) << size;
    }
  }
}

TEST_F(Contacts, ManySegmentsInOneFace) {
  // A zigzag of 2000 teeth and a line through its middle: 2000 crossings.
  SurfaceCurve zigzag, middle;
  const auto at = [&](double x, double y) {
    return SurfacePoint::in_face(mesh_.surface(), FaceId{40}, {x, y, 1 - x - y});
  };
  for (int i = 0; i <= 2000; ++i) zigzag.points.push_back(at(0.1 + i * 1e-4, i % 2 ? 0.5 : 0.2));
  middle.points = {at(0.05, 0.35), at(0.4, 0.35)};
  const std::vector<SurfaceCurve> both = {zigzag, middle};
  EXPECT_EQ(self_contacts(mesh_.surface(), both).size(), 2000U);
  EXPECT_TRUE(of(zigzag).empty());
}

TEST_F(Contacts, BadCurvesAreRefused) {
  EXPECT_THROW((void)of(SurfaceCurve{}), Error);
  EXPECT_THROW((void)of(path({0, 200}, false)), Error);
  EXPECT_TRUE(self_contacts(mesh_.surface(), {}).empty());
}

TEST(SelfContacts, GoAroundATorusOnce) {
  // A meridian and a parallel meet once; two parallels never.
  const SurfaceMesh mesh = SurfaceMesh::open(test::torus(12, 18));
  std::vector<VertexId> meridian, parallel, other;
  for (std::size_t i = 0; i < 12; ++i) meridian.emplace_back(5 * 12 + i);
  for (std::size_t j = 0; j < 18; ++j) parallel.emplace_back(j * 12 + 4);
  for (std::size_t j = 0; j < 18; ++j) other.emplace_back(j * 12 + 7);
  const auto curve = [&](const auto& way) { return vertex_curve(mesh.surface(), way, true); };
  EXPECT_EQ(self_contacts(mesh.surface(), std::vector{curve(meridian), curve(parallel)}).size(),
            1U);
  EXPECT_EQ(self_contacts(mesh.surface(), std::vector{curve(parallel), curve(other)}).size(), 0U);
  EXPECT_EQ(
      self_contacts(mesh.surface(), std::vector{curve(parallel), curve(other), curve(meridian)})
          .size(),
      2U);
}

/// From a vertex of the sheet in a direction of its plane, for a length of less than 1.
SurfacePoint spoke_end(const SurfaceMesh& mesh, const Point& middle, double angle, double length) {
  CurveInput input;
  input.points =
      std::vector<Point>{middle, middle + length * Point(std::cos(angle), std::sin(angle), 0)};
  return snap(mesh, input).points.back();
}

// A hundred curves from one vertex into the faces there have one contact. The contact is a stretch
// if two curves of different lengths have the same direction, for any order of the list.
TEST_F(Contacts, AFanAtAVertexIsOnePlace) {
  const Point middle(10, 10, 0);
  const SurfacePoint vertex = SurfacePoint::at_vertex(mesh_.surface(), VertexId{10 * 21 + 10});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const std::size_t doubled : {0U, 1U, 40U}) {
    std::vector<SurfaceCurve> curves;
    for (std::size_t k = 0; k < 100; ++k) {
      const double angle = 2 * std::numbers::pi * unit(random);
      const double length = 0.1 + 0.5 * unit(random);
      curves.push_back({false, {vertex, spoke_end(mesh_, middle, angle, length)}});
      if (k >= doubled) continue;
      curves.push_back({false, {spoke_end(mesh_, middle, angle, 0.05), vertex}});
    }
    std::shuffle(curves.begin(), curves.end(), random);
    const std::vector<SelfContact> places = self_contacts(mesh_.surface(), curves);
    ASSERT_EQ(places.size(), 1U) << doubled;
    EXPECT_EQ(places[0].curve, 0U);
    EXPECT_EQ(places[0].stretch, doubled > 0) << doubled;
  }
}

}  // namespace
}  // namespace talweg
