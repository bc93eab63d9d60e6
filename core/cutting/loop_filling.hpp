// Lids close the holes that a cut leaves.
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

/// Triangles over a closed polygon in space, without further points: the triangulation of least
/// area (G. Barequet & M. Sharir, "Filling gaps in the boundary of a polyhedron", 1995), which for
/// a plane polygon is the polygon itself. For polygons of more than 256 points it is the least one
/// over 256 of their points spread evenly, joined with those of the stretches between them. `loop`:
/// indices of points; triangles have its orientation. O(n³) up to 256 points, O(n) beyond. None for
/// fewer than three points.
std::vector<Triangle> fill_loop(const std::vector<Point>& points,
                                std::span<const std::uint32_t> loop);

/// Sides and triangles that a triangulation must not use.
struct LeftOut {
  std::function<bool(std::uint32_t, std::uint32_t)> chord;  ///< for sides that are not on the rim
  std::set<Triangle> triangles;                             ///< by their corners, ascending
  std::size_t whole = 256;           ///< up to this many points all triangulations are considered
  ProgressPoller* poller = nullptr;  ///< null: the search cannot be cancelled

  [[nodiscard]] bool has(Triangle triangle) const {
    if (triangles.empty()) return false;
    std::sort(triangle.begin(), triangle.end());
    return triangles.count(triangle) > 0;
  }
};
/// The triangulation of least area without these. For polygons of more than `whole` points it is
/// the one over some of the points (about 256, or more where sides are excluded), joined with those
/// of the stretches between them. None if there is none, or none was found. O(n³) up to `whole`
/// points.
std::optional<std::vector<Triangle>> fill_loop(const std::vector<Point>& points,
                                               std::span<const std::uint32_t> loop,
                                               const LeftOut& left_out);

/// The kinds of lid.
enum class LidKind : std::uint8_t {
  kAuto,      ///< plane where the rim is plane, of least area elsewhere
  kPlanar,    ///< plane; for rims inside each other in one plane, the surface between them
  kLeastArea  ///< fill_loop() of each rim
};

struct Lids {
  std::size_t filled = 0;      ///< rims that got a lid
  std::size_t planar = 0;      ///< rims with a plane lid
  std::size_t triangles = 0;   ///< in all lids; they are the last faces of the piece
  std::size_t left_open = 0;   ///< rims that end at the old boundary, and slits
  std::size_t inner = 0;       ///< points inside lids; they are the last vertices of the piece
  std::size_t with_inner = 0;  ///< rims whose lid has inner points
  double sunk_by = 0;          ///< mesh units: largest distance that inner points were moved
};
/// Fills the holes that a cut left in a piece. Lids never have an edge or a triangle that the piece
/// has already, and keep clear of the part of the piece that they close, of themselves, and of
/// other lids of that part. If the first choice of a lid does not, the triangulation of least area
/// that does is used; otherwise a lid with points inside, which are moved out of the way to the
/// outside of the lid. A lid may touch the piece, or go through it by up to `kPlaneTolerance` of
/// the rim's extent, only where nothing else helps or where it must be plane.
/// The faces and inner points of lids come from none: kNoFace in `faces`, kNoVertex in `vertices`.
/// Throws Error(kBadCurve), naming rim and curve, where a lid must be plane and its rim is not or
/// crosses itself, and where every lid goes through the piece, and Cancelled when `progress` (stage
/// "cap") says so; the piece is then unchanged.
Lids add_lids(Piece& piece, const OpenedSeams& opened, std::span<const CutMesh::Chain> chains,
              LidKind kind = LidKind::kAuto, const Progress& progress = {});

}  // namespace talweg
