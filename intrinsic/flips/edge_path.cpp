#include "talweg/intrinsic/flips/edge_path.hpp"

#include <string>
#include <utility>

#include "talweg/intrinsic/error.hpp"

namespace talweg {

EdgePath EdgePath::make(const SignpostTriangulation& triangulation,
                        std::vector<HalfedgeId> halfedges, bool closed) {
  const auto fail = [](const std::string& message) { throw Error(ErrorCode::kBadCurve, message); };
  if (halfedges.empty()) fail("A path needs at least one edge.");
  for (std::size_t i = 0; i < halfedges.size(); ++i) {
    if (halfedges[i].index() >= 2 * triangulation.edge_count()) {
      fail("Edge " + std::to_string(i) + " of the path does not exist.");
    }
  }
  for (std::size_t i = 0; i < halfedges.size(); ++i) {
    const bool last = i + 1 == halfedges.size();
    if (last && !closed) break;
    if (triangulation.head(halfedges[i]) != triangulation.tail(halfedges[last ? 0 : i + 1])) {
      fail("Edge " + std::to_string(i) + " of the path does not end where the next one starts.");
    }
  }
  return {std::move(halfedges), closed};
}

double path_length(SignpostTriangulation& triangulation, const EdgePath& path) {
  double length = 0;
  for (const HalfedgeId h : path.halfedges()) length += triangulation.length(h);
  return length;
}

}  // namespace talweg
