// Borders of labels on grids and spheres where every border is known.
#include "talweg/core/labels/label_borders.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/curve_embedding.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using Labels = std::vector<std::int64_t>;

/// One label per face by a rule on the face's middle.
template <class Rule>
Labels by_face(const SurfaceMesh& mesh, const Rule& rule) {
  Labels labels;
  for (std::size_t f = 0; f < mesh.surface().face_count(); ++f) {
    Point middle = Point::Zero();
    for (const VertexId v : mesh.surface().corners(FaceId{f})) middle += mesh.point(v) / 3;
    labels.push_back(rule(middle));
  }
  return labels;
}

template <class Rule>
Labels by_vertex(const SurfaceMesh& mesh, const Rule& rule) {
  Labels labels;
  for (const Point& p : mesh.points()) labels.push_back(rule(p));
  return labels;
}

/// A closed mesh without symmetry of the labels below: an octahedron, divided four times.
SurfaceMesh ball() { return SurfaceMesh::open(test::sphere(4)); }

int octant(const Point& p) {
  return (p.x() > 0.1 ? 1 : 0) + (p.y() > 0.1 ? 2 : 0) + (p.z() > 0.1 ? 4 : 0);
}

/// Exactly the edges between two labels are on borders, once each.
void expect_all_edges_once(const SurfaceMesh& mesh, const Labels& labels) {
  const Surface& surface = mesh.surface();
  std::multiset<std::size_t> found;
  for (const LabelBorder& border : label_borders(surface, labels)) {
    EXPECT_LT(border.labels[0], border.labels[1]);
    EXPECT_NO_THROW(check_drawn(surface, border.curve));
    const std::size_t n = border.curve.points.size();
    for (std::size_t i = 0; i + (border.curve.closed ? 0 : 1) < n; ++i) {
      const auto vertex = [&](std::size_t k) {
        return std::get<AtVertex>(border.curve.points[k % n].where()).vertex;
      };
      const HalfedgeId h = surface.find_halfedge(vertex(i), vertex(i + 1));
      ASSERT_TRUE(h.valid());
      EXPECT_EQ(labels[surface.face(h).index()], border.labels[0]);
      EXPECT_EQ(labels[surface.face(twin(h)).index()], border.labels[1]);
      found.insert(edge_of(h).index());
    }
  }
  std::multiset<std::size_t> expected;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    if (surface.on_boundary(EdgeId{e})) continue;
    if (labels[surface.face(h).index()] != labels[surface.face(twin(h)).index()]) {
      expected.insert(e);
    }
  }
  EXPECT_EQ(found, expected);
}

TEST(LabelBorders, OfTwoHalvesOfABallIsOneLoop) {
  const SurfaceMesh mesh = ball();
  const auto half = [](const Point& p) { return p.z() > 0.1 ? 7 : -3; };
  for (const Labels& labels : {by_face(mesh, half), by_vertex(mesh, half)}) {
    const auto borders = label_borders(mesh.surface(), labels);
    ASSERT_EQ(borders.size(), 1U);
    EXPECT_TRUE(borders[0].curve.closed);
    EXPECT_TRUE(borders[0].fixed.empty());
    EXPECT_EQ(borders[0].labels, (std::array<std::int64_t, 2>{-3, 7}));
    EXPECT_NO_THROW(check_drawn(mesh.surface(), borders[0].curve));
    // -3, the lower half, lies on the left: from above the loop runs clockwise.
    double area = 0;
    const std::vector<Point> at = positions_of(mesh, borders[0].curve);
    for (std::size_t i = 0; i < at.size(); ++i) area += at[i].cross(at[(i + 1) % at.size()]).z();
    EXPECT_LT(area, -1);
  }
  expect_all_edges_once(mesh, by_face(mesh, half));
}

TEST(LabelBorders, OfOctantsEndAtTheirJunctions) {
  const SurfaceMesh mesh = ball();
  expect_all_edges_once(mesh, by_face(mesh, octant));
  // Eight regions of a sphere with twelve borders between them (Euler).
  const auto borders = label_borders(mesh.surface(), by_vertex(mesh, octant));
  std::set<std::pair<std::int64_t, std::int64_t>> pairs;
  for (const LabelBorder& border : borders) {
    EXPECT_NO_THROW(check_drawn(mesh.surface(), border.curve));
    EXPECT_FALSE(border.curve.closed);
    pairs.emplace(border.labels[0], border.labels[1]);
  }
  EXPECT_GE(borders.size(), 12U);
  EXPECT_TRUE(pairs.contains({0, 1}) && pairs.contains({6, 7}));
}

TEST(LabelBorders, OfASheetEndAtItsBoundary) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(12, 8));
  const auto left = [](const Point& p) { return p.x() < 6 ? 0 : 1; };
  for (const Labels& labels : {by_face(mesh, left), by_vertex(mesh, left)}) {
    const auto borders = label_borders(mesh.surface(), labels);
    ASSERT_EQ(borders.size(), 1U);
    EXPECT_FALSE(borders[0].curve.closed);
    for (const SurfacePoint& end :
         {borders[0].curve.points.front(), borders[0].curve.points.back()}) {
      const double y = mesh.position(end).y();
      EXPECT_TRUE(y < 0.1 || y > 7.9) << y;
    }
  }
}

TEST(LabelBorders, ALoopThatHangsOnAJunctionIsHeldThere) {
  // A region that touches the border of two others at one vertex only: 2 inside 1, beside 0.
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(12, 8));
  const Surface& surface = mesh.surface();
  Labels labels = by_face(mesh, [](const Point& p) { return p.y() < 4 ? 0 : 1; });
  const auto straight = label_borders(surface, labels);
  ASSERT_EQ(straight.size(), 1U);
  // A face above the border that has a corner, but no side, on it.
  const auto on_border = [&](VertexId v) { return mesh.point(v).y() == 4; };
  for (std::size_t f = 0; f < labels.size(); ++f) {
    const auto corners = surface.corners(FaceId{f});
    const auto n = std::count_if(corners.begin(), corners.end(), on_border);
    const bool inside = std::all_of(corners.begin(), corners.end(), [&](VertexId v) {
      return mesh.point(v).y() >= 4 && mesh.point(v).x() > 3 && mesh.point(v).x() < 9;
    });
    if (labels[f] == 1 && n == 1 && inside) {
      labels[f] = 2;
      break;
    }
  }
  const auto borders = label_borders(surface, labels);
  ASSERT_EQ(borders.size(), 3U);  // the straight border in two pieces, and the face's sides
  std::size_t loops = 0;
  for (const LabelBorder& border : borders) {
    if (!border.curve.closed) continue;
    ++loops;
    ASSERT_EQ(border.fixed.size(), 1U);
    EXPECT_EQ(mesh.position(border.fixed[0]).y(), 4);
    EXPECT_EQ(border.curve.points.size(), 3U);
  }
  EXPECT_EQ(loops, 1U);
}

TEST(LabelBorders, RefusesInvalidLabels) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(12, 8));
  const auto refused = [&](const Labels& labels, const char* word) {
    try {
      label_borders(mesh.surface(), labels);
      ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  refused(Labels(5, 1), "5 labels");
  refused(Labels(mesh.surface().face_count(), 1), "the same label");
  refused(Labels(mesh.surface().vertex_count(), 4), "the same label");
}

}  // namespace
}  // namespace talweg
