#include "talweg/core/lifting/straight_legs.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <variant>

#include "talweg/core/drawing/canonical_order.hpp"
#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/lifting/leg_start.hpp"
#include "talweg/core/lifting/lifted_lengths.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// Whether two curves, or two passages of one curve, share a point at a vertex or on an edge that
/// is not fixed in both. Loops with fixed points begin at the first of these.
bool touch(std::span<const SurfaceCurve> curves, std::span<const DrawnLegs> legs) {
  std::vector<std::tuple<SurfaceElement, double, bool>> passed;  // element, t on an edge, is fixed
  for (std::size_t c = 0; c < curves.size(); ++c) {
    std::size_t next = 0;
    for (const SurfacePoint& point : curves[c].points) {
      const std::vector<SurfacePoint>& fixed = legs[c].fixed;
      const bool is_fixed = next < fixed.size() && point == fixed[next];
      if (is_fixed) ++next;
      const auto* edge = std::get_if<OnEdge>(&point.where());
      passed.emplace_back(element_of(point), edge != nullptr ? edge->t : 0, is_fixed);
    }
  }
  std::sort(passed.begin(), passed.end());
  return std::adjacent_find(passed.begin(), passed.end(), [](const auto& a, const auto& b) {
           const auto& [element, place, fixed] = a;
           return element.kind != SurfaceElement::Kind::kFace && element == std::get<0>(b) &&
                  place == std::get<1>(b) && !(fixed && std::get<2>(b));
         }) != passed.end();
}

}  // namespace

StraightLegs::Key StraightLegs::key_of(const SurfaceCurve& drawn) {
  return {element_of(drawn.points.front()), element_of(drawn.points.back()), drawn.points.size()};
}

std::shared_ptr<const StraightLegs::Leg> StraightLegs::find(const Legs& legs,
                                                            const SurfaceCurve& drawn) {
  const auto [first, last] = legs.equal_range(key_of(drawn));
  const auto same = std::find_if(
      first, last, [&](const auto& entry) { return entry.second->drawn.points == drawn.points; });
  return same == last ? nullptr : same->second;
}

std::optional<Straightened> StraightLegs::straightened(const SurfaceMesh& mesh,
                                                       Straightening& straightening,
                                                       std::span<const SurfaceCurve> curves,
                                                       std::span<const DrawnLegs> legs,
                                                       const Straightening::Options& options,
                                                       const Progress& progress) {
  Straightened result;
  Legs used;
  bool all = true;
  const auto straight = [&](const SurfaceCurve& drawn) {
    auto leg = find(used, drawn);
    if (leg) return leg;
    if (!options.prepare_whole_mesh) leg = find(kept_, drawn);
    if (!leg) {
      straightening.embed(std::span(&drawn, 1), {}, Loops::kKeep, {}, progress);
      const Straightened one = straightening.run(unlifted_length, options, progress);
      result.time_ms.straighten += one.time_ms.straighten;
      result.time_ms.trace += one.time_ms.trace;
      leg = std::make_shared<const Leg>(Leg{drawn, one.curves[0], one.paths[0], one.counts});
    }
    used.emplace(key_of(drawn), leg);
    return leg;
  };
  const auto with_leg = [&](const SurfaceCurve& stretch, StraightenedPath& path) {
    const CurveOrder order = canonical_order(mesh, stretch);
    const auto leg = straight(in_order(stretch, order));
    path.length_before += leg->path.length_before;
    path.length_after += leg->path.length_after;
    result.counts.flips += leg->counts.flips;
    result.counts.iterations += leg->counts.iterations;
    result.counts.clamped += leg->counts.clamped;
    result.counts.faces_touched += leg->counts.faces_touched;
    all = all && leg->path.termination == Termination::kConverged && leg->counts.blocked == 0;
    std::vector<SurfacePoint> points = leg->straight.points;
    if (order.reversed) std::reverse(points.begin(), points.end());
    return points;
  };
  try {
    for (std::size_t c = 0; all && c < curves.size(); ++c) {
      SurfaceCurve& curve = result.curves.emplace_back(curves[c]);
      StraightenedPath& path = result.paths.emplace_back();
      if (!legs[c].any()) continue;
      curve.points.clear();
      const std::vector<SurfaceCurve> stretches = stretches_of(legs[c], curves[c]);
      all = !stretches.empty();
      for (std::size_t k = 0; k < stretches.size(); ++k) {
        const std::vector<SurfacePoint> points =
            legs[c].is_leg[k] ? with_leg(stretches[k], path) : stretches[k].points;
        curve.points.insert(curve.points.end(), points.begin(), points.end() - 1);
        if (!curve.closed && k + 1 == stretches.size()) curve.points.push_back(points.back());
      }
    }
  } catch (const Error&) {  // a leg that has no edge of its own after its points were merged
    all = false;
  }
  kept_ = std::move(used);
  if (!all) return std::nullopt;
  result.counts.faces_touched = std::min(result.counts.faces_touched, mesh.surface().face_count());
  return result;
}

bool legs_meet(const Surface& surface, std::span<const SurfaceCurve> curves,
               std::span<const DrawnLegs> legs) {
  return touch(curves, legs) || !crossing_curves(surface, curves).empty();
}

}  // namespace talweg
