// What is under the mouse: a place on a mesh, a drawn point, a curve.
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
  const host::Curve* line;  ///< on which it was met; until the session changes
  std::size_t segment;      ///< of that
};

struct Picked {
  Session* session;
  std::optional<editing::Point> point;  ///< none: beside the mesh
};

class UnderMouse {
 public:
  UnderMouse(Sessions& sessions, HostCalls& host) : sessions_(sessions), host_(host) {}

  /// The point on the mesh that is drawn on or, where it is not `held` and nothing is drawn now, on
  /// any target; nothing beside all of them.
  std::optional<Picked> picked(const QPoint& at, bool held);
  /// The same by the tree of triangles of the mesh that is worked on, where that is the only thing
  /// that the mouse can meet. The host draws its whole scene to tell.
  std::optional<Picked> picked_by_us(const QPoint& at);
  /// The drawn point within a few pixels, the nearest one that can be seen.
  [[nodiscard]] std::optional<Handle> handle(const QPoint& at) const;
  /// The curve within a few pixels, as it is smoothed or as it was drawn, the nearest one that can
  /// be seen there.
  [[nodiscard]] std::optional<CurvePlace> curve(const QPoint& at) const;

 private:
  std::optional<Picked> picked_by_host(const QPoint& at, bool held);
  [[nodiscard]] bool is_alone() const;

  Sessions& sessions_;
  HostCalls& host_;
};

}  // namespace talweg::openflipper
