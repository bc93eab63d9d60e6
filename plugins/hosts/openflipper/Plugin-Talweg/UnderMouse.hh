// Finds the object under the mouse: a place on a mesh, a drawn point, or a curve.
#pragma once

#include <QPoint>
#include <optional>

#include "Sessions.hh"

namespace talweg::openflipper {

/// A drawn point.
struct Handle {
  std::size_t curve, point;
};

struct CurvePlace {
  std::size_t curve;
  const host::Curve* line;  ///< the picked line; valid until the session changes
  std::size_t segment;      ///< segment of the line
};

struct Picked {
  Session* session;
  std::optional<editing::Point> point;  ///< empty: beside the mesh
};

class UnderMouse {
 public:
  UnderMouse(Sessions& sessions, HostCalls& host) : sessions_(sessions), host_(host) {}

  /// The point under the mouse, on the mesh of the current drawing; if the mouse is not `held` and
  /// no curve is being drawn, on any target. Empty beside all of them.
  std::optional<Picked> picked(const QPoint& at, bool held);
  /// The same by the search tree of the current mesh, if nothing else can be under the mouse. The
  /// host would have to draw its whole scene.
  std::optional<Picked> picked_by_us(const QPoint& at);
  /// The nearest visible drawn point within a few pixels.
  [[nodiscard]] std::optional<Handle> handle(const QPoint& at) const;
  /// The nearest visible curve within a few pixels, smoothed or as drawn.
  [[nodiscard]] std::optional<CurvePlace> curve(const QPoint& at) const;

 private:
  std::optional<Picked> picked_by_host(const QPoint& at, bool held);
  [[nodiscard]] bool is_alone() const;

  Sessions& sessions_;
  HostCalls& host_;
};

}  // namespace talweg::openflipper
