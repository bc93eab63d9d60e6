// A comb shows how a curve turns: teeth across it on the surface, as long as it is curved there.
#pragma once

#include <vector>

#include "mesh_arrays.hpp"
#include "vectors.hpp"

namespace talweg::editing {

struct Tooth {
  Vector root;       ///< on the curve
  Vector out;        ///< across the curve in the surface, away from the side it turns to; length 1
  double curvature;  ///< geodesic, >= 0, 1 / mesh unit
};

/// Teeth at equal distances of about `spacing` (mesh units) along a curve that talweg.smooth gave
/// with point fields. Each has the mean curvature of the curve within `spacing` on both sides: a
/// polyline turns only at its points. Throws Error for a curve without curvatures or a spacing of
/// 0.
std::vector<Tooth> comb_of(const MeshArrays& mesh, const host::Curve& curve, double spacing);

}  // namespace talweg::editing
