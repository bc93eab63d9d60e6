// A handle chain is a curve along edges of an OpenMesh mesh.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <OpenMesh/Core/Mesh/Handles.hh>

#include "talweg/intrinsic/error.hpp"

namespace talweg {

/// Halfedges, tip to tail, as embed_curves() gives them.
using HandleChain = std::vector<OpenMesh::HalfedgeHandle>;

/// Throws Error(kBadCurve), with the chain and the place in it, for a halfedge that is not in the
/// mesh or does not begin where the previous halfedge ends. O(halfedges).
template <class Mesh>
void check_chains(const Mesh& mesh, std::span<const HandleChain> chains) {
  const auto refuse = [](std::size_t chain, std::size_t place, const char* why) {
    throw Error(ErrorCode::kBadCurve, "Halfedge " + std::to_string(place) + " of chain " +
                                          std::to_string(chain) + " " + why);
  };
  for (std::size_t c = 0; c < chains.size(); ++c) {
    for (std::size_t i = 0; i < chains[c].size(); ++i) {
      const auto h = chains[c][i];
      if (!mesh.is_valid_handle(h) ||
          (mesh.has_edge_status() && mesh.status(mesh.edge_handle(h)).deleted())) {
        refuse(c, i, "is not in the mesh.");
      }
      if (i > 0 && mesh.from_vertex_handle(h) != mesh.to_vertex_handle(chains[c][i - 1])) {
        refuse(c, i, "does not begin where the one before it ends.");
      }
    }
  }
}

template <class Mesh>
bool is_closed(const Mesh& mesh, const HandleChain& chain) {
  return !chain.empty() &&
         mesh.to_vertex_handle(chain.back()) == mesh.from_vertex_handle(chain.front());
}

}  // namespace talweg
