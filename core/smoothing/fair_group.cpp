#include "talweg/core/smoothing/fair_group.hpp"

#include <algorithm>
#include <utility>

#include "talweg/core/measure/measures.hpp"

namespace talweg {

std::vector<std::size_t> FairGroup::parts_of_stretches(const SampleChain& chain) const {
  std::vector<std::size_t> parts;
  std::size_t part = joined.is_ring ? joined.parts.size() - 1 : 0;
  for (const SurfacePoint& point : chain.fixed_points) {
    const auto at = std::find(junctions.begin(), junctions.end(), point);
    if (at != junctions.end()) {
      part = static_cast<std::size_t>(at - junctions.begin()) + (joined.is_ring ? 0 : 1);
    }
    parts.push_back(part);
  }
  if (parts.empty()) parts.push_back(0);  // a loop
  return parts;
}

FairGroup fair_group(const EmbeddedDrawing& embedded, JoinedCurves curves) {
  const OrderedDrawing& drawing = embedded.drawing();
  FairGroup group{std::move(curves), {}, {}, 0, 0, nullptr};
  group.drawn = joined(group.joined, drawing.curves());
  group.junctions = junctions(group.joined, drawing.curves());
  group.line =
      std::make_shared<DrawnLine>(positions_of(embedded.mesh(), group.drawn), group.drawn.closed);
  const auto& parts = group.joined.parts;
  for (const JoinedCurves::Part& part : parts) {
    group.edge += drawing.edges_near()[part.curve];
    group.length += drawing.measures()[part.curve].length;
  }
  group.edge /= static_cast<double>(parts.size());
  return group;
}

Taus taus_of(const FairGroup& group, const SmoothingOptions& options) {
  Taus taus;
  for (const JoinedCurves::Part& part : group.joined.parts) {
    taus.push_back(options.tau_of(part.curve));
  }
  return taus;
}

bool has_legs(const EmbeddedDrawing& drawing, const FairGroup& group) {
  return std::any_of(
      group.joined.parts.begin(), group.joined.parts.end(),
      [&](const JoinedCurves::Part& part) { return drawing.legs()[part.curve].any(); });
}

std::optional<LegStart> leg_start(const EmbeddedDrawing& drawing, const FairGroup& group,
                                  const SurfaceCurve& taut, double length_exponent) {
  const std::vector<SurfaceCurve> curves = split_at_junctions(group.joined, group.junctions, taut);
  std::optional<LegStart> all;
  std::size_t last = 0;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const JoinedCurves::Part& part = group.joined.parts[k];
    auto own = start_on(drawing.legs()[part.curve], curves[k], length_exponent);
    if (!own) return std::nullopt;
    if (part.reversed) own = reversed(*std::move(own), curves[k].points.size());
    if (!all) {
      all = std::move(own);
    } else {
      append(*own, last, *all);
    }
    last += curves[k].points.size() - 1;
  }
  if (group.joined.is_ring) {
    all->fixed.pop_back();
    all->tension.tolerances.pop_back();
  }
  return all;
}

}  // namespace talweg
