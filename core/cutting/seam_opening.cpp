#include "talweg/core/cutting/seam_opening.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/mesh/union_find.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

using Key = std::uint64_t;
Key directed(std::uint32_t a, std::uint32_t b) { return (Key{a} << 32U) | b; }
Key undirected(std::uint32_t a, std::uint32_t b) {
  return directed(std::min(a, b), std::max(a, b));
}

/// Opens seams. The maps hold only faces around the chains' vertices.
class Opener {
 public:
  Opener(MeshLists lists, std::span<const CutMesh::Chain> chains) : chains_(chains) {
    result_.lists = std::move(lists);
  }
  OpenedSeams run();

 private:
  void find_faces();
  void find_seams();
  void open_at(std::uint32_t v, std::span<const std::uint32_t> faces);
  void number_pieces();
  void find_sides();
  [[nodiscard]] std::uint32_t left_of(std::uint32_t a, std::uint32_t b) const {
    const auto found = face_of_.find(directed(a, b));
    return found == face_of_.end() ? kNone : found->second;
  }

  std::span<const CutMesh::Chain> chains_;
  std::vector<std::array<std::uint32_t, 2>> faces_at_;  // (vertex of a chain, face), sorted
  std::unordered_map<Key, std::uint32_t> face_of_;      // per directed edge, the face on its left
  std::unordered_set<Key> seams_;
  OpenedSeams result_;
};

void Opener::find_faces() {
  const MeshLists& lists = result_.lists;
  std::vector<bool> on_chain(lists.points.size(), false);
  for (const CutMesh::Chain& chain : chains_) {
    for (const std::uint32_t v : chain.vertices) {
      if (v < on_chain.size()) on_chain[v] = true;  // larger numbers are rejected in find_seams()
    }
  }
  for (std::uint32_t f = 0; f < lists.triangles.size(); ++f) {
    const Triangle& t = lists.triangles[f];
    bool touches = false;
    for (const std::uint32_t v : t) {
      if (v >= on_chain.size()) {
        throw Error(ErrorCode::kBadMesh, fmt::format("Face {} refers to vertex {}, but there are "
                                                     "only {} vertices.",
                                                     f, v, on_chain.size()));
      }
      if (on_chain[v]) faces_at_.push_back({v, f});
      touches = touches || on_chain[v];
    }
    for (std::size_t k = 0; touches && k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (face_of_.emplace(directed(a, b), f).second && a != b) continue;
      throw Error(ErrorCode::kBadMesh,
                  fmt::format("Face {} does not fit its neighbours at the edge from vertex {} to "
                              "vertex {}: the mesh is not an oriented surface there.",
                              f, a, b));
    }
  }
  std::sort(faces_at_.begin(), faces_at_.end());
}

void Opener::find_seams() {
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    const std::vector<std::uint32_t>& vertices = chains_[c].vertices;
    const std::size_t n = vertices.size();
    for (std::size_t i = 0; i + (chains_[c].closed ? 0 : 1) < n; ++i) {
      const std::uint32_t a = vertices[i], b = vertices[(i + 1) % n];
      if (n == 1) continue;  // a curve of a single point
      if (left_of(a, b) == kNone && left_of(b, a) == kNone) {
        throw Error(ErrorCode::kBadCurve,
                    fmt::format("No edge joins vertices {} and {} of chain {}.", a, b, c));
      }
      seams_.insert(undirected(a, b));
    }
  }
}

/// Gives every sector of faces between seams its own vertex; the sector of the smallest face keeps
/// the old vertex.
void Opener::open_at(std::uint32_t v, std::span<const std::uint32_t> faces) {
  UnionFind sectors(faces.size());
  const auto place = [&](std::uint32_t face) {
    return static_cast<std::uint32_t>(std::lower_bound(faces.begin(), faces.end(), face) -
                                      faces.begin());
  };
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    for (const std::uint32_t corner : result_.lists.triangles[faces[i]]) {
      const std::uint32_t w =
          result_.vertex_from[corner];  // `corner` may be a copy of a vertex opened earlier
      if (w == v || seams_.count(undirected(v, w)) > 0) continue;
      for (const std::uint32_t face : {left_of(v, w), left_of(w, v)}) {
        if (face != kNone) sectors.join(i, place(face));
      }
    }
  }
  std::vector<std::uint32_t> own(faces.size(), v);
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    const std::uint32_t first = sectors.find(i);
    if (first == i && i > 0) {
      own[i] = static_cast<std::uint32_t>(result_.lists.points.size());
      result_.lists.points.push_back(result_.lists.points[v]);
      result_.vertex_from.push_back(v);
    }
    own[i] = own[first];
    for (std::uint32_t& corner : result_.lists.triangles[faces[i]]) {
      if (corner == v) corner = own[i];
    }
  }
}

/// Numbers the pieces: faces that share a vertex belong to one piece.
void Opener::number_pieces() {
  UnionFind parts(result_.lists.points.size());
  for (const auto& [a, b, c] : result_.lists.triangles) {
    parts.join(a, b);
    parts.join(b, c);
  }
  std::vector<std::uint32_t> number(result_.lists.points.size(), kNone);  // by root vertex
  result_.piece_of_face.reserve(result_.lists.triangles.size());
  for (const Triangle& t : result_.lists.triangles) {
    std::uint32_t& piece = number[parts.find(t[0])];
    if (piece == kNone) piece = static_cast<std::uint32_t>(result_.pieces++);
    result_.piece_of_face.push_back(piece);
  }
}

void Opener::find_sides() {
  for (const CutMesh::Chain& chain : chains_) {
    const std::size_t n = chain.vertices.size();
    const auto pieces_on = [&](bool left) {
      std::vector<std::uint32_t> pieces;
      for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < n; ++i) {
        const std::uint32_t a = chain.vertices[i], b = chain.vertices[(i + 1) % n];
        const std::uint32_t face = left ? left_of(a, b) : left_of(b, a);
        if (face != kNone) pieces.push_back(result_.piece_of_face[face]);
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
  find_faces();
  find_seams();
  result_.vertex_from.resize(result_.lists.points.size());
  std::iota(result_.vertex_from.begin(), result_.vertex_from.end(), 0U);
  std::vector<std::uint32_t> faces;
  for (auto at = faces_at_.begin(); at != faces_at_.end();) {
    const std::uint32_t v = (*at)[0];
    for (faces.clear(); at != faces_at_.end() && (*at)[0] == v; ++at) faces.push_back((*at)[1]);
    open_at(v, faces);
  }
  number_pieces();
  find_sides();
  return std::move(result_);
}

}  // namespace

OpenedSeams open_seams(MeshLists lists, std::span<const CutMesh::Chain> chains) {
  return Opener(std::move(lists), chains).run();
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
