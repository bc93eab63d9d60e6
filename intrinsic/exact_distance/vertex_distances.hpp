// Vertex distances are the shortest distances known so far; later windows may lower them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "talweg/intrinsic/exact_distance/nearest_on_curve.hpp"
#include "talweg/intrinsic/surface/ids.hpp"

namespace talweg {

class VertexDistances {
 public:
  explicit VertexDistances(std::size_t vertex_count)
      : nearest_(vertex_count, NearestOnCurve::none()) {}

  /// Makes all distances infinite. O(reached vertices).
  void clear() {
    for (const VertexId v : reached_) nearest_[v.index()] = NearestOnCurve::none();
    reached_.clear();
  }

  [[nodiscard]] const NearestOnCurve& operator[](VertexId v) const { return nearest_[v.index()]; }
  /// The vertices with finite distances, in the order in which they were first reached.
  [[nodiscard]] std::span<const VertexId> reached() const { return reached_; }

  /// Stores a path that is shorter than the known one, and ignores other paths. True if the path is
  /// shorter by more than rounding.
  bool lower(VertexId v, const NearestOnCurve& way) {
    NearestOnCurve& known = nearest_[v.index()];
    if (!(way.distance < known.distance)) return false;
    const bool fresh = std::isinf(known.distance);
    const bool much = fresh || way.distance < known.distance * (1 - NearestOnCurve::kSame);
    known = {std::max(way.distance, 0.0), way.curve, way.arc_length};
    if (fresh) reached_.push_back(v);
    return much;
  }

 private:
  std::vector<NearestOnCurve> nearest_;  // per vertex
  std::vector<VertexId> reached_;
};

}  // namespace talweg
