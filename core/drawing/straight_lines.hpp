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

/// Gaps in a drawing: consecutive points that share no face and lie more than four times as far
/// apart as usual, which suggests that something is missing there. A quarter of the drawing's
/// length lies in segments no longer than usual, so that rests of the hand do not count. Clicked
/// points are all far apart, so they have no gaps.
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

/// Joins surface points by straight lines (geodesics). The memory is allocated once per object,
/// when it is first given points that share no face; a call costs what its lines touch. The surface
/// must outlive the object. One thread at a time.
class StraightLines {
 public:
  explicit StraightLines(const Surface& surface);
  StraightLines(StraightLines&&) noexcept;
  StraightLines& operator=(StraightLines&&) noexcept;
  ~StraightLines();

  /// A curve through the points, in order. Two points of a common face are joined inside it; others
  /// by the geodesic that FlipOut finds from a shortest edge path between them, which is locally,
  /// not always globally, shortest. Successive points that coincide count as one. Throws
  /// Error(kBadCurve) when two points lie on different components, or fewer than two (three if
  /// closed) different ones are left; Cancelled when `progress` (stage "draw") says so.
  SurfaceCurve join(std::span<const SurfacePoint> points, bool closed,
                    const Progress& progress = {});
  /// The gaps found by the last join().
  [[nodiscard]] const JoinedGaps& gaps() const { return gaps_; }

 private:
  void append_leg(const SurfacePoint& from, const SurfacePoint& to,
                  std::vector<SurfacePoint>& points, const Progress& progress);
  void append_line(const SurfacePoint& from, const SurfacePoint& to,
                   std::vector<SurfacePoint>& points, const Progress& progress);
  [[nodiscard]] VertexId nearest_corner(const SurfacePoint& point) const;

  /// Takes O(mesh) memory; needed only where two points share no face.
  struct Workshop;

  const Surface* surface_;
  void find_gaps();

  JoinedGaps gaps_;
  std::vector<double> legs_;    // lengths, mesh units, of the last join()
  std::vector<double> joined_;  // lengths of the legs through several faces
  std::unique_ptr<Workshop> workshop_;
};

/// The point itself, or the vertex or else the point on an edge from which it is at most 1e-9 away,
/// in barycentric coordinates of its face or as a part of its edge. Straight lines cannot be
/// straightened from a point that lies a rounding beside a vertex: the directions of what lies
/// between are noise. O(1).
SurfacePoint settled(const Surface& surface, const SurfacePoint& point);

}  // namespace talweg
