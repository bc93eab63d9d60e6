// The direction field has a unit vector on each face, from the heat of the sources, smoothed.
#pragma once

#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/heat/heat_flow.hpp"

namespace talweg::plugins {

/// One vector in space per face, of length 1, or 0 where the face has no direction.
using DirectionField = std::vector<Point>;

/// grad u / |grad u| of each face, reversed on side 1, so that directions continue across the
/// border; 0 where u is constant, and where `skipped` is set. `side` and `skipped` have one entry
/// per face.
DirectionField gradient_directions(const SurfaceMesh& mesh, const ScaledField& u,
                                   const std::vector<char>& side, const std::vector<char>& skipped);

/// Gives faces without a direction the mean of their neighbours' directions, ring by ring. Returns
/// the number of these faces.
std::size_t fill_directions(const Surface& surface, DirectionField& field);

/// Replaces every direction `passes` times by the mean of itself and those of the adjacent faces,
/// all at once.
void smooth_directions(const Surface& surface, DirectionField& field, int passes);

/// Per vertex i the sum over its faces of w X · grad λ_i, where λ_i is the hat function and w is
/// the face's area (which gives the divergence of X) or 1.
std::vector<double> divergence(const SurfaceMesh& mesh, const DirectionField& field,
                               bool area_weights);

}  // namespace talweg::plugins
