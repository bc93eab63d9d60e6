// The host's meshes and lines are copied to and from the arrays of talweg::editing, without
// geometry. Copies, and no geometry.
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "HostTypes.hh"
#include "talweg/editing/mesh_arrays.hpp"
#include "talweg/editing/selection_order.hpp"

namespace talweg::openflipper {

/// Throws editing::Error for a mesh with elements that are deleted but not yet collected: their
/// numbers would not be those of the host.
std::shared_ptr<const editing::MeshArrays> arrays_of(const TriMesh& mesh);

/// The point of a drawing where the mouse has hit a face.
editing::Point picked_on(const TriMesh& mesh, unsigned face, const ACG::Vec3d& hit);

ACG::Vec3d vector_at(const editing::MeshArrays& mesh, const editing::Point& point);

/// A result as a line with vertex, edge and face handles (-1: at none) and, where the result has
/// them, deviations as scalars.
void fill(PolyLine& line, const TriMesh& mesh, const host::Curve& result);
/// The points of a drawn curve.
void fill(PolyLine& line, const TriMesh& mesh, const editing::MeshArrays& arrays,
          const editing::Curve& drawn);

/// A line's points, to be put onto a mesh.
host::Curve positions_of(const PolyLine& line);

/// Selected vertices or, where edges are selected, these; in their order along the mesh. Throws
/// editing::Error where nothing is selected or the selection has no order.
std::vector<editing::OrderedVertices> ordered_selection(TriMesh& mesh,
                                                        const editing::MeshArrays& arrays);

/// Of the finite values; 0 without any above it.
double largest_of(const std::vector<double>& values);
/// Colours from blue (0) to red (the largest finite value); grey where a value is not finite.
std::vector<ACG::Vec4f> colours_of(const std::vector<double>& values);
void colour(TriMesh& mesh, const std::vector<double>& values);
/// The largest of all curves' values is red in each.
void colour(PolyLine& line, const std::vector<double>& values, double largest);

}  // namespace talweg::openflipper
