// Lids for the holes that a cut leaves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/mesh_lists.hpp"
#include "talweg/core/seam_opening.hpp"

namespace talweg {

/// Triangles over a closed polygon in space, without further points: of all triangulations that of
/// least area (G. Barequet & M. Sharir, "Filling gaps in the boundary of a polyhedron", 1995),
/// which in a plane is the polygon itself; of long polygons the least one over 256 of their points
/// spread evenly, and over the stretches between them. `loop`: indices of points; triangles turn as
/// it does. O(n³) up to 256 points, O(n) beyond. None for fewer than three points.
std::vector<Triangle> fill_loop(const std::vector<Point>& points,
                                std::span<const std::uint32_t> loop);

/// What a lid is.
enum class LidKind : std::uint8_t {
  kAuto,      ///< plane where its rim is, of least area elsewhere
  kPlanar,    ///< plane; with rims that lie inside each other in one plane the surface between them
  kLeastArea  ///< fill_loop() of each rim
};

struct Lids {
  std::size_t filled = 0;     ///< rims that got a lid
  std::size_t planar = 0;     ///< those of them whose lid is plane
  std::size_t triangles = 0;  ///< of all lids; the last faces of the piece
  std::size_t left_open = 0;  ///< rims that end at the old boundary, and slits
};
/// Fills the holes of a piece that were cut. Their faces come from none: kNoFace in `faces`.
/// Throws Error(kBadCurve) where a lid must be plane and its rim is not, or crosses itself.
inline constexpr std::uint32_t kNoFace = 0xFFFFFFFFU;
Lids add_lids(Piece& piece, const OpenedSeams& opened, std::span<const CutMesh::Chain> chains,
              LidKind kind = LidKind::kAuto);

}  // namespace talweg
