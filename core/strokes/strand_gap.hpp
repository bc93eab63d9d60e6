// The strand gap of a stroke is the distance between parts of it that run beside each other.
#pragma once

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The least distance through space of two parts of a stroke that run beside each other, such as
/// the legs of a U or the turns of a coil. Such parts are at least `apart` from each other along
/// the stroke and between `least` and `most` through space. They lie on the same side of the
/// surface, are parallel or antiparallel within 35 degrees, and approach or leave each other by no
/// more than a third. All lengths are in mesh units; infinite where no such parts exist. The stroke
/// is walked in steps of `step`. O(n log n) for n steps, and the pairs within `most`.
double strand_gap(const SurfaceMesh& mesh, const SurfaceCurve& stroke, double step, double apart,
                  double least, double most);

}  // namespace talweg
