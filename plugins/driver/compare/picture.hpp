// The picture of a comparison shows all methods' curves.
#pragma once

#include <string>

#include "compare/comparison.hpp"

namespace talweg::driver {

/// A PNG with the drawing and all results in one panel, and one panel per method with the place
/// where the drawing turns most. In a sweep the run whose deviation is nearest to 1.5 edges is
/// drawn. Throws Error as picture::render() and png_bytes() do.
std::string comparison_picture(const Comparison& comparison, const MeshLists& mesh);

}  // namespace talweg::driver
