// A better fit is another coordinate space, unit or place in which a drawing would lie on its mesh.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "talweg/core/mesh/closest_point.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {

/// The first words of every text that better_fit() returns.
constexpr std::string_view kWouldFit = "would fit ";

/// Looks for a change of the positions that would put them on the mesh, if they lie far from the
/// mesh. The changes tried are: x and y negated (between RAS and LPS); y up instead of z, and z up
/// instead of y; a scale of 10, 100, 1000, 25.4 or the inverse of one of these; a move by the
/// centre of the mesh's box, or by its negative; and, if the mean distance exceeds an eighth of
/// the diagonal of the mesh's box, a move by a round number. A change fits if the mean distance to
/// the mesh becomes at most a mean edge and a tenth of the present one; for a scale the distance is
/// compared as a part of the positions' own extent.
///
/// Returns words like "would fit 40 times better with x and y negated, as between RAS and LPS". The
/// text is empty where no change fits, and where the present mean distance is within a quarter of a
/// mean edge. At most 32 positions are measured, so the cost is O(log faces) for positions near the
/// mesh.
std::string better_fit(const SurfaceMesh& mesh, const ClosestPoint& closest,
                       std::span<const Point> positions);

}  // namespace talweg
