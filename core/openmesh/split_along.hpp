// Splitting makes a separate mesh of each piece of an OpenMesh mesh, with all properties.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "talweg/core/openmesh/close_seam.hpp"
#include "talweg/core/openmesh/curve_sides.hpp"
#include "talweg/core/openmesh/open_seam.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Removes the unwanted faces, and edges and vertices that no wanted face has. The remaining
/// elements keep their order and all properties. A wanted and an unwanted face must share no
/// vertex. Needs no status attributes.
template <class Mesh>
class FaceKeeper {
 public:
  FaceKeeper(Mesh& mesh, const std::vector<bool>& wanted)
      : mesh_(mesh),
        faces_(mesh.n_faces(), kNone),
        edges_(mesh.n_edges(), kNone),
        vertices_(mesh.n_vertices(), kNone) {
    number(wanted);
  }
  void run() {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (edges_[e] != kNone) move_edge(static_cast<int>(e));
    }
    move<OpenMesh::VertexHandle>(vertices_);
    move<OpenMesh::FaceHandle>(faces_);
    mesh_.resize(count(vertices_), count(edges_), count(faces_));
  }

 private:
  static constexpr int kNone = -1;
  using Numbers = std::vector<int>;

  void number(const std::vector<bool>& wanted) {
    for (std::size_t f = 0; f < wanted.size(); ++f) {
      if (!wanted[f]) continue;
      faces_[f] = 0;
      auto h = mesh_.halfedge_handle(OpenMesh::FaceHandle(static_cast<int>(f)));
      for (int k = 0; k < 3; ++k, h = mesh_.next_halfedge_handle(h)) {
        edges_[static_cast<std::size_t>(h.idx() / 2)] = 0;
        vertices_[static_cast<std::size_t>(mesh_.to_vertex_handle(h).idx())] = 0;
      }
    }
    for (Numbers* numbers : {&faces_, &edges_, &vertices_}) {
      int next = 0;
      for (int& n : *numbers) {
        if (n != kNone) n = next++;
      }
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (edges_[e] != kNone) check_links(static_cast<int>(e));
    }
  }
  void check_links(int e) const {
    for (const int side : {0, 1}) {
      const auto next = mesh_.next_halfedge_handle(OpenMesh::HalfedgeHandle(2 * e + side));
      if (edges_[static_cast<std::size_t>(next.idx() / 2)] != kNone) continue;
      throw Error(
          ErrorCode::kBadMesh,
          "Vertex " + std::to_string(mesh_.from_vertex_handle(next).idx()) +
              " alone joins two pieces of the mesh, so they cannot become meshes of their own.");
    }
  }
  static std::size_t count(const Numbers& numbers) {
    for (auto n = numbers.rbegin(); n != numbers.rend(); ++n) {
      if (*n != kNone) return static_cast<std::size_t>(*n) + 1;
    }
    return 0;
  }
  [[nodiscard]] OpenMesh::HalfedgeHandle moved(OpenMesh::HalfedgeHandle h) const {
    return OpenMesh::HalfedgeHandle(2 * edges_[static_cast<std::size_t>(h.idx() / 2)] +
                                    h.idx() % 2);
  }
  /// Elements only move to smaller handles, so no unread element is overwritten. The exception is
  /// links to previous halfedges, which are not read.
  void move_edge(int e) {
    const int to = edges_[static_cast<std::size_t>(e)];
    for (const int side : {0, 1}) {
      const OpenMesh::HalfedgeHandle h(2 * e + side), moved_h(2 * to + side);
      const auto next = moved(mesh_.next_halfedge_handle(h));
      const auto head = mesh_.to_vertex_handle(h);
      const auto face = mesh_.face_handle(h);
      mesh_.set_vertex_handle(
          moved_h, OpenMesh::VertexHandle(vertices_[static_cast<std::size_t>(head.idx())]));
      mesh_.set_face_handle(moved_h,
                            face.is_valid()
                                ? OpenMesh::FaceHandle(faces_[static_cast<std::size_t>(face.idx())])
                                : face);
      mesh_.set_next_halfedge_handle(moved_h, next);
      if (to != e) mesh_.copy_all_properties(h, moved_h, true);
    }
    if (to != e) mesh_.copy_all_properties(OpenMesh::EdgeHandle(e), OpenMesh::EdgeHandle(to), true);
  }
  template <class Handle>
  void move(const Numbers& numbers) {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (numbers[k] == kNone) continue;
      const Handle from(static_cast<int>(k)), to(numbers[k]);
      mesh_.set_halfedge_handle(to, moved(mesh_.halfedge_handle(from)));
      if (from != to) mesh_.copy_all_properties(from, to, true);
    }
  }

  Mesh& mesh_;
  Numbers faces_, edges_, vertices_;
};

/// Appends the pieces first, ..., last - 1, each as a mesh. O(mesh · log(pieces)).
template <class Mesh>
void append_pieces(Mesh mesh, const std::vector<int>& piece_of, int first, int last,
                   std::vector<Mesh>& parts) {
  if (last - first == 1) {
    parts.push_back(std::move(mesh));
    return;
  }
  const int middle = first + (last - first) / 2;
  const auto append = [&](Mesh half, int from, int to) {
    std::vector<bool> wanted;
    std::vector<int> pieces;
    for (const int piece : piece_of) {
      wanted.push_back(piece >= from && piece < to);
      if (wanted.back()) pieces.push_back(piece);
    }
    FaceKeeper<Mesh>(half, wanted).run();
    append_pieces(std::move(half), pieces, from, to, parts);
  };
  append(mesh, first, middle);
  append(std::move(mesh), middle, last);
}

/// Splits a mesh along chains, such as the chains of embed_curves(), into one mesh per piece, with
/// all properties and status bits. The pieces are ordered by their first faces. Elements keep their
/// order; deleted elements and isolated vertices are left out. With `lids` the rims of the seams
/// are closed, with the lids and errors of add_lids(). `mesh` does not change. O(mesh ·
/// log(pieces)). Throws Error(kBadCurve) as open_seam() does, and Error(kBadMesh) for pieces that
/// are joined at one vertex.
template <class Traits>
std::vector<OpenMesh::TriMesh_ArrayKernelT<Traits>> split_along(
    const OpenMesh::TriMesh_ArrayKernelT<Traits>& mesh, std::span<const HandleChain> chains,
    const std::optional<LidKind>& lids = {}, const Progress& progress = {}) {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
  Mesh whole = mesh;
  const OpenedSeam seam = open_seam(whole, chains);
  if (lids) close_seam(whole, seam, *lids, progress);
  const CurveSides sides = sides_of(whole, {});
  std::vector<bool> wanted;
  std::vector<int> pieces;
  for (const int piece : sides.piece_of) {
    wanted.push_back(piece != CurveSides::kNone);
    if (wanted.back()) pieces.push_back(piece);
  }
  std::vector<Mesh> parts;
  if (pieces.empty()) return parts;
  FaceKeeper<Mesh>(whole, wanted).run();
  append_pieces(std::move(whole), pieces, 0, sides.pieces, parts);
  return parts;
}

}  // namespace talweg
