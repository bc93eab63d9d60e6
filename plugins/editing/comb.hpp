// A comb shows the geodesic curvature of a curve: its teeth stand across the curve on the surface,
// and a tooth is as long as the curvature there is large.
#pragma once

#include <vector>

#include "mesh_arrays.hpp"
#include "vectors.hpp"

namespace talweg::editing {

struct Tooth {
  Vector root;       ///< on the curve
  Vector out;        ///< unit vector across the curve, away from the side to which the curve turns
  double curvature;  ///< geodesic curvature, >= 0, 1 / mesh unit
};

/// Teeth at equal distances of about `spacing` (mesh units, > 0) along a result curve of
/// talweg.smooth with point fields. A tooth has the mean curvature of the curve up to the next
/// tooth on both sides, since a polyline turns only at its points. Throws Error if the curve has no
/// field "curvature", or if `spacing` is not more than 0.
std::vector<Tooth> comb_of(const MeshArrays& mesh, const host::Curve& curve, double spacing);

}  // namespace talweg::editing
