// Opening a seam doubles the vertices and edges along chains, so that either side has its own, in
// place.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "talweg/core/openmesh/handle_chain.hpp"
#include "talweg/core/openmesh/relinking.hpp"
#include "talweg/core/openmesh/relinking_in_place.hpp"
#include "talweg/core/openmesh/vertex_sectors.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {

/// An opened seam, with its two rims.
struct OpenedSeam {
  /// Per chain, the halfedges of the faces on its left, which point along the chain, and of the
  /// faces on its right, which point against the chain. Where a side has no face, its list skips
  /// the edge.
  std::vector<HandleChain> left, right;
  /// The vertices of a chain before opening; a closed chain does not repeat the first vertex.
  struct Chain {
    bool closed = false;
    std::vector<OpenMesh::VertexHandle> vertices;
  };
  std::vector<Chain> chains;
  /// Pairs of an old vertex and its copy.
  std::vector<std::pair<OpenMesh::VertexHandle, OpenMesh::VertexHandle>> copies;
};

/// Finds the changes of connectivity that open the seams; the mesh stays unchanged.
template <class Mesh>
class SeamFinder {
 public:
  SeamFinder(const Mesh& mesh, std::span<const HandleChain> chains)
      : mesh_(mesh), chains_(chains) {}

  const Relinking& run() {
    found_.before = found_.after = {mesh_.n_vertices(), mesh_.n_edges(), mesh_.n_faces()};
    find_seams();
    for (const OpenMesh::VertexHandle v : vertices_) find_sectors(v);
    drop_single_edges();
    for (const OpenMesh::EdgeHandle e : edges_) open_edge(e);
    for (const auto& [v, sectors] : opened_) open_vertex(v, sectors);
    const auto most = static_cast<std::size_t>(std::numeric_limits<int>::max());
    if (found_.after.vertices >= most || found_.after.edges >= most / 2) {
      throw Error(ErrorCode::kBadMesh,
                  "The mesh would have more elements than handles can tell apart.");
    }
    return found_;
  }
  [[nodiscard]] OpenedSeam seam() const {
    OpenedSeam seam;
    for (const HandleChain& chain : chains_) {
      HandleChain& left = seam.left.emplace_back();
      HandleChain& right = seam.right.emplace_back();
      for (const Halfedge h : chain) {
        const Halfedge back = mesh_.opposite_halfedge_handle(h);
        if (!mesh_.is_boundary(h)) left.push_back(own(h));
        if (!mesh_.is_boundary(back)) right.push_back(own(back));
      }
      OpenedSeam::Chain& along = seam.chains.emplace_back();
      along.closed = is_closed(mesh_, chain);
      for (const Halfedge h : chain) along.vertices.push_back(mesh_.from_vertex_handle(h));
      if (!along.closed && !chain.empty()) {
        along.vertices.push_back(mesh_.to_vertex_handle(chain.back()));
      }
    }
    seam.copies = found_.copies;
    return seam;
  }

 private:
  using Vertex = OpenMesh::VertexHandle;
  using Halfedge = OpenMesh::HalfedgeHandle;
  using Edge = OpenMesh::EdgeHandle;

  void find_seams() {
    check_chains(mesh_, chains_);
    for (const HandleChain& chain : chains_) {
      for (const Halfedge h : chain) {
        const Edge e = mesh_.edge_handle(h);
        if (mesh_.is_boundary(e)) continue;
        edges_.push_back(e);
        vertices_.push_back(mesh_.from_vertex_handle(h));
        vertices_.push_back(mesh_.to_vertex_handle(h));
      }
    }
    keep_each_once(edges_);
    keep_each_once(vertices_);
  }
  template <class Handle>
  static void keep_each_once(std::vector<Handle>& handles) {
    std::sort(handles.begin(), handles.end());
    handles.erase(std::unique(handles.begin(), handles.end()), handles.end());
  }
  [[nodiscard]] bool is_seam(Edge e) const {
    return std::binary_search(edges_.begin(), edges_.end(), e);
  }
  void find_sectors(Vertex v) {
    opened_.emplace_back(v, sectors_of(mesh_, v, [&](Edge e) { return is_seam(e); }));
  }
  /// An edge stays closed if neither of its ends is divided: opening would give two edges between
  /// the same vertices.
  void drop_single_edges() {
    const auto stays_whole = [&](Vertex v) {
      const auto at =
          std::lower_bound(opened_.begin(), opened_.end(), v,
                           [](const auto& entry, Vertex vertex) { return entry.first < vertex; });
      return at->second.size() == 1;
    };
    std::vector<Edge> kept;
    for (const Edge e : edges_) {
      const Halfedge h = mesh_.halfedge_handle(e, 0);
      if (!stays_whole(mesh_.from_vertex_handle(h)) || !stays_whole(mesh_.to_vertex_handle(h))) {
        kept.push_back(e);
      }
    }
    edges_ = std::move(kept);
    const auto is_done = [&](const auto& entry) {
      const auto& sector = entry.second.front();
      return entry.second.size() == 1 && !is_seam(mesh_.edge_handle(sector.first()));
    };
    opened_.erase(std::remove_if(opened_.begin(), opened_.end(), is_done), opened_.end());
  }

  /// The halfedge that replaces `h` in its face after opening.
  [[nodiscard]] Halfedge own(Halfedge h) const {
    const auto found = new_edges_.find(h.idx() / 2);
    return found == new_edges_.end() || h.idx() % 2 == 0 ? h : Halfedge(2 * found->second + 1);
  }
  [[nodiscard]] static Halfedge twin(Halfedge h) { return Halfedge(h.idx() ^ 1); }
  /// The face at the second halfedge of `e` gets a new edge. The second halfedge of `e` and the
  /// first halfedge of the new edge become boundary.
  void open_edge(Edge e) {
    const Halfedge old = mesh_.halfedge_handle(e, 1);
    const int edge = static_cast<int>(found_.after.edges++);
    new_edges_.emplace(e.idx(), edge);
    const Halfedge made(2 * edge + 1);
    found_.halves.emplace_back(e, Edge(edge));
    found_.heads.emplace_back(made, mesh_.to_vertex_handle(old));
    found_.heads.emplace_back(twin(made), mesh_.from_vertex_handle(old));
    const auto face = mesh_.face_handle(old);
    found_.faces.emplace_back(made, face);
    found_.faces.emplace_back(old, OpenMesh::FaceHandle());
    if (mesh_.halfedge_handle(face) == old) found_.of_faces.emplace_back(face, made);
  }
  void open_vertex(Vertex v, const std::vector<VertexSector>& sectors) {
    for (std::size_t k = 0; k < sectors.size(); ++k) {
      const VertexSector& sector = sectors[k];
      Vertex vertex = v;
      if (k > 0) {
        vertex = Vertex(static_cast<int>(found_.after.vertices++));
        found_.copies.emplace_back(v, vertex);
      }
      for (const Halfedge outgoing : sector.outgoing) {
        const Halfedge incoming = mesh_.prev_halfedge_handle(outgoing);
        found_.heads.emplace_back(own(incoming), vertex);
        found_.nexts.emplace_back(own(incoming), own(outgoing));
      }
      const Halfedge in = twin(own(sector.first())), out = twin(own(sector.last(mesh_)));
      found_.heads.emplace_back(in, vertex);
      found_.nexts.emplace_back(in, out);
      found_.of_vertices.emplace_back(vertex, out);
    }
  }

  const Mesh& mesh_;
  std::span<const HandleChain> chains_;
  std::vector<Edge> edges_;       // to open, ascending
  std::vector<Vertex> vertices_;  // their ends, ascending
  std::vector<std::pair<Vertex, std::vector<VertexSector>>> opened_;
  std::unordered_map<int, int> new_edges_;  // by the old edge
  Relinking found_;
};

/// Opens seams along chains of halfedges, such as the chains of embed_curves(): either side gets
/// its own vertices and edges, with copies of all properties. The end of a chain inside the mesh
/// stays closed. Old handles stay valid; a divided vertex stays with the sector that has the
/// smallest face handle. O(elements along the chains), and O(mesh) when the mesh's arrays must
/// grow. Throws Error(kBadCurve) as check_chains() does, Error(kBadMesh) for more elements than
/// handles can number, and exceptions from copying a property; the mesh is then unchanged.
template <class Traits>
OpenedSeam open_seam(OpenMesh::TriMesh_ArrayKernelT<Traits>& mesh,
                     std::span<const HandleChain> chains) {
  SeamFinder finder(mesh, chains);
  const Relinking& changes = finder.run();
  OpenedSeam seam = finder.seam();
  change(mesh, changes, [](auto&) {});
  return seam;
}

}  // namespace talweg
