// Face paths are the paths that reach points inside a face: through its sides, from its
// corners, and from curves in the face itself.
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
struct EnteringWindow {
  EdgeWindow window;
  double lowest = 0;  ///< its smallest distance
  std::uint32_t side = 0;
  bool own = true;  ///< whether the window's x runs along the side rather than against it
};

/// The data that a query inside a face reads, side by side in memory. Windows and segments are
/// views.
struct FacePaths {
  std::array<SideFrame, 3> frames;
  std::array<NearestOnCurve, 3> corners;
  double longest = 0;  ///< length of the longest side
  std::span<const EnteringWindow> windows;
  std::span<const PolylinePiece> segments;  ///< in the face

  using Barycentric = std::array<double, 3>;  ///< in the order of Surface::corners()

  /// The shortest path to a point of the face, and its origin.
  struct Hit {
    NearestOnCurve nearest;
    std::size_t side = 0;  ///< the side in whose frame the path arrives
    const EnteringWindow* window = nullptr;
    const PolylinePiece* segment = nullptr;  ///< both null: a path from corner `side`
  };
  /// At most O(windows + segments of the face).
  [[nodiscard]] Hit hit(const Barycentric& b) const;

  /// The number of paths: one from each corner, through each window, and from each segment.
  [[nodiscard]] std::size_t count() const { return 3 + windows.size() + segments.size(); }
  /// Path number i < count() to a point of the face, whether it is the shortest or not. The length
  /// of a path is a convex function on the face, and the distance is the least length.
  [[nodiscard]] Hit path(std::size_t i, const Barycentric& b) const;

  /// The derivatives of the answer at b along a direction in the plane of frames[0].
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
