// Drawn loops are the strokes of a drawing whose hand meant a loop.
#pragma once

#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/strokes/loop_closing.hpp"

namespace talweg {

/// The drawing with the loops of closed_loop() closed, and told of where nobody asked for them; of
/// gap_of_near_loop() is told, too. As drawn, only strokes are looked at that were given as
/// positions, or painted, without way-points. Pins and way-points are never cut off. Throws as
/// StraightLines::join().
SnappedDrawing with_loops_closed(const SurfaceMesh& mesh, SnappedDrawing drawing,
                                 StraightLines& lines, CurveEnds ends);

}  // namespace talweg
