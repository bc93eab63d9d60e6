// Loop filling makes lids that close the holes which a cut leaves.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "talweg/core/cutting/seam_opening.hpp"
#include "talweg/core/cutting/vertex_origin.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// The triangulation of least area of a closed polygon in space, without further points (G.
/// Barequet & M. Sharir, "Filling gaps in the boundary of a polyhedron", 1995); for a plane polygon
/// its triangles cover the polygon. For more than 256 points, the triangulation is the least over
/// 256 evenly spread points, joined with triangulations of the stretches between these points.
/// `loop`: indices of points; the triangles have its orientation. O(n³) up to 256 points, O(n)
/// beyond. Empty for fewer than three points.
std::vector<Triangle> fill_loop(const std::vector<Point>& points,
                                std::span<const std::uint32_t> loop);

/// Sides and triangles that a triangulation must not contain.
struct LeftOut {
  std::function<bool(std::uint32_t, std::uint32_t)> chord;  ///< whether an inner side is excluded
  std::set<Triangle> triangles;                             ///< corners ascending
  std::size_t whole =
      256;  ///< largest number of points for which all triangulations are considered
  ProgressPoller* poller = nullptr;  ///< work is reported to it, if not null

  [[nodiscard]] bool has(Triangle triangle) const {
    if (triangles.empty()) return false;
    std::sort(triangle.begin(), triangle.end());
    return triangles.count(triangle) > 0;
  }
};
/// The triangulation of least area without the excluded sides and triangles. For more than `whole`
/// points, the triangulation is the least over some of the points (about 256, or more because of
/// excluded sides), joined with triangulations of the stretches between. Empty if none was found.
/// O(n³) up to `whole` points.
std::optional<std::vector<Triangle>> fill_loop(const std::vector<Point>& points,
                                               std::span<const std::uint32_t> loop,
                                               const LeftOut& left_out);

/// The kinds of lid.
enum class LidKind : std::uint8_t {
  kAuto,      ///< kPlanar for plane rims, kLeastArea for others
  kPlanar,    ///< plane; a rim with holes in the same plane gets one lid
  kLeastArea  ///< fill_loop() of each rim
};

struct Lids {
  std::size_t filled = 0;     ///< rims that got a lid
  std::size_t planar = 0;     ///< rims with a plane lid
  std::size_t triangles = 0;  ///< in all lids; the last faces of the piece
  std::size_t left_open =
      0;                  ///< rims that end at the old boundary, and slits (both sides of one seam)
  std::size_t inner = 0;  ///< inner points of lids; the last vertices of the piece
  std::size_t with_inner = 0;  ///< rims whose lid has inner points
  double sunk_by = 0;          ///< mesh units: largest move of an inner point
};
/// Fills the holes that a cut left in a piece. A lid has no edge or triangle that the piece already
/// has, and keeps clear of the connected part that it closes, of itself, and of other lids of this
/// part. If the first lid has contacts, the triangulation of least area without contacts is used;
/// if there is none, a lid with inner points, which are moved away from the faces. Only a lid that
/// must be plane, or for which all this fails, may touch the piece or penetrate it by up to
/// `kPlaneTolerance` of the rim's extent. The faces and inner points of lids have no source:
/// kNoFace in `faces`, kNoVertex in `vertices`. Throws Error(kBadCurve), with rim and curve, if a
/// lid must be plane but its rim is not plane or crosses itself, and if every lid penetrates the
/// piece; Cancelled (stage "cap"). The piece is then unchanged.
Lids add_lids(Piece& piece, const OpenedSeams& opened, std::span<const CutMesh::Chain> chains,
              LidKind kind = LidKind::kAuto, const Progress& progress = {});

}  // namespace talweg
