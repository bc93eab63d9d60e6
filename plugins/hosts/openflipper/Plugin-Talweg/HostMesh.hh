// Copies the host's meshes and lines to and from the arrays of talweg::editing. Computes no
// geometry.
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "HostTypes.hh"
#include "talweg/editing/mesh_arrays.hpp"
#include "talweg/editing/selection_order.hpp"

namespace talweg::openflipper {

/// Throws editing::Error for a mesh with deleted elements that are not yet collected: array indices
/// would differ from the host's indices.
std::shared_ptr<const editing::MeshArrays> arrays_of(const TriMesh& mesh);

/// The point of a drawing at which the mouse has hit a face.
editing::Point picked_on(const TriMesh& mesh, unsigned face, const ACG::Vec3d& hit);

ACG::Vec3d vector_at(const editing::MeshArrays& mesh, const editing::Point& point);

/// Makes a line of a result, with vertex, edge and face handles (-1: none), and with deviations as
/// scalars if the result has them.
void fill(PolyLine& line, const TriMesh& mesh, const host::Curve& result);
/// Makes a line of the points of a drawn curve.
void fill(PolyLine& line, const TriMesh& mesh, const editing::MeshArrays& arrays,
          const editing::Curve& drawn);

/// A curve of a line's points, which are moved onto the mesh later.
host::Curve positions_of(const PolyLine& line);

/// The selected edges or, without any, the selected vertices, in their order along the mesh. Throws
/// editing::Error without a selection, or if the selection has no order.
std::vector<editing::OrderedVertices> ordered_selection(TriMesh& mesh,
                                                        const editing::MeshArrays& arrays);

/// The largest finite value; 0 if no value is above 0.
double largest_of(const std::vector<double>& values);
/// Colours from blue (0) to red (the largest finite value); grey where a value is not finite.
std::vector<ACG::Vec4f> colours_of(const std::vector<double>& values);
void colour(TriMesh& mesh, const std::vector<double>& values);
/// Colours a line; `largest`, the largest value of all curves, is red.
void colour(PolyLine& line, const std::vector<double>& values, double largest);

}  // namespace talweg::openflipper
