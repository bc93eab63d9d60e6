#include "talweg/core/cutting/part_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/mesh_numbers.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg::test {
namespace {

/// 3 x 3 squares of size 1 as quads; vertex 4 y + x lies at (x, y). Vertex 5 is `height` above.
MeshLists quads(double height = 0) {
  std::string text = "OFF\n16 9 0\n";
  for (int v = 0; v < 16; ++v) {
    text += fmt::format("{} {} {}\n", v % 4, v / 4, v == 5 ? height : 0.0);
  }
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      const int v = 4 * y + x;
      text += fmt::format("4 {} {} {} {}\n", v, v + 1, v + 5, v + 4);
    }
  }
  return read_mesh("quads.off", text);
}

/// The quads cut from one point of an edge to another.
struct CutQuads {
  CutQuads(const MeshLists& lists, const std::vector<SurfacePoint>& ends) : file(lists) {
    const SurfaceMesh mesh = SurfaceMesh::open(file);
    StraightLines lines(mesh.surface());
    const SurfaceCurve curve = lines.join(ends, false);
    const CutMesh cut = cut_along(mesh, {&curve, 1});
    part = take_apart(mesh, cut, {}, {}).parts.at(0);
    faces = polygons_of(part, origins_of(part, cut, mesh.surface()), file.polygons);
  }
  [[nodiscard]] std::vector<std::size_t> corners() const {
    std::vector<std::size_t> all;
    for (std::size_t f = 0; f < faces.size(); ++f) all.push_back(faces.face(f).size());
    std::sort(all.begin(), all.end());
    return all;
  }
  /// The faces after writing and reading.
  [[nodiscard]] MeshLists back(const std::string& name) const {
    return read_mesh(name, mesh_bytes(name, part.lists, {}, {}, &faces).bytes);
  }

  MeshLists file;
  MeshPart part;
  FaceOutlines faces;
};

/// Across the middle column, from the middle of the lowest edge to that of the highest.
std::vector<SurfacePoint> across(const MeshLists& lists) {
  const Surface& surface = surface_of_lists(lists);
  return {between(surface, 1, 2, 0.5), between(surface, 13, 14, 0.5)};
}

TEST(PartPolygons, WholePolygonsStayAndPlanePolygonsAreCutIntoPolygons) {
  const MeshLists file = quads();
  const CutQuads cut(file, across(file));
  // Six quads are whole. The halves of the three others have one more corner, on the diagonal, and
  // those at the curve's ends another at the end.
  EXPECT_EQ(cut.corners(), (std::vector<std::size_t>{4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5}));
  for (const char* name : {"a.off", "a.obj", "a.ply"}) {
    const MeshLists back = cut.back(name);
    EXPECT_EQ(back.polygon_count, 12U);
    EXPECT_EQ(back.polygon_shapes.concave, 0U);
    EXPECT_EQ(back.points.size(), 16U + 7U);
    EXPECT_NEAR(area(back), 9, 1e-14);
    // A whole quad begins at the same corner as in the file.
    EXPECT_EQ(back.triangles[0], file.triangles[0]);
    EXPECT_EQ(back.triangles[1], file.triangles[1]);
  }
}

TEST(PartPolygons, PolygonsThatAreNotPlaneAreCutIntoTriangles) {
  const MeshLists file = quads(0.3);
  const CutQuads cut(file, across(file));
  EXPECT_EQ(file.polygon_shapes.not_plane, 4U);
  // Two of these quads are cut. Each becomes six triangles: the curve divides both of its triangles
  // into three.
  const std::vector<std::size_t> corners = cut.corners();
  EXPECT_EQ(std::count(corners.begin(), corners.end(), 4U), 6);
  EXPECT_EQ(std::count(corners.begin(), corners.end(), 5U), 2);
  EXPECT_EQ(std::count(corners.begin(), corners.end(), 3U), 12);
  EXPECT_NEAR(area(cut.back("a.ply")), area(cut.part.lists), 1e-13);
}

TEST(PartPolygons, AroundTheEndOfACurveAreTriangles) {
  const MeshLists file = quads();
  const Surface& surface = surface_of_lists(file);
  // From the lowest edge into the diagonal of the quad above it.
  const CutQuads cut(file, {between(surface, 1, 2, 0.5), between(surface, 1, 6, 0.5)});
  const std::vector<std::size_t> corners = cut.corners();
  EXPECT_EQ(std::count(corners.begin(), corners.end(), 4U), 8);
  EXPECT_EQ(std::count(corners.begin(), corners.end(), 3U),
            static_cast<std::ptrdiff_t>(corners.size()) - 8);
  EXPECT_NEAR(area(cut.back("a.obj")), 9, 1e-14);
}

TEST(PartPolygons, LongListsOfPlyAreReadBack) {
  MeshLists ring;
  std::vector<PolygonCorner> all;
  constexpr std::uint32_t kCorners = 300;
  for (std::uint32_t v = 0; v < kCorners; ++v) {
    const double angle = 2 * 3.141592653589793 * v / kCorners;
    ring.points.push_back({std::cos(angle), std::sin(angle), 0});
    if (v >= 2) ring.triangles.push_back({0, v - 1, v});
  }
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t f = 0; f < ring.triangles.size(); ++f) triangles.push_back(f);
  FaceOutlines faces;
  for (std::uint32_t v = 0; v < 2; ++v) all.push_back({0, v});
  for (std::uint32_t f = 0; f < ring.triangles.size(); ++f) all.push_back({f, 2});
  faces.add(all);
  const MeshLists back = read_mesh("a.ply", mesh_bytes("a.ply", ring, {}, {}, &faces).bytes);
  EXPECT_EQ(back.polygon_count, 1U);
  EXPECT_EQ(back.triangles, ring.triangles);
  EXPECT_THROW(mesh_bytes("a.stl", ring, {}, {}, &faces), Error);
  faces.corners[0].triangle = 400;
  EXPECT_THROW(mesh_bytes("a.ply", ring, {}, {}, &faces), Error);
}

}  // namespace
}  // namespace talweg::test
