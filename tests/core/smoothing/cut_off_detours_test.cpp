#include "talweg/core/smoothing/cut_off_detours.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kDetourColumns = 60;

class CutOffDetours : public testing::Test {
 protected:
  [[nodiscard]] static VertexId at(std::uint32_t column, std::uint32_t row) {
    return VertexId{row * (kDetourColumns + 1) + column};
  }
  [[nodiscard]] SurfaceCurve through(const std::vector<VertexId>& ways, bool closed = false) const {
    return test::vertex_curve(surface, draw_edge_path(surface, ways, closed), closed);
  }
  void expect_soundness(const SurfaceCurve& curve) const {
    const std::size_t n = curve.points.size();
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
      EXPECT_TRUE(common_face(surface, curve.points[i], curve.points[(i + 1) % n]).valid()) << i;
      EXPECT_FALSE(curve.points[i] == curve.points[(i + 1) % n]) << i;
    }
  }
  [[nodiscard]] static bool has(const SurfaceCurve& curve, const SurfacePoint& point) {
    return std::find(curve.points.begin(), curve.points.end(), point) != curve.points.end();
  }

  /// Put back beyond one distance everywhere.
  [[nodiscard]] WithDetours beyond(double far, const SurfaceCurve& straight,
                                   const SurfaceCurve& drawn) const {
    return with_detours(mesh, straight, drawn, std::vector<double>(drawn.points.size(), far));
  }

  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(kDetourColumns, 30));
  const SurfaceMesh& mesh = opened->mesh();
  const Surface& surface = opened->surface();
  const SurfaceCurve taut = through({at(2, 12), at(58, 12)});
  const SurfaceCurve spike =
      through({at(2, 12), at(29, 12), at(29, 22), at(30, 22), at(30, 12), at(58, 12)});
};

TEST_F(CutOffDetours, ArePutBackWhereTheyAreDeepEnough) {
  const WithDetours found = beyond(3, taut, spike);
  EXPECT_EQ(found.stretches, 1U);
  expect_soundness(found.curve);
  EXPECT_TRUE(has(found.curve, SurfacePoint::at_vertex(surface, at(29, 22))));
  EXPECT_NEAR(curve_length(surface, found.curve), curve_length(surface, spike), 2);
  EXPECT_EQ(found.curve.points.front(), taut.points.front());
  EXPECT_EQ(found.curve.points.back(), taut.points.back());
  const WithDetours none = beyond(10.5, taut, spike);
  EXPECT_EQ(none.stretches, 0U);
  EXPECT_EQ(none.curve.points, taut.points);
}

TEST_F(CutOffDetours, OneForEach) {
  const SurfaceCurve two = through({at(2, 12), at(15, 12), at(15, 22), at(16, 22), at(16, 12),
                                    at(40, 12), at(40, 2), at(41, 2), at(41, 12), at(58, 12)});
  const WithDetours found = beyond(3, taut, two);
  EXPECT_EQ(found.stretches, 2U);
  expect_soundness(found.curve);
  EXPECT_NEAR(curve_length(surface, found.curve), curve_length(surface, two), 4);
}

TEST_F(CutOffDetours, OfALoopWhereverItBegins) {
  const SurfaceCurve square = through({at(10, 5), at(50, 5), at(50, 25), at(10, 25)}, true);
  SurfaceCurve drawn = through(
      {at(10, 5), at(30, 5), at(30, 15), at(31, 15), at(31, 5), at(50, 5), at(50, 25), at(10, 25)},
      true);
  for (const std::size_t first : {0, 25, 60}) {  // the second one is on the detour
    SurfaceCurve turned = drawn;
    std::rotate(turned.points.begin(), turned.points.begin() + static_cast<std::ptrdiff_t>(first),
                turned.points.end());
    const WithDetours found = beyond(3, square, turned);
    EXPECT_EQ(found.stretches, 1U) << first << " " << turned.points.size();
    EXPECT_TRUE(found.curve.closed);
    expect_soundness(found.curve);
    EXPECT_NEAR(curve_length(surface, found.curve), curve_length(surface, drawn), 2) << first;
  }
}

TEST_F(CutOffDetours, NothingIsPutBackFromElsewhere) {
  const SurfaceCurve elsewhere = through({at(2, 25), at(58, 25)});
  EXPECT_EQ(beyond(3, taut, elsewhere).stretches, 0U);
  const SurfaceCurve ring = through({at(10, 5), at(20, 5), at(20, 9), at(10, 9)}, true);
  const SurfaceCurve other = through({at(40, 15), at(50, 15), at(50, 25), at(40, 25)}, true);
  EXPECT_EQ(beyond(3, ring, other).stretches, 0U);
}

}  // namespace
}  // namespace talweg
