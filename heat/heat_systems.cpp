#include "talweg/heat/heat_systems.hpp"

#include <cstddef>
#include <utility>

namespace talweg {

SymmetricMatrix neumann_heat_matrix(CotanLaplacian laplacian, const Components& components,
                                    const std::vector<double>& mean_edge_length,
                                    double time_scale) {
  SymmetricMatrix matrix = std::move(laplacian.stiffness);
  for (double& value : matrix.value) value *= time_scale;
  for (std::size_t v = 0; v < matrix.size(); ++v) {
    const double h = mean_edge_length[components.of_vertex[v]];
    if (h > 0) matrix.diagonal(v) += laplacian.mass[v] / h / h;
    if (!(matrix.diagonal(v) > 0)) matrix.diagonal(v) = 1;
  }
  return matrix;
}

SymmetricMatrix pinned_poisson_matrix(const CotanLaplacian& laplacian, const Components& components,
                                      std::vector<char>& pinned) {
  SymmetricMatrix matrix = laplacian.stiffness;
  pinned.assign(matrix.size(), 0);
  std::vector<char> seen(components.count, 0);
  for (std::size_t v = 0; v < matrix.size(); ++v) {
    char& component_seen = seen[components.of_vertex[v]];
    if (component_seen == 0 || !(matrix.diagonal(v) > 0)) pinned[v] = 1;
    component_seen = 1;
  }
  replace_by_identity(matrix, pinned);
  return matrix;
}

}  // namespace talweg
