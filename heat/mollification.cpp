#include "talweg/heat/mollification.hpp"

#include <algorithm>
#include <utility>

namespace talweg {
namespace {

/// a + b - c without cancellation where c is the longest side.
double triangle_slack(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  return c > a ? b - (c - a) : b + (a - c);
}

std::size_t component_of(const Surface& surface, const Components& components, EdgeId e) {
  return components.of_vertex[surface.tail(halfedge_of(e)).index()];
}

}  // namespace

std::vector<double> mean_edge_lengths(const Surface& surface, const Components& components) {
  std::vector<double> sum(components.count, 0.0);
  std::vector<std::size_t> edges(components.count, 0);
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const std::size_t c = component_of(surface, components, EdgeId{e});
    sum[c] += surface.length(EdgeId{e});
    ++edges[c];
  }
  for (std::size_t c = 0; c < sum.size(); ++c) {
    if (edges[c] > 0) sum[c] /= static_cast<double>(edges[c]);
  }
  return sum;
}

bool Mollification::changed() const {
  return std::any_of(amount.begin(), amount.end(), [](double a) { return a > 0; });
}

Mollification mollify(const Surface& surface, const Components& components, double slack) {
  const std::vector<double> h = mean_edge_lengths(surface, components);
  Mollification result;
  result.amount.assign(components.count, 0.0);
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const HalfedgeId side = surface.halfedge(FaceId{f});
    const std::size_t c = components.of_vertex[surface.tail(side).index()];
    const double l0 = surface.length(edge_of(side));
    const double l1 = surface.length(edge_of(surface.next(side)));
    const double l2 = surface.length(edge_of(surface.prev(side)));
    const double least = std::min(
        {triangle_slack(l0, l1, l2), triangle_slack(l1, l2, l0), triangle_slack(l2, l0, l1)});
    result.amount[c] = std::max(result.amount[c], slack * h[c] - least);
  }
  result.lengths.assign(surface.lengths().begin(), surface.lengths().end());
  for (std::size_t e = 0; e < result.lengths.size(); ++e) {
    result.lengths[e] += result.amount[component_of(surface, components, EdgeId{e})];
  }
  return result;
}

}  // namespace talweg
