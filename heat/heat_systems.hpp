// The heat systems are the matrices of the heat method, all of one pattern.
#pragma once

#include <vector>

#include "talweg/heat/cotan_laplacian.hpp"
#include "talweg/heat/symmetric_matrix.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// M / h² + s S, dimensionless, positive definite up to rounding; h is the mean edge length of each
/// vertex's component and s the time in units of h². Rows that would be 0 (isolated vertices,
/// components of no extent) get a unit diagonal.
SymmetricMatrix neumann_heat_matrix(CotanLaplacian laplacian, const Components& components,
                                    const std::vector<double>& mean_edge_length, double time_scale);

/// S with the row and column of each component's first vertex (and of every vertex whose row is 0)
/// replaced by rows and columns of the identity: positive definite up to rounding, dimensionless.
/// `pinned` receives the replaced vertices.
SymmetricMatrix pinned_poisson_matrix(const CotanLaplacian& laplacian, const Components& components,
                                      std::vector<char>& pinned);

}  // namespace talweg
