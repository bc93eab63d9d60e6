// Closing an opened seam gives each of its rims a lid, in place.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "talweg/core/cutting/loop_filling.hpp"
#include "talweg/core/openmesh/curve_sides.hpp"
#include "talweg/core/openmesh/open_seam.hpp"
#include "talweg/core/openmesh/openmesh_adaptor.hpp"
#include "talweg/core/openmesh/relinking_in_place.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

struct SeamLids : Lids {
  std::vector<OpenMesh::FaceHandle> faces;  ///< of the lids
};

/// Finds the connectivity between lids and the rims that they close; the mesh stays unchanged.
template <class Mesh>
class LidLinker {
 public:
  LidLinker(const Mesh& mesh, const OpenedSeam& seam) : mesh_(mesh) {
    found_.before = found_.after = {mesh.n_vertices(), mesh.n_edges(), mesh.n_faces()};
    for (const auto* side : {&seam.left, &seam.right}) {
      for (const HandleChain& rim : *side) {
        for (const auto h : rim) {
          const auto free = mesh.opposite_halfedge_handle(h);
          if (mesh.is_boundary(free)) {
            sides_[key(mesh.from_vertex_handle(free), mesh.to_vertex_handle(free))].halfedge = free;
          }
        }
      }
    }
  }
  OpenMesh::VertexHandle add_vertex() {
    return OpenMesh::VertexHandle(static_cast<int>(found_.after.vertices++));
  }
  OpenMesh::FaceHandle add(const std::array<OpenMesh::VertexHandle, 3>& corners) {
    const OpenMesh::FaceHandle f(static_cast<int>(found_.after.faces++));
    std::array<OpenMesh::HalfedgeHandle, 3> around;
    for (std::size_t k = 0; k < 3; ++k) around[k] = take(corners[k], corners[(k + 1) % 3]);
    for (std::size_t k = 0; k < 3; ++k) {
      found_.nexts.emplace_back(around[k], around[(k + 1) % 3]);
      found_.faces.emplace_back(around[k], f);
      if (corners[k].idx() >= static_cast<int>(mesh_.n_vertices())) {
        found_.of_vertices.emplace_back(corners[k], around[k]);
      }
    }
    found_.of_faces.emplace_back(f, around[2]);
    return f;
  }
  /// Throws Error(kNumerical) if a side of a lid has no neighbour (never seen).
  const Relinking& relinking() const {
    for (const auto& [ends, side] : sides_) {
      if (side.is_new && !side.used) fail();
    }
    return found_;
  }

 private:
  struct Side {
    OpenMesh::HalfedgeHandle halfedge = OpenMesh::HalfedgeHandle();
    bool is_new = false;
    bool used = false;
  };
  using Key = std::uint64_t;
  static Key key(OpenMesh::VertexHandle a, OpenMesh::VertexHandle b) {
    return Key{static_cast<std::uint32_t>(a.idx())} << 32U | static_cast<std::uint32_t>(b.idx());
  }
  [[noreturn]] static void fail() {
    throw Error(ErrorCode::kNumerical, "A lid does not fit the rim that it closes.");
  }
  OpenMesh::HalfedgeHandle take(OpenMesh::VertexHandle a, OpenMesh::VertexHandle b) {
    if (sides_.count(key(a, b)) == 0) {
      const int edge = static_cast<int>(found_.after.edges++);
      sides_[key(a, b)] = Side{OpenMesh::HalfedgeHandle(2 * edge), true, false};
      sides_[key(b, a)] = Side{OpenMesh::HalfedgeHandle(2 * edge + 1), true, false};
      found_.heads.emplace_back(OpenMesh::HalfedgeHandle(2 * edge), b);
      found_.heads.emplace_back(OpenMesh::HalfedgeHandle(2 * edge + 1), a);
    }
    Side& side = sides_[key(a, b)];
    if (std::exchange(side.used, true)) fail();
    return side.halfedge;
  }

  const Mesh& mesh_;
  std::unordered_map<Key, Side> sides_;
  Relinking found_;
};

/// Closes the rims of a seam that open_seam() has opened in this mesh. Lids and errors are those of
/// add_lids(); after an error the mesh is unchanged. New elements have default properties. O(mesh).
template <class Traits>
SeamLids close_seam(OpenMesh::TriMesh_ArrayKernelT<Traits>& mesh, const OpenedSeam& seam,
                    LidKind kind = LidKind::kAuto, const Progress& progress = {}) {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
  OpenMeshIds ids;
  OpenedSeams opened;
  opened.lists = lists_of(mesh, &ids);
  opened.vertex_from.resize(opened.lists.points.size());
  std::iota(opened.vertex_from.begin(), opened.vertex_from.end(), 0U);
  const auto number = [&](OpenMesh::VertexHandle v) {
    return static_cast<std::uint32_t>(ids.id(v).index());
  };
  for (const auto& [from, copy] : seam.copies) opened.vertex_from[number(copy)] = number(from);
  const CurveSides pieces = sides_of(mesh, {});
  opened.pieces = static_cast<std::size_t>(pieces.pieces);
  for (const auto f : mesh.faces()) {
    opened.piece_of_face.push_back(
        static_cast<std::uint32_t>(pieces.piece_of[static_cast<std::size_t>(f.idx())]));
  }
  std::vector<CutChain> chains;
  for (const OpenedSeam::Chain& chain : seam.chains) {
    CutChain& own = chains.emplace_back();
    own.closed = chain.closed;
    for (const auto v : chain.vertices) own.vertices.push_back(number(v));
  }
  Piece piece{opened.lists, {}, opened.vertex_from};
  std::iota(piece.vertices.begin(), piece.vertices.end(), 0U);
  piece.faces.resize(piece.lists.triangles.size());
  std::iota(piece.faces.begin(), piece.faces.end(), 0U);
  const std::size_t old_vertices = piece.vertices.size(), old_faces = piece.faces.size();
  SeamLids lids{add_lids(piece, opened, chains, kind, progress), {}};

  LidLinker<Mesh> linker(mesh, seam);
  std::vector<OpenMesh::VertexHandle> inner;
  while (old_vertices + inner.size() < piece.vertices.size()) inner.push_back(linker.add_vertex());
  for (std::size_t f = old_faces; f < piece.lists.triangles.size(); ++f) {
    std::array<OpenMesh::VertexHandle, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = piece.lists.triangles[f][k];
      corners[k] = v < old_vertices ? ids.handle(VertexId{v}) : inner[v - old_vertices];
    }
    lids.faces.push_back(linker.add(corners));
  }
  change(mesh, linker.relinking(), [&](auto&) {
    for (std::size_t k = 0; k < inner.size(); ++k) {
      const Point& p = piece.lists.points[old_vertices + k];
      mesh.set_point(inner[k], stored_point<Mesh>({p.x(), p.y(), p.z()}));
    }
  });
  return lids;
}

}  // namespace talweg
