// Laws of the whole pipeline, from mesh and drawing to smoothed curve, on every subject: invariance
// under irrelevant changes.
#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "laws/subjects.hpp"

namespace talweg {
namespace {

using test::Outcome;
using test::Subject;

struct Setting {
  std::string subject;
  double tau = 0;
  Method method = Method::kPaper;

  [[nodiscard]] std::string name() const {
    if (method == Method::kCorridor) return subject + "_corridor";
    return subject + (tau == 0 ? "_geodesic" : "_tau1");
  }
};

std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (const std::string& subject : test::subject_names()) {
    all.push_back({subject, 0, Method::kPaper});
    all.push_back({subject, 1, Method::kPaper});
    all.push_back({subject, 1, Method::kCorridor});
  }
  return all;
}

class PipelineLaw : public ::testing::TestWithParam<Setting> {
 protected:
  void SetUp() override {
    subject_ = test::make_subject(GetParam().subject);
    if (subject_.lists.points.empty()) {
      GTEST_SKIP() << test::missing(GetParam().subject);
    }
    tau_ = GetParam().tau;
    corridor_ = GetParam().method == Method::kCorridor;
    options_.method = GetParam().method;
    // Fairing stops when a step gains no relevant energy.
    exact_ = corridor_ ? 1e-4 : 1e-9;
    size_ = test::diameter_of(subject_.lists);
  }

  /// Compares the result on another mesh, transformed back by `back`, with the result on the mesh
  /// of the subject.
  template <class Back>
  void expect_same(const MeshLists& other, const Subject::Drawing& drawing,
                   const Subject::Drawing& on_other, Back back) {
    const Outcome expected = test::smooth_drawing(subject_.lists, drawing, tau_, options_);
    Outcome found = test::smooth_drawing(other, on_other, tau_, options_);
    for (Point& p : found.points) p = back(p);
    EXPECT_EQ(found.report.termination, expected.report.termination);
    EXPECT_LE(test::curve_gap(found.points, expected.points, drawing.closed), exact_ * size_)
        << expected.points.size() << " and " << found.points.size() << " points";
  }

  Subject subject_;
  double tau_ = 0;
  bool corridor_ = false;
  CurveOptions options_;
  double exact_ = 0;  // tolerance, relative to the size of the mesh
  double size_ = 0;
};

TEST_P(PipelineLaw, Scale) {
  for (const Subject::Drawing& drawing : subject_.drawings) {
    for (const double scale : {1e6, 1e-6, 0x1p40}) {
      MeshLists other = subject_.lists;
      for (Point& p : other.points) p *= scale;
      expect_same(other, drawing, drawing, [&](const Point& p) { return Point(p / scale); });
    }
  }
}

TEST_P(PipelineLaw, ShiftAndRotation) {
  const Eigen::AngleAxisd turn(1.1, Point(0.3, -0.8, 0.52).normalized());
  const Point shift = size_ * Point(50, -70, 30);
  MeshLists other = subject_.lists;
  for (Point& p : other.points) p = turn * p + shift;
  for (const Subject::Drawing& drawing : subject_.drawings) {
    expect_same(other, drawing, drawing,
                [&](const Point& p) { return Point(turn.inverse() * (p - shift)); });
  }
}

TEST_P(PipelineLaw, Renumbering) {
  std::mt19937 random(11);
  const MeshLists& lists = subject_.lists;
  std::vector<std::uint32_t> fresh(lists.points.size());
  for (std::uint32_t v = 0; v < fresh.size(); ++v) fresh[v] = v;
  std::shuffle(fresh.begin(), fresh.end(), random);
  MeshLists other = lists;
  for (std::size_t v = 0; v < fresh.size(); ++v) other.points[fresh[v]] = lists.points[v];
  for (Triangle& t : other.triangles) {
    for (std::uint32_t& v : t) v = fresh[v];
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  }
  std::shuffle(other.triangles.begin(), other.triangles.end(), random);
  for (const Subject::Drawing& drawing : subject_.drawings) {
    Subject::Drawing renamed = drawing;
    for (VertexId& v : renamed.path) v = VertexId{fresh[v.index()]};
    expect_same(other, drawing, renamed, [](const Point& p) { return p; });
  }
}

TEST_P(PipelineLaw, Reversal) {
  for (const Subject::Drawing& drawing : subject_.drawings) {
    Subject::Drawing reversed = drawing;
    std::reverse(reversed.path.begin(), reversed.path.end());
    expect_same(subject_.lists, drawing, reversed, [](const Point& p) { return p; });
  }
}

TEST_P(PipelineLaw, OtherStartOfAClosedCurve) {
  for (const Subject::Drawing& drawing : subject_.drawings) {
    if (!drawing.closed) continue;
    for (const double part : {0.21, 0.5, 0.83}) {
      Subject::Drawing turned = drawing;
      const auto size = static_cast<double>(drawing.path.size());
      std::rotate(turned.path.begin(),
                  turned.path.begin() + static_cast<std::ptrdiff_t>(part * size),
                  turned.path.end());
      expect_same(subject_.lists, drawing, turned, [](const Point& p) { return p; });
    }
  }
}

/// The drawing with a point inserted on each of its edges.
SurfaceCurve subdivided(const Surface& surface, const Subject::Drawing& drawing) {
  SurfaceCurve fine{drawing.closed, {}};
  const std::size_t n = drawing.path.size();
  for (std::size_t i = 0; i < n; ++i) {
    fine.points.push_back(SurfacePoint::at_vertex(surface, drawing.path[i]));
    if (i + 1 == n && !drawing.closed) break;
    const auto a = static_cast<std::uint32_t>(drawing.path[i].index());
    const auto b = static_cast<std::uint32_t>(drawing.path[(i + 1) % n].index());
    fine.points.push_back(test::between(surface, a, b, 0.4));
  }
  return fine;
}

TEST_P(PipelineLaw, SubdividedDrawing) {
  // At tau = 0 the subdivided drawing is the same curve on the same surface. For tau > 0 the
  // potential, which is linear in each triangle, is sampled at more points. These meshes are coarse
  // (L is 15 to 60 edges): at tau = 1 an edge beside the drawing climbs several times its length
  // and the results differ visibly, at tau = 0.1 by a fraction of an edge.
  const std::vector<double> taus =
      tau_ == 0 ? std::vector<double>{0} : std::vector<double>{corridor_ ? 0.25 : 0.1, tau_};
  const auto opened = OpenedMesh::open(subject_.lists);
  const CurveOptions uncapped{.method = options_.method, .cap_corners = false};
  CurveSmoother plain(opened);
  CurveSmoother fine(opened);
  for (const Subject::Drawing& drawing : subject_.drawings) {
    plain.set_curve(test::curve_of(opened->surface(), drawing), uncapped);
    fine.set_curve(subdivided(opened->surface(), drawing), uncapped);
    const double largest =
        corridor_ ? 0 : *std::max_element(plain.distance().begin(), plain.distance().end());
    for (std::size_t v = 0; v < plain.distance().size(); ++v) {
      ASSERT_NEAR(fine.distance()[v], plain.distance()[v], 1e-9 * largest) << v;
    }
    for (const double tau : taus) {
      const double gap =
          test::curve_gap(positions_of(opened->mesh(), fine.smooth(tau).curve()),
                          positions_of(opened->mesh(), plain.smooth(tau).curve()), drawing.closed);
      const double edges = gap / opened->mesh().mean_edge_length();
      RecordProperty("gap_at_" + std::to_string(tau), std::to_string(edges));
      const double bound = tau == 0 ? 1e-8 : tau < 1 ? (corridor_ ? 0.6 : 1) : 4;
      EXPECT_LE(edges, bound) << "mean edge lengths, at tau = " << tau;
    }
  }
}

TEST_P(PipelineLaw, OtherOrderOfASet) {
  const auto opened = OpenedMesh::open(subject_.lists);
  const Surface& surface = opened->surface();
  // Two parts of the first drawing that do not touch.
  const std::vector<VertexId>& path = subject_.drawings.front().path;
  const auto part = [&](double from, double to) {
    const auto n = static_cast<double>(path.size());
    return Subject::Drawing{{path.begin() + static_cast<std::ptrdiff_t>(from * n),
                             path.begin() + static_cast<std::ptrdiff_t>(to * n)},
                            false};
  };
  const std::vector<SurfaceCurve> curves = {test::curve_of(surface, part(0, 0.45)),
                                            test::curve_of(surface, part(0.55, 1))};
  CurveSmoother smoother(opened);
  smoother.set_curves(curves, options_);
  const SmoothingResult expected = smoother.smooth(tau_);
  std::vector<SurfaceCurve> swapped(curves.rbegin(), curves.rend());
  smoother.set_curves(swapped, options_);
  const SmoothingResult found = smoother.smooth(tau_);
  ASSERT_EQ(found.curves.size(), curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::size_t d = curves.size() - 1 - c;
    EXPECT_EQ(found.reports[d].termination, expected.reports[c].termination);
    EXPECT_LE(test::curve_gap(positions_of(opened->mesh(), found.curves[d]),
                              positions_of(opened->mesh(), expected.curves[c]), curves[c].closed),
              exact_ * size_);
  }
}

TEST_P(PipelineLaw, AnotherComponentChangesNothing) {
  // One component far away and much larger, one at the same place.
  const MeshLists& own = subject_.lists;
  MeshLists far = test::tube(12, 9, 3);
  for (Point& p : far.points) p = 1e3 * size_ * (p + Point(5, 0, 0));
  const Subject::Drawing& drawing = subject_.drawings.front();
  const Outcome expected = test::smooth_drawing(own, drawing, tau_, options_);
  for (const MeshLists& second : {far, own}) {
    const Outcome found =
        test::smooth_drawing(test::together(own, second, 0), drawing, tau_, options_);
    EXPECT_LE(test::curve_gap(found.points, expected.points, drawing.closed), exact_ * size_);
    EXPECT_EQ(found.report.flips, expected.report.flips);
  }
}

TEST_P(PipelineLaw, TwoComponentsAreSmoothedAsOne) {
  // Two copies of the mesh, with the drawing on both: both results equal the result on the mesh
  // alone.
  const MeshLists& own = subject_.lists;
  const MeshLists both = test::together(own, own, 0);
  const auto opened = OpenedMesh::open(both);
  const auto shift = own.points.size();
  const Subject::Drawing& drawing = subject_.drawings.front();
  Subject::Drawing on_second = drawing;
  for (VertexId& v : on_second.path) v = VertexId{v.index() + shift};
  const std::vector<SurfaceCurve> curves = {test::curve_of(opened->surface(), drawing),
                                            test::curve_of(opened->surface(), on_second)};
  CurveSmoother smoother(opened);
  smoother.set_curves(curves, options_);
  const SmoothingResult found = smoother.smooth(tau_);
  const Outcome expected = test::smooth_drawing(own, drawing, tau_, options_);
  for (const SurfaceCurve& curve : found.curves) {
    EXPECT_LE(test::curve_gap(positions_of(opened->mesh(), curve), expected.points, drawing.closed),
              exact_ * size_);
  }
}

TEST_P(PipelineLaw, InsertAndRemoveLeavesNoTrace) {
  // Drawings through faces and edges insert vertices, which must not affect the next drawing.
  const auto opened = OpenedMesh::open(subject_.lists);
  CurveSmoother used(opened);
  const SurfaceCurve drawn = test::curve_of(opened->surface(), subject_.drawings.front());
  used.set_curve(drawn, options_);
  const SmoothingResult first = used.smooth(tau_);
  used.set_curve(first.curve(), options_);
  used.smooth(tau_);
  used.set_curve(drawn, options_);
  const SmoothingResult again = used.smooth(tau_);
  EXPECT_EQ(again.curve().points, first.curve().points);
  EXPECT_EQ(again.report().flips, first.report().flips);
}

INSTANTIATE_TEST_SUITE_P(All, PipelineLaw, ::testing::ValuesIn(settings()),
                         [](const auto& one) { return one.param.name(); });

}  // namespace
}  // namespace talweg
