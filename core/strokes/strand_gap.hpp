// The strand gap of a stroke is the way between parts of it that run beside each other.
#pragma once

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The least distance through space of two parts of a stroke that run beside each other, as the
/// legs of a U do and the turns of a coil: at least `apart` along the way from each other, within
/// 35 degrees of parallel or antiparallel, neither drawing together nor apart by more than a third,
/// and at least `least` and at most `most` from each other, on the same side of the surface. All in
/// mesh units; infinite where there are none. The stroke is walked in steps of `step`. O(n log n)
/// for n steps, and the pairs within `most`.
double strand_gap(const SurfaceMesh& mesh, const SurfaceCurve& stroke, double step, double apart,
                  double least, double most);

}  // namespace talweg
