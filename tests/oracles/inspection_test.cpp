// Inspection and repair against CGAL's Polygon_mesh_processing, on meshes with planted defects and
// on real meshes. If the two programs define a defect differently, only the common case is compared
// (docs/development/testing.md).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/boost/graph/helpers.h>
#include <gtest/gtest.h>

#include "core/reference_data.hpp"
#include "polygon_soup.hpp"
#include "stress/planted_defects.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/core/space/face_shape.hpp"

namespace talweg {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using test::Soup;

bool is_manifold(const MeshInspection& found) {
  return !found.non_manifold_edges.found() && !found.non_manifold_vertices.found();
}

/// The number of the connected part of each face, and the number of parts.
std::pair<std::vector<std::size_t>, std::size_t> parts_of(Soup::Mesh& mesh) {
  auto part = mesh.add_property_map<Soup::Mesh::Face_index, std::size_t>("f:part").first;
  const std::size_t count = pmp::connected_components(mesh, part);
  std::vector<std::size_t> of_face;
  for (const auto f : mesh.faces()) of_face.push_back(part[f]);
  return {of_face, count};
}

/// Compares the counts on a manifold with consistent orientation.
void compare_surface(const MeshInspection& ours, Soup::Mesh mesh) {
  pmp::remove_isolated_vertices(mesh);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  std::vector<Soup::Mesh::Halfedge_index> singular;
  pmp::non_manifold_vertices(mesh, std::back_inserter(singular));
  EXPECT_TRUE(singular.empty());
  EXPECT_EQ(ours.components, parts_of(mesh).second);
  std::vector<Soup::Mesh::Halfedge_index> loops;
  pmp::extract_boundary_cycles(mesh, std::back_inserter(loops));
  EXPECT_EQ(ours.boundary_loops, loops.size());
  const auto boundary = std::count_if(mesh.edges().begin(), mesh.edges().end(),
                                      [&](const auto e) { return mesh.is_border(e); });
  EXPECT_EQ(ours.boundary_edges, static_cast<std::size_t>(boundary));
  EXPECT_EQ(ours.boundary_edges == 0, CGAL::is_closed(mesh));
  EXPECT_EQ(ours.edges, mesh.number_of_edges());
  const std::int64_t euler = static_cast<std::int64_t>(mesh.number_of_vertices()) -
                             static_cast<std::int64_t>(mesh.number_of_edges()) +
                             static_cast<std::int64_t>(mesh.number_of_faces());
  EXPECT_EQ(ours.euler_characteristic, euler);
  if (ours.non_finite_vertices.found() || mesh.number_of_edges() == 0) return;
  double least = std::numeric_limits<double>::infinity(), most = 0, sum = 0;
  for (const auto e : mesh.edges()) {
    const double length = pmp::edge_length(mesh.halfedge(e), mesh);
    least = std::min(least, length);
    most = std::max(most, length);
    sum += length;
  }
  EXPECT_NEAR(ours.edge_length_min, least, 1e-12 * least);
  EXPECT_NEAR(ours.edge_length_max, most, 1e-12 * most);
  const double mean = sum / static_cast<double>(mesh.number_of_edges());
  EXPECT_NEAR(ours.edge_length_mean, mean, 1e-10 * mean);
}

/// Compares counts of defects in lists that need not be a surface.
void compare_defects(const MeshLists& lists, const MeshInspection& ours) {
  Soup soup(lists);
  EXPECT_EQ(is_manifold(ours) && !ours.misoriented_edges.found(), soup.is_mesh());
  // CGAL compares positions. Duplicate faces are defined by vertex numbers, so the numbers are
  // passed as positions.
  std::vector<Soup::Kernel::Point_3> numbers;
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    numbers.emplace_back(static_cast<double>(v), 0, 0);
  }
  auto polygons = soup.polygons;
  EXPECT_EQ(ours.duplicate_faces.count,
            pmp::merge_duplicate_polygons_in_polygon_soup(numbers, polygons));
  if (!ours.non_finite_vertices.found()) {
    auto points = soup.points;
    polygons = soup.polygons;
    EXPECT_EQ(ours.duplicate_positions.count,
              pmp::merge_duplicate_points_in_polygon_soup(points, polygons));
  }
  if (!ours.indices_out_of_range.found()) {
    auto points = soup.points;
    std::vector<std::vector<std::size_t>> all;
    for (const Triangle& t : lists.triangles) all.emplace_back(t.begin(), t.end());
    EXPECT_EQ(ours.isolated_vertices.count,
              pmp::remove_isolated_points_in_polygon_soup(points, all));
  }
}

/// Compares faces without area. All faces of exactly zero area must be found, and besides only
/// faces within rounding of zero area.
std::size_t compare_flat_faces(const MeshLists& lists, const MeshInspection& ours) {
  if (ours.non_finite_vertices.found()) return 0;
  const Soup soup(lists);
  std::size_t flat = 0, exactly = 0;
  for (const Soup::Polygon& t : soup.polygons) {
    const bool collinear = CGAL::collinear(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
    const bool is_flat =
        shape_of({lists.points[t[0]], lists.points[t[1]], lists.points[t[2]]}).flat;
    EXPECT_TRUE(!collinear || is_flat) << t[0] << ' ' << t[1] << ' ' << t[2];
    flat += is_flat ? 1 : 0;
    exactly += collinear ? 1 : 0;
  }
  EXPECT_EQ(ours.zero_area_faces.count, flat);
  return flat - exactly;
}

/// Compares reversed faces. CGAL orients a part like its first face, Talweg reverses the fewer
/// faces, so the relative orientation of the faces of a part must agree.
void compare_turned(const RepairedMesh& repaired, const Soup& soup, const Soup::Oriented& theirs) {
  auto mesh = soup.mesh();
  const auto [part, count] = parts_of(mesh);
  std::vector<int> other_way(count, -1);
  for (std::size_t i = 0; i < soup.polygons.size(); ++i) {
    const auto& image = repaired.map.image(FaceId{soup.face[i]});
    ASSERT_NE(image.face, RepairMap::kDropped);
    const bool turned = image.corner[1] == 2;
    const int differs = turned != theirs.turned[i] ? 1 : 0;
    int& known = other_way[part[i]];
    if (known < 0) known = differs;
    EXPECT_EQ(known, differs) << "face " << soup.face[i];
  }
}

/// Compares orientation and splitting. At an edge of more than two faces CGAL separates all faces
/// and Talweg keeps pairs joined; a one-sided surface becomes two-sided with a slit in CGAL. These
/// cases are not compared.
void compare_orientation(const MeshLists& lists, const MeshInspection& ours) {
  Soup soup(lists);
  const Soup::Oriented theirs = soup.orient();
  EXPECT_EQ(ours.non_manifold_edges.count, theirs.crowded_edges.size());
  EXPECT_EQ(is_manifold(ours) && ours.orientable, theirs.succeeded);
  EXPECT_TRUE(soup.is_mesh());
  if (ours.non_manifold_edges.found() || !ours.orientable) return;
  EXPECT_EQ(ours.non_manifold_vertices.count, theirs.singular_vertices.size());
  for (const std::uint32_t v : ours.non_manifold_vertices.first) {
    EXPECT_TRUE(theirs.singular_vertices.contains(v)) << "vertex " << v;
  }
  if (soup.polygons.empty() || ours.indices_out_of_range.found() ||
      ours.non_finite_vertices.found()) {
    return;
  }
  const RepairedMesh repaired = repair(lists, {.weld = false, .drop = false});
  compare_turned(repaired, soup, theirs);
  EXPECT_EQ(repaired.changes.split_vertices.count, theirs.singular_vertices.size());
  EXPECT_EQ(repaired.lists.points.size(), soup.points.size());
  compare_surface(inspect(repaired.lists), soup.mesh());
}

/// A repaired mesh with the verdict usable must be a mesh for CGAL, with the same numbers of parts
/// and loops. The mesh must have faces left that name three different vertices.
void compare_repaired(const MeshLists& lists, const MeshInspection& ours) {
  if (ours.indices_out_of_range.found() || ours.non_finite_vertices.found() ||
      lists.triangles.empty()) {
    return;
  }
  const RepairedMesh repaired = repair(lists);
  const MeshInspection after = inspect(repaired.lists);
  if (after.verdict != MeshVerdict::kUsable) return;
  const Soup soup(repaired.lists);
  EXPECT_TRUE(soup.is_mesh());
  EXPECT_EQ(soup.polygons.size(), repaired.lists.triangles.size());
  if (soup.is_mesh()) compare_surface(after, soup.mesh());
}

/// Compares welding of vertices at equal positions. Welding within the tolerance is not compared.
void compare_welding(const MeshLists& lists, const MeshInspection& ours) {
  if (ours.indices_out_of_range.found() || ours.non_finite_vertices.found() ||
      lists.triangles.empty()) {
    return;
  }
  const RepairedMesh repaired =
      repair(lists, {.weld = true, .drop = false, .orient = false, .split = false});
  if (repaired.changes.weld_distance > 0) return;
  Soup soup(lists);
  const auto before = soup.polygons;
  pmp::merge_duplicate_points_in_polygon_soup(soup.points, soup.polygons);
  ASSERT_EQ(before.size(), soup.polygons.size());
  std::map<std::size_t, std::uint32_t> ours_of_theirs;
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto vertex = repaired.lists.triangles[soup.face[i]][k];
      const auto [known, added] = ours_of_theirs.try_emplace(soup.polygons[i][k], vertex);
      EXPECT_EQ(known->second, vertex) << "vertex " << before[i][k];
    }
  }
  std::set<std::uint32_t> different;
  for (const auto& [theirs, vertex] : ours_of_theirs) different.insert(vertex);
  EXPECT_EQ(different.size(), ours_of_theirs.size()) << "more was welded";
}

/// Compares everything. Returns the number of faces that are flat for Talweg but have an exact
/// area.
std::size_t compare(const MeshLists& lists) {
  const MeshInspection ours = inspect(lists);
  compare_defects(lists, ours);
  const std::size_t nearly = compare_flat_faces(lists, ours);
  compare_orientation(lists, ours);
  compare_welding(lists, ours);
  compare_repaired(lists, ours);
  const Soup soup(lists);
  if (soup.is_mesh()) compare_surface(ours, soup.mesh());
  return nearly;
}

TEST(InspectionOracle, AgreesOnPlantedDefects) {
  constexpr std::uint64_t kSeeds = 600;
  std::map<std::string, int> planted;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    stress::Random random(seed);
    MeshLists lists = stress::random_mesh(random);
    const std::string names = stress::plant_some(lists, random);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + names);
    compare(lists);
    ++planted[names.substr(0, names.find(','))];
    if (HasFailure()) return;
  }
  std::printf("  %d meshes, %zu kinds of first defects\n", static_cast<int>(kSeeds),
              planted.size());
  EXPECT_GE(planted.size(), stress::defects().size());
}

class InspectionOfReal : public ::testing::TestWithParam<const char*> {};

TEST_P(InspectionOfReal, Agrees) {
  const auto file = test::mesh_folder() / GetParam();
  if (!std::filesystem::exists(file)) GTEST_SKIP() << test::missing(GetParam());
  const MeshLists lists = read_mesh(file);
  const std::size_t nearly = compare(lists);
  std::printf("  %zu faces; flat within rounding, but not exactly: %zu\n", lists.triangles.size(),
              nearly);
}

INSTANTIATE_TEST_SUITE_P(All, InspectionOfReal,
                         ::testing::Values("aneurysm_14k.ply", "armadillo_86k.ply",
                                           "brain_icbm_164k.ply", "buildings_needles_400k.ply",
                                           "bunny_isolated_69k.ply", "car_nonmanifold_251k.ply",
                                           "cylinder_varying_16k.ply", "degenerate_13k.ply",
                                           "elephant_106holes_tiny_4k.ply", "fandisk_14k.ply",
                                           "misoriented_25k.ply", "mouse_skull_984k.ply",
                                           "skull_100k.ply", "skull_mri_585k.ply",
                                           "sword_quads_22k.off", "teeth_bowtie_10k.ply",
                                           "terrain_utm_21k.ply", "tooth_ct_119k.ply"),
                         [](const auto& one) {
                           const std::string name = one.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace talweg
