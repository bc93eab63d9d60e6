// The topology of the pieces that curves leave.
#include "talweg/core/cutting/cut_topology.hpp"

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"

namespace talweg {
namespace {

using Characteristics = std::vector<std::int64_t>;

SurfaceCurve through(const SurfaceMesh& mesh, std::initializer_list<std::uint32_t> vertices,
                     bool closed) {
  return test::vertex_curve(mesh.surface(), test::ids(vertices), closed);
}

TEST(CutTopology, ALoopOnASphereLeavesTwoDiscsAndAnOpenCurveASphere) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::sphere(3));
  const auto points = test::circle({0, 0, 0.2}, {1, 0, 0}, {0, 1, 0}, 12);
  const SurfaceCurve ring = test::drawn_near(mesh, points, true);
  EXPECT_EQ(pieces_along(mesh, std::span(&ring, 1), false), (Characteristics{1, 1}));
  const SurfaceCurve arc = test::drawn_near(mesh, std::span(points).first(4), false);
  // A slit opens a disc out of the sphere.
  EXPECT_EQ(pieces_along(mesh, std::span(&arc, 1), false), (Characteristics{1}));
}

TEST(CutTopology, AMeridianOpensATorusAndACollapsedOneDoesNot) {
  const std::uint32_t columns = 12, rows = 16;
  const SurfaceMesh mesh = SurfaceMesh::open(test::torus(columns, rows));
  const VertexId centre{5 * columns + 5};
  SurfaceCurve small{true, {}};
  HalfedgeId h = mesh.surface().halfedge(centre);
  do {
    small.points.push_back(SurfacePoint::at_vertex(mesh.surface(), mesh.surface().head(h)));
    h = mesh.surface().turn_ccw(h);
  } while (h != mesh.surface().halfedge(centre));
  EXPECT_EQ(pieces_along(mesh, std::span(&small, 1), false), (Characteristics{-1, 1}));

  std::vector<VertexId> way;
  for (std::uint32_t c = 0; c < columns; ++c) way.emplace_back(3 * columns + c);
  const SurfaceCurve meridian = test::vertex_curve(mesh.surface(), way, true);
  EXPECT_EQ(pieces_along(mesh, std::span(&meridian, 1), false), (Characteristics{0}));
}

TEST(CutTopology, SpikesDoNotCountWhereTheyAreLeftOut) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(8, 8));  // 9 vertices a row
  const SurfaceCurve plain = through(mesh, {20, 21, 22, 31, 40, 39, 38, 29}, true);
  const SurfaceCurve spiked = through(mesh, {20, 21, 22, 23, 24, 23, 22, 31, 40, 39, 38, 29}, true);
  const Characteristics ring_and_disc{0, 1};
  EXPECT_EQ(pieces_along(mesh, std::span(&plain, 1), false), ring_and_disc);
  EXPECT_EQ(pieces_along(mesh, std::span(&plain, 1), true), ring_and_disc);
  EXPECT_EQ(pieces_along(mesh, std::span(&spiked, 1), true), ring_and_disc);
  // Begun on the spike.
  const SurfaceCurve begun = through(mesh, {24, 23, 22, 31, 40, 39, 38, 29, 20, 21, 22, 23}, true);
  EXPECT_EQ(pieces_along(mesh, std::span(&begun, 1), true), ring_and_disc);
}

}  // namespace
}  // namespace talweg
