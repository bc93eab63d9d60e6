// Capped pieces are the pieces of meshes cut along random results, closed by lids.
#pragma once

#include <span>
#include <string>

#include "stress/random.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::stress {

struct CappedPieces {
  std::string broken;  ///< the first check that failed, or empty
  std::size_t pieces = 0, lids = 0, refused = 0;
};

/// Cuts along the curves, closes every piece by lids of a random kind, and checks it: an openable
/// manifold without the closed rims and with everything it had before. Lids may be refused by a
/// sentence that names rim and curve; the piece is then unchanged.
CappedPieces cap_pieces(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                        Random& random);

}  // namespace talweg::stress
