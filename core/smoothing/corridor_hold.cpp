#include "talweg/core/smoothing/corridor_hold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/smoothing/corridor_valleys.hpp"
#include "talweg/core/smoothing/lifted_lengths.hpp"
#include "talweg/core/smoothing/touched_edges.hpp"

namespace talweg {
namespace {

// A lift counts as none if it lengthens no edge by more than this part of the edge's length: the
// polish ignores smaller gains too (PolishOptions::tolerance).
constexpr double kUnfelt = 1e-7;

}  // namespace

/// How far out δ must be exact where the valley is narrow: the faces that the curve passes through
/// lie within the slack plus one edge.
double CorridorHold::exact_for_walls() const {
  const std::vector<double>& near = drawing_->drawing().edges_near();
  double exact = 0;
  for (std::size_t c = 0; c < valleys_->size(); ++c) {
    // While dragging, there are also valleys of curves that are only near the dragged one.
    exact = std::max(exact, largest_slack((*valleys_)[c]) + near[std::min(c, near.size() - 1)]);
  }
  return exact;
}

Straightened CorridorHold::straighten(const SmoothingOptions& options, Walls walls,
                                      const Progress& progress) {
  const Corridor corridor = this->corridor(options.tau);
  const double exact = walls == Walls::kExact ? HUGE_VAL : exact_for_walls();
  const std::size_t own = drawing_->surface().vertex_count();
  const auto metric = [&](VertexId p, VertexId q, double length) {
    const auto at = [&](VertexId v) {  // inserted vertices lie on the drawing
      return v.index() < own ? corridor.at_vertex_roughly(v, exact) : std::array<double, 2>{0, 0};
    };
    return lifted_length(length, at(p), at(q));
  };
  Asker asker(progress, "straighten");
  const AskedDuring asked(*distance_, asker);
  return drawing_->straighten(options, metric, progress);
}

Straightened CorridorHold::straighten_flat(const SmoothingOptions& options,
                                           const Progress& progress) {
  return drawing_->straighten(options, unlifted_length, progress);
}

/// Whether the lift would have changed one of the lengths that the straightening used. The ways
/// from the drawing along those edges bound their distance.
bool CorridorHold::is_felt(const Corridor& corridor, const Straightened& flat,
                           const Progress& progress) const {
  const TouchedEdges edges =
      touched_edges(drawing_->surface(), flat.touched, drawing_->drawing().curves(), progress);
  return !(corridor.largest_lengthening(edges.farthest, edges.shortest) <= kUnfelt);
}

std::optional<Straightened> CorridorHold::unlifted(const SmoothingOptions& options,
                                                   const Progress& progress) {
  if (options.tau == 0) return straighten_flat(options, progress);
  // Straightening without the lift is worth trying only if the lift would not be felt a sixteenth
  // of the drawing's radius beyond the slack.
  const Corridor corridor = this->corridor(options.tau);
  double beyond = HUGE_VAL, slack = 0;
  for (const Corridor::Valley& valley : *valleys_) {
    beyond = std::min(beyond, valley.length / 4);
    slack = std::max(slack, largest_slack(valley));
  }
  if (corridor.largest_lengthening(slack + beyond, beyond) > kUnfelt) return std::nullopt;
  SmoothingOptions lazy = options;
  lazy.prepare_whole_mesh = false;  // only the lengths it touches decide
  Straightened flat = straighten_flat(lazy, progress);
  if (is_felt(corridor, flat, progress)) return std::nullopt;
  return options.prepare_whole_mesh ? straighten_flat(options, progress) : std::move(flat);
}

void CorridorHold::hold_thin_loops(Straightened& straight) const {
  for (std::size_t c = 0; c < drawing_->capped().size(); ++c) {
    StraightenedPath& path = straight.paths[c];
    if (!drawing_->capped()[c].closed || path.termination != Termination::kCollapsed) continue;
    straight.curves[c] = drawing_->drawing().curves()[c];  // capping can cut through it
    path.length_after = path.length_before;
    path.termination = Termination::kConverged;
  }
}

void CorridorHold::polish(double tau, std::vector<SurfaceCurve>& curves, const Progress& progress,
                          const PolishOptions& options) {
  const SurfaceMesh& mesh = drawing_->mesh();
  const Corridor corridor = this->corridor(tau);
  Asker asker(progress, "polish");
  const AskedDuring asked(*distance_, asker);
  const ExactPotential exact = {
      [&](EdgeId e, double t) { return corridor.on_edge(e, t); },
      [&](const SurfacePoint& p) { return corridor.at(p); },
      [&](FaceId f, const auto& b, const auto& d) { return corridor.in_face(f, b, d); },
  };
  const std::vector<SurfaceCurve> before = curves;
  for (SurfaceCurve& curve : curves) {
    talweg::polish(mesh, curve, exact, drawing_->pins(), options, progress);
  }
  // Each curve is polished separately; those that cross afterwards get their old points back.
  for (auto crossing = crossing_curves(mesh.surface(), curves); !crossing.empty();
       crossing = crossing_curves(mesh.surface(), curves)) {
    const bool again = std::all_of(crossing.begin(), crossing.end(), [&](std::size_t c) {
      return curves[c].points == before[c].points;
    });
    if (again) break;
    for (const std::size_t c : crossing) curves[c] = before[c];
  }
}

}  // namespace talweg
