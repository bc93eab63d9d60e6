// Curves are led past saddle vertices, also across the first point of a loop.
#include "talweg/core/fairing/saddle_passing.hpp"

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

class SaddlePassingTest : public testing::Test {
 protected:
  static constexpr std::uint32_t columns = 9;
  /// A grid with vertices lifted at random: about half of the vertices are saddles.
  static MeshLists rough_grid(unsigned seed) {
    MeshLists lists = test::grid(columns - 1, columns - 1);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> height(-0.7, 0.7);
    for (Point& point : lists.points) point.z() = height(random);
    return lists;
  }
  /// The vertices around a square, beginning at any of them.
  static std::vector<VertexId> ring(std::size_t start) {
    std::vector<VertexId> ring;
    const auto add = [&](std::uint32_t x, std::uint32_t y) { ring.emplace_back(y * columns + x); };
    for (std::uint32_t k = 2; k < 6; ++k) add(k, 2);
    for (std::uint32_t k = 2; k < 6; ++k) add(6, k);
    for (std::uint32_t k = 6; k > 2; --k) add(k, 6);
    for (std::uint32_t k = 6; k > 2; --k) add(2, k);
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(start), ring.end());
    return ring;
  }
  static std::vector<KeptPoint> points_at(const Surface& surface,
                                          const std::vector<VertexId>& vertices) {
    std::vector<KeptPoint> points;
    for (const VertexId v : vertices) points.push_back({SurfacePoint::at_vertex(surface, v)});
    return points;
  }
};

TEST_F(SaddlePassingTest, EachPointAndTheNextShareAFaceWhereverALoopBegins) {
  std::size_t moved = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    const auto opened = OpenedMesh::open(rough_grid(seed));
    const Surface& surface = opened->mesh().surface();
    SaddlePassing passing(surface);
    for (std::size_t start = 0; start < 16; ++start) {
      const SurfaceCurve curve = passing.moved_off_saddles(points_at(surface, ring(start)), true);
      const std::size_t n = curve.points.size();
      for (std::size_t i = 0; i < n; ++i) {
        EXPECT_TRUE(common_face(surface, curve.points[i], curve.points[(i + 1) % n]).valid())
            << seed << ": " << start << ", " << i;
        moved += curve.points[i].is_vertex() ? 0 : 1;
      }
    }
  }
  EXPECT_GT(moved, 1000);
}

TEST_F(SaddlePassingTest, EndsAndPointsThatStayAreKept) {
  const auto opened = OpenedMesh::open(rough_grid(3));
  const Surface& surface = opened->mesh().surface();
  std::vector<KeptPoint> points = points_at(surface, ring(0));
  for (KeptPoint& point : points) point.stays = true;
  const SurfaceCurve loop = SaddlePassing(surface).moved_off_saddles(points, true);
  ASSERT_EQ(loop.points.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(loop.points[i], points[i].point);
  for (KeptPoint& point : points) point.stays = false;
  const SurfaceCurve open = SaddlePassing(surface).moved_off_saddles(points, false);
  EXPECT_EQ(open.points.front(), points.front().point);
  EXPECT_EQ(open.points.back(), points.back().point);
}

TEST_F(SaddlePassingTest, NoPointIsLostOfTheShortestCurves) {
  const auto opened = OpenedMesh::open(rough_grid(3));
  const Surface& surface = opened->mesh().surface();
  const std::vector<KeptPoint> one = points_at(surface, {VertexId{40}});
  EXPECT_EQ(SaddlePassing(surface).moved_off_saddles(one, true).points.size(), 1);
  EXPECT_EQ(SaddlePassing(surface).moved_off_saddles({}, false).points.size(), 0);
}

}  // namespace
}  // namespace talweg
