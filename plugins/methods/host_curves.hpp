// Host curves are curves as a host gives them, which are put on a mesh and joined there.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/plugin/talweg_plugin.h"
#include "talweg/plugin/talweg_way_points.h"

namespace talweg::plugins {

/// Copies the host's arrays into our own memory, with the marks of the points
/// (talweg_way_points.h); nothing is checked against a mesh. Throws
/// plugin::Failure(TALWEG_BAD_USAGE) for an array that cannot be read or values that are no marks,
/// or when the numbers of faces and barycentrics or of points and marks differ, and
/// TALWEG_BAD_CURVE when there are no points.
CurveInput input_of(const talweg_curve& curve);

/// The extension of the plugins that read the marks.
const talweg_way_points* way_points_extension();

/// Snaps the curves to the mesh and joins their points straight over the surface.
/// Throws Error as snap() and StraightLines::join() do.
SnappedDrawing drawing_of(const SurfaceMesh& mesh, StraightLines& lines,
                          std::span<const talweg_curve* const> curves,
                          const SnapOptions& options = {});

}  // namespace talweg::plugins
