#include "tools/scenes/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "tools/scenes/isosurface.hpp"
#include "tools/scenes/noise.hpp"
#include "tools/scenes/patients.hpp"
#include "tools/scenes/ply_writer.hpp"
#include "tools/scenes/relaxation.hpp"

namespace talweg::scenes {
namespace {

std::size_t boundary_edges(const Surface& surface) {
  std::size_t count = 0;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    count += surface.on_boundary(EdgeId{e}) ? 1U : 0U;
  }
  return count;
}

// Six times the volume inside a closed mesh; positive if the normals point outwards.
double signed_volume(const MeshLists& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.points[a].dot(mesh.points[b].cross(mesh.points[c]));
  }
  return sum / 6;
}

Surface surface_of(const MeshLists& mesh) {
  return Surface::from_triangles(mesh.points.size(), mesh.triangles);
}

const std::vector<DemoScene>& scenes() {
  static const std::vector<DemoScene> all = demo_scenes();
  return all;
}

// Expects a mesh that is manifold and oriented (Surface refuses others), in one piece, without
// slivers.
void expect_clean(const MeshLists& mesh) {
  const Surface surface = surface_of(mesh);
  EXPECT_EQ(components_of(surface).count, 1U);
  double worst = 1;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point u = mesh.points[b] - mesh.points[a], v = mesh.points[c] - mesh.points[a];
    const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
    worst = std::min(worst, u.cross(v).norm() / longest);
  }
  EXPECT_GT(worst, 0.01);
}

TEST(Isosurface, ABallIsClosedAndHasTheVolumeOfTheBall) {
  const Field ball = [](const Point& p) { return p.norm() - 1; };
  MeshLists mesh = isosurface(ball, Point::Constant(-1.3), Point::Constant(1.3), 0.08);
  relax(mesh, ball, 0.08, 3);
  expect_clean(mesh);
  const Surface surface = surface_of(mesh);
  EXPECT_EQ(boundary_edges(surface), 0U);
  EXPECT_EQ(mesh.points.size() + mesh.triangles.size() - surface.edge_count(), 2U);  // Euler
  // A chord of length h lies at most h²/8 below the sphere, so the volume lacks at most 3 h²/8.
  const double volume = signed_volume(mesh), full = 4 * std::acos(-1.0) / 3;
  EXPECT_LT(volume, full);
  EXPECT_GT(volume, full * (1 - 0.08 * 0.08));
  for (const Point& p : mesh.points) EXPECT_NEAR(p.norm(), 1, 1e-4);
}

TEST(Isosurface, TheSurfaceIsOpenAtTheBox) {
  const Field rod = [](const Point& p) { return std::hypot(p.x(), p.y()) - 0.5; };
  const MeshLists mesh = isosurface(rod, Point::Constant(-1), Point::Constant(1), 0.1);
  expect_clean(mesh);
  const Surface surface = surface_of(mesh);
  EXPECT_GT(boundary_edges(surface), 0U);
  EXPECT_EQ(mesh.points.size() + mesh.triangles.size(), surface.edge_count());  // an annulus
}

TEST(Noise, IsZeroAtIntegersAndContinuous) {
  EXPECT_EQ(noise({3, -2, 7}, 5), 0);
  EXPECT_NEAR(noise({2 - 1e-9, 0.3, 0.4}, 5), noise({2 + 1e-9, 0.3, 0.4}, 5), 1e-7);
  EXPECT_NE(noise({0.5, 0.5, 0.5}, 5), noise({0.5, 0.5, 0.5}, 6));
}

// One test, since making the scenes takes most of its time.
TEST(Scenes, MeshesAreCleanAndOfTheStatedTopology) {
  ASSERT_EQ(scenes().size(), 3U);
  EXPECT_EQ(scenes()[0].name, "vessel");
  EXPECT_EQ(scenes()[1].name, "figure");
  EXPECT_EQ(scenes()[2].name, "terrain");
  for (const DemoScene& scene : scenes()) {
    SCOPED_TRACE(scene.name);
    for (const Point& p : scene.mesh.points) ASSERT_TRUE(p.allFinite());
    expect_clean(scene.mesh);
    EXPECT_GE(scene.mesh.triangles.size(), 30000U);
    EXPECT_LE(scene.mesh.triangles.size(), 90000U);
    // Only the figure is closed.
    EXPECT_EQ(boundary_edges(surface_of(scene.mesh)) == 0, scene.name == "figure");

    const std::vector<std::uint32_t>& ids = scene.through.vertices;
    EXPECT_GE(ids.size(), 10U);
    EXPECT_EQ(std::set<std::uint32_t>(ids.begin(), ids.end()).size(), ids.size());
    for (const std::uint32_t v : ids) EXPECT_LT(v, scene.mesh.points.size());
    EXPECT_EQ(scene.through.closed, scene.name == "vessel");
  }
  EXPECT_GT(signed_volume(scenes()[1].mesh), 0);  // its normals point outwards
}

TEST(Scenes, TerrainIsAHeightFieldThatFacesUp) {
  const MeshLists mesh = terrain_scene().mesh;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point u = mesh.points[b] - mesh.points[a], v = mesh.points[c] - mesh.points[a];
    ASSERT_GT(u.cross(v).z(), 0);
  }
}

TEST(Scenes, ScenesAreReproducibleBitForBit) {
  const std::vector<DemoScene> again = demo_scenes();
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_TRUE(ply_bytes(again[i].mesh) == ply_bytes(scenes()[i].mesh)) << again[i].name;
    EXPECT_EQ(draw_arguments(again[i].through), draw_arguments(scenes()[i].through));
  }
}

TEST(Waypoints, TextsAreArgumentsOfTheDriver) {
  EXPECT_EQ(draw_arguments({{3, 1, 2}, false}), "--through 3,1,2 --points rough");
  EXPECT_EQ(draw_arguments({{3, 1, 2}, true}), "--through 3,1,2 --closed --points rough");
}

TEST(Waypoints, AcrossStaysOnTheLargestComponent) {
  MeshLists mesh = terrain_scene().mesh;  // an island in front of the terrain
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {{-9e4, 0, 0}, {-8e4, 0, 0}, {-9e4, 1e4, 0}});
  mesh.triangles.push_back({first, first + 1, first + 2});
  const Waypoints across = waypoints_across(mesh);
  EXPECT_GE(across.vertices.size(), 10U);
  EXPECT_FALSE(across.closed);
  for (const std::uint32_t v : across.vertices) EXPECT_LT(v, first);
  // The ends are far apart: more than half of the terrain's side.
  EXPECT_GT((mesh.points[across.vertices.front()] - mesh.points[across.vertices.back()]).norm(),
            5000);
  EXPECT_EQ(waypoints_across(mesh).vertices, across.vertices);
}

TEST(Waypoints, AMeshTooSmallForACurveIsAnError) {
  EXPECT_THROW(waypoints_across(MeshLists{}), Error);
  MeshLists mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_THROW(waypoints_across(mesh), Error);
}

TEST(GalleryScenes, AreCleanAndHaveCurvesOrParcels) {
  const std::vector<DemoScene> all = gallery_scenes();
  ASSERT_EQ(all.size(), 4U);
  for (const DemoScene& scene : all) {
    SCOPED_TRACE(scene.name);
    expect_clean(scene.mesh);
    EXPECT_EQ(scene.through.vertices.empty(), scene.name == "cortex");
  }
  const MeshLists& cortex = all[2].mesh;
  EXPECT_EQ(boundary_edges(surface_of(cortex)), 0U);
  EXPECT_GT(signed_volume(cortex), 0);
  const std::vector<int> labels = cortex_parcels(cortex);
  ASSERT_EQ(labels.size(), cortex.triangles.size());
  EXPECT_GE(std::set<int>(labels.begin(), labels.end()).size(), 20U);
  // The terrain's border runs from one side of the sheet to the other.
  const DemoScene& terrain = all[3];
  const Surface sheet = surface_of(terrain.mesh);
  EXPECT_TRUE(sheet.on_boundary(VertexId{terrain.through.vertices.front()}));
  EXPECT_TRUE(sheet.on_boundary(VertexId{terrain.through.vertices.back()}));
  EXPECT_FALSE(terrain.through.closed);
}

TEST(Patients, HaveVesselsOfTenSizesEachOfItsOwnShape) {
  const Patients patients;
  for (std::size_t i = 0; i < 10; ++i) {
    const DemoScene scene = patients.scene(i);
    const double wanted = 5000.0 * static_cast<double>(i + 1);
    EXPECT_NEAR(static_cast<double>(scene.mesh.triangles.size()), wanted, 0.1 * wanted) << i;
    EXPECT_EQ(components_of(surface_of(scene.mesh)).count, 1U)
        << i;  // refuses what is not a surface
    EXPECT_TRUE(scene.through.closed);
    EXPECT_GE(scene.through.vertices.size(), 3U);
  }
  const DemoScene one = patients.scene(3), other = patients.scene(13);
  EXPECT_EQ(one.mesh.triangles, other.mesh.triangles);
  EXPECT_NE(one.mesh.points, other.mesh.points);
  EXPECT_NE(one.through.vertices, other.through.vertices);
  EXPECT_EQ(one.mesh.points, patients.scene(3).mesh.points);
  EXPECT_EQ(other.name, "vessel00013");
}

}  // namespace
}  // namespace talweg::scenes
