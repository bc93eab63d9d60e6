#include "talweg/core/measure/bounded_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "talweg/core/measure/coarse_distance.hpp"
#include "talweg/core/measure/segments_in_space.hpp"

namespace talweg {
namespace {

/// Bounds of the maximum and the mean distance over a stretch with distances of at most a and b at
/// its ends. A distance changes at most as fast as its point moves (slope 1).
struct Tent {
  double most = 0, mean = 0;

  Tent(double a, double b, double length) {
    const double low = std::min(a, b), high = std::min(std::max(a, b), low + length);
    most = (low + high + length) / 2;
    mean = (low + high) / 2;
    if (length > 0 && std::isfinite(high))
      mean += (length - (high - low) * (high - low) / length) / 4;
  }
};

/// A segment of length 0 for each curve of one point, which has no other segments.
std::vector<CurveSegment> points_of(const Surface& surface, std::span<const SurfaceCurve> curves) {
  std::vector<CurveSegment> points;
  for (const SurfaceCurve& curve : curves) {
    if (curve.points.size() != 1) continue;
    const SurfacePoint& at = curve.points.front();
    points.push_back(segment_between(surface, at, at, any_face(surface, at)));
  }
  return points;
}

class Bounds {
 public:
  Bounds(const SurfaceMesh& mesh, std::span<const SurfaceCurve> others)
      : mesh_(&mesh), coarse_(mesh.surface(), others), space_(mesh, others) {}

  void add(const CurveSegment& segment, const KnownSegment& known) {
    const CoarseDistance::OnSegment rough = coarse_.on(segment);
    const Tent whole(rough.first, rough.last, segment.length);
    double most = std::min({rough.most, whole.most, known.most}), mean = whole.mean;
    if (std::isfinite(known.first + known.middle + known.last)) {
      const Tent first(known.first, known.middle, segment.length / 2);
      const Tent second(known.middle, known.last, segment.length / 2);
      most = std::min(most, std::max(first.most, second.most));
      mean = std::min(mean, (first.mean + second.mean) / 2);
    }
    const SurfacePoint middle = segment.point(mesh_->surface(), 0.5);
    least_ = std::max(least_, space_.tree().to(mesh_->position(middle)).distance);
    if (!at_ || most > most_) {
      most_ = most;
      at_ = middle;
    }
    length_ += segment.length;
    integral_ += segment.length > 0 ? segment.length * mean : 0;
  }

  /// The bounds, given the largest exact distance found.
  [[nodiscard]] OneSidedSurfaceDeviation result(double largest) const {
    OneSidedSurfaceDeviation result{std::max(most_, largest),
                                    length_ > 0 ? integral_ / length_ : most_, *at_};
    result.exact = false;
    result.at_least = std::min(std::max(least_, largest), result.max);
    return result;
  }

 private:
  const SurfaceMesh* mesh_;
  CoarseDistance coarse_;
  SegmentsInSpace space_;
  double most_ = 0, least_ = 0;
  double length_ = 0, integral_ = 0;
  std::optional<SurfacePoint> at_;
};

}  // namespace

OneSidedSurfaceDeviation bounded_deviation(const SurfaceMesh& mesh,
                                           std::span<const SurfaceCurve> from,
                                           std::span<const CurveSegment> segments,
                                           std::span<const SurfaceCurve> others,
                                           std::span<const KnownSegment> known, double largest) {
  Bounds bounds(mesh, others);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    bounds.add(segments[i], i < known.size() ? known[i] : KnownSegment{});
  }
  for (const CurveSegment& point : points_of(mesh.surface(), from)) bounds.add(point, {});
  return bounds.result(largest);
}

}  // namespace talweg
