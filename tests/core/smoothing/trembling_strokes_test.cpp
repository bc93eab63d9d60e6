// A long stroke that trembles wildly is fair, follows its drawing and does not cross itself.
#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

/// A stroke of 1,879 points with random trembling of nine edges. Fairing that starts from the
/// drawing with fine samples ends at a bending of 153.
TEST(TremblingStrokes, AreFairAllAlong) {
  constexpr std::uint32_t kColumns = 900;
  const auto opened = OpenedMesh::open(test::grid(kColumns, 40));
  SurfaceCurve drawn;
  std::uint32_t y = 20;
  const auto go = [&](std::uint32_t x) {
    drawn.points.push_back(
        SurfacePoint::at_vertex(opened->surface(), VertexId{y * (kColumns + 1) + x}));
  };
  go(2);
  std::uint64_t random = 42;
  for (std::uint32_t x = 3; x + 1 < kColumns; ++x) {
    go(x);
    random = random * 48271 % 2147483647;
    const auto by = static_cast<std::int64_t>(random % 5) - 2;
    const auto to = static_cast<std::uint32_t>(std::clamp<std::int64_t>(y + by, 11, 29));
    while (y != to) {
      y += to > y ? 1 : -1;
      go(x);
    }
  }
  ASSERT_EQ(drawn.points.size(), 1879U);
  const SmoothingResult result = smooth_curve(opened, drawn);
  EXPECT_TRUE(result.report().warnings.empty());
  EXPECT_LT(result.report().after.bending, 0.02 * result.report().before.bending);
  EXPECT_LT(result.report().deviation_to_drawn_max, 1.6 * result.report().slack);
  EXPECT_TRUE(self_contacts(opened->surface(), result.curves).empty());
}

}  // namespace
}  // namespace talweg
