// Host curves are a host's curves, which are put on a mesh and joined there.
#pragma once

#include <vector>

#include "host_mesh.hpp"
#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/plugin/talweg_plugin.h"
#include "talweg/plugin/talweg_way_points.h"

namespace talweg::plugins {

/// Copies the host's arrays into our own memory, with the marks of the points
/// (talweg_way_points.h); nothing is checked against a mesh. Throws
/// plugin::Failure(TALWEG_BAD_USAGE) for an array that cannot be read or values that are not marks,
/// or when the numbers of faces and barycentrics or of points and marks differ, and
/// TALWEG_BAD_CURVE when there are no points.
CurveInput input_of(const talweg_curve& curve);

/// The extension of plugins that read the marks.
const talweg_way_points* way_points_extension();

/// Snaps curves, in the numbers of the opened mesh, to it. Throws Error as snap() does.
std::vector<SnappedCurve> snapped_on(const HostMesh& mesh, const std::vector<CurveInput>& curves,
                                     const SnapOptions& options = {});
/// The same, with their points joined straight over the surface. Throws Error as
/// StraightLines::join() does, too.
SnappedDrawing drawing_of(const HostMesh& mesh, StraightLines& lines,
                          const std::vector<CurveInput>& curves);

}  // namespace talweg::plugins
