// Edge ways lead along edges to vertices whose distances are known.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "talweg/intrinsic/exact_distance/nearest_on_curve.hpp"
#include "talweg/intrinsic/exact_distance/vertex_distances.hpp"
#include "talweg/intrinsic/exact_distance/work_tally.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Exact distances would cost far more where faces are needles: there the number of windows grows
/// with the square of the number of edges. The surface must outlive the object.
class EdgeWays {
 public:
  explicit EdgeWays(const Surface& surface) : surface_(&surface) {}

  /// To be called when the distances of the vertices are others.
  void clear() { from_ = -1; }

  /// The shortest way from v, which is farther than `exact` from the curves, along edges to a
  /// vertex within that distance; all distances up to it must be known. Infinite where there is
  /// none. Work is told; what was found stays when that throws.
  NearestOnCurve shortest(VertexId v, double exact, const VertexDistances& known, WorkTally& work);

 private:
  struct Reached {
    VertexId vertex;
    double way = 0;  // along edges
    bool settled = false;
  };
  struct Way {
    NearestOnCurve nearest;
    VertexId vertex;
  };
  struct IsLater {
    bool operator()(const Way& a, const Way& b) const {
      return b.nearest.is_nearer_than(a.nearest);
    }
  };

  std::optional<NearestOnCurve> search_near(VertexId v, double exact, const VertexDistances& known);
  void reach(VertexId v, double way);
  NearestOnCurve search_all(VertexId v, double exact, const VertexDistances& known,
                            WorkTally& work);
  void start_from_all(double exact, const VertexDistances& known);
  void push(VertexId v, const NearestOnCurve& nearest);

  const Surface* surface_;
  std::vector<Reached> reached_;  // by the last search from a vertex
  // The search from all exact distances: its limit, queue and settled vertices.
  double from_ = -1;
  std::vector<Way> queue_;
  std::unordered_map<VertexId, NearestOnCurve> settled_;
};

}  // namespace talweg
