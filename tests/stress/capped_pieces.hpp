// Capped pieces are meshes cut along random results, and the pieces closed.
#pragma once

#include <span>
#include <string>

#include "stress/random.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::stress {

struct CappedPieces {
  std::string broken;  ///< what did not hold; empty where everything did
  std::size_t pieces = 0, lids = 0, refused = 0;
};

/// Cuts along the curves, closes every piece by lids of a random kind, and inspects it: a manifold
/// that can be opened, without the rims that lids have closed, and with what it had before. Lids
/// may be refused, by a sentence that names rim and curve; the piece is as it was then.
CappedPieces cap_pieces(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                        Random& random);

}  // namespace talweg::stress
