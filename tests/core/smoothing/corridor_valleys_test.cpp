// What is tried before a set with loops is smoothed.
#include "talweg/core/smoothing/corridor_valleys.hpp"

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kPlainColumns = 24;

VertexId in_plain(std::uint32_t i, std::uint32_t j) {
  return VertexId{j * (kPlainColumns + 1) + i};
}

/// A loop around one vertex and a straight line far from it.
struct SpeckAndLine {
  SurfaceMesh mesh = SurfaceMesh::open(test::grid(kPlainColumns, kPlainColumns));
  OrderedDrawing drawing;
  std::vector<Corridor::Valley> valleys;
  std::size_t speck = 0;

  SpeckAndLine() {
    const std::vector<VertexId> around{in_plain(5, 4), in_plain(5, 5), in_plain(4, 5),
                                       in_plain(3, 4), in_plain(3, 3), in_plain(4, 3)};
    std::vector<VertexId> line;
    for (std::uint32_t i = 1; i < kPlainColumns; ++i) line.push_back(in_plain(i, 18));
    const std::vector curves{test::vertex_curve(mesh.surface(), line, false),
                             test::vertex_curve(mesh.surface(), around, true)};
    Asker asker({}, "test");
    drawing = OrderedDrawing(mesh, curves, asker);
    valleys = valleys_of(mesh, drawing, {});
    speck = drawing.place_of(1);
    for (Corridor::Valley& valley : valleys) valley.slack = 4;  // the loop is in doubt
  }

  /// A trial in which the speck collapses or stays.
  [[nodiscard]] Smoothed trial(bool collapses) const {
    Smoothed result;
    for (const SurfaceCurve& curve : drawing.curves()) result.curves.emplace_back().curve = curve;
    if (collapses) result.curves[speck].path.termination = Termination::kCollapsed;
    return result;
  }
};

TEST(CorridorValleys, OnlyLoopsInDoubtAreMadeFairInTrials) {
  SpeckAndLine set;
  int trials = 0;
  hold_loops(set.valleys, set.mesh, set.drawing, [&](const SmoothingOptions& options) {
    for (std::size_t c = 0; c < set.valleys.size(); ++c) {
      EXPECT_EQ(options.finish_of(c), c == set.speck ? Finish::kFair : Finish::kTaut);
      EXPECT_EQ(options.tau_of(c), 0.25);
    }
    return set.trial(++trials < 3);
  });
  EXPECT_EQ(trials, 3);
  EXPECT_EQ(set.valleys[set.speck].slack, 1);      // halved twice
  EXPECT_EQ(set.valleys[1 - set.speck].slack, 4);  // as it was
}

TEST(CorridorValleys, WithoutALoopInDoubtNothingIsTried) {
  SpeckAndLine set;
  set.valleys[set.speck].slack = 1e-3;
  hold_loops(set.valleys, set.mesh, set.drawing, [&](const SmoothingOptions&) {
    ADD_FAILURE();
    return Smoothed{};
  });
  EXPECT_EQ(set.valleys[set.speck].slack, 1e-3);
}

}  // namespace
}  // namespace talweg
