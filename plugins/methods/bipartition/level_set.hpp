// A level set is the zero set of a function on the vertices, as curves.
#pragma once

#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::plugins {

/// The curves where the function, linear on each face, is 0, with its positive side on the left:
/// first those from boundary to boundary, then loops, each in the order of edge numbers. A vertex
/// where the function is 0 counts as positive, and points stay away from the ends of their edges,
/// so that curves are simple, disjoint and meet no vertex. `value` and `known` have one entry per
/// vertex; faces with an unknown corner have no curve. O(faces).
std::vector<SurfaceCurve> zero_set(const Surface& surface, const std::vector<double>& value,
                                   const std::vector<char>& known);

}  // namespace talweg::plugins
