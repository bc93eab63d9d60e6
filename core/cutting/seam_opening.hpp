// Opening seams takes a mesh apart along chains of its edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

struct OpenedSeams {
  MeshLists lists;  ///< vertices keep their numbers; copies for the other sides of seams follow
  std::vector<std::uint32_t> vertex_from;    ///< the vertex that each is a copy of, or itself
  std::vector<std::uint32_t> piece_of_face;  ///< numbered by their first faces
  std::size_t pieces = 0;
  /// Per chain the pieces on its left and right, seen along it with the outside up; equal where the
  /// chain does not separate them.
  std::vector<std::vector<std::uint32_t>> left, right;
};

/// Takes a mesh apart along chains of edges: afterwards the two sides of a seam have separate
/// vertices. An end of an open chain inside the mesh stays closed; a chain of one vertex opens
/// nothing. Pieces are the parts that are still connected.
/// The lists must be a surface, as those of cut_along() are; only the faces around the chains are
/// checked for that. O(vertices + faces), and one pass over all other faces.
/// Throws Error(kBadMesh) for an index out of range, and for faces around a chain that do not fit
/// together; Error(kBadCurve) naming chain and place where two neighbours of a chain are not joined
/// by an edge.
OpenedSeams open_seams(MeshLists lists, std::span<const CutMesh::Chain> chains);

/// One piece, or several as one mesh, without unused vertices. `faces`, `vertices`: the original
/// face or vertex of each. O(vertices + faces) of all pieces, however small the wanted ones are.
struct Piece {
  MeshLists lists;
  std::vector<std::uint32_t> faces, vertices;
};
Piece piece_of(const OpenedSeams& opened, const std::vector<bool>& wanted);

}  // namespace talweg
