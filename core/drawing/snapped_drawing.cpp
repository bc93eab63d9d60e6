#include "talweg/core/drawing/snapped_drawing.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "talweg/core/space/message_numbers.hpp"

namespace talweg {
namespace {

/// The way-points of a curve under PointMeaning::kExact.
std::vector<InputWayPoint> exact_points(const SnappedCurve& curve) {
  if (!curve.way_points.empty()) return curve.way_points;
  std::vector<InputWayPoint> all;
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    if (!std::binary_search(curve.painted.begin(), curve.painted.end(), k)) all.push_back({k, 0});
  }
  return all;
}

/// The largest of the first three steps of a stroke, and the largest of its last three; 0 for
/// curves that are not strokes of a hand.
std::array<double, 2> steps_at_ends(const SurfaceMesh& mesh, const SnappedCurve& curve) {
  constexpr std::size_t kSteps = 3;
  std::array<double, 2> steps{};
  if (!curve.of_hand) return steps;
  const std::size_t n = curve.points.size();
  const auto step = [&](std::size_t k) {
    return (mesh.position(curve.points[k + 1]) - mesh.position(curve.points[k])).norm();
  };
  for (std::size_t k = 0; k < std::min(kSteps, n - 1); ++k) {
    steps[0] = std::max(steps[0], step(k));
    steps[1] = std::max(steps[1], step(n - 2 - k));
  }
  return steps;
}

/// Adds sentences on the ends of a curve that run over the border.
void tell_beyond_border(const SnappedCurve& curve, std::size_t number,
                        std::vector<std::string>& notes) {
  for (std::size_t side = 0; side < 2; ++side) {
    const BeyondBorder& beyond = curve.beyond_border[side];
    if (beyond.points == 0) continue;
    notes.push_back(fmt::format(
        "Curve {} runs over the border of the mesh at its {}: {} {} up to {} beyond the "
        "border {} left out, and the curve {} exactly at the border.",
        number, side == 0 ? "start" : "end", beyond.points, beyond.points == 1 ? "point" : "points",
        mesh_units_text(beyond.farthest), beyond.points == 1 ? "is" : "are",
        side == 0 ? "begins" : "ends"));
  }
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
    notes.insert(notes.end(), curve.notes.begin(), curve.notes.end());
    if (better_fit.empty()) better_fit = curve.better_fit;
    tell_beyond_border(curve, curves.size(), notes);
    may_be_loop.push_back(curve.may_be_loop);
    hand_steps.push_back(steps_at_ends(mesh, curve));
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
  sentences.insert(sentences.end(), notes.begin(), notes.end());
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
