// Seam opening separates a mesh along chains of its edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

struct OpenedSeams {
  MeshLists lists;                           ///< vertices keep their numbers; copies follow
  std::vector<std::uint32_t> vertex_from;    ///< the vertex that each copies, or itself
  std::vector<std::uint32_t> piece_of_face;  ///< pieces are numbered by their first faces
  std::size_t pieces = 0;
  /// Per chain, the pieces on its left and right, ascending, seen along the chain with the outside
  /// up. A piece may be on both sides.
  std::vector<std::vector<std::uint32_t>> left, right;
};

/// Opens seams along chains of edges: the two sides of a seam get separate vertices. The end of an
/// open chain inside the mesh stays closed; a chain of one vertex opens nothing. Pieces are the
/// connected parts after opening. The lists must form an oriented surface, as the lists of
/// cut_along() do; only faces around the chains are checked. O(vertices + faces). Throws
/// Error(kBadMesh) for an index out of range, and for faces around a chain that do not form a
/// surface; Error(kBadCurve) with the chain if no edge joins two consecutive vertices.
OpenedSeams open_seams(MeshLists lists, std::span<const CutMesh::Chain> chains);

/// One or several pieces as one mesh, without unused vertices. `faces`, `vertices`: the numbers of
/// its elements in OpenedSeams::lists. O(vertices + faces) of all pieces, even if the wanted pieces
/// are small.
struct Piece {
  MeshLists lists;
  std::vector<std::uint32_t> faces, vertices;
};
Piece piece_of(const OpenedSeams& opened, const std::vector<bool>& wanted);

}  // namespace talweg
