// Separation of a mesh by curves, the sentences about curves that do not separate, and the way from
// drawing to parts.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/mesh_numbers.hpp"
#include "core/reference_data.hpp"
#include "talweg/core/cutting/cut_report.hpp"
#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/core/mesh/border_points.hpp"
#include "talweg/core/strokes/border_ends.hpp"
#include "talweg/talweg.hpp"

namespace talweg::curve_separation_test {
namespace {

using test::area;

PartOptions split_apart() {
  PartOptions options;
  options.split = true;
  return options;
}

MeshParts parted(const SurfaceMesh& mesh, const std::vector<SurfaceCurve>& curves) {
  return take_apart(mesh, cut_along(mesh, curves), {}, split_apart());
}

SurfaceCurve through(const SurfaceMesh& mesh, std::initializer_list<std::uint32_t> vertices,
                     bool closed = false) {
  return test::vertex_curve(mesh.surface(), test::ids(vertices), closed);
}

/// A sheet of 6 x 6 squares without the four in its middle; vertex (i, j) is 7 j + i.
MeshLists disc_with_hole() {
  MeshLists lists = test::grid(6, 6);
  std::erase_if(lists.triangles, [&](const Triangle& t) {
    Point middle = Point::Zero();
    for (const std::uint32_t v : t) middle += lists.points[v] / 3;
    return std::abs(middle.x() - 3) < 1 && std::abs(middle.y() - 3) < 1;
  });
  return lists;
}

TEST(CurveSeparation, FromBorderToBorder) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(4, 4));
  const MeshParts made = parted(mesh, {through(mesh, {10, 11, 12, 13, 14})});
  EXPECT_EQ(made.pieces, 2U);
  EXPECT_EQ(made.separates, std::vector<bool>{true});
  EXPECT_TRUE(made.notes.empty());
}

TEST(CurveSeparation, IsNotAskedForWithoutSeams) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(4, 4));
  const std::vector<SurfaceCurve> slit = {through(mesh, {10, 11, 12})};
  const MeshParts made = take_apart(mesh, cut_along(mesh, slit), {}, {});
  EXPECT_TRUE(made.separates.empty());
  EXPECT_TRUE(made.notes.empty());
}

TEST(CurveSeparation, AnEndInside) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(8, 8));
  const MeshParts made = parted(mesh, {through(mesh, {36, 37, 38, 39})});  // to (3, 4)
  EXPECT_EQ(made.pieces, 1U);
  EXPECT_EQ(made.separates, std::vector<bool>{false});
  ASSERT_EQ(made.notes.size(), 1U);
  EXPECT_EQ(made.notes[0],
            "Curve 0 does not separate the mesh: its end at (3, 4, 0) lies inside, 3 mesh units "
            "from the border. Draw it from border to border, or as a loop.");
  const std::vector<ReportEntry> report =
      entries_of(mesh, cut_along(mesh, {}), made, {"Of reading."}, 0);
  const auto entry = [&](const std::string& key) {
    return std::find_if(report.begin(), report.end(),
                        [&](const ReportEntry& e) { return e.key == key; })
        ->value;
  };
  EXPECT_FALSE(std::get<bool>(entry("separates.0")));
  EXPECT_EQ(std::get<std::vector<std::string>>(entry("warnings")),
            (std::vector<std::string>{"Of reading.", made.notes[0]}));
}

TEST(CurveSeparation, AcrossATubeTwoAreNeeded) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::tube(8, 5, 3));
  const SurfaceCurve one = through(mesh, {0, 8, 16, 24, 32});
  const SurfaceCurve other = through(mesh, {4, 12, 20, 28, 36});
  const MeshParts alone = parted(mesh, {one});
  EXPECT_EQ(alone.pieces, 1U);
  ASSERT_EQ(alone.notes.size(), 1U);
  EXPECT_EQ(alone.notes[0],
            "Curve 0 does not separate the mesh: it leads from one border to another. A second "
            "curve between these two borders would separate the mesh together with it.");
  const MeshParts both = parted(mesh, {one, other});
  EXPECT_EQ(both.pieces, 2U);
  EXPECT_EQ(both.separates, (std::vector<bool>{true, true}));
  EXPECT_TRUE(both.notes.empty());
}

TEST(CurveSeparation, AHoleIsABorder) {
  const SurfaceMesh mesh = SurfaceMesh::open(disc_with_hole());
  // Beside the hole, from a border to itself.
  EXPECT_EQ(parted(mesh, {through(mesh, {7, 8, 9, 10, 11, 12, 13})}).pieces, 2U);
  // From the left border to the hole, and from the hole on.
  const SurfaceCurve left = through(mesh, {21, 22, 23}), right = through(mesh, {25, 26, 27});
  EXPECT_EQ(parted(mesh, {left}).separates, std::vector<bool>{false});
  const MeshParts both = parted(mesh, {left, right});
  EXPECT_EQ(both.pieces, 2U);
  EXPECT_NEAR(area(both.parts[0].lists), 16, 1e-12);
  EXPECT_TRUE(both.notes.empty());
}

TEST(CurveSeparation, LoopsAroundAHandle) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::torus(8, 12));
  const SurfaceCurve loop = through(mesh, {0, 1, 2, 3, 4, 5, 6, 7}, true);
  const SurfaceCurve other = through(mesh, {32, 33, 34, 35, 36, 37, 38, 39}, true);
  const MeshParts alone = parted(mesh, {loop});
  ASSERT_EQ(alone.notes.size(), 1U);
  EXPECT_EQ(
      alone.notes[0],
      "Curve 0 does not separate the mesh: the mesh is connected around it, as around a "
      "handle. A second loop around the same handle would separate the mesh together with it.");
  EXPECT_EQ(parted(mesh, {loop, other}).separates, (std::vector<bool>{true, true}));
  const MeshParts open = parted(mesh, {through(mesh, {0, 1, 2})});
  ASSERT_EQ(open.notes.size(), 1U);
  EXPECT_NE(open.notes[0].find("The mesh has no border, so draw a loop."), std::string::npos)
      << open.notes[0];
}

TEST(CurveSeparation, CurvesThatEndOnOthers) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(4, 4));
  const MeshParts made =
      parted(mesh, {through(mesh, {10, 11, 12, 13, 14}), through(mesh, {12, 17, 22})});
  EXPECT_EQ(made.pieces, 3U);
  EXPECT_EQ(made.separates, (std::vector<bool>{true, true}));
}

TEST(CurveSeparation, ACurveAlongTheBorder) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(4, 4));
  const MeshParts made = parted(mesh, {through(mesh, {0, 1, 2})});
  ASSERT_EQ(made.notes.size(), 1U);
  EXPECT_EQ(made.notes[0], "Curve 0 does not separate the mesh: it runs along the border only.");
}

TEST(CurveSeparation, ACurveThatCutsSomethingOutOnItsWay) {
  // In from the left, around a square, and out of that to an end inside.
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(8, 8));
  const MeshParts made =
      parted(mesh, {through(mesh, {36, 37, 38, 29, 30, 31, 40, 49, 48, 47, 38, 39})});
  EXPECT_EQ(made.separates, std::vector<bool>{false});
  ASSERT_EQ(made.notes.size(), 1U);
  EXPECT_NE(
      made.notes[0].find("does not separate the mesh along its whole length: its end at (3, 4, 0)"),
      std::string::npos)
      << made.notes[0];
  EXPECT_EQ(made.pieces, 2U);
}

TEST(CurveSeparation, ManyAreCounted) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(30, 6));
  std::vector<SurfaceCurve> slits;
  for (std::uint32_t k = 0; k < 10; ++k) {
    slits.push_back(through(mesh, {64 + 2 * k, 95 + 2 * k, 126 + 2 * k}));
  }
  const MeshParts made = parted(mesh, slits);
  ASSERT_EQ(made.notes.size(), 9U);
  EXPECT_EQ(made.notes.back(), "2 more curves do not separate the mesh.");
}

/// Rough ground, [0, 20] x [0, 12], 60 x 36 squares.
MeshLists terrain() {
  MeshLists lists = test::grid(60, 36);
  for (Point& p : lists.points) {
    p /= 3;
    p.z() = std::sin(0.7 * p.x()) * std::cos(0.9 * p.y()) + 0.1 * std::sin(9 * p.x() + 7 * p.y());
  }
  return lists;
}

/// From drawing to parts as a program does it: snapped, led to the border, smoothed and cut.
struct CutStroke {
  CutStroke(const std::shared_ptr<const OpenedMesh>& opened, std::vector<Point> points) {
    const SurfaceMesh& mesh = opened->mesh();
    StraightLines lines(mesh.surface());
    const SnappedCurve snapped = snap(mesh, {false, std::move(points), {}});
    SnappedDrawing drawing;
    drawing.add(mesh, std::span(&snapped, 1), lines);
    drawing = with_ends_at_border(mesh, std::move(drawing), lines, ExtendedCurves::kStrokes);
    notes = drawing.notes;
    drawn = drawing.curves[0];
    smooth = smooth_curve(opened, drawn).curve();
    parts = parted(mesh, {smooth});
  }

  std::vector<std::string> notes;
  SurfaceCurve drawn, smooth;
  MeshParts parts;
};

TEST(BorderToBorder, ATremblingStrokeOverTerrain) {
  const MeshLists lists = terrain();
  const auto opened = OpenedMesh::open(lists);
  std::mt19937 random(3);
  std::normal_distribution<double> trembling(0, 0.04);
  for (const double over : {1.0, 0.2, -0.3}) {  // beyond the border, or short of it
    SCOPED_TRACE(over);
    std::vector<Point> stroke;
    for (double x = -over; x <= 20 + over; x += 0.1) {
      const double y = 6 + 2 * std::sin(0.4 * x) + trembling(random);
      stroke.emplace_back(x, y, std::sin(0.7 * x) * std::cos(0.9 * y));
    }
    const CutStroke cut(opened, stroke);
    EXPECT_EQ(cut.notes.size(), 2U);
    // Ends are fixed, to the bit.
    EXPECT_EQ(cut.smooth.points.front(), cut.drawn.points.front());
    EXPECT_EQ(cut.smooth.points.back(), cut.drawn.points.back());
    EXPECT_TRUE(is_on_boundary(opened->surface(), cut.smooth.points.front()));
    EXPECT_TRUE(is_on_boundary(opened->surface(), cut.smooth.points.back()));
    EXPECT_NEAR(opened->mesh().position(cut.smooth.points.front()).x(), 0, 1e-12);
    EXPECT_NEAR(opened->mesh().position(cut.smooth.points.back()).x(), 20, 1e-12);
    ASSERT_EQ(cut.parts.parts.size(), 2U);
    EXPECT_EQ(cut.parts.separates, std::vector<bool>{true});
    const double whole = area(lists);
    EXPECT_NEAR(area(cut.parts.parts[0].lists) + area(cut.parts.parts[1].lists), whole,
                1e-12 * whole);
    EXPECT_GT(area(cut.parts.parts[0].lists), 0.3 * whole);
    EXPECT_GT(area(cut.parts.parts[1].lists), 0.3 * whole);
  }
}

/// From edge to edge of a real terrain, in coordinates of some millions.
TEST(BorderToBorder, ARealTerrain) {
  const auto path = test::mesh_folder() / "terrain_utm_21k.ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << test::missing("terrain_utm_21k");
  const MeshLists lists = read_mesh(path);
  const auto opened = OpenedMesh::open(lists);
  Point low = lists.points[0], high = low;
  for (const Point& p : lists.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Point size = high - low;
  std::vector<Point> stroke;
  const ClosestPoint closest(opened->mesh());
  for (double t = -0.06; t <= 1.06; t += 0.004) {  // as seen from above
    Point p = low + Point(t * size.x(), (0.5 + 0.2 * std::sin(5 * t)) * size.y(), 0.5 * size.z());
    const double z = opened->mesh().position(closest.nearest(p).point).z();
    p.z() = z;
    stroke.push_back(p);
  }
  const CutStroke cut(opened, stroke);
  EXPECT_TRUE(is_on_boundary(opened->surface(), cut.smooth.points.front()));
  EXPECT_TRUE(is_on_boundary(opened->surface(), cut.smooth.points.back()));
  ASSERT_EQ(cut.parts.parts.size(), 2U);
  const double whole = area(lists);
  EXPECT_NEAR(area(cut.parts.parts[0].lists) + area(cut.parts.parts[1].lists), whole, 1e-9 * whole);
}

}  // namespace
}  // namespace talweg::curve_separation_test
