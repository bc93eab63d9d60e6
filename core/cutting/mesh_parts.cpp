#include "talweg/core/cutting/mesh_parts.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "talweg/core/cutting/attribute_transfer.hpp"
#include "talweg/core/cutting/curve_separation.hpp"
#include "talweg/core/cutting/seam_opening.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

const char* name_of(KeptSide side) { return side == KeptSide::kLeft ? "left" : "right"; }

/// Per curve, the pieces on its left or right.
const std::vector<std::vector<std::uint32_t>>& pieces_on(const OpenedSeams& seams, bool left) {
  return left ? seams.left : seams.right;
}

/// Throws Error(kBadCurve) for a curve that does not separate the mesh. A curve along the boundary,
/// with a side without faces, is left to refuse_empty().
void check_parted(const SurfaceMesh& mesh, const CutMesh& cut, const OpenedSeams& seams,
                  KeptSide keep) {
  for (std::size_t c = 0; c < seams.left.size(); ++c) {
    if (separates(seams, c) || seams.left[c].empty() || seams.right[c].empty()) continue;
    throw Error(ErrorCode::kBadCurve,
                fmt::format("{} So there is no {} side to keep.",
                            why_not_separated(mesh, cut, seams, c), name_of(keep)));
  }
}

[[noreturn]] void refuse_empty(const OpenedSeams& seams, KeptSide keep) {
  const bool left = keep == KeptSide::kLeft;
  const char* const side = name_of(keep);
  const auto& here = pieces_on(seams, left);
  const auto& there = pieces_on(seams, !left);
  for (std::size_t c = 0; c < here.size(); ++c) {
    for (const std::uint32_t k : here[c]) {
      for (std::size_t d = 0; d < there.size(); ++d) {
        if (std::find(there[d].begin(), there[d].end(), k) == there[d].end()) continue;
        throw Error(ErrorCode::kBadCurve,
                    fmt::format("keep {} leaves nothing: the part on the {} of curve {} is also on "
                                "the {} of curve {}; reverse one of the two curves.",
                                side, side, c, left ? "right" : "left", d));
      }
    }
  }
  const std::size_t n = here.size();
  throw Error(ErrorCode::kBadCurve,
              fmt::format("keep {} leaves nothing: {} on the {}.", side,
                          n == 1 ? "curve 0 has no face"
                                 : fmt::format("none of the curves 0 to {} has a face", n - 1),
                          side));
}

/// Per piece, whether it is kept. `between` counts the pieces on the kept side of one curve and the
/// other side of another.
std::vector<bool> kept(const OpenedSeams& seams, KeptSide keep, std::size_t& between) {
  if (keep == KeptSide::kBoth) return std::vector<bool>(seams.pieces, true);
  std::vector<bool> wanted(seams.pieces, false), other(seams.pieces, false);
  const bool left = keep == KeptSide::kLeft;
  for (const auto& pieces : pieces_on(seams, left)) {
    for (const std::uint32_t k : pieces) wanted[k] = true;
  }
  for (const auto& pieces : pieces_on(seams, !left)) {
    for (const std::uint32_t k : pieces) other[k] = true;
  }
  for (std::size_t k = 0; k < seams.pieces; ++k) {
    if (wanted[k] && other[k]) ++between;
    wanted[k] = wanted[k] && !other[k];
  }
  if (std::find(wanted.begin(), wanted.end(), true) == wanted.end()) refuse_empty(seams, keep);
  return wanted;
}

MeshPart whole(MeshLists lists) {
  MeshPart part;
  part.lists = std::move(lists);
  part.vertices.resize(part.lists.points.size());
  part.faces.resize(part.lists.triangles.size());
  std::iota(part.vertices.begin(), part.vertices.end(), 0U);
  std::iota(part.faces.begin(), part.faces.end(), 0U);
  return part;
}

using Chains = std::vector<CutMesh::Chain>;

MeshPart part_of(const OpenedSeams& seams, const std::vector<bool>& wanted, const Chains& chains,
                 const std::optional<LidKind>& lids, const Progress& progress) {
  Piece piece = piece_of(seams, wanted);
  MeshPart part;
  if (lids) part.lids = add_lids(piece, seams, chains, *lids, progress);
  part.lists = std::move(piece.lists);
  part.faces = std::move(piece.faces);
  for (const std::uint32_t v : piece.vertices) {
    part.vertices.push_back(v == kNoVertex ? kNoVertex : seams.vertex_from[v]);
  }
  return part;
}

MeshParts without_attributes(MeshLists lists, const SurfaceMesh& mesh, const CutMesh& cut,
                             const PartOptions& options, const Progress& progress) {
  const Chains& chains = cut.chains;
  MeshParts made;
  if (!options.opens()) {
    made.parts.push_back(whole(std::move(lists)));
    return made;
  }
  const OpenedSeams seams = open_seams(std::move(lists), chains);
  made.pieces = seams.pieces;
  for (std::size_t c = 0; c < chains.size(); ++c) made.separates.push_back(separates(seams, c));
  if (options.keep != KeptSide::kBoth) check_parted(mesh, cut, seams, options.keep);
  made.notes = separation_notes(mesh, cut, seams);
  const std::vector<bool> wanted = kept(seams, options.keep, made.between);
  if (!options.split) {
    made.parts.push_back(part_of(seams, wanted, chains, options.lids, progress));
    return made;
  }
  for (std::size_t k = 0; k < seams.pieces; ++k) {
    if (!wanted[k]) continue;
    std::vector<bool> one(seams.pieces, false);
    one[k] = true;
    made.parts.push_back(part_of(seams, one, chains, options.lids, progress));
  }
  return made;
}

void put_attributes(MeshParts& made, MeshAttributes carried) {
  for (MeshPart& part : made.parts) part.attributes = picked(carried, part.vertices, part.faces);
  made.left_out = std::move(carried.left_out);
}

/// Finds the vertices of a part at each vertex of the chains. Memory and time grow with the chains
/// and the part only, because the mesh may be divided into many parts.
class VerticesOnChains {
 public:
  explicit VerticesOnChains(std::span<const CutMesh::Chain> chains) {
    for (const CutMesh::Chain& chain : chains) {
      of_cut_.insert(of_cut_.end(), chain.vertices.begin(), chain.vertices.end());
    }
    std::sort(of_cut_.begin(), of_cut_.end());
    of_cut_.erase(std::unique(of_cut_.begin(), of_cut_.end()), of_cut_.end());
    here_.resize(of_cut_.size());
    maybe_.resize(16 * of_cut_.size() + 1);
    for (const std::uint32_t v : of_cut_) maybe_[v % maybe_.size()] = true;
  }
  void add(std::uint32_t of_cut, std::uint32_t of_part) {
    if (!maybe_[of_cut % maybe_.size()]) return;  // a fast test: most vertices are on no chain
    const auto found = std::lower_bound(of_cut_.begin(), of_cut_.end(), of_cut);
    if (found == of_cut_.end() || *found != of_cut) return;
    here_[static_cast<std::size_t>(found - of_cut_.begin())].push_back(of_part);
  }
  [[nodiscard]] const std::vector<std::uint32_t>& at(std::uint32_t of_cut) const {
    const auto found = std::lower_bound(of_cut_.begin(), of_cut_.end(), of_cut);
    return here_[static_cast<std::size_t>(found - of_cut_.begin())];
  }

 private:
  std::vector<std::uint32_t> of_cut_;  // ascending
  std::vector<bool> maybe_;            // by vertex of the cut mesh modulo the size
  std::vector<std::vector<std::uint32_t>> here_;
};

}  // namespace

MeshParts take_apart(const SurfaceMesh& mesh, const CutMesh& cut, const MeshAttributes& attributes,
                     const PartOptions& options, const Progress& progress) {
  MeshParts made = without_attributes(cut.lists, mesh, cut, options, progress);
  put_attributes(made, carried_to(cut, mesh.surface(), attributes));
  return made;
}

MeshParts take_apart(const SurfaceMesh& mesh, CutMesh&& cut, const MeshAttributes& attributes,
                     const PartOptions& options, const Progress& progress) {
  MeshAttributes carried =
      carried_to(cut, mesh.surface(), attributes);  // before the lists are moved away
  MeshParts made = without_attributes(std::move(cut.lists), mesh, cut, options, progress);
  put_attributes(made, std::move(carried));
  return made;
}

PartOrigins origins_of(const MeshPart& part, const CutMesh& cut, const Surface& surface,
                       const RepairMap* map) {
  PartOrigins origins;
  origins.vertices.resize(part.vertices.size());
  VerticesOnChains on_chains(cut.chains);
  for (std::uint32_t v = 0; v < part.vertices.size(); ++v) {
    if (part.vertices[v] == kNoVertex) continue;
    origins.vertices[v] = origin_of(cut.vertex_from[part.vertices[v]], surface, map);
    on_chains.add(part.vertices[v], v);
  }
  origins.faces.reserve(part.faces.size());
  for (const std::uint32_t f : part.faces) {
    if (f == kNoFace) {
      origins.faces.push_back(kNoFace);
      continue;
    }
    const FaceId from{cut.face_from[f]};
    const FaceId number = map == nullptr ? from : map->file_face(from);
    origins.faces.push_back(static_cast<std::uint32_t>(number.index()));
  }
  for (const CutMesh::Chain& chain : cut.chains) {
    PartOrigins::Curve& curve = origins.curves.emplace_back();
    curve.closed = chain.closed;
    for (const std::uint32_t v : chain.vertices) curve.vertices.push_back(on_chains.at(v));
  }
  return origins;
}

}  // namespace talweg
