// The sides of curves are faces of an OpenMesh mesh between chains of its edges.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "talweg/core/openmesh/handle_chain.hpp"

namespace talweg {

/// The pieces into which chains divide a mesh, and the pieces on either side of each chain.
struct CurveSides {
  static constexpr int kNone = -1;
  std::vector<int> piece_of;  ///< by the face's handle; kNone if it is deleted
  int pieces = 0;             ///< numbered by their first faces
  /// Per chain the pieces on its left and right, seen along it with the outside up, ascending;
  /// equal where the chains do not separate them.
  std::vector<std::vector<int>> left, right;

  /// The faces of the wanted pieces, ascending.
  [[nodiscard]] std::vector<OpenMesh::FaceHandle> faces(std::span<const int> wanted) const {
    std::vector<bool> is_wanted(static_cast<std::size_t>(pieces), false);
    for (const int piece : wanted) is_wanted.at(static_cast<std::size_t>(piece)) = true;
    std::vector<OpenMesh::FaceHandle> found;
    for (std::size_t f = 0; f < piece_of.size(); ++f) {
      if (piece_of[f] != kNone && is_wanted[static_cast<std::size_t>(piece_of[f])]) {
        found.emplace_back(static_cast<int>(f));
      }
    }
    return found;
  }
};

/// Finds the pieces of the mesh: faces that are connected across edges without a chain. O(mesh).
/// Throws Error(kBadCurve) as check_chains() does.
template <class Traits>
CurveSides sides_of(const OpenMesh::TriMesh_ArrayKernelT<Traits>& mesh,
                    std::span<const HandleChain> chains) {
  check_chains(mesh, chains);
  std::vector<bool> on_chain(mesh.n_edges(), false);
  for (const HandleChain& chain : chains) {
    for (const auto h : chain) on_chain[static_cast<std::size_t>(h.idx() / 2)] = true;
  }
  CurveSides sides;
  sides.piece_of.assign(mesh.n_faces(), CurveSides::kNone);
  const auto piece = [&](OpenMesh::FaceHandle f) -> int& {
    return sides.piece_of[static_cast<std::size_t>(f.idx())];
  };
  std::vector<OpenMesh::FaceHandle> open;
  for (const auto start : mesh.faces()) {
    if (piece(start) != CurveSides::kNone) continue;
    piece(start) = sides.pieces++;
    for (open.assign(1, start); !open.empty();) {
      const OpenMesh::FaceHandle f = open.back();
      open.pop_back();
      auto h = mesh.halfedge_handle(f);
      for (int k = 0; k < 3; ++k, h = mesh.next_halfedge_handle(h)) {
        const auto next = mesh.face_handle(mesh.opposite_halfedge_handle(h));
        if (on_chain[static_cast<std::size_t>(h.idx() / 2)] || !next.is_valid()) continue;
        if (piece(next) != CurveSides::kNone) continue;
        piece(next) = piece(f);
        open.push_back(next);
      }
    }
  }
  for (const HandleChain& chain : chains) {
    const auto pieces_on = [&](bool left) {
      std::vector<int> found;
      for (const auto h : chain) {
        const auto f = mesh.face_handle(left ? h : mesh.opposite_halfedge_handle(h));
        if (f.is_valid()) found.push_back(piece(f));
      }
      std::sort(found.begin(), found.end());
      found.erase(std::unique(found.begin(), found.end()), found.end());
      return found;
    };
    sides.left.push_back(pieces_on(true));
    sides.right.push_back(pieces_on(false));
  }
  return sides;
}

}  // namespace talweg
