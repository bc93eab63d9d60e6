#include "talweg/core/mesh/mesh_inspection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/reference_data.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

struct Shape {
  std::size_t vertices, edges, faces, components, loops;
  std::int64_t genus;
};

void expect_shape(const MeshLists& lists, const Shape& expected) {
  const MeshInspection m = inspect(lists);
  EXPECT_EQ(m.vertices, expected.vertices);
  EXPECT_EQ(m.edges, expected.edges);
  EXPECT_EQ(m.faces, expected.faces);
  EXPECT_EQ(m.components, expected.components);
  EXPECT_EQ(m.boundary_loops, expected.loops);
  ASSERT_TRUE(m.genus.has_value());
  EXPECT_EQ(*m.genus, expected.genus);
  EXPECT_EQ(m.euler_characteristic, 2 * static_cast<std::int64_t>(expected.components) -
                                        static_cast<std::int64_t>(expected.loops) -
                                        2 * expected.genus);
  EXPECT_EQ(m.verdict, MeshVerdict::kUsable);
  EXPECT_EQ(obstacle(m), "");
}

TEST(MeshInspection, TopologyOfKnownShapes) {
  expect_shape(grid(3, 2), {12, 23, 12, 1, 1, 0});
  expect_shape(box(), {8, 18, 12, 1, 0, 0});
  expect_shape(sphere(2), {66, 192, 128, 1, 0, 0});
  expect_shape(tube(7, 4, 2), {28, 70, 42, 1, 2, 0});
  expect_shape(torus(6, 5), {30, 90, 60, 1, 0, 1});
  expect_shape(together(torus(6, 5), tube(7, 4, 2), 10), {58, 160, 102, 2, 2, 1});
}

TEST(MeshInspection, MeasuresOfABox) {
  MeshLists lists = box();
  for (Point& p : lists.points) p += Point(10, 0, 0);
  const MeshInspection m = inspect(lists);
  EXPECT_DOUBLE_EQ(m.edge_length_min, 1);
  EXPECT_DOUBLE_EQ(m.edge_length_max, std::sqrt(2.0));
  EXPECT_NEAR(m.edge_length_mean, (12 + 6 * std::sqrt(2.0)) / 18, 1e-14);
  EXPECT_NEAR(m.smallest_angle, std::numbers::pi / 4, 1e-15);
  EXPECT_EQ(m.box_min, (std::array<double, 3>{10, 0, 0}));
  EXPECT_EQ(m.box_max, (std::array<double, 3>{11, 1, 1}));
  EXPECT_DOUBLE_EQ(m.size, std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(m.offset, std::sqrt(10.5 * 10.5 + 0.5));
}

TEST(MeshInspection, EmptyLists) {
  EXPECT_EQ(inspect({}).verdict, MeshVerdict::kUnusable);
  EXPECT_EQ(inspect({}).reason, "The mesh has no vertices.");
  MeshLists cloud = grid(2, 2);
  cloud.triangles.clear();
  EXPECT_EQ(inspect(cloud).verdict, MeshVerdict::kUnusable);
  EXPECT_EQ(inspect(cloud).isolated_vertices.count, 9U);
}

TEST(MeshInspection, IndexOutOfRange) {
  const MeshInspection m = inspect(with_index_out_of_range(grid(3, 2), 4));
  EXPECT_EQ(m.indices_out_of_range.count, 1U);
  EXPECT_EQ(m.verdict, MeshVerdict::kUnusable);
  EXPECT_EQ(m.reason, "1 face refers to vertices that do not exist (face 4 to vertex 12 of 12).");
}

TEST(MeshInspection, NonFiniteCoordinates) {
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity(), 1e308, 1e41}) {
    const MeshInspection m =
        inspect(with_coordinate(with_coordinate(grid(3, 2), 7, value), 5, value));
    EXPECT_EQ(m.non_finite_vertices.count, 2U);
    EXPECT_EQ(m.verdict, MeshVerdict::kUnusable);
    const std::string largest = std::isfinite(value)
                                    ? (value > 1e300 ? "; the largest is 1e+308: scale the mesh"
                                                     : "; the largest is 1e+41: scale the mesh")
                                    : "";
    EXPECT_EQ(m.reason,
              "2 vertices have a coordinate that is not a finite number of at most 1e+40 (first: "
              "vertex 5" +
                  largest + ").");
    EXPECT_TRUE(std::isfinite(m.edge_length_mean));
    EXPECT_TRUE(std::isfinite(m.size));
  }
}

TEST(MeshInspection, RepeatedVertex) {
  const MeshInspection m = inspect(with_repeated_vertex(grid(3, 2)));
  EXPECT_EQ(m.repeated_vertex_faces.count, 1U);
  EXPECT_EQ(m.reason, "1 face uses a vertex twice (face 12).");
  EXPECT_EQ(m.verdict, MeshVerdict::kRepairable);
  EXPECT_EQ(m.edges, 23U);
}

TEST(MeshInspection, DuplicateFace) {
  for (const bool reversed : {false, true}) {
    const MeshInspection m = inspect(with_duplicate_face(grid(3, 2), 5, reversed));
    EXPECT_EQ(m.duplicate_faces.count, 1U);
    EXPECT_EQ(m.reason, "1 face repeats the vertices of another face (face 12 repeats face 5).");
    EXPECT_EQ(m.verdict, MeshVerdict::kRepairable);
  }
}

TEST(MeshInspection, NonManifoldEdge) {
  // Face 0 of the grid is (0, 1, 5); its side (0, 5) is inner: a fin there is the third face.
  MeshLists lists = grid(3, 2);
  std::rotate(lists.triangles[0].begin(), lists.triangles[0].begin() + 2, lists.triangles[0].end());
  const MeshInspection m = inspect(with_fin(lists, 0));
  EXPECT_EQ(m.non_manifold_edges.count, 1U);
  EXPECT_EQ(m.reason,
            "1 edge has more than two faces (between vertices 0 and 5, faces 0, 1 and 12).");
  EXPECT_FALSE(m.genus.has_value());
}

TEST(MeshInspection, TurnedFace) {
  const MeshInspection m = inspect(with_turned_face(sphere(1), 3));
  EXPECT_EQ(m.misoriented_edges.count, 3U);
  EXPECT_TRUE(m.orientable);
  EXPECT_EQ(m.genus, 0);
  EXPECT_EQ(m.verdict, MeshVerdict::kRepairable);
}

TEST(MeshInspection, OneSidedStrip) {
  const MeshInspection m = inspect(moebius(9));
  EXPECT_EQ(m.boundary_loops, 1U);
  EXPECT_EQ(m.euler_characteristic, 0);
  EXPECT_EQ(m.misoriented_edges.count, 1U);
  EXPECT_FALSE(m.orientable);
  EXPECT_EQ(m.verdict, MeshVerdict::kUnusable);
}

/// Found by random runs: a mesh of size 1e-6 at 5,000,000 from the origin is welded to one point.
TEST(MeshInspection, AMeshWithoutExtentIsNotRepairable) {
  MeshLists lists = with_turned_face(box(), 3);
  for (Point& p : lists.points) p = 1e-12 * p + Point(5e6, 5e6, 5e6);
  const MeshInspection found = inspect(lists);
  EXPECT_EQ(found.verdict, MeshVerdict::kUnusable);
  EXPECT_NE(found.reason.find("All faces have zero area"), std::string::npos) << found.reason;
  EXPECT_NE(found.reason.find("first: between vertices"), std::string::npos) << found.reason;
  EXPECT_THROW(OpenedMesh::open(repair(lists).lists), Error);
}

TEST(MeshInspection, BowTie) {
  const MeshInspection m = inspect(with_bow_tie(grid(3, 2), 6));
  EXPECT_EQ(m.non_manifold_vertices.count, 1U);
  EXPECT_EQ(m.non_manifold_vertices.first.front(), 6U);
  EXPECT_EQ(m.components, 2U);
  EXPECT_EQ(m.isolated_vertices.count, 1U);
  EXPECT_EQ(m.verdict, MeshVerdict::kRepairable);
}

TEST(MeshInspection, OdditiesAreUsable) {
  const MeshInspection flat = inspect(with_zero_area_face(grid(3, 2), 0));
  EXPECT_EQ(flat.zero_area_faces.count, 1U);
  EXPECT_EQ(flat.zero_area_faces.first.front(), 12U);
  EXPECT_NEAR(flat.smallest_angle, std::numbers::pi / 4, 1e-15);
  EXPECT_EQ(flat.verdict, MeshVerdict::kUsable);

  const double height = 0.5 * std::tan(0.5 * std::numbers::pi / 180);
  const MeshInspection needle = inspect(with_needle(grid(3, 2), 0, Point(0, -height, 0)));
  EXPECT_EQ(needle.needle_faces.count, 1U);
  EXPECT_EQ(needle.zero_area_faces.count, 0U);
  EXPECT_NEAR(needle.smallest_angle, 0.5 * std::numbers::pi / 180, 1e-14);
  EXPECT_EQ(needle.verdict, MeshVerdict::kUsable);

  const MeshInspection twin = inspect(together(grid(3, 2), grid(3, 2), 3));
  EXPECT_EQ(twin.duplicate_positions.count, 3U);
  EXPECT_EQ(twin.verdict, MeshVerdict::kUsable);

  const MeshInspection alone = inspect(with_isolated_vertices(grid(3, 2), 8));
  EXPECT_EQ(alone.isolated_vertices.count, 8U);
  EXPECT_EQ(alone.isolated_vertices.first.size(), Defect<std::uint32_t>::kPlaces);
  EXPECT_EQ(alone.euler_characteristic, 1);
  EXPECT_EQ(alone.verdict, MeshVerdict::kUsable);
}

// The verdict and the reason are those of opening and of repairing the mesh.
TEST(MeshInspection, TooSmallAndTooLargeMeshesAreNotUsable) {
  for (const double unit : {1e-200, 1e-80, 1e-41, 1e-39, 1e39, 1e41, 1e80}) {
    MeshLists lists = sphere(2);
    for (Point& p : lists.points) p *= unit;
    const MeshInspection m = inspect(lists);
    const bool fits = unit > 1e-40 && unit < 1e40;
    EXPECT_EQ(m.verdict == MeshVerdict::kUsable, fits) << unit << ": " << m.reason;
    EXPECT_EQ(out_of_range(lists), fits ? "" : m.reason);
    try {
      SurfaceMesh::open(lists);
      EXPECT_TRUE(fits) << unit;
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), m.reason);
    }
    try {
      repair(lists);
      EXPECT_TRUE(fits) << unit;
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), m.reason);
    }
  }
}

TEST(MeshInspection, UnitsChangeNothing) {
  for (const double unit : {1e-200, 1e-8, 1e8, 1e39}) {
    MeshLists lists = with_needle(with_zero_area_face(sphere(1), 0), 0, Point(0, 0, 1e-4));
    const MeshInspection before = inspect(lists);
    for (Point& p : lists.points) p *= unit;
    const MeshInspection after = inspect(lists);
    EXPECT_EQ(after.zero_area_faces.count, before.zero_area_faces.count);
    EXPECT_EQ(after.needle_faces.count, before.needle_faces.count);
    EXPECT_NEAR(after.smallest_angle, before.smallest_angle, 1e-12);
    EXPECT_NEAR(after.edge_length_mean / unit, before.edge_length_mean, 1e-12);
  }
}

/// The values of each mesh in the collection's table: faces, vertices, components, loops, genus or
/// -1, misoriented edges, edges with more than two faces, bow-ties, duplicate positions, isolated
/// vertices, faces below 1 degree.
struct Listed {
  const char* file;
  std::size_t faces, vertices, components, loops;
  std::int64_t genus;
  std::size_t misoriented, non_manifold, bow_ties, duplicates, isolated, needles;
};

TEST(MeshInspection, RealMeshes) {
  const std::filesystem::path folder = test::mesh_folder();
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << test::missing("real meshes");
  const Listed table[] = {
      {"elephant_106holes_tiny_4k.ply", 4463, 2798, 1, 106, 3, 0, 0, 0, 65, 0, 0},
      {"teeth_bowtie_10k.ply", 10493, 5325, 20, 5, -1, 0, 0, 40, 0, 0, 2},
      {"degenerate_13k.ply", 13477, 7068, 8, 3, 8, 0, 0, 0, 3, 0, 15},
      {"aneurysm_14k.ply", 14186, 7095, 1, 0, 0, 0, 0, 0, 0, 0, 0},
      {"fandisk_14k.ply", 14454, 7229, 1, 0, 0, 0, 0, 0, 0, 0, 0},
      {"cylinder_varying_16k.ply", 16442, 8285, 1, 1, 0, 0, 0, 0, 0, 0, 3},
      {"terrain_utm_21k.ply", 21186, 10800, 1, 1, 0, 0, 0, 0, 0, 0, 0},
      {"misoriented_25k.ply", 24685, 12577, 1, 6, 0, 23889, 0, 0, 0, 0, 0},
      {"sword_quads_22k.off", 44582, 22293, 1, 0, 0, 0, 0, 0, 0, 0, 0},
      {"bunny_isolated_69k.ply", 69451, 35947, 1, 5, 0, 0, 0, 0, 0, 1113, 1},
      {"armadillo_86k.ply", 86482, 43243, 1, 0, 0, 0, 0, 0, 0, 0, 0},
      {"skull_100k.ply", 100002, 49999, 1, 0, 2, 0, 0, 0, 0, 0, 34},
      {"tooth_ct_119k.ply", 118576, 59294, 1, 1, 0, 0, 0, 0, 0, 0, 1500},
      {"brain_icbm_164k.ply", 163840, 81924, 2, 0, 0, 0, 0, 0, 0, 0, 0},
      {"car_nonmanifold_251k.ply", 250962, 125446, 1, 0, -1, 0, 33, 0, 0, 0, 0},
      {"buildings_needles_400k.ply", 400020, 200062, 26, 0, 0, 3, 0, 0, 27, 0, 21061},
      {"skull_mri_585k.ply", 585426, 293490, 1, 17, 219, 0, 0, 0, 0, 0, 1014},
      {"mouse_skull_984k.ply", 984128, 491612, 1, 0, 227, 0, 0, 0, 0, 0, 11524}};
  for (const Listed& row : table) {
    SCOPED_TRACE(row.file);
    const MeshInspection m = inspect(read_mesh(folder / row.file));
    EXPECT_EQ(m.faces, row.faces);
    EXPECT_EQ(m.vertices, row.vertices);
    EXPECT_EQ(m.components, row.components);
    EXPECT_EQ(m.boundary_loops, row.loops);
    EXPECT_EQ(m.genus.value_or(-1), row.genus);
    EXPECT_EQ(m.misoriented_edges.count, row.misoriented);
    EXPECT_EQ(m.non_manifold_edges.count, row.non_manifold);
    EXPECT_EQ(m.non_manifold_vertices.count, row.bow_ties);
    EXPECT_EQ(m.duplicate_positions.count, row.duplicates);
    EXPECT_EQ(m.isolated_vertices.count, row.isolated);
    EXPECT_EQ(m.needle_faces.count, row.needles);
    EXPECT_EQ(m.indices_out_of_range.count + m.non_finite_vertices.count +
                  m.repeated_vertex_faces.count + m.duplicate_faces.count,
              0U);
    const bool clean = row.misoriented + row.non_manifold + row.bow_ties == 0;
    EXPECT_EQ(m.verdict, clean ? MeshVerdict::kUsable : MeshVerdict::kRepairable);
  }
}

}  // namespace
}  // namespace talweg::test
