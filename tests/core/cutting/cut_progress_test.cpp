// Cutting reports its progress, can be cancelled at any question, and makes no needless copies.
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/mesh_numbers.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/drawing/straight_lines.hpp"

namespace talweg {
namespace {

/// A sheet of 200 x 200 squares, and a line through its faces.
struct CutProgress : ::testing::Test {
  static constexpr std::size_t kAll = SIZE_MAX;

  /// Cuts, and answers `yes` questions with yes, then with no.
  CutMesh cut(std::size_t yes) {
    fractions.clear();
    return cut_along(mesh, {&curve, 1}, {}, [&](const char* stage, double fraction) {
      EXPECT_EQ(std::string(stage), "cut");
      fractions.push_back(fraction);
      return fractions.size() <= yes;
    });
  }

  SurfaceMesh mesh = SurfaceMesh::open(test::grid(200, 200));
  SurfaceCurve curve =
      StraightLines(mesh.surface())
          .join(std::vector<SurfacePoint>{test::between(mesh.surface(), 0, 1, 0.3),
                                          test::between(mesh.surface(), 40399, 40400, 0.6)},
                false);
  std::vector<double> fractions;  // of the last cut
};

TEST_F(CutProgress, RisesFrom0To1AndChangesNothing) {
  const CutMesh told = cut(kAll), untold = cut_along(mesh, {&curve, 1});
  ASSERT_GT(fractions.size(), 4U);
  EXPECT_EQ(fractions.front(), 0);
  EXPECT_EQ(fractions.back(), 1);
  for (std::size_t k = 1; k < fractions.size(); ++k) EXPECT_LE(fractions[k - 1], fractions[k]);
  EXPECT_EQ(told.lists.triangles, untold.lists.triangles);
  EXPECT_EQ(told.lists.points, untold.lists.points);
  EXPECT_EQ(told.vertex_from, untold.vertex_from);
}

TEST_F(CutProgress, IsCancelledAtAnyQuestion) {
  cut(kAll);
  const std::size_t all = fractions.size();
  for (std::size_t yes = 0; yes < all; ++yes) {
    EXPECT_THROW(cut(yes), Cancelled);
    EXPECT_EQ(fractions.size(), yes + 1);  // no question follows
  }
}

/// Moving the lists gives the same parts as copying them, also with attributes at corners.
TEST_F(CutProgress, PartsOfTheListsThatWereTakenAreTheSame) {
  MeshAttributes attributes;
  attributes.vertices.push_back({"x", NumberType::kFloat64, {}});
  for (const Point& p : mesh.points()) attributes.vertices[0].values.push_back(p.x());
  attributes.texture.dimension = 2;
  for (std::uint32_t f = 0; f < mesh.surface().face_count(); ++f) {
    attributes.texture.corners.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    for (int k = 0; k < 6; ++k) attributes.texture.values.push_back(f + 0.1 * k);
  }
  PartOptions open, split;
  open.open = true;
  split.split = true;
  for (const PartOptions& options : {PartOptions{}, open, split}) {
    CutMesh cut = cut_along(mesh, {&curve, 1});
    const Point* const points = cut.lists.points.data();
    const MeshParts copied = take_apart(mesh, std::as_const(cut), attributes, options);
    const MeshParts taken = take_apart(mesh, std::move(cut), attributes, options);
    ASSERT_EQ(taken.parts.size(), copied.parts.size());
    for (std::size_t k = 0; k < taken.parts.size(); ++k) {
      const MeshPart &a = taken.parts[k], &b = copied.parts[k];
      EXPECT_EQ(a.lists.points, b.lists.points);
      EXPECT_EQ(a.lists.triangles, b.lists.triangles);
      EXPECT_EQ(a.vertices, b.vertices);
      EXPECT_EQ(a.faces, b.faces);
      EXPECT_EQ(a.attributes.vertices[0].values, b.attributes.vertices[0].values);
      EXPECT_EQ(a.attributes.texture.values, b.attributes.texture.values);
      EXPECT_EQ(a.attributes.texture.corners, b.attributes.texture.corners);
    }
    if (!options.opens()) {
      EXPECT_EQ(taken.parts[0].lists.points.data(), points);
    }
  }
}

}  // namespace
}  // namespace talweg
