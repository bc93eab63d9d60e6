// Laws of single algorithms, on every subject: Laplacian, Delaunay triangulation, distance.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "laws/subjects.hpp"
#include "talweg/heat/cotan_laplacian.hpp"
#include "talweg/intrinsic/flips/delaunay.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {
namespace {

class DiscreteLaw : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    subject_ = test::make_subject(GetParam());
    if (subject_.lists.points.empty()) {
      GTEST_SKIP() << test::missing(GetParam());
    }
  }
  test::Subject subject_;
};

/// The current triangulation as a surface.
Surface rebuilt(SignpostTriangulation& t) {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> gluing;
  std::vector<std::uint32_t> side_of(2 * t.edge_count(), Surface::kNoSide);
  std::vector<HalfedgeId> order;
  for (std::size_t i = 0; i < 2 * t.edge_count(); ++i) {
    HalfedgeId h{i};
    if (!t.has_face(h) || side_of[i] != Surface::kNoSide) continue;
    Triangle triangle{};
    for (std::uint32_t& corner : triangle) {
      corner = static_cast<std::uint32_t>(t.tail(h).index());
      side_of[h.index()] = static_cast<std::uint32_t>(order.size());
      order.push_back(h);
      h = t.next(h);
    }
    triangles.push_back(triangle);
  }
  for (const HalfedgeId h : order) gluing.push_back(side_of[twin(h).index()]);
  Surface surface = Surface::from_gluing(t.vertex_count(), triangles, gluing);
  std::vector<double> lengths(surface.edge_count());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    HalfedgeId h = surface.halfedge(FaceId{f});
    for (std::size_t k = 0; k < 3; ++k, h = surface.next(h)) {
      lengths[edge_of(h).index()] = t.length(order[3 * f + k]);
    }
  }
  surface.set_lengths(lengths);
  return surface;
}

/// Entries of the Delaunay cotan matrix by row and column.
std::map<std::pair<std::int32_t, std::int32_t>, double> delaunay_matrix(const Surface& surface) {
  const auto laplacian = cotan_laplacian(surface.vertex_count(), delaunay_triangles(surface));
  std::map<std::pair<std::int32_t, std::int32_t>, double> entries;
  const SymmetricMatrix& m = laplacian.stiffness;
  for (std::size_t j = 0; j < m.size(); ++j) {
    for (std::int32_t k = m.column_start[j]; k < m.column_start[j + 1]; ++k) {
      entries[{m.row[static_cast<std::size_t>(k)], static_cast<std::int32_t>(j)}] +=
          m.value[static_cast<std::size_t>(k)];
    }
  }
  return entries;
}

TEST_P(DiscreteLaw, DelaunayAfterAnyFlipsGivesTheSameCotanMatrix) {
  const SurfaceMesh mesh = SurfaceMesh::open(subject_.lists);
  const auto expected = delaunay_matrix(mesh.surface());
  double largest = 0;
  for (const auto& [place, value] : expected) largest = std::max(largest, std::abs(value));

  SignpostTriangulation t(mesh.surface());
  std::mt19937 random(3);
  std::size_t flips = 0;
  for (std::size_t k = 0; k < 2 * t.edge_count(); ++k) {
    flips += t.flip(EdgeId{random() % t.edge_count()}) ? 1 : 0;
  }
  EXPECT_GT(flips, t.edge_count() / 2);
  const auto found = delaunay_matrix(rebuilt(t));
  // Four points on a circle have two Delaunay diagonals, each with weight 0, so entries are
  // compared, not patterns. Lengths of flipped edges carry the rounding of all flips.
  double worst = 0;
  for (const auto& [place, value] : expected) {
    const auto it = found.find(place);
    worst = std::max(worst, std::abs(value - (it == found.end() ? 0 : it->second)));
  }
  for (const auto& [place, value] : found) {
    if (!expected.contains(place)) worst = std::max(worst, std::abs(value));
  }
  RecordProperty("worst", std::to_string(worst / largest));
  EXPECT_LE(worst, 1e-6 * largest);
}

double perimeter(SignpostTriangulation& t, HalfedgeId diagonal) {
  double sum = 0;
  for (const HalfedgeId side : {diagonal, twin(diagonal)}) {
    sum += t.length(t.next(side)) + t.length(t.prev(side));
  }
  return sum;
}

/// The squared perimeter divided by the area of the smaller triangle: 1 / angle for needles. The
/// flip back enlarges the rounding of a diagonal's length by this factor.
double shape_number(SignpostTriangulation& t, HalfedgeId diagonal) {
  double area = HUGE_VAL;
  for (const HalfedgeId side : {diagonal, twin(diagonal)}) {
    if (!t.has_face(side)) continue;
    area = std::min(area,
                    triangle_area(t.length(side), t.length(t.next(side)), t.length(t.prev(side))));
  }
  const double around = t.on_boundary(edge_of(diagonal)) ? 0 : perimeter(t, diagonal);
  return around * around / area;
}

TEST_P(DiscreteLaw, FlipAndItsInverseRestoreLengths) {
  // A second flip turns the edge back on itself.
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  const SurfaceMesh mesh = SurfaceMesh::open(subject_.lists);
  SignpostTriangulation t(mesh.surface());
  std::size_t flipped = 0;
  for (std::size_t e = 0; e < t.edge_count(); ++e) {
    const EdgeId edge{e};
    const double length = t.length(edge);
    const HalfedgeId h = halfedge_of(edge);
    const VertexId tail = t.tail(h);
    const VertexId head = t.head(h);
    const double before = shape_number(t, h);
    if (!t.flip(edge)) continue;
    ++flipped;
    const double shape = std::max(before, shape_number(t, h));
    ASSERT_TRUE(t.flip(edge)) << e;
    // The inverse flip of a diagonal may reverse its direction.
    EXPECT_TRUE((t.tail(h) == tail && t.head(h) == head) ||
                (t.tail(h) == head && t.head(h) == tail));
    EXPECT_NEAR(t.length(edge), length, 16 * kEpsilon * shape * perimeter(t, h)) << e;
    t.undo_flip();
    t.undo_flip();
    EXPECT_EQ(t.length(edge), length);
  }
  EXPECT_GT(flipped, t.edge_count() / 2);
}

TEST_P(DiscreteLaw, LaplacianRowsSumToZero) {
  const SurfaceMesh mesh = SurfaceMesh::open(subject_.lists);
  for (const bool delaunay : {false, true}) {
    const auto triangles =
        delaunay ? delaunay_triangles(mesh.surface()) : metric_triangles(mesh.surface());
    const SymmetricMatrix m = cotan_laplacian(mesh.surface().vertex_count(), triangles).stiffness;
    const std::vector<double> sums = multiply(m, std::vector<double>(m.size(), 1.0));
    for (std::size_t v = 0; v < sums.size(); ++v) {
      EXPECT_NEAR(sums[v], 0, 1e-12 * (1 + m.diagonal(v))) << v;
    }
    // Positive semidefinite: x'Sx >= 0 for any x.
    std::mt19937 random(5);
    for (int trial = 0; trial < 5; ++trial) {
      std::vector<double> x(m.size());
      for (double& value : x) value = static_cast<double>(random()) * 0x1p-31 - 1;
      const std::vector<double> y = multiply(m, x);
      double energy = 0;
      for (std::size_t v = 0; v < x.size(); ++v) energy += x[v] * y[v];
      EXPECT_GT(energy, 0);
    }
  }
}

TEST_P(DiscreteLaw, DistanceIsNotNegativeAndAlmostOneLipschitz) {
  // The exact distance changes along an edge by at most the length of the edge. The heat method
  // fits unit gradients only on average: at the medial axis and at sources single edges are
  // steeper. The bounds are a slope of 1.5 for every edge, and 1.25 for 99 of 100 edges.
  const auto opened = OpenedMesh::open(subject_.lists);
  const Surface& surface = opened->surface();
  for (const test::Subject::Drawing& drawing : subject_.drawings) {
    CurveSmoother smoother(opened);
    smoother.set_curve(test::curve_of(surface, drawing), test::kPapers);
    std::vector<double> slopes;
    for (const double d : smoother.distance()) EXPECT_GE(d, 0);
    for (std::size_t e = 0; e < surface.edge_count(); ++e) {
      const HalfedgeId h = halfedge_of(EdgeId{e});
      slopes.push_back(std::abs(smoother.distance()[surface.tail(h).index()] -
                                smoother.distance()[surface.head(h).index()]) /
                       surface.length(EdgeId{e}));
    }
    std::sort(slopes.begin(), slopes.end());
    const double most = slopes[slopes.size() - 1 - slopes.size() / 100];
    RecordProperty("largest", std::to_string(slopes.back()));
    RecordProperty("most", std::to_string(most));
    EXPECT_LE(slopes.back(), 1.5);
    EXPECT_LE(most, 1.25);
  }
}

INSTANTIATE_TEST_SUITE_P(All, DiscreteLaw, ::testing::ValuesIn(test::subject_names()),
                         [](const auto& one) { return one.param; });

}  // namespace
}  // namespace talweg
