#include "talweg/core/fairing/strip_curvature.hpp"

#include <cstddef>
#include <numbers>

#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {

/// The angle defect of a vertex and a third of the area around it; both 0 on the boundary.
const StripCurvature::Sum& StripCurvature::of(VertexId v) {
  const auto [place, is_new] = known_.try_emplace(static_cast<std::uint32_t>(v.index()));
  Sum& sum = place->second;
  if (!is_new || surface_->on_boundary(v)) return sum;
  sum.defect = 2 * std::numbers::pi;
  const HalfedgeId first = surface_->halfedge(v);
  HalfedgeId h = first;
  do {
    const auto length = [&](HalfedgeId side) { return surface_->length(edge_of(side)); };
    const double a = length(h), b = length(surface_->prev(h)), c = length(surface_->next(h));
    sum.defect -= angle_between(a, b, c);
    sum.area += triangle_area(a, b, c) / 3;
    h = surface_->turn_ccw(h);
  } while (h != first);
  return sum;
}

StripCurvature::Sum StripCurvature::of(const SampleChain& chain, const ChainJoin& join) {
  Sum sum;
  const auto add = [&](VertexId v) {
    const Sum& one = of(v);
    sum.defect += one.defect;
    sum.area += one.area;
  };
  for (const VertexId v : surface_->corners(join.from.face)) add(v);
  for (const HalfedgeId h : chain.strip(join)) {
    add(surface_->tail(surface_->prev(twin(h))));  // the corner beyond
  }
  return sum;
}

std::vector<double> StripCurvature::along(const SampleChain& chain) {
  std::vector<Sum> sums;
  sums.reserve(chain.joins.size());
  for (const ChainJoin& join : chain.joins) sums.push_back(of(chain, join));
  std::vector<double> curvature(chain.size(), 0);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (chain.is_end(i)) continue;
    const Sum &before = sums[i == 0 ? sums.size() - 1 : i - 1], &after = sums[i];
    const double area = before.area + after.area;
    if (area > 0) curvature[i] = (before.defect + after.defect) / area;
  }
  return curvature;
}

}  // namespace talweg
