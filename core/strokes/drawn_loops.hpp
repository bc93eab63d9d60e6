// Drawn loops are strokes of a drawing whose hand meant a closed curve.
#pragma once

#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/strokes/loop_closing.hpp"

namespace talweg {

/// The drawing after closed_loop() has closed the strokes that are meant as loops. Sentences tell
/// of loops closed without the user's request, and of the gaps that gap_of_near_loop() finds. With
/// CurveEnds::kAsDrawn, only strokes that were given as positions or painted, and have no
/// way-points, are closed. Pins and way-points are never cut off. Throws as StraightLines::join().
SnappedDrawing with_loops_closed(const SurfaceMesh& mesh, SnappedDrawing drawing,
                                 StraightLines& lines, CurveEnds ends);

}  // namespace talweg
