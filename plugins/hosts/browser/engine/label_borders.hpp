// Borders between the labels of triangles, as curves to smooth.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh_files.hpp"

namespace talweg::browser {

/// A label for each triangle, from the mesh's first attribute with a whole number for each
/// triangle. Throws editing::Error if there is none.
std::vector<double> labels_of(const FileMesh& mesh);

/// Strokes along the edges between triangles of different labels. Strokes end where more than two
/// labels meet. Throws editing::Error for a wrong number of labels, and if there is no border.
std::vector<editing::Curve> label_borders(const editing::MeshArrays& mesh,
                                          const std::vector<double>& labels);

}  // namespace talweg::browser
