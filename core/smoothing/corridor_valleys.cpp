#include "talweg/core/smoothing/corridor_valleys.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/corridor_width.hpp"
#include "talweg/core/smoothing/curve_gaps.hpp"

namespace talweg {
namespace {

/// Where the slacks of two curves meet, nothing would keep the curves apart.
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

/// For a loop that no slack holds. A strip of width w and length l that closed up would save about
/// 2 l, and has to climb to (a tau w / 2)^2 / L on both sides.
void steepen(Corridor::Valley& valley, const SurfaceMesh& mesh, const SurfaceCurve& drawn) {
  const double width = 4 * width_of_loop(mesh, drawn);
  const double length = curve_length(mesh.surface(), drawn);
  if (!(width > 0)) return;
  valley.slack = width / 8;
  valley.length = std::min(valley.length, width * width / length);
}

std::vector<bool> doubtful_loops(const std::vector<Corridor::Valley>& valleys,
                                 const SurfaceMesh& mesh, const OrderedDrawing& drawing) {
  std::vector<bool> doubtful;
  for (std::size_t c = 0; c < valleys.size(); ++c) {
    doubtful.push_back(valleys[c].closed &&
                       valleys[c].slack > width_of_loop(mesh, drawing.curves()[c]));
  }
  return doubtful;
}

/// Whether a trial run has left a loop at least so long (mesh units), and fair.
bool is_held(const SmoothedCurve& result, double least, const SurfaceMesh& mesh) {
  return result.path.termination == Termination::kConverged && result.warnings.empty() &&
         measure_curve(mesh.surface(), result.curve).length >= least;
}

/// What a trial run does not need to know is not faired.
std::vector<OwnOptions> fair_where(const std::vector<bool>& flags) {
  if (std::find(flags.begin(), flags.end(), false) == flags.end()) return {};
  std::vector<OwnOptions> own(flags.size());
  for (std::size_t c = 0; c < flags.size(); ++c) {
    if (!flags[c]) own[c].finish = Finish::kTaut;
  }
  return own;
}

/// What the hand is along a curve, narrowed as the valley was.
std::vector<double> own_field(const Corridor::Valley& valley, const SurfaceMesh& mesh,
                              const OrderedDrawing& drawing, std::size_t curve) {
  const StrokeSlack& slack = drawing.slacks()[curve];
  std::vector<double> field = slack_at_points(mesh, drawing.curves()[curve], slack);
  for (double& value : field) value *= valley.slack / slack.slack;
  return field;
}

bool any(const std::vector<bool>& flags) {
  return std::find(flags.begin(), flags.end(), true) != flags.end();
}

}  // namespace

std::vector<Corridor::Valley> valleys_of(const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                         const Progress& progress) {
  constexpr std::size_t kOfPoint = 16;  // units of work
  Asker asker(progress, "solve");
  std::vector<Corridor::Valley> valleys;
  for (std::size_t c = 0; c < drawing.curves().size(); ++c) {
    const SurfaceCurve& curve = drawing.curves()[c];
    asker.did(kOfPoint * curve.points.size());
    Corridor::Valley& valley = valleys.emplace_back();
    valley.closed = curve.closed;
    valley.slack = drawing.slacks()[c].slack;
    valley.trembling = valley.slack;
    valley.length = corridor_length(mesh, curve);
  }
  if (valleys.size() > 1) keep_apart(valleys, mesh, drawing, progress);
  return valleys;
}

bool has_doubtful_loop(const std::vector<Corridor::Valley>& valleys, const SurfaceMesh& mesh,
                       const OrderedDrawing& drawing) {
  return any(doubtful_loops(valleys, mesh, drawing));
}

void hold_loops(std::vector<Corridor::Valley>& valleys, const SurfaceMesh& mesh,
                const OrderedDrawing& drawing,
                const std::function<Smoothed(const SmoothingOptions&)>& smooth) {
  constexpr double kLeastLoopTau = 0.25;  // from here on no loop may collapse
  constexpr int kMost = 7;
  // Most loops need none or one; what the most do not hold, fewer do not hold as a rule.
  constexpr int kHalvings[] = {0, 1, kMost, 2, 3, 4, 5, 6};
  const std::vector<Corridor::Valley> wide = valleys;
  std::vector<bool> doubtful = doubtful_loops(valleys, mesh, drawing), hopeless(valleys.size());
  const auto narrow = [&](int halvings) {
    for (std::size_t c = 0; c < valleys.size(); ++c) {
      if (doubtful[c]) valleys[c].slack = std::ldexp(wide[c].slack, -halvings);
    }
  };
  SmoothingOptions options;
  options.tau = kLeastLoopTau;
  for (const int halvings : kHalvings) {
    if (!any(doubtful)) break;
    narrow(halvings);
    options.per_curve = fair_where(doubtful);
    const Smoothed tried = smooth(options);
    for (std::size_t c = 0; c < valleys.size(); ++c) {
      if (!doubtful[c]) continue;
      const bool held = is_held(tried.curves[c], drawing.measures()[c].length / 2, mesh);
      hopeless[c] = halvings == kMost && !held;
      doubtful[c] = halvings == kMost ? held : !held;
    }
  }
  narrow(kMost);
  for (std::size_t c = 0; c < valleys.size(); ++c) {
    if (hopeless[c]) steepen(valleys[c], mesh, drawing.curves()[c]);
  }
}

std::vector<Corridor::Valley> with_options(std::vector<Corridor::Valley> valleys,
                                           const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                           const SmoothingOptions& options) {
  for (std::size_t c = 0; c < valleys.size(); ++c) {
    Corridor::Valley& valley = valleys[c];
    valley.given = options.slack_of(c) || !options.slack_at.empty();
    if (const auto slack = options.slack_of(c)) valley.slack = *slack;
    if (!valley.given) valley.slack_at = own_field(valley, mesh, drawing, c);
    if (!options.slack_at.empty()) valley.slack_at = options.slack_at[c];
    if (valley.given) valley.trembling = valley.slack;
    // With fewer points per turn the phase could not follow the loop.
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
