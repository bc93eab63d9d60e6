// The part of a report that is measured on the curves.
#pragma once

#include <cstddef>

#include "talweg/core/measures.hpp"
#include "talweg/core/report.hpp"
#include "talweg/core/surface_mesh.hpp"
#include "talweg/intrinsic/signpost_triangulation.hpp"

namespace talweg {

/// Points, lengths, curvatures and deviations before and after. `before` are the measures of the
/// drawing. O((m + n) log n) for curves of m and n points.
SmoothingReport report_on_curve(const SurfaceMesh& mesh, const SurfaceCurve& drawn,
                                const CurveMeasures& before, const SurfaceCurve& result);

/// Faces of the surface with a corner whose directions have been laid out. O(touched).
std::size_t count_touched_faces(const SignpostTriangulation& triangulation);

}  // namespace talweg
