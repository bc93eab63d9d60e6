// Embedding turns curves into edges of an OpenMesh mesh, with the result of cut_along(), and keeps
// all properties.
#include "talweg/core/openmesh/embed_curves.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/mesh_numbers.hpp"
#include "core/openmesh_meshes.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"

namespace talweg::test {
namespace {

/// A triangle of handles, begun at the smallest.
using Handles = std::array<int, 3>;
Handles begun_at_least(Handles t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

template <class Mesh>
std::multiset<Handles> triangles_of(const Mesh& mesh) {
  std::multiset<Handles> triangles;
  for (const auto f : mesh.faces()) {
    Handles t{};
    auto h = mesh.halfedge_handle(f);
    for (int& corner : t) {
      corner = mesh.to_vertex_handle(h).idx();
      h = mesh.next_halfedge_handle(h);
    }
    triangles.insert(begun_at_least(t));
  }
  return triangles;
}

/// The opened form of a mesh, and a copy of the mesh before the change.
template <class Mesh>
struct Opened {
  explicit Opened(const Mesh& mesh) : surface(surface_of(mesh, &ids)), before(mesh) {}
  OpenMeshIds ids;
  SurfaceMesh surface;
  Mesh before;

  [[nodiscard]] int handle(std::size_t vertex) const {
    const std::size_t old = surface.points().size();
    if (vertex < old) return ids.handle(VertexId{vertex}).idx();
    return static_cast<int>(before.n_vertices() + vertex - old);
  }
};

/// The same triangles, chains and positions as cut_along() makes on lists.
template <class Mesh>
void expect_as_on_lists(const Opened<Mesh>& opened, const Mesh& mesh, const Embedding& made,
                        const CutMesh& cut) {
  std::multiset<Handles> expected;
  for (const auto& [a, b, c] : cut.lists.triangles) {
    expected.insert(begun_at_least({opened.handle(a), opened.handle(b), opened.handle(c)}));
  }
  EXPECT_EQ(triangles_of(mesh), expected);
  for (std::size_t v = opened.surface.points().size(); v < cut.lists.points.size(); ++v) {
    const auto& p = cut.lists.points[v];
    EXPECT_EQ(mesh.point(OpenMesh::VertexHandle(opened.handle(v))),
              stored_point<Mesh>({p.x(), p.y(), p.z()}));
  }
  ASSERT_EQ(made.chains.size(), cut.chains.size());
  for (std::size_t c = 0; c < cut.chains.size(); ++c) {
    const auto& vertices = cut.chains[c].vertices;
    const std::size_t n = vertices.size();
    ASSERT_EQ(made.chains[c].size(), n < 2 ? 0 : cut.chains[c].closed ? n : n - 1);
    for (std::size_t i = 0; i < made.chains[c].size(); ++i) {
      const auto h = made.chains[c][i];
      EXPECT_EQ(mesh.from_vertex_handle(h).idx(), opened.handle(vertices[i]));
      EXPECT_EQ(mesh.to_vertex_handle(h).idx(), opened.handle(vertices[(i + 1) % n]));
    }
  }
  EXPECT_EQ(made.crossings, cut.crossings);
  EXPECT_EQ(made.merged, cut.merged);
}

/// Elements that the plan does not divide are the same, with all their values.
template <class Mesh>
void expect_the_rest_untouched(const Opened<Mesh>& opened, const Mesh& mesh,
                               const OwnProperties& own, const CutPlan& plan) {
  const Mesh& before = opened.before;
  const Written<Mesh> old(before, own), now(mesh, own);
  std::set<int> faces;
  for (const std::uint32_t f : plan.faces) faces.insert(opened.ids.handle(FaceId{f}).idx());
  for (const auto f : before.all_faces()) {
    if (faces.count(f.idx()) > 0) continue;
    EXPECT_EQ(now.faces[static_cast<std::size_t>(f.idx())],
              old.faces[static_cast<std::size_t>(f.idx())]);
    if (before.status(f).deleted()) continue;
    for (const auto h : before.fh_range(f)) {
      EXPECT_EQ(now.halfedges[static_cast<std::size_t>(h.idx())],
                old.halfedges[static_cast<std::size_t>(h.idx())]);
    }
  }
  for (std::size_t e = 0; e < old.edges.size(); ++e) EXPECT_EQ(now.edges[e], old.edges[e]);
  for (const auto v : before.all_vertices()) {
    const auto values = [](const std::string& written) {
      return written.substr(written.find(' '));
    };
    EXPECT_EQ(values(now.vertices[static_cast<std::size_t>(v.idx())]),
              values(old.vertices[static_cast<std::size_t>(v.idx())]));
  }
}

template <class Mesh>
void expect_parts_like_the_whole(const Mesh& mesh, const OwnProperties& own,
                                 const Embedding& made) {
  ASSERT_EQ(made.faces.size(), made.face_from.size());
  for (std::size_t k = 0; k < made.faces.size(); ++k) {
    const auto from = made.face_from[k], to = made.faces[k];
    EXPECT_EQ(mesh.property(own.f_number, to), mesh.property(own.f_number, from));
    EXPECT_EQ(mesh.property(own.f_text, to), mesh.property(own.f_text, from));
    EXPECT_EQ(mesh.color(to), mesh.color(from));
    EXPECT_EQ(mesh.status(to).bits(), mesh.status(from).bits());
  }
}

template <class Mesh>
class EmbedCurves : public testing::Test {};
using Meshes = testing::Types<FloatMesh, DoubleMesh>;
TYPED_TEST_SUITE(EmbedCurves, Meshes);

TYPED_TEST(EmbedCurves, AsOnListsInRandomMeshesWithAllThatTheyKnow) {
  const MeshLists meshes[] = {grid(12, 9), sphere(2), torus(16, 9), tube(12, 8, 4),
                              together(grid(6, 6), sphere(1), 20)};
  std::mt19937 random(3);
  int runs = 0, crossed = 0, refused = 0;
  for (const MeshLists& lists : meshes) {
    for (int k = 0; k < 12; ++k) {
      SCOPED_TRACE(testing::Message() << lists.triangles.size() << " faces, run " << k);
      auto mesh = openmesh_of<TypeParam>(lists);
      delete_some(mesh, random, k % 5);
      OwnProperties own;
      own.add_to(mesh, random);
      add_attributes(mesh, random);
      for (const auto e : mesh.edges()) mesh.status(e).set_tagged(random() % 3 == 0);
      for (const auto f : mesh.faces()) mesh.status(f).set_selected(random() % 3 == 0);
      const Opened<TypeParam> opened(mesh);
      const auto curves = random_curves(opened.surface, random);
      const CutOptions options{1e-6,
                               resolution_near<typename TypeParam::Scalar>(opened.surface, curves)};
      Embedding made;
      try {
        made = embed_curves(mesh, opened.surface, opened.ids, curves);
      } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("rounding"), std::string::npos) << error.what();
        EXPECT_EQ(Written<TypeParam>(mesh, own), Written<TypeParam>(opened.before, own));
        ++refused;
        continue;
      }
      std::string why;
      EXPECT_TRUE(is_sound(mesh, &why)) << why;
      const CutMesh cut = cut_along(opened.surface, curves, options);
      expect_as_on_lists(opened, mesh, made, cut);
      expect_the_rest_untouched(opened, mesh, own, plan_cut(opened.surface, curves, options));
      expect_parts_like_the_whole(mesh, own, made);
      const MeshLists now = lists_of(mesh);
      EXPECT_EQ(euler(surface_of(mesh).surface()), euler(opened.surface.surface()));
      EXPECT_NEAR(area(now), area(lists_of(opened.before)), 1e-5 * area(now));
      ++runs;
      if (made.crossings > 0) ++crossed;
    }
  }
  EXPECT_GT(runs, 40);
  EXPECT_GT(crossed, 15);
  EXPECT_LT(refused, 10);
}

/// A square of two faces, (0, 1, 3) and (0, 3, 2), side 1, with a curve from the middle of the left
/// side over the diagonal's point at 1/4 to a point inside the lower face.
template <class Mesh>
struct Square {
  Mesh mesh = openmesh_of<Mesh>(grid(1, 1));
  OpenMeshIds ids;
  SurfaceMesh opened = surface_of(mesh, &ids);
};

TYPED_TEST(EmbedCurves, ValuesOfASplitEdgeByHand) {
  Square<TypeParam> square;
  auto& mesh = square.mesh;
  mesh.request_vertex_normals();
  mesh.request_vertex_colors();
  mesh.request_vertex_texcoords2D();
  mesh.request_halfedge_texcoords2D();
  request_status(mesh);
  for (const auto v : mesh.vertices()) {
    const auto p = mesh.point(v);
    mesh.set_texcoord2D(v, {static_cast<float>(p[0]), static_cast<float>(2 * p[1])});
    mesh.set_normal(v, {static_cast<float>(p[0]), 0, static_cast<float>(1 - p[0])});
    mesh.set_color(v, {static_cast<unsigned char>(255 * p[0]), 10, 0});
    mesh.status(v).set_selected(true);
    mesh.status(v).set_tagged(v.idx() == 0);
  }
  for (const auto f : mesh.faces()) {  // another texture on either face
    for (const auto h : mesh.fh_range(f)) {
      const auto p = mesh.point(mesh.to_vertex_handle(h));
      mesh.set_texcoord2D(h, {static_cast<float>(p[0]) + 10.0F * static_cast<float>(f.idx()),
                              static_cast<float>(p[1])});
    }
  }
  const Surface& surface = square.opened.surface();
  SurfaceCurve curve;
  curve.points = {SurfacePoint::at_vertex(surface, VertexId{1}), between(surface, 0, 3, 0.25),
                  SurfacePoint::at_vertex(surface, VertexId{2})};
  EmbedOptions options;
  options.marks.feature = true;
  mesh.add_property(options.marks.curve, "curve");
  const Embedding made =
      embed_curves(mesh, square.opened, square.ids, std::span(&curve, 1), options);
  EXPECT_TRUE(is_sound(mesh));
  ASSERT_EQ(mesh.n_vertices(), 5U);
  ASSERT_EQ(mesh.n_faces(), 4U);
  ASSERT_EQ(mesh.n_edges(), 8U);
  const auto v = made.vertices.at(0);
  EXPECT_EQ(mesh.point(v), typename TypeParam::Point(0.25, 0.25, 0));
  EXPECT_EQ(mesh.texcoord2D(v), OpenMesh::Vec2f(0.25F, 0.5F));
  EXPECT_NEAR(mesh.normal(v)[0], 0.25 / std::hypot(0.25, 0.75), 1e-6);
  EXPECT_NEAR(mesh.normal(v)[2], 0.75 / std::hypot(0.25, 0.75), 1e-6);
  EXPECT_EQ(mesh.color(v), OpenMesh::Vec3uc(64, 10, 0));  // 63.75, rounded
  EXPECT_TRUE(mesh.status(v).selected());
  EXPECT_FALSE(mesh.status(v).tagged());
  for (const auto f : mesh.faces()) {
    const int old =
        f.idx() < 2 ? f.idx() : made.face_from.at(static_cast<std::size_t>(f.idx() - 2)).idx();
    for (const auto h : mesh.fh_range(f)) {
      const auto p = mesh.point(mesh.to_vertex_handle(h));
      EXPECT_EQ(mesh.texcoord2D(h),
                OpenMesh::Vec2f(static_cast<float>(p[0]) + 10.0F * static_cast<float>(old),
                                static_cast<float>(p[1])));
    }
  }
  ASSERT_EQ(made.chains.at(0).size(), 2U);
  int features = 0;
  for (const auto e : mesh.edges()) features += mesh.status(e).feature() ? 1 : 0;
  EXPECT_EQ(features, 2);
  for (const auto h : made.chains[0]) EXPECT_TRUE(mesh.status(mesh.edge_handle(h)).feature());
  EXPECT_TRUE(mesh.status(v).feature());
  EXPECT_FALSE(mesh.status(mesh.vertex_handle(0)).feature());
}

TYPED_TEST(EmbedCurves, WithoutStatusNothingIsDeleted) {
  auto mesh = openmesh_of<TypeParam>(grid(5, 5));
  const Opened<TypeParam> opened(mesh);
  SurfaceCurve curve;  // along the boundary and into the mesh
  const Surface& surface = opened.surface.surface();
  curve.points = {between(surface, 0, 1, 0.5), SurfacePoint::at_vertex(surface, VertexId{1}),
                  between(surface, 1, 2, 0.25), SurfacePoint::at_vertex(surface, VertexId{2}),
                  between(surface, 8, 9, 0.5)};
  const Embedding made = embed_curves(mesh, std::span(&curve, 1));
  EXPECT_FALSE(mesh.has_face_status());
  EXPECT_FALSE(mesh.has_vertex_status());
  std::string why;
  EXPECT_TRUE(is_sound(mesh, &why)) << why;
  expect_as_on_lists(opened, mesh, made, cut_along(opened.surface, std::span(&curve, 1)));
}

TYPED_TEST(EmbedCurves, AgainAndAgain) {
  auto mesh = openmesh_of<TypeParam>(sphere(2));
  std::mt19937 random(5);
  const MeshLists before = lists_of(mesh);
  for (int k = 0; k < 6; ++k) {
    const SurfaceMesh opened = surface_of(mesh);
    const auto curves = random_curves(opened, random);
    try {
      embed_curves(mesh, curves);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("rounding"), std::string::npos);
    }
    EXPECT_TRUE(is_sound(mesh));
  }
  EXPECT_NEAR(area(lists_of(mesh)), area(before), 1e-5 * area(before));
  EXPECT_EQ(euler(surface_of(mesh).surface()), 2);
}

TEST(EmbedCurvesInSinglePrecision, MergesPointsThatAreEqualInSinglePrecision) {
  MeshLists lists = grid(4, 4);
  for (Point& p : lists.points) p += Point(4096, 4096, 0);  // numbers are 2^-11 apart there
  auto mesh = openmesh_of<FloatMesh>(lists);
  OpenMeshIds ids;
  const SurfaceMesh opened = surface_of(mesh, &ids);
  SurfaceCurve curve;
  curve.points = {between(opened.surface(), 0, 1, 0.5), between(opened.surface(), 1, 6, 0.9999),
                  between(opened.surface(), 6, 7, 0.5)};
  const CutMesh exact = cut_along(opened, std::span(&curve, 1));
  EXPECT_EQ(exact.merged, 0U);
  const Embedding made = embed_curves(mesh, opened, ids, std::span(&curve, 1));
  EXPECT_EQ(made.merged, 1U);
  EXPECT_NEAR(made.largest_move, 1e-4, 1e-9);
  EXPECT_EQ(made.vertices.size(), 2U);
  EXPECT_TRUE(is_sound(mesh));
}

/// One curve goes straight, the other over a point that lies 1e-9 beside it.
TEST(EmbedCurvesInSinglePrecision, RefusesToInvertAFace) {
  OwnProperties own;
  std::mt19937 random(1);
  auto mesh = openmesh_of<FloatMesh>(grid(1, 1));
  own.add_to(mesh, random);
  auto fine = openmesh_of<DoubleMesh>(grid(1, 1));
  OpenMeshIds ids;
  const SurfaceMesh opened = surface_of(mesh, &ids);
  const Surface& surface = opened.surface();
  const auto at = [&](double a, double b) {
    return SurfacePoint::in_face(surface, FaceId{0}, {1 - a - b, a, b});
  };
  const std::vector<SurfaceCurve> curves = {
      {false, {at(0.25, 0.25), at(0.375, 0.25 + 1e-9), at(0.5, 0.25)}},
      {false, {at(0.25, 0.25), at(0.5, 0.25)}}};
  const Written<FloatMesh> before(mesh, own);
  EXPECT_NO_THROW(embed_curves(fine, curves));
  try {
    embed_curves(mesh, opened, ids, curves);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadMesh);
    EXPECT_STREQ(error.what(),
                 "Face 0 cannot be divided in single precision: rounding would turn a part of it "
                 "over.");
  }
  EXPECT_EQ(Written<FloatMesh>(mesh, own), before);
}

/// Bad input gives one sentence, and leaves the mesh unchanged, bit for bit.
class EmbedCurvesRefuses : public testing::Test {
 protected:
  void SetUp() override {
    std::mt19937 random(2);
    request_status(mesh);
    own.add_to(mesh, random);
    opened = surface_of(mesh, &ids);
    curve.points = {between(opened.surface(), 0, 1, 0.5), between(opened.surface(), 0, 6, 0.5)};
  }
  void expect_refused(const std::string& sentence) {
    const Written<DoubleMesh> before(mesh, own);
    try {
      embed_curves(mesh, opened, ids, std::span(&curve, 1), options);
      ADD_FAILURE() << "not refused: " << sentence;
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), sentence);
    }
    EXPECT_EQ(Written<DoubleMesh>(mesh, own), before);
  }

  DoubleMesh mesh = openmesh_of<DoubleMesh>(grid(4, 4));
  OwnProperties own;
  OpenMeshIds ids;
  SurfaceMesh opened;
  SurfaceCurve curve;
  EmbedOptions options;
};

TEST_F(EmbedCurvesRefuses, ACurveOfAnotherMesh) {
  const SurfaceMesh other = SurfaceMesh::open(grid(20, 20));
  curve.points[1] = between(other.surface(), 300, 301, 0.5);
  expect_refused("Point 1 of curve 0 is not on this mesh: the curve belongs to another mesh.");
  curve.points[1] = between(opened.surface(), 20, 21, 0.5);
  expect_refused("Points 0 and 1 of curve 0 lie in no common face.");
}

TEST_F(EmbedCurvesRefuses, AMeshThatHasChanged) {
  mesh.set_point(mesh.vertex_handle(6), OpenMesh::Vec3d(9, 9, 9));
  expect_refused("The mesh has changed since it was opened, at vertex 6.");
}

TEST_F(EmbedCurvesRefuses, AFaceThatWasDeleted) {
  mesh.delete_face(mesh.face_handle(0), false);
  expect_refused("The mesh has changed since it was opened, at face 0.");
}

TEST_F(EmbedCurvesRefuses, AMeshThatWasCollected) {
  mesh.delete_face(mesh.face_handle(0), false);
  mesh.garbage_collection();
  expect_refused("The mesh has changed since it was opened, at face 0.");
}

TEST_F(EmbedCurvesRefuses, EmbeddingWithTheOldNumbersAgain) {
  embed_curves(mesh, opened, ids, std::span(&curve, 1));
  expect_refused("The mesh has changed since it was opened, at face 0.");
}

TEST_F(EmbedCurvesRefuses, AChainAlongAnEdgeThatIsGone) {
  curve.points = {SurfacePoint::at_vertex(opened.surface(), VertexId{0}),
                  SurfacePoint::at_vertex(opened.surface(), VertexId{1})};
  mesh.delete_face(mesh.face_handle(0), false);
  mesh.garbage_collection();
  expect_refused(
      "No edge joins vertex 0 of chain 0 to the next vertex: the mesh has changed since the plan "
      "was made, or the plan belongs to another mesh.");
}

TEST_F(EmbedCurvesRefuses, NumbersOfAnotherMesh) {
  static_cast<void>(surface_of(openmesh_of<DoubleMesh>(grid(2, 2)), &ids));
  expect_refused(
      "The ids belong to another mesh: they count other numbers of vertices or triangles than the "
      "opened mesh.");
}

TEST_F(EmbedCurvesRefuses, MarksThatTheMeshHasNoRoomFor) {
  mesh.release_edge_status();
  options.marks.feature = true;
  expect_refused(
      "Edges cannot be marked as features: the mesh has no status of edges and vertices.");
}

/// A value whose copy fails when the fuse has burnt down.
struct Bomb {
  static inline int fuse = -1;
  Bomb() = default;
  Bomb(const Bomb&) = default;
  Bomb& operator=(const Bomb&) {
    if (fuse >= 0 && fuse-- == 0) throw std::runtime_error("The copy failed.");
    return *this;
  }
};

TEST_F(EmbedCurvesRefuses, APropertyThatCannotBeCopied) {
  OpenMesh::FPropHandleT<Bomb> bombs;
  mesh.add_property(bombs, "bombs");
  const Written<DoubleMesh> before(mesh, own);
  for (int fuse = 0; fuse < 2; ++fuse) {
    Bomb::fuse = fuse;
    EXPECT_THROW(embed_curves(mesh, opened, ids, std::span(&curve, 1)), std::runtime_error);
    EXPECT_EQ(Written<DoubleMesh>(mesh, own), before);
  }
  Bomb::fuse = -1;
  EXPECT_NO_THROW(embed_curves(mesh, opened, ids, std::span(&curve, 1)));
  EXPECT_TRUE(is_sound(mesh));
}

}  // namespace
}  // namespace talweg::test
