#include "talweg/core/drawing/snapped_drawing.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace talweg {
namespace {

/// The points of a curve that are way-points if it is taken exactly.
std::vector<InputWayPoint> exact_points(const SnappedCurve& curve) {
  if (!curve.way_points.empty()) return curve.way_points;
  std::vector<InputWayPoint> all;
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    if (!std::binary_search(curve.painted.begin(), curve.painted.end(), k)) all.push_back({k, 0});
  }
  return all;
}

}  // namespace

void SnappedDrawing::add(const SurfaceMesh& mesh, std::span<const SnappedCurve> snapped,
                         StraightLines& lines, const Progress& progress) {
  for (const SnappedCurve& curve : snapped) {
    for (const std::size_t pin : curve.pins) pins.push_back(curve.points[pin]);
    for (const InputWayPoint& way : curve.way_points) {
      way_points.push_back({curve.points[way.point], way.tolerance});
    }
    for (const InputWayPoint& way : exact_points(curve)) {
      all_exact.push_back({curve.points[way.point], way.tolerance});
    }
    for (const std::size_t k : curve.painted) painted.push_back(curve.points[k]);
    if (!curve.why_stroke.empty()) strokes.push_back(curve.why_stroke);
    told.insert(told.end(), curve.told.begin(), curve.told.end());
    if (better_fit.empty()) better_fit = curve.better_fit;
    may_be_loop.push_back(curve.may_be_loop);
    curves.push_back(lines.join(curve.points, curve.closed, progress));
    gaps.add(lines.gaps());
    if (curve.way_points.empty()) gaps_in_strokes.add(lines.gaps());
    largest_snap_distance = std::max(largest_snap_distance, curve.largest_snap_distance);
  }
  moved = snap_warning(largest_snap_distance, mesh);
  if (!better_fit.empty()) moved += fmt::format(" It {}.", better_fit);
  far = moved_far(largest_snap_distance, mesh) || !better_fit.empty();
}

std::vector<std::string> SnappedDrawing::warnings() const {
  std::vector<std::string> sentences;
  if (!moved.empty()) sentences.push_back(moved);
  sentences.insert(sentences.end(), told.begin(), told.end());
  if (gaps.count > 0) sentences.push_back(gap_warning(gaps));
  return sentences;
}

std::vector<std::string> SnappedDrawing::decisive() const {
  std::vector<std::string> sentences;
  if (far) sentences.push_back(moved);
  if (gaps_in_strokes.count > 0) sentences.push_back(gap_warning(gaps));
  return sentences;
}

}  // namespace talweg
