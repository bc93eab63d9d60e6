// The cotan Laplacian and the lumped masses are computed from the side lengths of triangles.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "talweg/heat/symmetric_matrix.hpp"
#include "talweg/intrinsic/flips/delaunay.hpp"

namespace talweg {

/// A triangle's shape. Cotangents and area are 0 for a triangle without area.
struct TriangleShape {
  std::array<double, 3> cotangent{};  ///< at corner k
  double area = 0;                    ///< length squared
};

/// Side k runs from corner k to corner k + 1. The shape is computed from the four factors of
/// Heron's formula in Kahan's stable form, so needles lose no digits. The error of a cotangent is a
/// few ulp of the largest cotangent, or of 1 if all are smaller; the relative error of the area is
/// a few ulp.
TriangleShape triangle_shape(const std::array<double, 3>& length);

struct CotanLaplacian {
  /// n × n, symmetric, positive semidefinite up to rounding, rows sum to zero: (S u)_i = Σ_j (cot
  /// α_ij + cot β_ij) / 2 · (u_i - u_j). Dimensionless, because lengths cancel.
  SymmetricMatrix stiffness;
  /// Diagonal mass, a third of the area of the triangles at each vertex (barycentric); 0 at an
  /// isolated vertex. Length squared. Sums to the area.
  std::vector<double> mass;
};

/// O(triangles). Triangles without area add nothing but keep their entries in the pattern; isolated
/// vertices have a zero row. Corners must be below `vertex_count`. Throws Error(kOutOfMemory) when
/// the matrix would have 2^31 entries or more.
CotanLaplacian cotan_laplacian(std::size_t vertex_count, std::span<const MetricTriangle> triangles);

}  // namespace talweg
