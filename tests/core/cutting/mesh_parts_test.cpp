#include "talweg/core/cutting/mesh_parts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/mesh_numbers.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using test::area;

/// A sheet of 4 x 4 squares, cut by a line between two edges and through a face; the left is above.
struct CutSheet {
  explicit CutSheet(const MeshLists& sheet = test::grid(4, 4)) : mesh(SurfaceMesh::open(sheet)) {
    StraightLines lines(mesh.surface());
    const std::vector<SurfacePoint> ends = {test::between(mesh.surface(), 5, 10, 0.25),
                                            test::between(mesh.surface(), 9, 14, 0.6)};
    curve = lines.join(ends, false);
    cut = cut_along(mesh, {&curve, 1});
    attributes.vertices.push_back({"quality", NumberType::kFloat64, {}});
    for (const Point& p : sheet.points) attributes.vertices[0].values.push_back(p.x() + 2 * p.y());
    attributes.left_out = {"a list"};
  }
  [[nodiscard]] MeshParts parts(const PartOptions& options = {}) const {
    return take_apart(mesh, cut, attributes, options);
  }

  SurfaceMesh mesh;
  SurfaceCurve curve;
  CutMesh cut;
  MeshAttributes attributes;
};

PartOptions kept_side(KeptSide side) {
  PartOptions options;
  options.keep = side;
  return options;
}
PartOptions split_parts() {
  PartOptions options;
  options.split = true;
  return options;
}

std::string refused_parts(const CutMesh& cut, const SurfaceMesh& mesh, const PartOptions& options) {
  try {
    take_apart(mesh, cut, {}, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
    return error.what();
  }
  return "none";
}

/// The origins give the positions of the part's vertices and faces, and the curves along its seam.
void expect_origins(const MeshPart& part, const PartOrigins& origins, const MeshLists& input) {
  ASSERT_EQ(origins.vertices.size(), part.lists.points.size());
  for (std::size_t v = 0; v < origins.vertices.size(); ++v) {
    const VertexOrigin& from = origins.vertices[v];
    Point at = Point::Zero();
    double all = 0;
    for (std::size_t k = 0; k < 3 && from.vertices[k] != kNoVertex; ++k) {
      at += from.weights[k] * input.points.at(from.vertices[k]);
      all += from.weights[k];
    }
    EXPECT_NEAR(all, 1, 1e-15);
    EXPECT_NEAR((at - part.lists.points[v]).norm(), 0, 1e-14) << v;
  }
  ASSERT_EQ(origins.faces.size(), part.lists.triangles.size());
  for (std::size_t f = 0; f < origins.faces.size(); ++f) {
    // The squares' halves: the middle of a piece is on the same side as that of the whole.
    const auto middle = [](const MeshLists& lists, std::size_t face) {
      Point sum = Point::Zero();
      for (const std::uint32_t v : lists.triangles.at(face)) sum += lists.points[v] / 3;
      return sum;
    };
    const Point whole = middle(input, origins.faces[f]), piece = middle(part.lists, f);
    EXPECT_EQ(std::floor(whole.x()), std::floor(piece.x()));
    EXPECT_EQ(std::floor(whole.y()), std::floor(piece.y()));
    const auto lower = [](const Point& p) {
      return p.x() - std::floor(p.x()) > p.y() - std::floor(p.y());
    };
    EXPECT_EQ(lower(whole), lower(piece)) << f;
  }
}

TEST(MeshParts, WithoutOptionsTheWholeCutMesh) {
  const CutSheet sheet;
  const MeshParts made = sheet.parts();
  ASSERT_EQ(made.parts.size(), 1U);
  EXPECT_EQ(made.pieces, 1U);
  EXPECT_EQ(made.parts[0].lists.triangles, sheet.cut.lists.triangles);
  EXPECT_EQ(made.left_out, std::vector<std::string>{"a list"});
  // A linear attribute stays linear.
  const auto& values = made.parts[0].attributes.vertices.at(0).values;
  ASSERT_EQ(values.size(), made.parts[0].lists.points.size());
  for (std::size_t v = 0; v < values.size(); ++v) {
    const Point& p = made.parts[0].lists.points[v];
    EXPECT_NEAR(values[v], p.x() + 2 * p.y(), 1e-12);
  }
}

TEST(MeshParts, SplittingGivesAPartForEachPiece) {
  const CutSheet sheet;
  const MeshParts made = sheet.parts(split_parts());
  ASSERT_EQ(made.parts.size(), 2U);
  EXPECT_EQ(made.pieces, 2U);
  EXPECT_NEAR(area(made.parts[0].lists) + area(made.parts[1].lists), 16, 1e-12);
  PartOptions open;
  open.open = true;
  const MeshParts opened = sheet.parts(open);
  ASSERT_EQ(opened.parts.size(), 1U);
  EXPECT_EQ(opened.pieces, 2U);
  EXPECT_EQ(opened.parts[0].lists.points.size(),
            made.parts[0].lists.points.size() + made.parts[1].lists.points.size());
}

TEST(MeshParts, KeepingASideGivesThePieceOnThatSide) {
  const CutSheet sheet;
  // From (0, 1.25) to (4, 1.6): 5.7 of the area of 16 is below, on the right.
  EXPECT_NEAR(area(sheet.parts(kept_side(KeptSide::kRight)).parts.at(0).lists), 5.7, 1e-12);
  EXPECT_NEAR(area(sheet.parts(kept_side(KeptSide::kLeft)).parts.at(0).lists), 10.3, 1e-12);
}

TEST(MeshParts, OriginsLeadBackToTheMesh) {
  const CutSheet sheet;
  const MeshLists input = test::grid(4, 4);
  const MeshParts made = sheet.parts(split_parts());
  for (const MeshPart& part : made.parts) {
    const PartOrigins origins = origins_of(part, sheet.cut, sheet.mesh.surface());
    expect_origins(part, origins, input);
    ASSERT_EQ(origins.curves.size(), 1U);
    EXPECT_FALSE(origins.curves[0].closed);
    ASSERT_EQ(origins.curves[0].vertices.size(), sheet.cut.chains[0].vertices.size());
    for (const auto& here : origins.curves[0].vertices) ASSERT_EQ(here.size(), 1U);
    const Point begin = part.lists.points[origins.curves[0].vertices.front()[0]];
    EXPECT_NEAR((begin - Point(0, 1.25, 0)).norm(), 0, 1e-15);
  }
}

TEST(MeshParts, WeightsOnEdgesAreFractions) {
  const CutSheet sheet;
  const PartOrigins origins = origins_of(sheet.parts().parts[0], sheet.cut, sheet.mesh.surface());
  const std::uint32_t begin = origins.curves.at(0).vertices.at(0).at(0);
  const VertexOrigin& from = origins.vertices[begin];
  const auto* edge = std::get_if<OnEdge>(&sheet.curve.points[0].where());
  ASSERT_NE(edge, nullptr);
  EXPECT_EQ(from.weights[1], edge->t);
  EXPECT_EQ(from.weights[0], 1 - edge->t);
  EXPECT_EQ(from.vertices[2], kNoVertex);
  EXPECT_EQ(origins.vertices[3].vertices[0], 3U);  // an old vertex keeps its number
  EXPECT_EQ(origins.vertices[3].vertices[1], kNoVertex);
}

TEST(MeshParts, OriginsAreInTheNumbersBeforeTheRepair) {
  MeshLists raw = test::grid(4, 4);
  const Triangle twice = raw.triangles[9];
  raw.triangles.insert(raw.triangles.begin() + 3, {twice[1], twice[2], twice[0]});
  const RepairedMesh repaired = repair(raw);
  ASSERT_EQ(repaired.lists.triangles.size(), raw.triangles.size() - 1);
  const CutSheet sheet(repaired.lists);
  for (const MeshPart& part : sheet.parts(split_parts()).parts) {
    expect_origins(part, origins_of(part, sheet.cut, sheet.mesh.surface(), &repaired.map), raw);
  }
}

TEST(MeshParts, FacesOfLidsHaveNoOrigin) {
  const SurfaceMesh tube = SurfaceMesh::open(test::tube(8, 4, 4));
  SurfaceCurve ring =
      test::vertex_curve(tube.surface(), test::ids({16, 17, 18, 19, 20, 21, 22, 23}), true);
  const CutMesh cut = cut_along(tube, {&ring, 1});
  PartOptions options = split_parts();
  options.lids = LidKind::kAuto;
  const MeshParts made = take_apart(tube, cut, {}, options);
  ASSERT_EQ(made.parts.size(), 2U);
  for (const MeshPart& part : made.parts) {
    EXPECT_EQ(part.lids.filled, 1U);
    const PartOrigins origins = origins_of(part, cut, tube.surface());
    EXPECT_EQ(std::count(origins.faces.begin(), origins.faces.end(), kNoFace), 6);  // of an octagon
    EXPECT_TRUE(origins.curves.at(0).closed);
  }
}

TEST(MeshParts, RefusesASideWithoutAPiece) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(4, 4));
  const SurfaceCurve slit = test::vertex_curve(mesh.surface(), test::ids({6, 7, 8}), false);
  EXPECT_EQ(refused_parts(cut_along(mesh, {&slit, 1}), mesh, kept_side(KeptSide::kLeft)),
            "Curve 0 does not separate the mesh: its start at (1, 1, 0) lies inside, 1 mesh unit "
            "from the border, and its end at (3, 1, 0) lies inside, 1 mesh unit from the border. "
            "Draw it from border to border, or as a loop. So there is no left side to keep.");
  const SurfaceCurve rim = test::vertex_curve(
      mesh.surface(), test::ids({0, 1, 2, 3, 4, 9, 14, 19, 24, 23, 22, 21, 20, 15, 10, 5}), true);
  EXPECT_EQ(refused_parts(cut_along(mesh, {&rim, 1}), mesh, kept_side(KeptSide::kRight)),
            "keep right leaves nothing: curve 0 has no face on the right.");
  const std::vector<SurfaceCurve> both = {rim, rim};
  EXPECT_EQ(refused_parts(cut_along(mesh, both), mesh, kept_side(KeptSide::kRight)),
            "keep right leaves nothing: none of the curves 0 to 1 has a face on the right.");
  // The piece between two lines is on the left of one and on the right of the other.
  const std::vector<SurfaceCurve> lines = {
      test::vertex_curve(mesh.surface(), test::ids({5, 6, 7, 8, 9}), false),
      test::vertex_curve(mesh.surface(), test::ids({15, 16, 17, 18, 19}), false)};
  const MeshParts above = take_apart(mesh, cut_along(mesh, lines), {}, kept_side(KeptSide::kLeft));
  EXPECT_EQ(above.pieces, 3U);
  EXPECT_EQ(above.between, 1U);
  EXPECT_NEAR(area(above.parts.at(0).lists), 4, 1e-12);
}

}  // namespace
}  // namespace talweg
