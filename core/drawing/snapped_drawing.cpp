#include "talweg/core/drawing/snapped_drawing.hpp"

#include <algorithm>

namespace talweg {

void SnappedDrawing::add(const SurfaceMesh& mesh, std::span<const SnappedCurve> snapped,
                         StraightLines& lines, const Progress& progress) {
  for (const SnappedCurve& curve : snapped) {
    for (const std::size_t pin : curve.pins) pins.push_back(curve.points[pin]);
    curves.push_back(lines.join(curve.points, curve.closed, progress));
    gaps.add(lines.gaps());
    largest_snap_distance = std::max(largest_snap_distance, curve.largest_snap_distance);
  }
  moved = snap_warning(largest_snap_distance, mesh);
  far = moved_far(largest_snap_distance, mesh);
}

std::vector<std::string> SnappedDrawing::warnings() const {
  std::vector<std::string> sentences;
  if (!moved.empty()) sentences.push_back(moved);
  if (gaps.count > 0) sentences.push_back(gap_warning(gaps));
  return sentences;
}

}  // namespace talweg
