// Mollification lengthens edges so that no triangle is degenerate, for the Laplacian only.
#pragma once

#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// The mean length of the edges of each component; 0 for an isolated vertex. O(edges).
std::vector<double> mean_edge_lengths(const Surface& surface, const Components& components);

/// The mollified edge lengths of a surface, and how much was added to them.
struct Mollification {
  std::vector<double> lengths;  ///< one per edge
  std::vector<double> amount;   ///< one per component: added to each of its edges; >= 0

  /// Whether any length differs from the surface's own.
  [[nodiscard]] bool changed() const;
};

/// Adds to all edges of a component the smallest amount by which every triangle satisfies the
/// triangle inequality with slack: a + b >= c + slack · h, where h is the component's mean edge
/// length (Sharp & Crane 2020, "A Laplacian for Nonmanifold Triangle Meshes"). Components without
/// bad triangles keep their lengths bit for bit. The amount is at most slack · h on a surface whose
/// lengths satisfy the triangle inequality. Scales with the surface. O(faces).
Mollification mollify(const Surface& surface, const Components& components, double slack = 1e-5);

}  // namespace talweg
