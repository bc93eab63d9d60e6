// Refined meshes are the same surface with smaller faces, and results follow drawings finer than
// the mesh.
#include "talweg/core/smoothing/refined_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using namespace test;

constexpr double kEverywhere = std::numeric_limits<double>::infinity();

TEST(RefinedMesh, IsTheSameSurfaceInSmallerFaces) {
  for (const MeshLists& lists : {sheet(1), box(), tube(5, 3, 2), torus(7, 5)}) {
    const SurfaceMesh mesh = SurfaceMesh::open(lists);
    // The drawing runs from the middle of the first face to the middles of its neighbours and of
    // their neighbours.
    const FaceId first{0U};
    SurfaceCurve drawn;
    drawn.points.push_back(SurfacePoint::in_face(mesh.surface(), first, {0.2, 0.5, 0.3}));
    drawn.points.push_back(SurfacePoint::in_face(mesh.surface(), first, {0.5, 0.2, 0.3}));
    HalfedgeId h = mesh.surface().halfedge(first);
    while (!mesh.surface().has_face(twin(h))) h = mesh.surface().next(h);
    drawn.points.push_back(SurfacePoint::on_edge(mesh.surface(), edge_of(h), 0.3));
    const FaceId second = mesh.surface().face(twin(h));
    drawn.points.push_back(SurfacePoint::in_face(mesh.surface(), second, {0.1, 0.3, 0.6}));
    const double longest = mesh.mean_edge_length() / 50;
    const std::vector<FaceId> faces = {first, second};
    const RefinedMesh refined =
        refine_along(mesh, std::span(&drawn, 1), faces, std::span(&longest, 1), kEverywhere);
    const SurfaceMesh fine = SurfaceMesh::open(refined.lists);  // so it is conforming

    EXPECT_EQ(std::count_if(refined.face_of.begin(), refined.face_of.end(),
                            [&](FaceId f) { return f.index() >= mesh.surface().face_count(); }),
              0);
    const auto area_of = [](const MeshLists& m) {
      double area = 0;
      for (const Triangle& t : m.triangles) {
        area += (m.points[t[1]] - m.points[t[0]]).cross(m.points[t[2]] - m.points[t[0]]).norm() / 2;
      }
      return area;
    };
    EXPECT_NEAR(area_of(refined.lists) / area_of(lists), 1, 1e-12);
    for (std::size_t f = 0; f < refined.face_of.size(); ++f) {
      const auto corners = mesh.surface().corners(refined.face_of[f]);
      for (std::size_t j = 0; j < 3; ++j) {
        Point at = Point::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
          at += refined.corners_of[f][j][k] * mesh.point(corners[k]);
        }
        EXPECT_LT((at - refined.lists.points[refined.lists.triangles[f][j]]).norm(), 1e-12);
      }
    }

    const SurfaceCurve on_fine = refined.refined(fine.surface(), std::span(&drawn, 1)).front();
    EXPECT_GT(on_fine.points.size(), 20U);
    EXPECT_NEAR(curve_length(fine.surface(), on_fine), curve_length(mesh.surface(), drawn), 1e-12);
    for (std::size_t i = 0; i < on_fine.points.size(); ++i) {
      const RefinedMesh::Place& place = refined.curves[0][i];
      if (i + 1 < on_fine.points.size()) {
        const FaceId face = common_face(fine.surface(), on_fine.points[i], on_fine.points[i + 1]);
        ASSERT_TRUE(face.valid()) << i;
        double edge = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const Triangle& t = refined.lists.triangles[place.face.index()];
          edge = std::max(
              edge, (refined.lists.points[t[k]] - refined.lists.points[t[(k + 1) % 3]]).norm());
        }
        EXPECT_LE(edge, longest);
      }
      const Point from = mesh.position(drawn.points[place.drawn]);
      const Point to = mesh.position(drawn.points[std::min<std::size_t>(place.drawn + 1, 3)]);
      EXPECT_LT((from + place.part * (to - from) - fine.position(on_fine.points[i])).norm(), 1e-12);
    }
    const SurfaceCurve back = refined.coarse(fine.surface(), mesh.surface(), on_fine);
    for (std::size_t i = 0; i < back.points.size(); ++i) {
      EXPECT_LT((mesh.position(back.points[i]) - fine.position(on_fine.points[i])).norm(), 1e-12);
    }
    for (std::size_t i = 0; i + 1 < back.points.size(); ++i) {
      EXPECT_TRUE(common_face(mesh.surface(), back.points[i], back.points[i + 1]).valid());
    }
  }
}

TEST(RefinedMesh, RefinesOnlyFacesInReach) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(100, 100));
  const SurfaceCurve drawn =
      straight_through(mesh, {Point(50.1, 50.2, 0), Point(50.5, 50.3, 0)}, false);
  const double longest = 0.1;
  const std::vector<FaceId> faces = {any_face(mesh.surface(), drawn.points.front())};
  const RefinedMesh refined =
      refine_along(mesh, std::span(&drawn, 1), faces, std::span(&longest, 1), 4);
  EXPECT_GT(refined.face_of.size(), 50U);  // the face of the drawing is divided
  EXPECT_LT(refined.face_of.size(), 500U);
}

TEST(RefinedMesh, OfPlacesThatTouchIsASurface) {
  const SurfaceMesh mesh = SurfaceMesh::open(sheet(16));
  const auto speck = [&](double x, double y) {
    return straight_through(mesh, {Point(x, y, 0), Point(x + 0.01, y, 0)}, false);
  };
  for (double x = 2.1; x < 6; x += 0.5) {
    for (double y = 2.1; y < 6; y += 0.5) {
      const std::vector<SurfaceCurve> curves{speck(4.1, 4.1), speck(x, y)};
      const std::vector<FaceId> faces{any_face(mesh.surface(), curves[0].points[0]),
                                      any_face(mesh.surface(), curves[1].points[0])};
      const RefinedMesh part = refine_along(mesh, curves, faces, std::vector<double>{1, 1}, 0, {});
      EXPECT_NO_THROW(SurfaceMesh::open(part.lists)) << x << " " << y;
    }
  }
}

TEST(RefinedMesh, IsNotForCurvesAlongEdges) {
  const auto opened = OpenedMesh::open(hills(40));
  const SurfaceCurve drawn = wave_on_hills(opened->mesh());
  EXPECT_TRUE(too_large_faces(opened->mesh(), drawn, 1e-9).empty());
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  EXPECT_EQ(smoother.smooth(1.0).report().engine, Engine::kLocal);
}

}  // namespace
}  // namespace talweg
