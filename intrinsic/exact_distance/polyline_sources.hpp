// Polyline sources are the windows that curves send to the sides of the faces they run through.
#pragma once

#include <cstddef>
#include <optional>

#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"
#include "talweg/intrinsic/exact_distance/polyline_window.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

class WindowFront;

/// The window of a point inside a face, or on one of its sides, on side k: straight paths from the
/// point reach the whole side. Laid out in the side's frame, where the paths lead downwards, out of
/// the face.
EdgeWindow window_of_point(const PolylinePiece& point, const SideFrame& frame, std::size_t k);

/// The window of the interior of a segment on side k: parallel paths at right angles to the
/// segment. None if no such path reaches the side. Laid out as in window_of_point().
std::optional<EdgeWindow> window_of_segment(const PolylinePiece& segment, const SideFrame& frame,
                                            std::size_t k);

/// Sends all windows of the curves to the front, and starts the front at the curve points that are
/// vertices. Cost: the insertion of up to three windows per piece (window_front.hpp).
void send_pieces(const Surface& surface, const PolylinePieces& pieces, WindowFront& front);

/// A good step for the front: an eighth of the mean side of the curves' faces. The step affects
/// only the amount of superfluous work, not the result. O(pieces).
double step_width(const Surface& surface, const PolylinePieces& pieces);

}  // namespace talweg
