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
#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Triangles over a closed polygon in space, without further points: of all triangulations that of
/// least area (G. Barequet & M. Sharir, "Filling gaps in the boundary of a polyhedron", 1995),
/// which in a plane is the polygon itself; of long polygons the least one over 256 of their points
/// spread evenly, and over the stretches between them. `loop`: indices of points; triangles turn as
/// it does. O(n³) up to 256 points, O(n) beyond. None for fewer than three points.
std::vector<Triangle> fill_loop(const std::vector<Point>& points,
                                std::span<const std::uint32_t> loop);

/// What a triangulation must do without.
struct LeftOut {
  std::function<bool(std::uint32_t, std::uint32_t)> chord;  ///< asked for sides that are no rim's
  std::set<Triangle> triangles;                             ///< by their corners, ascending
  std::size_t whole = 256;  ///< up to so many points all triangulations are looked at
  Asker* asker = nullptr;   ///< asked on the way

  [[nodiscard]] bool has(Triangle triangle) const {
    if (triangles.empty()) return false;
    std::sort(triangle.begin(), triangle.end());
    return triangles.count(triangle) > 0;
  }
};
/// The least of those that do without; of polygons of more than `whole` points the one over a part
/// of them, about 256 and more where sides of that are left out, and over the stretches between
/// them. None where there is none, or none was found. O(n³) up to `whole` points.
std::optional<std::vector<Triangle>> fill_loop(const std::vector<Point>& points,
                                               std::span<const std::uint32_t> loop,
                                               const LeftOut& left_out);

/// What a lid is.
enum class LidKind : std::uint8_t {
  kAuto,      ///< plane where its rim is, of least area elsewhere
  kPlanar,    ///< plane; with rims that lie inside each other in one plane the surface between them
  kLeastArea  ///< fill_loop() of each rim
};

struct Lids {
  std::size_t filled = 0;      ///< rims that got a lid
  std::size_t planar = 0;      ///< those of them whose lid is plane
  std::size_t triangles = 0;   ///< of all lids; the last faces of the piece
  std::size_t left_open = 0;   ///< rims that end at the old boundary, and slits
  std::size_t inner = 0;       ///< points inside lids; the last vertices of the piece
  std::size_t with_inner = 0;  ///< rims whose lid has such points
  double sunk_by = 0;  ///< how far they are moved out of the way of the piece at most, mesh units
};
/// Fills the holes of a piece that were cut. Lids never have an edge or a triangle that the piece
/// has already, and keep clear of what they close, of themselves and of other lids of that part of
/// the piece. So where the first choice of a lid does not, it is the triangulation of least area
/// that does; else one with points inside that are moved out of the way, to the outside of the lid.
/// A lid may touch what lies in it but for `kPlaneTolerance`, where nothing else helps and where it
/// must be plane.
/// Their faces and inner points come from none: kNoFace in `faces`, kNoVertex in `vertices`.
/// Throws Error(kBadCurve), naming rim and curve, where a lid must be plane and its rim is not or
/// crosses itself, and where every lid goes through the piece, and Cancelled when `progress` (stage
/// "cap") says so; the piece is as it was then.
inline constexpr std::uint32_t kNoFace = 0xFFFFFFFFU;
inline constexpr std::uint32_t kNoVertex = 0xFFFFFFFFU;
Lids add_lids(Piece& piece, const OpenedSeams& opened, std::span<const CutMesh::Chain> chains,
              LidKind kind = LidKind::kAuto, const Progress& progress = {});

}  // namespace talweg
