// The ways into a face are all that reach a point inside it: through its sides, from its corners,
// and from curves in the face itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "talweg/intrinsic/exact_distance/nearest_on_curve.hpp"
#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"
#include "talweg/intrinsic/exact_distance/polyline_window.hpp"
#include "talweg/intrinsic/surface/plane_point.hpp"

namespace talweg {

/// A window of a side that leads into the face.
struct LedIn {
  EdgeWindow window;
  double lowest = 0;  ///< its smallest distance
  std::uint32_t side = 0;
  bool own = true;  ///< whether the window's x runs along the side rather than against it
};

/// Everything that a query inside a face reads, side by side in memory. Only views windows and
/// segments.
struct WaysIntoFace {
  std::array<SideFrame, 3> frames;
  std::array<NearestOnCurve, 3> corners;
  double longest = 0;  ///< side
  std::span<const LedIn> windows;
  std::span<const PolylinePiece> segments;  ///< in the face

  using Barycentric = std::array<double, 3>;  ///< in the order of Surface::corners()

  /// The shortest way to a point of the face, and where it comes from.
  struct Hit {
    NearestOnCurve nearest;
    std::size_t side = 0;  ///< the side in whose frame the way arrives
    const LedIn* window = nullptr;
    const PolylinePiece* segment = nullptr;  ///< if both are null: from the corner of that side
  };
  /// At most O(windows + segments of the face).
  [[nodiscard]] Hit hit(const Barycentric& b) const;

  /// The number of ways: one from each corner, through each window, and from each segment.
  [[nodiscard]] std::size_t count() const { return 3 + windows.size() + segments.size(); }
  /// Way number i < count() to a point of the face, whether it is the shortest or not. Its length
  /// is a convex function on the face, and the distance is the least of them.
  [[nodiscard]] Hit way(std::size_t i, const Barycentric& b) const;

  /// How the answer at b changes along a direction, one of the plane of frames[0].
  struct Slopes {
    double distance = 0;
    double arc_length = 0;
  };
  [[nodiscard]] Slopes slopes(const Hit& hit, const Barycentric& b, PlanePoint direction) const;

 private:
  using Corners = std::array<PlanePoint, 3>;  // one point in the frames of the three sides
  void offer_windows(const Corners& at, Hit& best) const;
  void offer_segments(PlanePoint at, Hit& best) const;
};

}  // namespace talweg
