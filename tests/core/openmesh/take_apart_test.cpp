// Splitting divides an OpenMesh mesh along embedded curves, and keeps all properties.
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/mesh_numbers.hpp"
#include "core/openmesh_meshes.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/seam_opening.hpp"
#include "talweg/core/openmesh/embed_curves.hpp"
#include "talweg/core/openmesh/split_along.hpp"

namespace talweg::test {
namespace {

/// A triangle's corners in space, begun at the least: pieces are compared by these.
using CornerPoints = std::array<std::array<double, 3>, 3>;
std::multiset<CornerPoints> corners_of(const MeshLists& lists) {
  std::multiset<CornerPoints> all;
  for (const Triangle& t : lists.triangles) {
    CornerPoints corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = lists.points[t[k]];
      corners[k] = {p.x(), p.y(), p.z()};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.insert(corners);
  }
  return all;
}

/// The pieces of the mesh as lists, opened along the same chains.
struct OnLists {
  OpenedSeams opened;
  std::vector<CutChain> chains;

  template <class Mesh>
  OnLists(const Mesh& mesh, std::span<const HandleChain> handles) {
    OpenMeshIds ids;
    const MeshLists lists = lists_of(mesh, &ids);
    for (const HandleChain& chain : handles) {
      CutChain& own = chains.emplace_back();
      own.closed = is_closed(mesh, chain);
      for (const auto h : chain) {
        own.vertices.push_back(
            static_cast<std::uint32_t>(ids.id(mesh.from_vertex_handle(h)).index()));
      }
      if (!own.closed && !chain.empty()) {
        own.vertices.push_back(
            static_cast<std::uint32_t>(ids.id(mesh.to_vertex_handle(chain.back())).index()));
      }
    }
    opened = open_seams(lists, chains);
  }
  [[nodiscard]] Piece piece(std::size_t k) const {
    std::vector<bool> wanted(opened.pieces, false);
    wanted[k] = true;
    return piece_of(opened, wanted);
  }
};

/// A mesh with curves as edges, and all kinds of values.
template <class Mesh>
struct Embedded {
  Mesh mesh;
  OwnProperties own;
  std::vector<HandleChain> chains;
  bool made = false;

  Embedded(const MeshLists& lists, std::mt19937& random, int holes)
      : mesh(openmesh_of<Mesh>(lists)) {
    delete_some(mesh, random, holes);
    own.add_to(mesh, random);
    add_attributes(mesh, random);
    const SurfaceMesh opened = surface_of(mesh);
    try {
      chains = embed_curves(mesh, random_curves(opened, random)).chains;
      made = true;
    } catch (const Error&) {  // single precision would turn a part of a face over
    }
  }
};

template <class Mesh>
class TakeApart : public testing::Test {
 protected:
  /// Random meshes, some closed, some with boundary or deleted elements.
  template <class Check>
  void each(Check check) {
    const MeshLists meshes[] = {grid(12, 9), sphere(2), torus(16, 9), tube(12, 8, 4),
                                together(grid(6, 6), sphere(1), 20)};
    std::mt19937 random(7);
    int runs = 0;
    for (const MeshLists& lists : meshes) {
      for (int k = 0; k < 8; ++k) {
        SCOPED_TRACE(testing::Message() << lists.triangles.size() << " faces, run " << k);
        Embedded<Mesh> embedded(lists, random, k % 4);
        if (!embedded.made) continue;
        check(embedded);
        ++runs;
      }
    }
    EXPECT_GT(runs, 30);
  }
};
using BothPrecisions = testing::Types<FloatMesh, DoubleMesh>;
TYPED_TEST_SUITE(TakeApart, BothPrecisions);

TYPED_TEST(TakeApart, SeamsOpenAsOnLists) {
  this->each([](Embedded<TypeParam>& embedded) {
    TypeParam& mesh = embedded.mesh;
    const TypeParam before = mesh;
    const OnLists expected(mesh, embedded.chains);
    const OpenedSeam seam = open_seam(mesh, std::span<const HandleChain>(embedded.chains));
    std::string why;
    EXPECT_TRUE(is_sound(mesh, &why)) << why;
    const MeshLists now = lists_of(mesh);
    EXPECT_EQ(now.points.size(), expected.opened.lists.points.size());
    EXPECT_EQ(corners_of(now), corners_of(expected.opened.lists));
    EXPECT_EQ(euler(surface_of(mesh).surface()),
              euler(SurfaceMesh::open(expected.opened.lists).surface()));
    EXPECT_EQ(seam.copies.size(), mesh.n_vertices() - before.n_vertices());
    const OwnProperties& own = embedded.own;
    for (const auto& [from, copy] : seam.copies) {
      EXPECT_EQ(mesh.point(copy), mesh.point(from));
      EXPECT_EQ(mesh.property(own.v_text, copy), mesh.property(own.v_text, from));
      EXPECT_EQ(mesh.property(own.v_number, copy), mesh.property(own.v_number, from));
      EXPECT_EQ(mesh.normal(copy), mesh.normal(from));
    }
    // Every corner of a face keeps its values.
    for (const auto f : before.faces()) {
      auto h = before.halfedge_handle(f), g = mesh.halfedge_handle(f);
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(mesh.texcoord2D(g), before.texcoord2D(h));
        EXPECT_EQ(mesh.property(own.h_text, g), before.property(own.h_text, h));
        EXPECT_EQ(mesh.property(own.e_text, mesh.edge_handle(g)),
                  before.property(own.e_text, before.edge_handle(h)));
        EXPECT_EQ(mesh.point(mesh.to_vertex_handle(g)), before.point(before.to_vertex_handle(h)));
        h = before.next_halfedge_handle(h);
        g = mesh.next_halfedge_handle(g);
      }
      EXPECT_EQ(mesh.property(own.f_text, f), before.property(own.f_text, f));
    }
    for (std::size_t c = 0; c < seam.left.size(); ++c) {
      for (const auto h : seam.left[c]) EXPECT_FALSE(mesh.is_boundary(h));
      for (const auto h : seam.right[c]) EXPECT_FALSE(mesh.is_boundary(h));
    }
  });
}

TYPED_TEST(TakeApart, SidesAreThoseOnLists) {
  this->each([](Embedded<TypeParam>& embedded) {
    const OnLists expected(embedded.mesh, embedded.chains);
    const CurveSides sides = sides_of(embedded.mesh, std::span<const HandleChain>(embedded.chains));
    ASSERT_EQ(sides.pieces, static_cast<int>(expected.opened.pieces));
    OpenMeshIds ids;
    static_cast<void>(lists_of(embedded.mesh, &ids));
    for (std::size_t f = 0; f < expected.opened.piece_of_face.size(); ++f) {
      const auto handle = ids.handle(FaceId{f});
      EXPECT_EQ(sides.piece_of[static_cast<std::size_t>(handle.idx())],
                static_cast<int>(expected.opened.piece_of_face[f]));
    }
    for (std::size_t c = 0; c < embedded.chains.size(); ++c) {
      EXPECT_TRUE(std::equal(sides.left[c].begin(), sides.left[c].end(),
                             expected.opened.left[c].begin(), expected.opened.left[c].end()));
      EXPECT_TRUE(std::equal(sides.right[c].begin(), sides.right[c].end(),
                             expected.opened.right[c].begin(), expected.opened.right[c].end()));
    }
    std::vector<int> all(static_cast<std::size_t>(sides.pieces));
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(sides.faces(all).size(), expected.opened.piece_of_face.size());
  });
}

TYPED_TEST(TakeApart, PiecesAreMeshesWithAllProperties) {
  this->each([](Embedded<TypeParam>& embedded) {
    const TypeParam& mesh = embedded.mesh;
    const OwnProperties& own = embedded.own;
    const Written<TypeParam> before(mesh, own);
    const OnLists expected(mesh, embedded.chains);
    const auto parts = split_along(mesh, std::span<const HandleChain>(embedded.chains));
    EXPECT_EQ(Written<TypeParam>(mesh, own), before);
    ASSERT_EQ(parts.size(), expected.opened.pieces);
    std::multiset<std::string> texts, of_parts;
    for (const auto f : mesh.faces()) texts.insert(mesh.property(own.f_text, f));
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const TypeParam& part = parts[k];
      std::string why;
      EXPECT_TRUE(is_sound(part, &why)) << why;
      const Piece piece = expected.piece(k);
      const MeshLists lists = lists_of(part);
      EXPECT_EQ(part.n_vertices(), piece.lists.points.size());
      EXPECT_EQ(part.n_faces(), piece.lists.triangles.size());
      EXPECT_EQ(corners_of(lists), corners_of(piece.lists));
      for (const auto f : part.faces()) of_parts.insert(part.property(own.f_text, f));
      // Every vertex of a piece equals a vertex of the mesh in all values.
      std::map<std::string, OpenMesh::VertexHandle> by_text;
      for (const auto v : mesh.vertices()) by_text[mesh.property(own.v_text, v)] = v;
      for (const auto v : part.vertices()) {
        EXPECT_EQ(by_text.count(part.property(own.v_text, v)), 1U);
      }
    }
    EXPECT_EQ(of_parts, texts);
  });
}

TYPED_TEST(TakeApart, LidsCloseASphereThatIsCutInTwo) {
  auto mesh = openmesh_of<TypeParam>(sphere(3));
  OpenMeshIds ids;
  const SurfaceMesh opened = surface_of(mesh, &ids);
  StraightLines lines(opened.surface());
  const auto at = [&](std::size_t v) {
    return SurfacePoint::at_vertex(opened.surface(), VertexId{v});
  };
  const SurfaceCurve curve = lines.join(std::vector{at(20), at(100), at(200)}, true);
  const Embedding made = embed_curves(mesh, opened, ids, std::span(&curve, 1));
  const std::span<const HandleChain> chains(made.chains);
  const double whole = volume(lists_of(mesh));
  const auto parts = split_along(mesh, chains, LidKind::kAuto);
  ASSERT_EQ(parts.size(), 2U);
  double sum = 0;
  for (const TypeParam& part : parts) {
    EXPECT_TRUE(is_sound(part));
    EXPECT_EQ(euler(surface_of(part).surface()), 2);
    for (const auto e : part.edges()) EXPECT_FALSE(part.is_boundary(e));
    sum += volume(lists_of(part));
  }
  EXPECT_NEAR(sum, whole, 1e-5 * whole);  // the same lid, from both sides

  const OpenedSeam seam = open_seam(mesh, chains);
  const std::size_t faces = mesh.n_faces();
  const SeamLids lids = close_seam(mesh, seam);
  EXPECT_EQ(lids.filled, 2U);
  EXPECT_EQ(lids.faces.size(), lids.triangles);
  EXPECT_EQ(mesh.n_faces(), faces + lids.triangles);
  EXPECT_TRUE(is_sound(mesh));
  EXPECT_EQ(sides_of(mesh, {}).pieces, 2);
}

/// One seam by hand: a sheet of two squares, cut between them.
TYPED_TEST(TakeApart, ASeamAcrossASheetByHand) {
  auto mesh = openmesh_of<TypeParam>(grid(2, 1));  // the middle column is 1 and 4
  const HandleChain chain{mesh.find_halfedge(mesh.vertex_handle(1), mesh.vertex_handle(4))};
  const std::size_t edges = mesh.n_edges();
  const OpenedSeam seam = open_seam(mesh, std::span(&chain, 1));
  EXPECT_TRUE(is_sound(mesh));
  EXPECT_EQ(mesh.n_vertices(), 8U);
  EXPECT_EQ(mesh.n_edges(), edges + 1);
  ASSERT_EQ(seam.left.at(0).size(), 1U);
  ASSERT_EQ(seam.right.at(0).size(), 1U);
  const auto left = mesh.face_handle(seam.left[0][0]), right = mesh.face_handle(seam.right[0][0]);
  EXPECT_LT(mesh.calc_face_centroid(left)[0], 1);
  EXPECT_GT(mesh.calc_face_centroid(right)[0], 1);
  EXPECT_EQ(seam.copies.size(), 2U);
}

TYPED_TEST(TakeApart, AnEdgeInsideStaysClosedAndASlitHasTips) {
  auto mesh = openmesh_of<TypeParam>(grid(4, 4));
  const auto edge = [&](unsigned a, unsigned b) {
    return mesh.find_halfedge(mesh.vertex_handle(a), mesh.vertex_handle(b));
  };
  const HandleChain one{edge(6, 7)};
  EXPECT_TRUE(open_seam(mesh, std::span(&one, 1)).copies.empty());
  EXPECT_EQ(mesh.n_vertices(), 25U);
  const HandleChain two{edge(6, 7), edge(7, 8)};
  EXPECT_EQ(open_seam(mesh, std::span(&two, 1)).copies.size(), 1U);
  EXPECT_TRUE(is_sound(mesh));
  EXPECT_EQ(mesh.n_vertices(), 26U);
  EXPECT_EQ(split_along(mesh, {}).size(), 1U);
}

TEST(TakeApartRefuses, StaleHandlesAndLeavesTheMeshAsItIs) {
  auto mesh = openmesh_of<DoubleMesh>(grid(4, 4));
  request_status(mesh);
  OwnProperties own;
  std::mt19937 random(1);
  own.add_to(mesh, random);
  HandleChain chain{mesh.find_halfedge(mesh.vertex_handle(6), mesh.vertex_handle(7)),
                    mesh.find_halfedge(mesh.vertex_handle(7), mesh.vertex_handle(8))};
  const std::span<const HandleChain> chains(&chain, 1);
  const auto expect_refused = [&](const std::string& sentence) {
    const Written<DoubleMesh> before(mesh, own);
    for (int call = 0; call < 3; ++call) {
      try {
        if (call == 0) open_seam(mesh, chains);
        if (call == 1) static_cast<void>(sides_of(mesh, chains));
        if (call == 2) static_cast<void>(split_along(mesh, chains));
        ADD_FAILURE() << "not refused: " << sentence;
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
        EXPECT_EQ(error.what(), sentence);
      }
    }
    EXPECT_EQ(Written<DoubleMesh>(mesh, own), before);
  };
  std::swap(chain[0], chain[1]);
  expect_refused("Halfedge 1 of chain 0 does not begin where the one before it ends.");
  chain = {OpenMesh::HalfedgeHandle(100000)};
  expect_refused("Halfedge 0 of chain 0 is not in the mesh.");
  chain = {OpenMesh::HalfedgeHandle()};
  expect_refused("Halfedge 0 of chain 0 is not in the mesh.");
  chain = {mesh.halfedge_handle(mesh.face_handle(0))};
  mesh.delete_edge(mesh.edge_handle(chain[0]), false);
  expect_refused("Halfedge 0 of chain 0 is not in the mesh.");
}

TEST(TakeApartRefuses, APropertyThatCannotBeCopied) {
  struct Fuse {
    bool armed = false;
    Fuse() = default;
    Fuse(const Fuse&) = default;
    Fuse& operator=(const Fuse& other) {
      if (other.armed) throw std::runtime_error("The copy failed.");
      return *this;
    }
  };
  auto mesh = openmesh_of<DoubleMesh>(grid(2, 1));
  OwnProperties own;
  std::mt19937 random(1);
  own.add_to(mesh, random);
  OpenMesh::VPropHandleT<Fuse> bombs;
  mesh.add_property(bombs, "bombs");
  mesh.property(bombs, mesh.vertex_handle(4)).armed = true;
  const HandleChain chain{mesh.find_halfedge(mesh.vertex_handle(1), mesh.vertex_handle(4))};
  const Written<DoubleMesh> before(mesh, own);
  EXPECT_THROW(open_seam(mesh, std::span(&chain, 1)), std::runtime_error);
  EXPECT_EQ(Written<DoubleMesh>(mesh, own), before);
}

}  // namespace
}  // namespace talweg::test
