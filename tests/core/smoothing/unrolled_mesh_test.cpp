// The unrolled mesh has a sheet for each turn of a drawing.
#include "talweg/core/smoothing/unrolled_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg::unrolled_mesh_test {
namespace {

using namespace test;

constexpr double kPi = std::numbers::pi;

// The strip can be closed where the drawing begins, unless the drawing enters and leaves a face
// there across one edge.
TEST(UnrolledMesh, WhereverTheDrawingBeginsNoTurnIsLost) {
  const MeshLists lists = tube(48, 60, 8);
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const SurfaceCurve drawn = straight_through(mesh, twice_around(), true);
  const double whole = curve_length(mesh.surface(), drawn);
  for (std::size_t start = 0; start < drawn.points.size(); start += 16) {
    SurfaceCurve turned = drawn;
    std::rotate(turned.points.begin(), turned.points.begin() + static_cast<std::ptrdiff_t>(start),
                turned.points.end());
    const UnrolledMesh strip = unroll(mesh, std::span(&turned, 1), {true}, 2);
    // The result must not be a whole copy of the mesh, on which the turns coincide.
    EXPECT_NE(strip.face_of.size(), lists.triangles.size()) << start;
    const SurfaceMesh laid = SurfaceMesh::open(strip.lists);
    const std::vector<SurfaceCurve> there =
        strip.unrolled(mesh, laid.surface(), std::span(&turned, 1));
    EXPECT_NEAR(curve_length(laid.surface(), there.front()), whole, 1e-9 * whole) << start;
  }
}

/// A plate of cubes of size 1 whose middle of every three by three is missing, so that it has as
/// many handles as holes; `size` must be a multiple of 3. The vertices of the upper side come
/// first.
MeshLists plate_with_holes(std::uint32_t size) {
  MeshLists lists;
  const std::uint32_t columns = size + 1, upper = columns * columns;
  for (const double z : {1.0, 0.0}) {
    for (std::uint32_t v = 0; v < upper; ++v)
      lists.points.emplace_back(v % columns, v / columns, z);
  }
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    lists.triangles.push_back({a, b, c});
    lists.triangles.push_back({a, c, d});
  };
  const auto is_there = [&](std::uint32_t x, std::uint32_t y) {  // also where x or y is -1
    return x < size && y < size && !(x % 3 == 1 && y % 3 == 1);
  };
  const auto wall = [&](std::uint32_t a, std::uint32_t b) { quad(b, a, a + upper, b + upper); };
  for (std::uint32_t y = 0; y < size; ++y) {
    for (std::uint32_t x = 0; x < size; ++x) {
      if (!is_there(x, y)) continue;
      const std::uint32_t a = y * columns + x, b = a + 1, c = b + columns, d = a + columns;
      quad(a, b, c, d);
      quad(d + upper, c + upper, b + upper, a + upper);
      if (!is_there(x, y - 1)) wall(a, b);
      if (!is_there(x + 1, y)) wall(b, c);
      if (!is_there(x, y + 1)) wall(c, d);
      if (!is_there(x - 1, y)) wall(d, a);
    }
  }
  return lists;
}

// The two ways around a handle meet at one copy of a face, not at two copies.
TEST(UnrolledMesh, HandlesAreLaidOutOnce) {
  const MeshLists lists = plate_with_holes(36);
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  ASSERT_EQ(2 * mesh.surface().edge_count(), 3 * lists.triangles.size());  // a closed mesh
  const SurfaceCurve drawn = vertex_curve(
      mesh.surface(), along_grid(37, {{{3, 9}, {30, 9}, {30, 30}, {18, 30}, {18, 3}}}), false);
  const UnrolledMesh strip = unroll(mesh, std::span(&drawn, 1), {true}, 5);
  EXPECT_GT(strip.faces_of_strips, lists.triangles.size() / 2);
  EXPECT_LT(strip.faces_of_strips, 3 * lists.triangles.size() / 2);
}

}  // namespace
}  // namespace talweg::unrolled_mesh_test
