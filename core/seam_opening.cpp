#include "talweg/core/seam_opening.hpp"

#include <algorithm>
#include <string>
#include <unordered_set>

#include "talweg/core/surface_mesh.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

class Opener {
 public:
  Opener(const MeshLists& lists, std::span<const CutMesh::Chain> chains)
      : mesh_(SurfaceMesh::open(lists)), surface_(mesh_.surface()), chains_(chains) {
    result_.lists = lists;
    seam_.assign(surface_.edge_count(), false);
  }
  OpenedSeams run();

 private:
  void find_seams();
  void open_at(VertexId v);
  void number_pieces();
  void find_sides();

  SurfaceMesh mesh_;
  const Surface& surface_;
  std::span<const CutMesh::Chain> chains_;
  std::vector<bool> seam_;                      // per edge
  std::vector<std::vector<HalfedgeId>> along_;  // per chain
  OpenedSeams result_;
};

void Opener::find_seams() {
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    const std::vector<std::uint32_t>& vertices = chains_[c].vertices;
    std::vector<HalfedgeId>& along = along_.emplace_back();
    const std::size_t n = vertices.size();
    for (std::size_t i = 0; i + (chains_[c].closed ? 0 : 1) < n; ++i) {
      const std::uint32_t a = vertices[i], b = vertices[(i + 1) % n];
      const std::size_t count = surface_.vertex_count();
      const HalfedgeId h =
          a < count && b < count ? surface_.find_halfedge(VertexId{a}, VertexId{b}) : HalfedgeId{};
      if (!h.valid()) {
        throw Error(ErrorCode::kBadCurve, "Vertices " + std::to_string(a) + " and " +
                                              std::to_string(b) + " of chain " + std::to_string(c) +
                                              " are joined by no edge.");
      }
      along.push_back(h);
      seam_[edge_of(h).index()] = true;
    }
  }
}

/// Every sector between seams gets a vertex; the first one keeps the old.
void Opener::open_at(VertexId v) {
  std::vector<HalfedgeId> spokes;  // with their faces, counterclockwise
  const HalfedgeId first = surface_.halfedge(v);
  HalfedgeId h = first;
  do {
    if (!surface_.has_face(h)) break;
    spokes.push_back(h);
    h = surface_.turn_ccw(h);
  } while (h != first);
  const bool whole = h == first && !surface_.on_boundary(v);
  if (whole) {  // begin behind a seam
    const auto at = std::find_if(spokes.begin(), spokes.end(),
                                 [&](HalfedgeId s) { return seam_[edge_of(s).index()]; });
    if (at == spokes.end()) return;
    std::rotate(spokes.begin(), at, spokes.end());
  }
  const auto old = static_cast<std::uint32_t>(v.index());
  std::uint32_t own = old;
  for (std::size_t k = 0; k < spokes.size(); ++k) {
    if (k > 0 && seam_[edge_of(spokes[k]).index()]) {
      own = static_cast<std::uint32_t>(result_.lists.points.size());
      result_.lists.points.push_back(Point(result_.lists.points[old]));
      result_.vertex_from.push_back(old);
    }
    for (std::uint32_t& corner : result_.lists.triangles[surface_.face(spokes[k]).index()]) {
      if (corner == old) corner = own;
    }
  }
}

void Opener::number_pieces() {
  result_.piece_of_face.assign(surface_.face_count(), kNone);
  std::vector<std::uint32_t> open;
  for (std::uint32_t f = 0; f < surface_.face_count(); ++f) {
    if (result_.piece_of_face[f] != kNone) continue;
    const auto piece = static_cast<std::uint32_t>(result_.pieces++);
    result_.piece_of_face[f] = piece;
    open.assign(1, f);
    while (!open.empty()) {
      HalfedgeId h = surface_.halfedge(FaceId{open.back()});
      open.pop_back();
      for (int k = 0; k < 3; ++k, h = surface_.next(h)) {
        if (seam_[edge_of(h).index()] || !surface_.has_face(twin(h))) continue;
        const auto next = static_cast<std::uint32_t>(surface_.face(twin(h)).index());
        if (result_.piece_of_face[next] != kNone) continue;
        result_.piece_of_face[next] = piece;
        open.push_back(next);
      }
    }
  }
}

void Opener::find_sides() {
  for (const std::vector<HalfedgeId>& along : along_) {
    const auto pieces_on = [&](bool left) {
      std::vector<std::uint32_t> pieces;
      for (const HalfedgeId h : along) {
        const HalfedgeId side = left ? h : twin(h);
        if (surface_.has_face(side))
          pieces.push_back(result_.piece_of_face[surface_.face(side).index()]);
      }
      std::sort(pieces.begin(), pieces.end());
      pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
      return pieces;
    };
    result_.left.push_back(pieces_on(true));
    result_.right.push_back(pieces_on(false));
  }
}

OpenedSeams Opener::run() {
  result_.vertex_from.resize(surface_.vertex_count());
  for (std::uint32_t v = 0; v < surface_.vertex_count(); ++v) result_.vertex_from[v] = v;
  find_seams();
  std::vector<VertexId> at;
  for (const std::vector<HalfedgeId>& along : along_) {
    for (const HalfedgeId h : along) {
      at.push_back(surface_.tail(h));
      at.push_back(surface_.head(h));
    }
  }
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end()), at.end());
  for (const VertexId v : at) open_at(v);
  number_pieces();
  find_sides();
  return std::move(result_);
}

}  // namespace

OpenedSeams open_seams(const MeshLists& lists, std::span<const CutMesh::Chain> chains) {
  return Opener(lists, chains).run();
}

Piece piece_of(const OpenedSeams& opened, const std::vector<bool>& wanted) {
  Piece piece;
  piece.lists.single_precision = opened.lists.single_precision;
  std::vector<std::uint32_t> number(opened.lists.points.size(), kNone);
  for (std::uint32_t f = 0; f < opened.lists.triangles.size(); ++f) {
    if (!wanted[opened.piece_of_face[f]]) continue;
    Triangle triangle = opened.lists.triangles[f];
    for (std::uint32_t& corner : triangle) {
      if (number[corner] == kNone) {
        number[corner] = static_cast<std::uint32_t>(piece.vertices.size());
        piece.vertices.push_back(corner);
        piece.lists.points.push_back(opened.lists.points[corner]);
      }
      corner = number[corner];
    }
    piece.lists.triangles.push_back(triangle);
    piece.faces.push_back(f);
  }
  return piece;
}

}  // namespace talweg
