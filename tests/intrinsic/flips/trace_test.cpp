#include "talweg/intrinsic/flips/trace.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/flips/point_insertion.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {
namespace {

using namespace test;

std::vector<EdgePath> every_edge(const SignpostTriangulation& t) {
  std::vector<EdgePath> paths;
  for (std::size_t i = 0; i < 2 * t.edge_count(); ++i) {
    paths.push_back(EdgePath::make(t, {HalfedgeId{i}}, false));
  }
  return paths;
}

std::vector<double> lengths_of(SignpostTriangulation& t, const std::vector<EdgePath>& paths) {
  std::vector<double> lengths;
  for (const EdgePath& p : paths) lengths.push_back(path_length(t, p));
  return lengths;
}

/// The height of a vertex. The heights lift the metric.
double height(const Point& p) { return std::sin(1.3 * p[0]) + std::cos(0.7 * p[1]) * p[0] / 4; }

double lifted_length(const Surface& s, const std::vector<Point>& points,
                     const SurfaceCurve& curve) {
  const auto lifted = [&](const SurfacePoint& p) {
    const FaceId face = any_face(s, p);
    const auto weights = coordinates_in(s, p, face).barycentric;
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += weights[k] * height(points[s.corners(face)[k].index()]);
    }
    return sum;
  };
  double length = 0;
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
    const SurfacePoint &p = curve.points[i], &q = curve.points[(i + 1) % n];
    length +=
        std::hypot(distance(position(s, points, p), position(s, points, q)), lifted(p) - lifted(q));
  }
  return length;
}

TEST(Trace, WithoutFlipsPathsStayOnTheirEdges) {
  const Surface s = surface_of(grid(2, 2));
  SignpostTriangulation t(s);
  Tracer tracer(t);
  const std::vector<EdgePath> paths = {path_through(t, {0, 1, 2, 5}),
                                       path_through(t, {0, 1, 4, 3}, true)};
  const TraceResult result = tracer.trace_and_undo(paths);
  ASSERT_EQ(result.curves.size(), 2U);
  ASSERT_EQ(result.curves[0].points.size(), 4U);
  ASSERT_EQ(result.curves[1].points.size(), 4U);
  EXPECT_FALSE(result.curves[0].closed);
  EXPECT_TRUE(result.curves[1].closed);
  EXPECT_EQ(result.curves[0].points[3], SurfacePoint::at_vertex(s, VertexId{5}));
  EXPECT_EQ(result.curves[1].points[2], SurfacePoint::at_vertex(s, VertexId{4}));
}

TEST(Trace, NoPathsJustUndoes) {
  const Surface s = surface_of(grid(4, 4));
  SignpostTriangulation t(s);
  const Snapshot before = snapshot(t);
  Random random(1);
  flip_at_random(t, random, 100);
  EXPECT_TRUE(Tracer(t).trace_and_undo({}).curves.empty());
  EXPECT_EQ(snapshot(t), before);
}

TEST(Trace, PlanarEdgesAreStraightLines) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const TestMesh mesh = grid(8, 8, 0.24, seed);
    const Surface s = surface_of(mesh);
    SignpostTriangulation t(s);
    const Snapshot before = snapshot(t);
    Random random(seed);
    flip_fat(t, random, 4000, 0.02);
    const auto paths = every_edge(t);
    std::vector<std::array<VertexId, 2>> ends;
    for (const EdgePath& p : paths) {
      ends.push_back({t.tail(p.halfedges()[0]), t.head(p.halfedges()[0])});
    }
    Tracer tracer(t);
    const TraceResult result = tracer.trace_and_undo(paths);
    EXPECT_EQ(result.clamped, 0U);
    EXPECT_EQ(snapshot(t), before);
    for (std::size_t k = 0; k < paths.size(); ++k) {
      const SurfaceCurve& curve = result.curves[k];
      EXPECT_TRUE(runs_in_faces(s, curve));
      ASSERT_EQ(curve.points.front(), SurfacePoint::at_vertex(s, ends[k][0]));
      ASSERT_EQ(curve.points.back(), SurfacePoint::at_vertex(s, ends[k][1]));
      const Point a = mesh.points[ends[k][0].index()], b = mesh.points[ends[k][1].index()];
      const Point d = b - a;
      double last = -1;
      for (const SurfacePoint& p : curve.points) {
        const Point x = position(s, mesh.points, p) - a;
        EXPECT_NEAR((x[0] * d[1] - x[1] * d[0]) / norm(d), 0, 1e-12);
        const double along = (x[0] * d[0] + x[1] * d[1]) / (norm(d) * norm(d));
        EXPECT_GT(along, last);
        last = along;
      }
      EXPECT_NEAR(length_of(s, mesh.points, curve), norm(d), 1e-12);
    }
    // A second trace finds nothing left of the first.
    EXPECT_EQ(tracer.trace_and_undo({}).curves.size(), 0U);
  }
}

TEST(Trace, CurvedEdgesKeepTheirLengths) {
  const TestMesh meshes[] = {tetrahedron(),        octahedron(),      sphere(1),
                             box(2, 1, 1),         torus(3, 3, 3, 1), torus(7, 4, 3, 1),
                             cylinder(3, 2, 1, 2), cone(3, 1, 1, 4),  double_torus(1)};
  for (const TestMesh& mesh : meshes) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Surface s = surface_of(mesh);
      for (const bool lifted : {false, true}) {
        SignpostTriangulation t(s);
        if (lifted) {
          t.set_metric([&](VertexId a, VertexId b, double length) {
            return std::hypot(length,
                              height(mesh.points[a.index()]) - height(mesh.points[b.index()]));
          });
        }
        const Snapshot before = snapshot(t);
        Random random(seed);
        flip_fat(t, random, 300, 0.01);
        const auto paths = every_edge(t);
        const auto expected = lengths_of(t, paths);
        const TraceResult result = Tracer(t).trace_and_undo(paths);
        EXPECT_EQ(result.clamped, 0U);
        EXPECT_EQ(snapshot(t), before);
        for (std::size_t k = 0; k < paths.size(); ++k) {
          EXPECT_TRUE(runs_in_faces(s, result.curves[k]));
          const double length = lifted ? lifted_length(s, mesh.points, result.curves[k])
                                       : length_of(s, mesh.points, result.curves[k]);
          EXPECT_NEAR(length, expected[k], 1e-10 * (1 + expected[k]));
        }
      }
    }
  }
}

/// Follows a traced edge of a Δ-complex from one corner, unfolding triangle by triangle. Faces can
/// be glued to themselves, so several strips may fit the crossed edges. The check succeeds if one
/// of the strips ends at `to`, straight, at distance `length`, with every crossing at the traced
/// place.
class Unfolding {
 public:
  Unfolding(SignpostTriangulation& t, const SurfaceCurve& curve, double length)
      : t_(t), curve_(curve), length_(length) {}

  bool fits(VertexId from, VertexId to) {
    if (curve_.points.size() == 2) {
      for (std::size_t e = 0; e < t_.edge_count(); ++e) {
        const HalfedgeId h = halfedge_of(EdgeId{e});
        const bool joins =
            (t_.tail(h) == from && t_.head(h) == to) || (t_.tail(h) == to && t_.head(h) == from);
        if (joins && std::abs(t_.length(h) - length_) < 1e-9) return true;
      }
      return false;
    }
    for (std::size_t i = 0; i < 2 * t_.edge_count(); ++i) {
      const HalfedgeId through{i};
      if (!t_.has_face(through) || t_.tail(t_.prev(through)) != from ||
          edge_of(through) != on(1).edge) {
        continue;
      }
      const double base = t_.length(through);
      start_ = apex(base, t_.length(t_.prev(through)), t_.length(t_.next(through)));
      crossed_ = {point(through, {0, 0}, {base, 0}, 1)};
      if (onward(through, {0, 0}, {base, 0}, 1, to)) return true;
    }
    return false;
  }

 private:
  const OnEdge& on(std::size_t k) const { return std::get<OnEdge>(curve_.points[k].where()); }

  PlanePoint point(HalfedgeId h, PlanePoint tail, PlanePoint head, std::size_t k) const {
    const double at = h == halfedge_of(edge_of(h)) ? on(k).t : 1 - on(k).t;
    return {(1 - at) * tail.x + at * head.x, (1 - at) * tail.y + at * head.y};
  }

  bool onward(HalfedgeId through, PlanePoint tail, PlanePoint head, std::size_t k, VertexId to) {
    const HalfedgeId out = twin(through);
    if (!t_.has_face(out)) return false;
    const double base = t_.length(out), dx = (head.x - tail.x) / base,
                 dy = (head.y - tail.y) / base;
    const PlanePoint local = apex(base, t_.length(t_.next(out)), t_.length(t_.prev(out)));
    const PlanePoint corner = {tail.x + local.x * dx + local.y * dy,
                               tail.y + local.x * dy - local.y * dx};
    if (k + 2 == curve_.points.size()) {
      return t_.tail(t_.prev(out)) == to && straight_to(corner);
    }
    for (const HalfedgeId side : {t_.next(out), t_.prev(out)}) {
      if (edge_of(side) != on(k + 1).edge) continue;
      const bool keeps_tail = side == t_.next(out);
      const PlanePoint a = keeps_tail ? tail : corner, b = keeps_tail ? corner : head;
      crossed_.push_back(point(side, a, b, k + 1));
      if (onward(side, a, b, k + 1, to)) return true;
      crossed_.pop_back();
    }
    return false;
  }

  bool straight_to(PlanePoint end) const {
    const double x = end.x - start_.x, y = end.y - start_.y, size = std::hypot(x, y);
    if (std::abs(size - length_) > 1e-9 * (1 + length_)) return false;
    for (const PlanePoint& p : crossed_) {
      const double off = ((p.x - start_.x) * y - (p.y - start_.y) * x) / size;
      if (std::abs(off) > 1e-9 * (1 + length_)) return false;
    }
    return true;
  }

  SignpostTriangulation& t_;
  const SurfaceCurve& curve_;
  double length_;
  PlanePoint start_;
  std::vector<PlanePoint> crossed_;
};

TEST(Trace, FollowsEdgesOfRandomComplexes) {
  Random random(21);
  std::size_t crossings = 0, self_glued = 0;
  for (int k = 0; k < 1500; ++k) {
    const Surface s = random_complex(random, 1 + random.below(8), random.uniform(0, 0.3));
    for (std::size_t f = 0; f < s.face_count(); ++f) {
      for (HalfedgeId h = s.halfedge(FaceId{f}), e = h; e.valid();) {
        self_glued += s.next(e) == twin(e) || s.prev(e) == twin(e) ? 1 : 0;
        e = s.next(e) == h ? HalfedgeId{} : s.next(e);
      }
    }
    SignpostTriangulation t(s);
    const Snapshot before = snapshot(t);
    flip_fat(t, random, 60, 0.02);
    const auto paths = every_edge(t);
    const auto expected = lengths_of(t, paths);
    std::vector<std::array<VertexId, 2>> ends;
    for (const EdgePath& p : paths) {
      ends.push_back({t.tail(p.halfedges()[0]), t.head(p.halfedges()[0])});
    }
    const TraceResult result = Tracer(t).trace_and_undo(paths);
    EXPECT_EQ(snapshot(t), before);
    EXPECT_EQ(result.clamped, 0U);
    for (std::size_t p = 0; p < paths.size(); ++p) {
      crossings += result.curves[p].points.size() - 2;
      ASSERT_TRUE(Unfolding(t, result.curves[p], expected[p]).fits(ends[p][0], ends[p][1]))
          << "complex " << k << ", halfedge " << p;
    }
  }
  EXPECT_GT(crossings, 10000U);
  EXPECT_GT(self_glued, 100U);
}

TEST(Trace, PathsThroughInsertedVertices) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const TestMesh mesh = grid(5, 5, 0.2, seed);
    const Surface s = surface_of(mesh);
    SignpostTriangulation t(s);
    PointInsertion insertion(t);
    Random random(seed);
    std::vector<VertexId> inserted;
    for (int k = 0; k < 30; ++k) {
      const double u = random.uniform(0.1, 0.8), v = random.uniform(0.05, 0.95 - u);
      const FaceId f{random.below(s.face_count())};
      inserted.push_back(insertion.insert(
          k % 2 == 0 ? SurfacePoint::in_face(s, f, {u, v, 1 - u - v})
                     : SurfacePoint::on_edge(s, EdgeId{random.below(s.edge_count())}, u)));
    }
    const Snapshot before = snapshot(t);
    flip_fat(t, random, 2000, 0.02);
    const auto paths = every_edge(t);
    std::vector<std::array<VertexId, 2>> ends;
    for (const EdgePath& p : paths) {
      ends.push_back({t.tail(p.halfedges()[0]), t.head(p.halfedges()[0])});
    }
    const TraceResult result = Tracer(t).trace_and_undo(paths);
    EXPECT_EQ(snapshot(t), before);
    for (std::size_t k = 0; k < paths.size(); ++k) {
      const SurfaceCurve& curve = result.curves[k];
      EXPECT_TRUE(runs_in_faces(s, curve));
      EXPECT_EQ(curve.points.front(), t.location(ends[k][0]));
      EXPECT_EQ(curve.points.back(), t.location(ends[k][1]));
      EXPECT_NEAR(length_of(s, mesh.points, curve),
                  distance(position(s, mesh.points, curve.points.front()),
                           position(s, mesh.points, curve.points.back())),
                  1e-9);
    }
    t.remove_inserted();
  }
}

}  // namespace
}  // namespace talweg
