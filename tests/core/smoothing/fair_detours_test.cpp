// Fair curves follow detours that straightening cuts off.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

TEST(FairDetours, AreKeptWhereStraighteningCutsThemOff) {
  constexpr std::uint32_t kDetourColumns = 60;
  const auto opened = OpenedMesh::open(test::grid(kDetourColumns, 30));
  const auto at = [](std::uint32_t column, std::uint32_t row) {
    return VertexId{row * (kDetourColumns + 1) + column};
  };
  std::vector<VertexId> way;
  for (std::uint32_t k = 2; k <= 28; k += 2) way.push_back(at(k, 12 + k / 2 % 2));
  for (const auto& [i, j] : {std::pair(29U, 12U), {29U, 24U}, {31U, 24U}, {31U, 12U}}) {
    way.push_back(at(i, j));
  }
  for (std::uint32_t k = 32; k <= 58; k += 2) way.push_back(at(k, 12 + k / 2 % 2));
  const SurfaceCurve drawn =
      test::vertex_curve(opened->surface(), draw_edge_path(opened->surface(), way), false);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  SmoothingOptions options;
  const SmoothingResult fair = smoother.smooth(options);
  options.finish = Finish::kTaut;
  const SmoothingResult straightened = smoother.smooth(options);
  EXPECT_GT(straightened.report().deviation_from_drawn_max, 6);
  EXPECT_LT(fair.report().deviation_from_drawn_max, 3);
  EXPECT_LE(fair.report().deviation_to_drawn_max, 1.5 * fair.report().slack * (1 + 1e-3));
  EXPECT_LT(fair.report().after.bending, fair.report().before.bending / 4);
}

}  // namespace
}  // namespace talweg
