// Straight lines join the points of a drawing over the surface.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Gaps in a drawing: pairs of successive points that share no face and lie more than four times
/// the usual distance apart, which suggests missing points. The usual distance is the length up to
/// which segments make a quarter of the drawing's length, so that rests of the hand do not count.
/// Drawings through clicks have no gaps, because all their points are far apart.
struct JoinedGaps {
  std::size_t count = 0;
  double longest = 0;  ///< mesh units

  void add(const JoinedGaps& more) {
    count += more.count;
    longest = std::max(longest, more.longest);
  }
};

/// A sentence that reports the gaps; empty where there are none.
std::string gap_warning(const JoinedGaps& gaps);

/// Joins surface points by straight lines (geodesics). An object allocates its memory once, at the
/// first points that share no face; a call costs O(faces that its lines touch). The surface must
/// outlive the object. One thread at a time.
class StraightLines {
 public:
  explicit StraightLines(const Surface& surface);
  StraightLines(StraightLines&&) noexcept;
  StraightLines& operator=(StraightLines&&) noexcept;
  ~StraightLines();

  /// A curve through the points, in order. Two points of a common face are joined inside it. Other
  /// points are joined by the geodesic that FlipOut finds from the shortest edge path between
  /// corners of their faces. The geodesic is no longer than this path, and locally, not always
  /// globally, shortest. Successive points that coincide count as one. Throws Error(kBadCurve) when
  /// two points lie on different components, or when fewer than two different points (three if
  /// closed) remain; throws Cancelled when `progress` (stage "draw") says so.
  SurfaceCurve join(std::span<const SurfacePoint> points, bool closed,
                    const Progress& progress = {});
  /// The gaps found by the last join().
  [[nodiscard]] const JoinedGaps& gaps() const { return gaps_; }

 private:
  void append_leg(const SurfacePoint& from, const SurfacePoint& to,
                  std::vector<SurfacePoint>& points, const Progress& progress);
  void append_line(const SurfacePoint& from, const SurfacePoint& to,
                   std::vector<SurfacePoint>& points, const Progress& progress);

  /// Takes O(mesh) memory; needed only where two points share no face.
  struct Workshop;

  const Surface* surface_;
  void find_gaps();

  JoinedGaps gaps_;
  std::vector<double> legs_;    // lengths, mesh units, of the last join()
  std::vector<double> joined_;  // lengths of the legs through several faces
  std::unique_ptr<Workshop> workshop_;
};

/// The point itself, or the vertex or else the point on an edge at most 1e-9 away, in barycentric
/// coordinates of the point's face or as a part of its edge. A geodesic from a point that lies a
/// rounding beside a vertex cannot be straightened, because the directions of the tiny edges
/// between them are noise. O(1).
SurfacePoint settled(const Surface& surface, const SurfacePoint& point);

}  // namespace talweg
