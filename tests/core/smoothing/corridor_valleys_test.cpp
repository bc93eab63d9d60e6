#include "talweg/core/smoothing/corridor_valleys.hpp"

#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kAcross = 40;

/// A loop 20 edges long and one edge wide, whose slack is wider than that.
class HoldLoops : public testing::Test {
 protected:
  /// The slack that is left, with trials that hold the loop from so many halvings on.
  double slack_held_from(int halvings) {
    const std::vector<StrokeSlack> slacks{{4, SlackSource::kTrembling, {}}};
    const OrderedDrawing drawing = checked_drawing(mesh, std::span(&loop, 1), slacks, {}, {});
    std::vector<Corridor::Valley> valleys = valleys_of(mesh, drawing, {});
    hold_loops(valleys, mesh, drawing, [&](const SmoothingOptions&) {
      tried.push_back(valleys[0].slack);
      Smoothed result;
      result.curves.emplace_back().curve = drawing.curves()[0];
      if (valleys[0].slack > std::ldexp(4, -halvings)) {
        result.curves[0].path.termination = Termination::kCollapsed;
      }
      return result;
    });
    return valleys[0].slack;
  }

  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(kAcross, kAcross));
  const SurfaceMesh& mesh = opened->mesh();
  const SurfaceCurve loop = test::vertex_curve(
      opened->surface(),
      draw_edge_path(
          opened->surface(),
          std::vector{VertexId{20 * (kAcross + 1) + 10}, VertexId{20 * (kAcross + 1) + 30},
                      VertexId{21 * (kAcross + 1) + 30}, VertexId{21 * (kAcross + 1) + 10}},
          true),
      true);
  std::vector<double> tried;
};

TEST_F(HoldLoops, HalveTheSlackUntilTheLoopHolds) {
  EXPECT_EQ(slack_held_from(0), 4);
  EXPECT_EQ(tried, std::vector<double>({4}));
  tried.clear();
  EXPECT_EQ(slack_held_from(1), 2);
  EXPECT_EQ(tried, std::vector<double>({4, 2}));
  tried.clear();
  EXPECT_EQ(slack_held_from(3), 0.5);
  EXPECT_EQ(slack_held_from(6), 4 / 64.0);
  EXPECT_EQ(slack_held_from(7), 4 / 128.0);
}

TEST_F(HoldLoops, FindByTheThirdTrialThatNoSlackHolds) {
  EXPECT_LT(slack_held_from(100), 1);
  EXPECT_EQ(tried, std::vector<double>({4, 2, 4 / 128.0}));
}

}  // namespace
}  // namespace talweg
