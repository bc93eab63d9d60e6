#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/core/repair/vertex_welding.hpp"
#include "talweg/core/repair/weld_hint.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

/// Two plates of 10 x 10 beside each other. Vertices 1 and 2 of the first lie at vertices 4 and 7
/// of the second, but for a gap along x and along y.
MeshLists plates(double gap, double offset = 0) {
  MeshLists lists;
  const double x = offset + 10;
  lists.points = {{offset, 0, 0},  {x, 0, 0},      {x, 10, 0},      {offset, 10, 0},
                  {x + gap, 0, 0}, {x + 10, 0, 0}, {x + 10, 10, 0}, {x, 10 - gap, 0}};
  lists.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  return lists;
}

TEST(WeldTolerance, ASeamIsFoundMeasuredAndNamed) {
  const MeshLists lists = plates(1e-6);
  const MeshInspection before = inspect(lists);
  EXPECT_EQ(before.duplicate_positions.count, 0U);
  const NearVertices near = near_vertices(lists, before);
  EXPECT_EQ(near.count, 4U);
  EXPECT_NEAR(near.largest_gap, 1e-6, 1e-14);
  EXPECT_DOUBLE_EQ(near.tolerance, 1e-6);
  const auto welded = try_weld(lists, before);
  ASSERT_TRUE(welded);
  EXPECT_EQ(welded->steps, "weld=1e-06");
  EXPECT_EQ(weld_sentence(before, *welded),
            "4 vertices lie within 1e-06 of others: with repair=weld=1e-06 the mesh has 1 part "
            "instead of 2 and 1 boundary loop instead of 2 boundary loops.");
}

TEST(WeldTolerance, TheSeamIsClosedAndEveryMoveIsTold) {
  const MeshLists lists = plates(1e-6);
  EXPECT_EQ(inspect(repair(lists, repair_steps("weld")).lists).components, 2U);
  const RepairedMesh mesh = repair_to_surface(lists, repair_steps("weld=1e-6"));
  EXPECT_EQ(inspect(mesh.lists).components, 1U);
  EXPECT_EQ(mesh.lists.triangles,
            (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {1, 5, 6}, {1, 6, 2}}));
  EXPECT_EQ(mesh.changes.welded_vertices.count, 2U);
  EXPECT_NEAR(mesh.changes.weld_distance, 1e-6, 1e-14);
  EXPECT_EQ(mesh.changes.held_apart, 0U);
  EXPECT_EQ(sentences(mesh.changes),
            (std::vector<std::string>{"Repair: 2 vertices were welded onto others, over at most "
                                      "1e-06 mesh units (vertex 4 as 1, 7 as 2)."}));
  // A gap that is wider than the tolerance stays.
  EXPECT_EQ(repair(lists, repair_steps("weld=9e-7")).changes.welded_vertices.count, 0U);
}

TEST(WeldTolerance, SeamsBeyondRoundingOfLargeCoordinates) {
  const MeshLists lists = plates(1e-13, 40);  // coordinates of 50
  const MeshInspection before = inspect(lists);
  EXPECT_EQ(near_vertices(lists, before).count, 4U);
  EXPECT_GE(near_vertices(lists, before).tolerance, 0.9e-13);
  const auto welded = try_weld(lists, before);
  ASSERT_TRUE(welded);
  EXPECT_EQ(welded->after.components, 1U);
  EXPECT_EQ(inspect(repair(lists, repair_steps(welded->steps)).lists).components, 1U);
  // No near vertices in a mesh without nearly coincident vertices.
  EXPECT_EQ(near_vertices(grid(4, 3), inspect(grid(4, 3))).count, 0U);
  const MeshLists apart = plates(0.5);
  EXPECT_EQ(near_vertices(apart, inspect(apart)).count, 0U);
  EXPECT_EQ(weld_hint(apart), "");
}

TEST(WeldTolerance, EndsOfAnEdgeAreNeverJoined) {
  // Edges are 1 long or more, and the tolerance is wider than all of the mesh.
  const MeshLists sheet = grid(4, 3);
  const RepairedMesh same = repair(sheet, repair_steps("weld=100"));
  EXPECT_EQ(same.lists.triangles, sheet.triangles);
  EXPECT_EQ(same.changes.welded_vertices.count, 0U);
  EXPECT_EQ(same.changes.held_apart, sheet.points.size());
  ASSERT_EQ(sentences(same.changes).size(), 1U);
  EXPECT_NE(sentences(same.changes)[0].find("stay apart"), std::string::npos);
  // A chain of three gaps of about 1/3 leads from one end of an edge of length 1 to the other.
  MeshLists chain;
  chain.points = {{0, 0, 0},     {1, 0, 0},    {0.5, 10, 0},  {0.34, 0, 0}, {0, -10, 0},
                  {0.3, -10, 0}, {0.67, 0, 0}, {0.6, -20, 0}, {0.9, -20, 0}};
  chain.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  for (Point& p : chain.points) p.y() *= 10;
  const RepairedMesh apart = repair(chain, repair_steps("weld=0.35"));
  EXPECT_EQ(apart.lists.triangles, chain.triangles);
  EXPECT_GE(apart.changes.held_apart, 4U);
}

TEST(WeldTolerance, FacesThatLoseTheirAreaAreTold) {
  MeshLists lists;  // vertex 0 lies below the tip of the thin face
  lists.points = {{0.5, 0, 0}, {0.8, -1, 0}, {0.2, -1, 0}, {0, 0, 0}, {1, 0, 0}, {0.5, 1e-4, 0}};
  lists.triangles = {{0, 2, 1}, {3, 4, 5}};
  const RepairedMesh mesh = repair(lists, repair_steps("weld=1e-3"));
  EXPECT_EQ(mesh.changes.welded_vertices.count, 1U);
  EXPECT_EQ(mesh.changes.flattened_faces.count, 1U);
  EXPECT_NEAR(mesh.changes.weld_distance, 1e-4, 1e-15);
}

/// The groups of welding as sets of positions.
std::set<std::set<std::vector<double>>> groups_of(const MeshLists& lists, double tolerance) {
  const Welding welding = weld_vertices(lists, tolerance);
  std::vector<std::set<std::vector<double>>> of(lists.points.size());
  for (std::size_t v = 0; v < of.size(); ++v) {
    const Point& p = lists.points[v];
    of[welding.onto[v]].insert({p.x(), p.y(), p.z()});
  }
  return {of.begin(), of.end()};
}

TEST(WeldTolerance, GroupsDoNotDependOnTheOrder) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.02, 0.02);
  MeshLists soup;  // corners of one place up to 0.07 apart, of faces whose edges are 1 or more
  const MeshLists sheet = grid(6, 6);
  for (const Triangle& t : sheet.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t v : t) {
      soup.points.push_back(sheet.points[v] + Point(shift(random), shift(random), shift(random)));
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const auto groups = groups_of(soup, 0.03);
  std::vector<std::uint32_t> to(soup.points.size());
  std::iota(to.begin(), to.end(), 0U);
  for (int round = 0; round < 5; ++round) {
    std::shuffle(to.begin(), to.end(), random);
    MeshLists other = soup;
    for (std::size_t v = 0; v < to.size(); ++v) other.points[to[v]] = soup.points[v];
    for (Triangle& t : other.triangles) t = {to[t[0]], to[t[1]], to[t[2]]};
    std::shuffle(other.triangles.begin(), other.triangles.end(), random);
    EXPECT_EQ(groups_of(other, 0.03), groups);
  }
  // With a tolerance for all corners of a place, the result is one sheet.
  const RepairedMesh mesh = repair(soup, repair_steps("weld=0.07"));
  EXPECT_EQ(mesh.changes.welded_vertices.count, soup.points.size() - sheet.points.size());
  EXPECT_LT(mesh.changes.weld_distance, 0.07);
  EXPECT_EQ(inspect(mesh.lists).components, 1U);
}

TEST(WeldTolerance, IsReadFromTheListOfSteps) {
  RepairSteps steps = repair_steps("drop,weld=1e-4");
  EXPECT_EQ(steps, (RepairSteps{true, true, false, false, 1e-4}));
  steps = repair_steps("weld=2,all");
  EXPECT_EQ(steps, (RepairSteps{true, true, true, true, 2}));
  for (const char* list : {"weld=", "weld=-1", "weld=0", "weld=nan", "weld=inf", "weld=1mm"}) {
    try {
      repair_steps(list);
      FAIL() << list;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadUsage);
      EXPECT_NE(std::string(error.what()).find("length above 0 in mesh units"), std::string::npos);
    }
  }
  EXPECT_THROW(repair_steps("drop=1"), Error);
}

}  // namespace
}  // namespace talweg::test
