// The unit gradient of the heat, negated, is the gradient that the distance should have.
#pragma once

#include <span>
#include <vector>

#include "talweg/heat/heat_flow.hpp"
#include "talweg/heat/heat_triangles.hpp"

namespace talweg {

/// The right-hand side b of S δ = b whose solution has the gradients closest to X = -∇u / |∇u|
/// (Crane, Weischedel & Wardetzky 2013, steps II and III): b_i = ∫ X · ∇λ_i over the triangles at
/// i, λ_i the hat function. One number per vertex, in length units; Σ b = 0 up to rounding.
///
/// Only differences along sides are needed: X · e_ij = (u_i - u_j) / |∇u|, and |∇u| follows from
/// the layout of the triangle on its longest side. Each triangle is first scaled by its own largest
/// |u|, so the direction is accurate wherever u is not 0. Triangles where u is constant have no
/// direction and add nothing. O(triangles).
std::vector<double> unit_gradient_divergence(std::span<const HeatTriangle> triangles,
                                             const ScaledField& u);

}  // namespace talweg
