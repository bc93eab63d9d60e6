// Curves as a host gives them, put on a mesh.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/plugin/talweg_plugin.h"

namespace talweg::plugins {

/// Reads what a host gives, into memory of our own; nothing is checked against a mesh.
/// Throws plugin::Failure(TALWEG_BAD_USAGE) for an array that cannot be read, or when there are not
/// as many barycentrics as faces, and TALWEG_BAD_CURVE when there are no points.
CurveInput input_of(const talweg_curve& curve);

struct Drawing {
  std::vector<SurfaceCurve> curves;
  std::vector<SurfacePoint> pins;
  double largest_snap_distance = 0;  ///< by which a position was moved onto the mesh, mesh units
  std::string moved;                 ///< a sentence on that, if any was
  bool far = false;                  ///< so far that the sentence comes first
  JoinedGaps gaps;
};

/// Snaps the curves to the mesh and joins their points straight over the surface.
/// Throws Error as snap() and StraightLines::join() do.
Drawing drawing_of(const SurfaceMesh& mesh, StraightLines& lines,
                   std::span<const talweg_curve* const> curves, const SnapOptions& options = {});

/// Adds sentences that tell of a curve that was moved onto the mesh, and of joined gaps; they come
/// first where it was moved far.
void add_drawing_warnings(const Drawing& drawing, std::vector<std::string>& warnings);

}  // namespace talweg::plugins
