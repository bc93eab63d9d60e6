#include "talweg/core/drawing/capping.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/reference_data.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::grid;
using test::ids;
using test::surface_of_lists;

/// Whether some inner vertex and its two neighbours are the corners of a triangle.
bool has_corner(const Surface& surface, const std::vector<VertexId>& path, bool closed) {
  const std::size_t n = path.size();
  for (std::size_t i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i) {
    std::vector<VertexId> three{path[(i + n - 1) % n], path[i], path[(i + 1) % n]};
    std::sort(three.begin(), three.end());
    for (std::size_t f = 0; f < surface.face_count(); ++f) {
      auto corners = surface.corners(FaceId{f});
      std::sort(corners.begin(), corners.end());
      if (std::equal(three.begin(), three.end(), corners.begin())) return true;
    }
  }
  return false;
}

TEST(Capping, ReplacesTwoSidesOfATriangleByTheThird) {
  const Surface surface = surface_of_lists(grid(2, 2));
  auto path = ids({0, 1, 4});
  EXPECT_EQ(cap_corners(surface, path, false), 1U);
  EXPECT_EQ(path, ids({0, 4}));
  // 1, 0, 3 is a corner of a square, not of a triangle.
  path = ids({1, 0, 3});
  EXPECT_EQ(cap_corners(surface, path, false), 0U);
  EXPECT_EQ(path, ids({1, 0, 3}));
}

TEST(Capping, RepeatsUntilNoCornerIsLeft) {
  // About vertex 0 of a hexagon everything can be capped down to one edge only through it.
  const Surface surface = surface_of_lists(grid(4, 4));
  auto path = ids({0, 1, 6, 7, 12, 13, 18});
  EXPECT_EQ(cap_corners(surface, path, false), 3U);
  EXPECT_EQ(path, ids({0, 6, 12, 18}));
  EXPECT_FALSE(has_corner(surface, path, false));
  // A cap can make a corner at the previous vertex: 5, 0, 1, 6 becomes 5, 0, 6 and then 5, 6.
  path = ids({5, 0, 1, 6});
  EXPECT_EQ(cap_corners(surface, path, false), 2U);
  EXPECT_EQ(path, ids({5, 6}));
}

TEST(Capping, LeavesPinnedVerticesAndEnds) {
  const Surface surface = surface_of_lists(grid(4, 4));
  auto path = ids({0, 1, 6, 7, 12});
  EXPECT_EQ(cap_corners(surface, path, false, ids({7})), 1U);
  EXPECT_EQ(path, ids({0, 6, 7, 12}));
}

TEST(Capping, ClosedPathsAreCappedAcrossTheirStart) {
  const Surface surface = surface_of_lists(grid(4, 4));
  // A square with one corner cut off. 1 is the corner of triangle 0, 1, 6, at the end of the list.
  const auto loop = ids({1, 6, 12, 17, 16, 15, 10, 5, 0});
  for (std::size_t turn = 0; turn < loop.size(); ++turn) {
    auto path = loop;
    std::rotate(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(turn), path.end());
    EXPECT_GT(cap_corners(surface, path, true), 0U) << turn;
    EXPECT_FALSE(has_corner(surface, path, true)) << turn;
    EXPECT_GE(path.size(), 3U);
  }
}

TEST(Capping, ClosedPathsKeepThreeVertices) {
  const Surface surface = surface_of_lists(grid(2, 2));
  auto path = ids({0, 1, 4});
  EXPECT_EQ(cap_corners(surface, path, true), 0U);
  path = ids({0, 1, 4, 3});
  EXPECT_EQ(cap_corners(surface, path, true), 1U);
  EXPECT_EQ(path.size(), 3U);
}

TEST(Capping, ShortAndUnknownPaths) {
  const Surface surface = surface_of_lists(grid(2, 2));
  for (auto path : {ids({}), ids({4}), ids({4, 5})}) {
    EXPECT_EQ(cap_corners(surface, path, false), 0U);
    EXPECT_EQ(cap_corners(surface, path, true), 0U);
  }
  auto path = ids({0, 99, 1});
  EXPECT_THROW(cap_corners(surface, path, false), Error);
}

TEST(Capping, LeavesNoCornerOfADrawing) {
  const Surface surface = surface_of_lists(test::sphere(3));
  for (const bool closed : {false, true}) {
    auto path = draw_edge_path(surface, ids({0, 20, 40, 3, 60}), closed);
    const auto ends = std::pair(path.front(), path.back());
    const std::size_t before = path.size();
    const std::size_t capped = cap_corners(surface, path, closed);
    EXPECT_EQ(before - capped, path.size());
    EXPECT_FALSE(has_corner(surface, path, closed));
    if (!closed) {
      EXPECT_EQ(std::pair(path.front(), path.back()), ends);
    }
    EXPECT_EQ(cap_corners(surface, path, closed), 0U);
  }
}

TEST(Capping, FindsNothingOnTheReferenceCurves) {
  for (const char* name : {"fandisk_14k", "aneurysm_14k", "armadillo_86k"}) {
    const auto reference = test::reference_curve(name);
    if (!reference) GTEST_SKIP() << test::missing(name);
    auto path = reference->path;
    EXPECT_EQ(cap_corners(reference->mesh.surface(), path, reference->closed), 0U) << name;
  }
}

}  // namespace
}  // namespace talweg
