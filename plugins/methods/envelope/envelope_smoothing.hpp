// Envelope smoothing is Laplacian smoothing along the edges of a mesh, inside a distance envelope.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::plugins {

struct EnvelopeOptions {
  double envelope = 0;           ///< mesh units, > 0: largest distance of nodes from the drawing
  std::size_t iterations = 500;  ///< largest number of rounds, >= 1
  double weight = 1;             ///< part of a step, (0, 1]: 1 goes to the best place at once
  double tolerance = 1e-6;  ///< >= 0: stops when a round shortens the curves by a smaller fraction
  /// Called before every round with its number; false stops, and the result is that of the last
  /// round.
  std::function<bool(std::size_t round)> go_on;
};

struct EnvelopeResult {
  std::vector<SurfaceCurve> curves;  ///< one per drawn curve
  std::vector<char> collapsed;       ///< per curve: its loop got shorter than three mesh edges
  std::size_t rounds = 0;
  std::size_t splits = 0;  ///< vertices over which a curve has passed
  std::size_t merges = 0;  ///< nodes that were removed
  bool converged = false;  ///< whether it stopped by the tolerance
  bool cancelled = false;
};

/// The method of Lawonn, Gasteiger, Rössl & Preim (2014). The curves' points lie on mesh edges and
/// slide along them. In each round first every other node, then the rest, moves to the place on its
/// edge that minimises |p - a|²/|a - p0| + |p - b|²/|b - p0|, where a and b are its neighbours and
/// p0 is its present place (`weight` of the way). A node that comes to a vertex of the mesh becomes
/// a node there. Where the curve can be shorter on one side of the vertex, the node splits into one
/// node for each edge on that side. Two nodes in one place merge, and so does a node whose two
/// neighbours share a face with its edge. No step makes the curve longer. A step ends where its
/// node would be farther from the drawn curves than the envelope, measured as exact distance along
/// the surface.
///
/// Ends, pins, and vertices that the drawn curves pass more than once stay. Curves never pass each
/// other or themselves, so each stays in its isotopy class unless it has `collapsed`, or comes to
/// or leaves the boundary of the mesh. Throws Error(kBadCurve) where two neighbours of a drawn
/// curve share no face, or an open curve ends where it begins.
EnvelopeResult smooth_in_envelope(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                  std::span<const SurfacePoint> pins,
                                  const EnvelopeOptions& options);

}  // namespace talweg::plugins
