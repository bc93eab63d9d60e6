// Polyline sources are the windows that curves send to the sides of the faces they run through.
#pragma once

#include <cstddef>
#include <optional>

#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"
#include "talweg/intrinsic/exact_distance/polyline_window.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

class WindowFront;

/// What a point inside a face, or on one of its sides, sends to side k: the whole side is reached
/// straight from it. Laid out in the side's frame, where it leads downwards, out of the face.
EdgeWindow window_of_point(const PolylinePiece& point, const SideFrame& frame, std::size_t k);

/// What the inside of a segment sends to side k: parallel ways at right angles to it. None where no
/// such way reaches the side. Laid out as above.
std::optional<EdgeWindow> window_of_segment(const PolylinePiece& segment, const SideFrame& frame,
                                            std::size_t k);

/// Sends all windows of the curves, and starts from those of their points that are vertices. Up to
/// three windows for each piece, and what inserting them costs (window_front.hpp).
void send_pieces(const Surface& surface, const PolylinePieces& pieces, WindowFront& front);

/// A good step for the front: an eighth of the mean side of the curves' faces. It affects only the
/// amount of superfluous work, not the result. O(pieces).
double step_width(const Surface& surface, const PolylinePieces& pieces);

}  // namespace talweg
