// Curves and values between OpenMesh handles and ids: polygons, deleted elements, either precision.
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/openmesh_meshes.hpp"
#include "core/small_meshes.hpp"
#include "core/temporary_folder.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/openmesh/openmesh_changes.hpp"
#include "talweg/core/openmesh/openmesh_drawings.hpp"
#include "talweg/core/openmesh/openmesh_points.hpp"
#include "talweg/core/openmesh/openmesh_properties.hpp"

namespace talweg::test {
namespace {

using TriMesh = OpenMesh::TriMesh_ArrayKernelT<>;
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<>;
using Vertices = std::vector<OpenMesh::VertexHandle>;

/// n x n quads, or two triangles each; vertex (x, y) is x + y (n + 1).
template <class Mesh>
Mesh squares(unsigned n) {
  Mesh mesh;
  for (unsigned k = 0; k < (n + 1) * (n + 1); ++k) {
    mesh.add_vertex({static_cast<float>(k % (n + 1)), static_cast<float>(k / (n + 1)), 0});
  }
  for (unsigned y = 0; y < n; ++y) {
    for (unsigned x = 0; x < n; ++x) {
      const unsigned a = x + y * (n + 1);
      const Vertices quad{mesh.vertex_handle(a), mesh.vertex_handle(a + 1),
                          mesh.vertex_handle(a + n + 2), mesh.vertex_handle(a + n + 1)};
      if constexpr (std::is_same_v<Mesh, PolyMesh>) {
        mesh.add_face(quad);
      } else {
        mesh.add_face(quad[0], quad[1], quad[2]);
        mesh.add_face(quad[0], quad[2], quad[3]);
      }
    }
  }
  request_status(mesh);
  return mesh;
}

std::vector<std::size_t> indices_of(const CurveInput& curve) {
  std::vector<std::size_t> result;
  for (const VertexId v : std::get<std::vector<VertexId>>(curve.points)) {
    result.push_back(v.index());
  }
  return result;
}

template <class Call>
std::string refusal(const Call& call, ErrorCode code) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    return error.what();
  }
  return "no error";
}

TEST(OpenMeshPolygons, BecomeFansWithAMapToFacesAndCorners) {
  PolyMesh mesh;
  for (const auto& [x, y] : {std::pair{0.0F, 0.0F}, {2, 0}, {3, 2}, {1, 3}, {-1, 2}, {1, -2}}) {
    mesh.add_vertex({x, y, 0});
  }
  const auto v = [&](unsigned k) { return mesh.vertex_handle(k); };
  request_status(mesh);
  mesh.add_face({v(0), v(1), v(2), v(3), v(4)});
  mesh.add_face({v(0), v(5), v(1)});
  OpenMeshIds ids;
  const MeshLists lists = lists_of(mesh, &ids);
  EXPECT_EQ(lists.polygon_count, 1U);
  ASSERT_EQ(lists.triangles.size(), 4U);
  EXPECT_EQ(ids.id(mesh.face_handle(1)).index(), 3U);
  // Each triangle has the corners of its face that the map names.
  for (std::size_t f = 0; f < 4; ++f) {
    const OpenMesh::FaceHandle face = ids.handle(FaceId{f});
    EXPECT_EQ(face.idx(), f < 3 ? 0 : 1);
    Vertices corners;
    for (auto it = mesh.cfv_begin(face); it.is_valid(); ++it) corners.push_back(*it);
    std::set<int> expected, found;
    for (const std::size_t c : ids.corners(FaceId{f})) expected.insert(corners.at(c).idx());
    for (const std::uint32_t c : lists.triangles[f]) {
      found.insert(ids.handle(VertexId{c}).idx());
    }
    EXPECT_EQ(found, expected);
  }
  mesh.delete_face(mesh.face_handle(0), false);
  EXPECT_EQ(lists_of(mesh, &ids).triangles.size(), 1U);
  EXPECT_FALSE(ids.id(mesh.face_handle(0)).valid());
  EXPECT_EQ(ids.handle(FaceId{std::size_t{0}}), mesh.face_handle(1));
}

TEST(OpenMeshDrawings, FollowVerticesHalfedgesAndMarkedEdges) {
  TriMesh mesh = squares<TriMesh>(4);
  mesh.delete_vertex(mesh.vertex_handle(0));
  OpenMeshIds ids;
  const auto opened = open_mesh(mesh, &ids);
  // Smart handles are handles.
  const Vertices path{OpenMesh::make_smart(mesh.vertex_handle(6), mesh), mesh.vertex_handle(7),
                      mesh.vertex_handle(8)};
  EXPECT_EQ(indices_of(curve_of(ids, path)), (std::vector<std::size_t>{5, 6, 7}));
  const Vertices round{mesh.vertex_handle(6), mesh.vertex_handle(7), mesh.vertex_handle(12),
                       mesh.vertex_handle(6)};
  EXPECT_TRUE(curve_of(ids, round).closed);
  EXPECT_EQ(indices_of(curve_of(ids, round)), (std::vector<std::size_t>{5, 6, 11}));
  std::vector<OpenMesh::HalfedgeHandle> halfedges;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    halfedges.push_back(mesh.find_halfedge(path[k], path[k + 1]));
  }
  EXPECT_EQ(indices_of(curve_of(mesh, ids, halfedges)), (std::vector<std::size_t>{5, 6, 7}));

  // A loop of four edges and a chain of two, marked in any order.
  const auto edge = [&](unsigned a, unsigned b) {
    return mesh.edge_handle(mesh.find_halfedge(mesh.vertex_handle(a), mesh.vertex_handle(b)));
  };
  for (const auto e :
       {edge(6, 7), edge(11, 12), edge(6, 11), edge(7, 12), edge(18, 19), edge(18, 23)}) {
    mesh.status(e).set_selected(true);
  }
  const auto curves = curves_of(mesh, ids, selected_edges(mesh));
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_TRUE(curves[0].closed != curves[1].closed);
  const CurveInput& loop = curves[0].closed ? curves[0] : curves[1];
  const CurveInput& chain = curves[0].closed ? curves[1] : curves[0];
  EXPECT_EQ(indices_of(loop).size(), 4U);
  auto ends = indices_of(chain);
  EXPECT_EQ(ends[1], 17U);  // handle 18
  for (const CurveInput& curve : curves)
    EXPECT_EQ(snap(opened->mesh(), curve).closed, curve.closed);
  EXPECT_TRUE(feature_edges(mesh).empty());
  mesh.status(edge(18, 19)).set_feature(true);
  EXPECT_EQ(feature_edges(mesh), (std::vector<OpenMesh::EdgeHandle>{edge(18, 19)}));
}

TEST(OpenMeshDrawings, RefuseHandlesThatAreNotThere) {
  TriMesh mesh = squares<TriMesh>(3);
  mesh.delete_vertex(mesh.vertex_handle(0));
  OpenMeshIds ids;
  lists_of(mesh, &ids);
  for (const int k : {-1, 0, 16}) {
    const Vertices path{mesh.vertex_handle(5), OpenMesh::VertexHandle(k)};
    EXPECT_EQ(refusal([&] { curve_of(ids, path); }, ErrorCode::kBadCurve),
              "Point 1 of the curve is the vertex handle " + std::to_string(k) +
                  ", which the opened mesh does not have.");
  }
  const std::vector<OpenMesh::HalfedgeHandle> apart{
      mesh.find_halfedge(mesh.vertex_handle(5), mesh.vertex_handle(6)),
      mesh.find_halfedge(mesh.vertex_handle(9), mesh.vertex_handle(10))};
  EXPECT_NE(refusal([&] { curve_of(mesh, ids, apart); }, ErrorCode::kBadCurve).find("Halfedge 1"),
            std::string::npos);
  const std::vector<OpenMesh::HalfedgeHandle> none{OpenMesh::HalfedgeHandle(9999)};
  EXPECT_NE(refusal([&] { curve_of(mesh, ids, none); }, ErrorCode::kBadCurve).find("9999"),
            std::string::npos);
  const std::vector<OpenMesh::EdgeHandle> edges{OpenMesh::EdgeHandle(9999)};
  EXPECT_NE(refusal([&] { curves_of(mesh, ids, edges); }, ErrorCode::kBadCurve).find("9999"),
            std::string::npos);
}

template <class Mesh>
Point position_of(const Mesh& mesh, const HandlePoint& point) {
  const auto at = [&](OpenMesh::VertexHandle v) {
    return Point(mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]);
  };
  if (const auto* v = std::get_if<OpenMesh::VertexHandle>(&point)) return at(*v);
  if (const auto* on = std::get_if<OnHalfedge>(&point)) {
    return (1 - on->t) * at(mesh.from_vertex_handle(on->halfedge)) +
           on->t * at(mesh.to_vertex_handle(on->halfedge));
  }
  const auto& in = std::get<InFaceHandle>(point);
  Point sum = Point::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(mesh.face_handle(in.corners[k]), in.face);
    sum += in.barycentric[k] * at(mesh.to_vertex_handle(in.corners[k]));
  }
  return sum;
}

template <class Mesh>
void expect_points_go_out_and_back() {
  Mesh mesh = squares<Mesh>(4);
  mesh.delete_vertex(mesh.vertex_handle(24));
  OpenMeshIds ids;
  const auto opened = open_mesh(mesh, &ids);
  const Surface& surface = opened->surface();
  SurfaceCurve curve;
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
    if (!surface.halfedge(VertexId{v}).valid()) continue;
    curve.points.push_back(SurfacePoint::at_vertex(surface, VertexId{v}));
  }
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    curve.points.push_back(SurfacePoint::on_edge(surface, EdgeId{e}, 0.3));
  }
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    curve.points.push_back(SurfacePoint::in_face(surface, FaceId{f}, {0.2, 0.3, 0.5}));
  }
  const auto out = handle_points(mesh, ids, surface, curve);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const Point expected = opened->mesh().position(curve.points[k]);
    EXPECT_LT((position_of(mesh, out[k]) - expected).norm(), 1e-12) << k;
    const SurfacePoint back = surface_point(mesh, ids, surface, out[k]);
    EXPECT_LT((opened->mesh().position(back) - expected).norm(), 1e-12) << k;
    EXPECT_EQ(back.where().index(), curve.points[k].where().index()) << k;
  }
}

TEST(OpenMeshPoints, GoOutAsHandlesAndBack) {
  expect_points_go_out_and_back<TriMesh>();
  expect_points_go_out_and_back<PolyMesh>();  // diagonals lie inside faces
}

TEST(OpenMeshPoints, RefuseHandlesThatAreNotThere) {
  TriMesh mesh = squares<TriMesh>(2);
  OpenMeshIds ids;
  const auto opened = open_mesh(mesh, &ids);
  const auto refused = [&](const HandlePoint& point) {
    return refusal([&] { surface_point(mesh, ids, opened->surface(), point); },
                   ErrorCode::kBadCurve);
  };
  EXPECT_NE(refused(OpenMesh::VertexHandle(99)).find("vertex handle 99"), std::string::npos);
  EXPECT_NE(refused(OnHalfedge{OpenMesh::HalfedgeHandle(999), 0.5}).find("999"), std::string::npos);
  EXPECT_NE(refused(OnHalfedge{OpenMesh::HalfedgeHandle(0), 1.5}), "no error");
  InFaceHandle missing;
  missing.face = OpenMesh::FaceHandle(77);
  EXPECT_NE(refused(missing).find("face handle 77"), std::string::npos);
}

class OpenMeshProperties : public TemporaryFolder {};

TEST_F(OpenMeshProperties, HoldValuesByNameAndType) {
  TriMesh mesh = squares<TriMesh>(3);
  mesh.delete_vertex(mesh.vertex_handle(0));
  OpenMeshIds ids;
  const MeshLists lists = lists_of(mesh, &ids);
  std::vector<double> heights(lists.points.size());
  for (std::size_t v = 0; v < heights.size(); ++v) heights[v] = 10 + static_cast<double>(v);
  auto distance = vertex_property<double>(mesh, ids, "distance", heights);
  EXPECT_EQ(distance[mesh.vertex_handle(1)], 10);
  EXPECT_EQ(distance[mesh.vertex_handle(0)], 0);  // deleted
  std::vector<int> sides(lists.triangles.size());
  for (std::size_t f = 0; f < sides.size(); ++f) sides[f] = static_cast<int>(f % 3);
  const auto side = face_property<int>(mesh, ids, "side", sides);
  EXPECT_EQ(labels_of(ids, side), std::vector<std::int64_t>(sides.begin(), sides.end()));
  // Again: the same property, other values.
  heights[0] = -1;
  vertex_property<double>(mesh, ids, "distance", heights);
  EXPECT_EQ(distance[mesh.vertex_handle(1)], -1);
  EXPECT_NE(
      refusal([&] { vertex_property<int>(mesh, ids, "distance", heights); }, ErrorCode::kBadUsage)
          .find("of another type"),
      std::string::npos);
  heights.pop_back();
  EXPECT_NE(refusal([&] { vertex_property<double>(mesh, ids, "distance", heights); },
                    ErrorCode::kBadUsage)
                .find("15 vertices"),
            std::string::npos);
  EXPECT_EQ(distance[mesh.vertex_handle(1)], -1);
}

TEST_F(OpenMeshProperties, ArePersistentIfWanted) {
  for (const PropertyLife life : {PropertyLife::kTemporary, PropertyLife::kPersistent}) {
    TriMesh mesh = squares<TriMesh>(2);
    OpenMeshIds ids;
    const MeshLists lists = lists_of(mesh, &ids);
    std::vector<double> values(lists.points.size(), 2.5);
    vertex_property<double>(mesh, ids, "distance", values, life);
    face_property<int>(mesh, ids, "label", std::vector<int>(lists.triangles.size(), 7), life);
    const std::string path = file("mesh.om").string();
    ASSERT_TRUE(OpenMesh::IO::write_mesh(mesh, path));
    TriMesh back;
    OpenMesh::VPropHandleT<double> distance;
    OpenMesh::FPropHandleT<int> label;
    back.add_property(distance, "distance");
    back.add_property(label, "label");
    for (const auto v : back.vertices()) back.property(distance, v) = 0;
    ASSERT_TRUE(OpenMesh::IO::read_mesh(back, path));
    const bool kept = life == PropertyLife::kPersistent;
    EXPECT_EQ(back.property(distance, back.vertex_handle(3)) == 2.5, kept);
    EXPECT_EQ(back.property(label, back.face_handle(3)) == 7, kept);
  }
}

TEST(OpenMeshChanges, AStampTellsOfMovesAndOfOtherFaces) {
  TriMesh mesh = squares<TriMesh>(3);
  const OpenMeshStamp before = stamp_of(mesh);
  EXPECT_EQ(stamp_of(mesh), before);
  TriMesh::Point& p = mesh.point(mesh.vertex_handle(5));
  p[2] += 0.1F;
  EXPECT_EQ(stamp_of(mesh).connectivity, before.connectivity);
  EXPECT_NE(stamp_of(mesh).points, before.points);
  p[2] -= 0.1F;
  p[2] = 0;
  EXPECT_EQ(stamp_of(mesh), before);
  mesh.flip(mesh.edge_handle(mesh.find_halfedge(mesh.vertex_handle(5), mesh.vertex_handle(10))));
  EXPECT_NE(stamp_of(mesh).connectivity, before.connectivity);
  const OpenMeshStamp flipped = stamp_of(mesh);
  mesh.delete_face(mesh.face_handle(0), false);
  EXPECT_NE(stamp_of(mesh).connectivity, flipped.connectivity);
  EXPECT_EQ(stamp_of(mesh).points, flipped.points);
}

TEST(OpenMeshChanges, ReopenTakesMovedVerticesAndNothingElse) {
  TriMesh mesh = squares<TriMesh>(5);
  mesh.delete_vertex(mesh.vertex_handle(0));
  OpenMeshIds ids;
  const auto opened = open_mesh(mesh, &ids);
  for (const auto v : mesh.vertices()) mesh.point(v)[2] = 0.3F * static_cast<float>(v.idx() % 4);
  const auto moved = reopen(mesh, ids, *opened);
  const auto fresh = open_mesh(mesh);
  ASSERT_EQ(moved->surface().edge_count(), fresh->surface().edge_count());
  EXPECT_TRUE(std::ranges::equal(moved->surface().lengths(), fresh->surface().lengths()));
  EXPECT_TRUE(std::ranges::equal(moved->mesh().points(), fresh->mesh().points()));
  EXPECT_EQ(moved->mesh().mean_edge_length(), fresh->mesh().mean_edge_length());
  mesh.point(mesh.vertex_handle(7))[1] = std::nanf("");
  EXPECT_NE(refusal([&] { reopen(mesh, ids, *opened); }, ErrorCode::kBadMesh), "no error");
  mesh.point(mesh.vertex_handle(7))[1] = 1;
  mesh.flip(mesh.edge_handle(mesh.find_halfedge(mesh.vertex_handle(7), mesh.vertex_handle(14))));
  EXPECT_NE(refusal([&] { reopen(mesh, ids, *opened); }, ErrorCode::kBadUsage), "no error");
  mesh.delete_face(mesh.face_handle(9), false);
  EXPECT_NE(refusal([&] { reopen(mesh, ids, *opened); }, ErrorCode::kBadUsage), "no error");
}

TEST(OpenMeshChanges, CurvesStayWhereTheirFacesStillExist) {
  TriMesh mesh = squares<TriMesh>(6);  // 7 vertices a row
  OpenMeshIds ids;
  const auto opened = open_mesh(mesh, &ids);
  // Straight through the third row of squares.
  SurfaceCurve curve;
  {
    const Surface& s = opened->surface();
    for (unsigned x = 0; x <= 6; ++x) {
      const HalfedgeId up =
          s.find_halfedge(VertexId{std::size_t{x + 14}}, VertexId{std::size_t{x + 21}});
      const bool along = up == halfedge_of(edge_of(up));
      curve.points.push_back(SurfacePoint::on_edge(s, edge_of(up), along ? 0.4 : 0.6));
      if (x == 6) break;
      const HalfedgeId diagonal =
          s.find_halfedge(VertexId{std::size_t{x + 14}}, VertexId{std::size_t{x + 22}});
      const bool forward = diagonal == halfedge_of(edge_of(diagonal));
      curve.points.push_back(SurfacePoint::on_edge(s, edge_of(diagonal), forward ? 0.4 : 0.6));
    }
  }
  const auto kept = [&] {
    OpenMeshIds now_ids;
    const auto now = open_mesh(mesh, &now_ids);
    std::vector<std::vector<Point>> result;
    for (const SurfaceCurve& c :
         kept_stretches(curve, ids, opened->surface(), now_ids, now->surface())) {
      result.push_back(positions_of(now->mesh(), c));
    }
    return result;
  };
  const std::vector<Point> whole = positions_of(opened->mesh(), curve);
  mesh.add_face(mesh.add_vertex({3, -1, 0}), mesh.vertex_handle(4), mesh.vertex_handle(3));
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_EQ(kept()[0].size(), whole.size());
  for (std::size_t k = 0; k < whole.size(); ++k) EXPECT_LT((kept()[0][k] - whole[k]).norm(), 1e-14);
  // Without a face of the third square, the curve is divided.
  const auto h = mesh.find_halfedge(mesh.vertex_handle(16), mesh.vertex_handle(24));
  mesh.delete_face(mesh.face_handle(h), false);
  ASSERT_EQ(kept().size(), 2U);
  EXPECT_EQ(kept()[0].size() + kept()[1].size(), whole.size());
  EXPECT_LT((kept()[1].back() - whole.back()).norm(), 1e-14);
}

TEST(OpenMeshChanges, AClosedCurveStaysClosedOrBecomesOneStretch) {
  TriMesh mesh = squares<TriMesh>(6);
  OpenMeshIds ids;
  const auto opened = open_mesh(mesh, &ids);
  SurfaceCurve loop;
  loop.closed = true;
  for (const std::size_t v : {16, 17, 18, 25, 32, 31, 30, 23}) {
    loop.points.push_back(SurfacePoint::at_vertex(opened->surface(), VertexId{v}));
  }
  const auto kept = [&] {
    OpenMeshIds now_ids;
    const auto now = open_mesh(mesh, &now_ids);
    return kept_stretches(loop, ids, opened->surface(), now_ids, now->surface());
  };
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_TRUE(kept()[0].closed);
  EXPECT_EQ(kept()[0].points.size(), 8U);
  // The edge 18-25 loses both of its faces.
  const auto h = mesh.find_halfedge(mesh.vertex_handle(18), mesh.vertex_handle(25));
  const auto left = mesh.face_handle(h), right = mesh.face_handle(mesh.opposite_halfedge_handle(h));
  mesh.delete_face(left, false);
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_TRUE(kept()[0].closed);
  mesh.delete_face(right, false);
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_FALSE(kept()[0].closed);
  EXPECT_EQ(kept()[0].points.size(), 8U);
}

}  // namespace
}  // namespace talweg::test
