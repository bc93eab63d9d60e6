// Measures whether the result depends on τ without jumps.
#include <algorithm>
#include <optional>

#include "talweg/core/measure/deviation.hpp"
#include "talweg/core/measure/edge_length_near.hpp"
#include "tools/quality/runs.hpp"

namespace talweg::quality {

Sweep sweep(const Subject& subject, const NamedPath& drawing, const CurveOptions& curve_options) {
  const SurfaceMesh& mesh = subject.mesh->mesh();
  CurveSmoother smoother(subject.mesh);
  smoother.set_curve(drawing.curve(mesh.surface()), curve_options);
  const double edge = edge_length_near(mesh.surface(), drawing.curve(mesh.surface()));
  Sweep result{subject.name, drawing.name};
  std::vector<Point> before;
  double deviation_before = 0;
  for (double tau = 0.25; tau <= 4; tau *= 1.01) {
    const SmoothingResult smoothed = smoother.smooth(tau);
    const SmoothingReport& report = smoothed.report();
    const double now = std::max(report.deviation_to_drawn_max, report.deviation_from_drawn_max);
    std::vector<Point> points = positions_of(mesh, smoothed.curve());
    if (!before.empty()) {
      const Deviation moved = deviation(points, drawing.closed, before, drawing.closed);
      const double move = std::max(moved.to_drawn.max, moved.from_drawn.max) / edge;
      const double rise = (now - deviation_before) / edge;
      ++result.steps;
      if (rise > 0.1) ++result.rises;
      if (move > 0.2) ++result.moves;
      result.largest_move = std::max(result.largest_move, move);
      result.largest_rise = std::max(result.largest_rise, rise);
    }
    before = std::move(points);
    deviation_before = now;
  }
  return result;
}

}  // namespace talweg::quality
