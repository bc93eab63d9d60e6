#include "stress/capped_pieces.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/cutting/loop_filling.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/seam_opening.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::stress {
namespace {

/// A sentence on the first fault of a piece and its lids, or "".
std::string fault_of(const Piece& before, const Piece& part, const Lids& lids) {
  const MeshInspection old = inspect(before.lists), found = inspect(part.lists);
  if (old.verdict != MeshVerdict::kUsable) return "a piece is not usable: " + old.reason;
  if (found.verdict != MeshVerdict::kUsable) return "lids make it unusable: " + found.reason;
  if (old.boundary_loops < lids.filled ||
      found.boundary_loops != old.boundary_loops - lids.filled) {
    return fmt::format("{} of {} rims have lids, and {} are left", lids.filled, old.boundary_loops,
                       found.boundary_loops);
  }
  const std::size_t faces = before.lists.triangles.size(), points = before.lists.points.size();
  if (part.lists.triangles.size() != faces + lids.triangles ||
      part.faces.size() != faces + lids.triangles ||
      part.lists.points.size() != points + lids.inner ||
      part.vertices.size() != points + lids.inner) {
    return "lids do not count what they add";
  }
  if (!std::equal(before.lists.triangles.begin(), before.lists.triangles.end(),
                  part.lists.triangles.begin()) ||
      !std::equal(before.lists.points.begin(), before.lists.points.end(),
                  part.lists.points.begin())) {
    return "lids change the piece";
  }
  for (const Point& p : part.lists.points) {
    if (!p.allFinite()) return "a point of a lid is not finite";
  }
  SurfaceMesh::open(part.lists);
  return "";
}

}  // namespace

CappedPieces cap_pieces(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                        Random& random) {
  CappedPieces result;
  CutOptions options;
  if (random.one_in(3)) options.merge = random.scale(1e-11, 1e-2);
  const LidKind kind = random.one_in(3) ? LidKind::kLeastArea : LidKind::kAuto;
  const CutMesh cut = cut_along(mesh, curves, options);
  const OpenedSeams seams = open_seams(cut.lists, cut.chains);
  const bool together = random.one_in(4);
  for (std::size_t k = 0; k < (together ? 1 : seams.pieces); ++k) {
    std::vector<bool> wanted(seams.pieces, together);
    wanted[k] = true;
    const Piece before = piece_of(seams, wanted);
    Piece part = before;
    ++result.pieces;
    try {
      const Lids lids = add_lids(part, seams, cut.chains, kind);
      result.lids += lids.filled;
      result.broken = fault_of(before, part, lids);
    } catch (const Error& error) {
      const std::string text = error.what();
      ++result.refused;
      if (error.code() != ErrorCode::kBadCurve || !text.starts_with("The rim of ") ||
          text.find(" on curve ") == std::string::npos) {
        result.broken = "capping says: " + text;
      } else if (part.faces.size() != before.faces.size() ||
                 part.lists.points.size() != before.lists.points.size()) {
        result.broken = "refused lids stay";
      }
    }
    if (!result.broken.empty()) return result;
  }
  return result;
}

}  // namespace talweg::stress
