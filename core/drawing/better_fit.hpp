// A better fit is another space, unit or place in which a drawing would lie on its mesh.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "talweg/core/mesh/closest_point.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {

/// The beginning of better_fit()'s words.
constexpr std::string_view kWouldFit = "would fit ";

/// Whether positions lie far from the mesh and would lie on it with x and y turned (RAS and LPS),
/// or with y up instead of z (or back), scaled by 10, 100, 1000, 25.4 or an inverse of these, or
/// moved by the centre of the mesh's box, there or back, or (if all lie away from it) by a round
/// number. On it means within a mean edge in the mean, and ten times nearer than now; when scaled,
/// as a part of their own extent.
///
/// Words like "would fit 40 times better with x and y negated, as between RAS and LPS"; empty where
/// nothing fits, and where positions lie within a quarter of a mean edge in the mean. At most 32
/// positions are looked at, so it takes O(log faces) for positions near the mesh.
std::string better_fit(const SurfaceMesh& mesh, const ClosestPoint& closest,
                       std::span<const Point> positions);

}  // namespace talweg
