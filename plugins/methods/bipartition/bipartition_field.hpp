// The bipartition field is a function whose zero set is the relaxed border of a bipartition.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg::plugins {

struct BipartitionOptions {
  double heat_time = 1;      ///< in squared mean edge lengths, > 0
  int passes = 5;            ///< number of smoothing passes over the directions, >= 0
  double anchor = 0.1;       ///< > 0: how strongly the border is held
  bool area_weights = true;  ///< whether faces count by their area; otherwise equally
  bool guard = true;  ///< whether faces of sources only take the directions of their neighbours
};

struct BipartitionField {
  std::vector<double> phi;          ///< per vertex; < 0 and > 0 on the two sides
  std::vector<char> known;          ///< per vertex: whether it is connected with the border
  std::size_t border_vertices = 0;  ///< number of sources
  std::size_t source_faces = 0;     ///< faces with three sources, where the gradient is 0
  bool cancelled = false;
};

/// The method of Livesu, "A Heat Flow Relaxation Scheme for n Dimensional Discrete Hyper Surfaces"
/// (Computers & Graphics 2018). `side`, 0 or 1 per face, is the bipartition; its border is the set
/// of vertices with faces of both sides.
///
/// Heat flows for a time from the border, which is kept at 1. Its gradients are normalised,
/// reversed on side 1, and smoothed; then phi minimises |S phi - div|² + anchor² |phi on the
/// border|², where S is the cotan Laplacian and div the divergence of the directions. Parts of the
/// mesh without border keep phi = 0.
/// Throws Error(kNumerical) if the systems cannot be solved, Error(kOutOfMemory).
BipartitionField relax_bipartition(const SurfaceMesh& mesh, const std::vector<char>& side,
                                   const BipartitionOptions& options, const Progress& progress);

}  // namespace talweg::plugins
