// Properties of all curve formats: round trips, files written completely, errors with a sentence.
#include "talweg/core/io/curve_file.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/curve_files.hpp"
#include "talweg/core/drawing/snapping.hpp"

namespace talweg {
namespace {

using test::CurveFiles;
namespace fs = std::filesystem;

class PositionFormats : public CurveFiles, public ::testing::WithParamInterface<const char*> {};
using CurveFile = CurveFiles;

// 17 digits and 64-bit numbers lose nothing, so positions agree exactly.
TEST_P(PositionFormats, GivePositionsBackExactly) {
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<SurfaceCurve> curves{test::ring(mesh), test::walk(mesh),
                                         test::vertex_walk(mesh, 40, 9)};
  write_curves(path(GetParam()), mesh, curves);
  const std::vector<CurveInput> found = read_curves(path(GetParam()));
  ASSERT_EQ(found.size(), curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c) {
    EXPECT_EQ(found[c].closed, curves[c].closed);
    EXPECT_EQ(test::positions(found[c]), positions_of(mesh, curves[c]));
  }
}

TEST_P(PositionFormats, GiveMeshVerticesBackAsVertices) {
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<SurfaceCurve> curves{test::vertex_walk(mesh, 3, 12)};
  write_curves(path(GetParam()), mesh, curves);
  const SnappedCurve snapped = snap(mesh, read_curves(path(GetParam())).front());
  EXPECT_EQ(snapped.points, curves[0].points);
  EXPECT_EQ(snapped.largest_snap_distance, 0);
}

TEST_P(PositionFormats, EqualCurvesAreEqualFiles) {
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<SurfaceCurve> curves{test::ring(mesh)};
  write_curves(path(GetParam()), mesh, curves);
  const std::string first = bytes_of(path(GetParam()));
  write_curves(path(GetParam()), mesh, curves);
  EXPECT_EQ(bytes_of(path(GetParam())), first);
}

TEST_P(PositionFormats, RefuseEmptyAndMissingFiles) {
  expect_refused(GetParam(), "", {"the file is empty"});
  EXPECT_THROW(read_curves(path(GetParam())), Error);
  put(GetParam(), "");
  EXPECT_THROW(read_curves(path(GetParam())), Error);
}

TEST_P(PositionFormats, SurviveDamage) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(2, 1));
  const std::vector<SurfaceCurve> curves{test::vertex_walk(mesh, 0, 4)};
  write_curves(path(GetParam()), mesh, curves);
  const std::string bytes = bytes_of(path(GetParam()));
  try_every_prefix(GetParam(), bytes);
  try_damaged(GetParam(), bytes, 600);
}

INSTANTIATE_TEST_SUITE_P(All, PositionFormats,
                         ::testing::Values("c.obj", "c.ply", "c.vtp", "c.vtk", "c.mrk.json"));

TEST_F(CurveFile, JsonKeepsPointsBitForBit) {
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<SurfaceCurve> curves{test::ring(mesh), test::walk(mesh),
                                         test::vertex_walk(mesh, 40, 9)};
  write_curves(path("a.json"), mesh, curves);
  const std::vector<SnappedCurve> found = snap(mesh, read_curves(path("a.json")));
  ASSERT_EQ(found.size(), curves.size());
  std::vector<SurfaceCurve> again;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    EXPECT_EQ(found[c].closed, curves[c].closed);
    EXPECT_EQ(found[c].points, curves[c].points);
    again.push_back({found[c].closed, found[c].points});
  }
  write_curves(path("b.json"), mesh, again);
  EXPECT_EQ(bytes_of(path("a.json")), bytes_of(path("b.json")));
}

// Every edge, as a side of both its faces, with fractions that rounding could change.
TEST_F(CurveFile, JsonKeepsFractionsOnEveryEdge) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::sphere(1));
  const Surface& surface = mesh.surface();
  std::vector<SurfaceCurve> curves;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    for (const double t : {1.0 / 3, 0.1, 0.7, 3e-15, 1e-300, 1 - 1e-16 * 3}) {
      for (const VertexId end :
           {surface.head(halfedge_of(EdgeId{e})), surface.tail(halfedge_of(EdgeId{e}))}) {
        curves.push_back({false,
                          {SurfacePoint::on_edge(surface, EdgeId{e}, t),
                           SurfacePoint::at_vertex(surface, end)}});
      }
    }
  }
  write_curves(path("a.json"), mesh, curves);
  const std::vector<SnappedCurve> found = snap(mesh, read_curves(path("a.json")));
  ASSERT_EQ(found.size(), curves.size());
  std::size_t lost = 0;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const OnEdge& wanted = std::get<OnEdge>(curves[c].points[0].where());
    const SurfacePoint& point = found[c].points[0];
    // Near the end of an edge where 1 - t is stored, t is rounded to the precision of 1 - t.
    const auto* edge = std::get_if<OnEdge>(&point.where());
    if (edge == nullptr || !(*edge == wanted)) ++lost;
  }
  EXPECT_EQ(lost, 0U);
}

TEST_F(CurveFile, VertexIdsComeBack) {
  const SurfaceMesh mesh = test::odd_sphere();
  SurfaceCurve loop{true, {}};
  for (const VertexId v : mesh.surface().corners(FaceId{5})) {
    loop.points.push_back(SurfacePoint::at_vertex(mesh.surface(), v));
  }
  const std::vector<SurfaceCurve> curves{test::vertex_walk(mesh, 40, 9), loop};
  write_curves(path("a.txt"), mesh, curves);
  const std::vector<SnappedCurve> found = snap(mesh, read_curves(path("a.txt")));
  ASSERT_EQ(found.size(), 2U);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(found[c].closed, curves[c].closed);
    EXPECT_EQ(found[c].points, curves[c].points);
  }
}

TEST_F(CurveFile, VertexIdsCannotHoldOtherPoints) {
  const SurfaceMesh mesh = test::odd_sphere();
  put("a.txt", "old");
  const std::vector<SurfaceCurve> curves{test::ring(mesh)};
  try {
    write_curves(path("a.txt"), mesh, curves);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadFile);
    EXPECT_NE(std::string(error.what()).find("point 0 of curve 0"), std::string::npos);
  }
  EXPECT_EQ(bytes_of(path("a.txt")), "old");
}

TEST_F(CurveFile, EachFaceContainsThePointAndTheNext) {
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<SurfaceCurve> curves{test::ring(mesh), test::walk(mesh)};
  write_curves(path("a.json"), mesh, curves);
  const std::vector<CurveInput> found = read_curves(path("a.json"));
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto& at = std::get<std::vector<FaceCoordinates>>(found[c].points);
    const std::size_t n = at.size();
    for (std::size_t k = 0; k < n; ++k) {
      if (k + 1 == n && !found[c].closed) continue;
      const auto faces = faces_at(mesh.surface(), curves[c].points[(k + 1) % n]);
      EXPECT_NE(std::find(faces.begin(), faces.end(), at[k].face), faces.end());
    }
  }
}

TEST_F(CurveFile, RefusesCurvesThatDoNotLieOnTheMesh) {
  const SurfaceMesh mesh = test::odd_sphere();
  const auto code = [&](const std::vector<SurfaceCurve>& curves) {
    try {
      write_curves(path("a.json"), mesh, curves);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kNumerical;
  };
  const SurfacePoint a = SurfacePoint::at_vertex(mesh.surface(), VertexId{0});
  const SurfacePoint b = SurfacePoint::at_vertex(mesh.surface(), VertexId{1});
  EXPECT_EQ(code({}), ErrorCode::kBadCurve);
  EXPECT_EQ(code({{false, {}}}), ErrorCode::kBadCurve);
  EXPECT_EQ(code({{false, {a}}}), ErrorCode::kBadCurve);
  EXPECT_EQ(code({{false, {a, b}}}), ErrorCode::kBadCurve);  // opposite poles
  EXPECT_FALSE(fs::exists(path("a.json")));
}

TEST_F(CurveFile, NamesUnknownExtensions) {
  expect_refused("a.stl", "solid", {"'.stl'", ".mrk.json"});
  expect_refused("a", "1 2", {"known are"});
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<SurfaceCurve> curves{test::ring(mesh)};
  EXPECT_THROW(write_curves(path("a.stl"), mesh, curves), Error);
}

TEST_F(CurveFile, ExtensionsInEitherCase) {
  EXPECT_EQ(read("A.TXT", "1 2 3").size(), 1U);
  EXPECT_EQ(read("A.OBJ", "v 0 0 0\nv 1 0 0\nl 1 2\n").size(), 1U);
}

TEST_F(CurveFile, WritesBesideAndRenames) {
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<SurfaceCurve> curves{test::ring(mesh)};
  write_curves(path("a.json"), mesh, curves);
  const auto files = std::distance(fs::directory_iterator(path("").parent_path()), {});
  EXPECT_EQ(files, 1) << "a temporary file was left";
  try {
    write_curves(path("missing/a.json"), mesh, curves);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadFile);
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos) << error.what();
  }
}

TEST_F(CurveFile, FollowsLinksAndKeepsPermissions) {
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<SurfaceCurve> curves{test::ring(mesh)};
  put("real.json", "old");
  fs::permissions(path("real.json"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(path("real.json"), path("link.json"));
  write_curves(path("link.json"), mesh, curves);
  EXPECT_TRUE(fs::is_symlink(path("link.json")));
  EXPECT_EQ(read_curves(path("real.json")).size(), 1U);
  EXPECT_EQ(fs::status(path("real.json")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(CurveFile, RefusesDirectories) {
  fs::create_directories(path("d.json"));
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<SurfaceCurve> curves{test::ring(mesh)};
  EXPECT_THROW(read_curves(path("d.json")), Error);
  EXPECT_THROW(write_curves(path("d.json"), mesh, curves), Error);
}

}  // namespace
}  // namespace talweg
