// The face beyond a window is the face that the window's paths enter; they reach its two other
// sides.
#pragma once

#include <array>
#include <optional>

#include "talweg/intrinsic/exact_distance/polyline_window.hpp"
#include "talweg/intrinsic/surface/plane_point.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Converts a window from the layout along the edge's own halfedge to the layout along `into`, and
/// back.
inline EdgeWindow laid_along(HalfedgeId into, const EdgeWindow& window, double length) {
  return into == halfedge_of(edge_of(into)) ? window : window.turned(length);
}

/// The face of the halfedge `into`, laid out with that halfedge from (0, 0) to (length, 0) and the
/// face above, so that sources lie below. Windows must be laid out along `into`, too. Their
/// continuations on another side are laid out along the twin of that side, into the next face.
struct FaceBeyond {
  HalfedgeId right, left;  ///< from the head of `into` to the apex, and from there to its tail
  double length = 0, right_length = 0, left_length = 0;
  PlanePoint top;  ///< the apex

  /// `into` must have a face.
  FaceBeyond(const Surface& surface, HalfedgeId into);

  using Stretch = std::array<double, 2>;  // of a side: begin, end
  /// The stretches of the two sides that straight paths through the window reach.
  struct Reached {
    std::optional<Stretch> right, left;
  };
  /// The source must not lie on the line of the window's edge.
  [[nodiscard]] Reached reached_through(const EdgeWindow& window) const;

  /// The window's source as seen through a stretch of the right (or left) side.
  [[nodiscard]] EdgeWindow through_right(const EdgeWindow& window, const Stretch& stretch) const;
  [[nodiscard]] EdgeWindow through_left(const EdgeWindow& window, const Stretch& stretch) const;
};

}  // namespace talweg
