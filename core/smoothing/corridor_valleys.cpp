#include "talweg/core/smoothing/corridor_valleys.hpp"

#include <algorithm>
#include <cstddef>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/corridor_width.hpp"
#include "talweg/core/smoothing/curve_gaps.hpp"

namespace talweg {
namespace {

/// Narrows the slack of curves to less than half of their gaps: nothing would keep curves apart
/// whose slacks overlap.
void keep_apart(std::vector<Corridor::Valley>& valleys, const SurfaceMesh& mesh,
                const OrderedDrawing& drawing, const Progress& progress) {
  constexpr double kOfGap = 0.45;
  double most = 0;
  for (const Corridor::Valley& valley : valleys) most = std::max(most, valley.slack);
  const std::vector<double> gaps = gaps_to_others(mesh, drawing.curves(), most / kOfGap, progress);
  for (std::size_t c = 0; c < gaps.size(); ++c) {
    valleys[c].slack = std::min(valleys[c].slack, kOfGap * gaps[c]);
    valleys[c].apart = gaps[c] / 2;
  }
}

/// The slack along a curve as estimated, scaled by the same factor as the valley's slack.
std::vector<double> own_field(const Corridor::Valley& valley, const SurfaceMesh& mesh,
                              const OrderedDrawing& drawing, std::size_t curve) {
  const StrokeSlack& slack = drawing.slacks()[curve];
  std::vector<double> field = slack_at_points(mesh, drawing.curves()[curve], slack);
  for (double& value : field) value *= valley.slack / slack.slack;
  return field;
}

}  // namespace

std::vector<Corridor::Valley> valleys_of(const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                         const Progress& progress) {
  constexpr std::size_t kOfPoint = 16;  // units of work
  ProgressPoller poller(progress, "solve");
  std::vector<Corridor::Valley> valleys;
  for (std::size_t c = 0; c < drawing.curves().size(); ++c) {
    const SurfaceCurve& curve = drawing.curves()[c];
    poller.add_work(kOfPoint * curve.points.size());
    Corridor::Valley& valley = valleys.emplace_back();
    valley.closed = curve.closed;
    valley.slack = drawing.slacks()[c].slack;
    valley.slack_before_gaps = valley.slack;
    valley.length = corridor_length(mesh, curve);
  }
  if (valleys.size() > 1) keep_apart(valleys, mesh, drawing, progress);
  return valleys;
}

std::vector<Corridor::Valley> with_options(std::vector<Corridor::Valley> valleys,
                                           const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                           const SmoothingOptions& options) {
  for (std::size_t c = 0; c < valleys.size(); ++c) {
    Corridor::Valley& valley = valleys[c];
    valley.slack_from_options = options.slack_of(c) || !options.slack_at.empty();
    if (const auto slack = options.slack_of(c)) valley.slack = *slack;
    if (!valley.slack_from_options) valley.slack_at = own_field(valley, mesh, drawing, c);
    if (!options.slack_at.empty()) valley.slack_at = options.slack_at[c];
    if (valley.slack_from_options) valley.slack_before_gaps = valley.slack;
    // The phase cannot follow a loop with fewer than eight points per turn.
    const std::size_t most = std::max<std::size_t>(drawing.curves()[c].points.size() / 8, 1);
    valley.turns = std::min(options.phase_turns, static_cast<int>(most));
  }
  return valleys;
}

double largest_slack(const Corridor::Valley& valley) {
  const std::vector<double>& field = valley.slack_at;
  return field.empty() ? valley.slack : *std::max_element(field.begin(), field.end());
}

}  // namespace talweg
