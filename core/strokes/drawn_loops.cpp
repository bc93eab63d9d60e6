#include "talweg/core/strokes/drawn_loops.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/drawing/way_point.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

std::string note_on_loop(const ClosedLoop& loop) {
  if (loop.cut > loop.gap) {
    return fmt::format(
        "A curve runs over its own beginning; its ends, together {} long, were left out, and "
        "the curve is taken as a loop.",
        mesh_units_text(loop.cut));
  }
  return fmt::format("The ends of a curve lie {} apart; the curve is taken as a loop.",
                     mesh_units_text(loop.gap));
}

std::string note_on_gap(double gap) {
  return fmt::format(
      "The ends of a curve lie {} apart; the curve is taken as open. If a loop is meant, close "
      "the curve.",
      mesh_units_text(gap));
}

bool any_on(const PointLookup& points, const SnappedDrawing& drawing) {
  const auto is_on = [&](const SurfacePoint& point) { return points.contains(point); };
  return std::any_of(drawing.pins.begin(), drawing.pins.end(), is_on) ||
         std::any_of(drawing.way_points.begin(), drawing.way_points.end(),
                     [&](const WayPoint& way) { return is_on(way.point); });
}

/// Removes the marks of points that were cut off a stroke and lie on no curve of the drawing.
void forget_marks(const PointLookup& gone, SnappedDrawing& drawing) {
  PointLookup left;
  for (const SurfaceCurve& curve : drawing.curves) left.add_all(curve.points);
  const auto is_gone = [&](const SurfacePoint& point) {
    return gone.contains(point) && !left.contains(point);
  };
  std::erase_if(drawing.painted, is_gone);
  std::erase_if(drawing.all_exact, [&](const WayPoint& way) { return is_gone(way.point); });
}

}  // namespace

SnappedDrawing with_loops_closed(const SurfaceMesh& mesh, SnappedDrawing drawing,
                                 StraightLines& lines, CurveEnds ends) {
  if (ends == CurveEnds::kOpen) return drawing;
  for (std::size_t c = 0; c < drawing.curves.size(); ++c) {
    const bool always = ends == CurveEnds::kClosed;
    if (!always && (c >= drawing.may_be_loop.size() || !drawing.may_be_loop[c])) continue;
    std::optional<ClosedLoop> loop = closed_loop(mesh, drawing.curves[c], lines, always);
    if (!loop) {
      if (const auto gap = gap_of_near_loop(mesh, drawing.curves[c])) {
        drawing.notes.push_back(note_on_gap(*gap));
      }
      continue;
    }
    const std::vector<SurfacePoint> stroke = std::move(drawing.curves[c].points);
    const PointLookup kept(loop->curve.points);
    PointLookup gone;
    for (const SurfacePoint& point : stroke) {
      if (!kept.contains(point)) gone.add(point);
    }
    // A loop without a clicked point or a pin is joined again from the whole stroke.
    if (any_on(gone, drawing)) loop = ClosedLoop{lines.join(stroke, true), loop->gap, 0};
    drawing.curves[c] = std::move(loop->curve);
    if (!always || loop->cut > loop->gap) drawing.notes.push_back(note_on_loop(*loop));
    forget_marks(gone, drawing);
  }
  return drawing;
}

}  // namespace talweg
