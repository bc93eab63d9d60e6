// Edge path distances are lengths of paths along edges to vertices whose distances are known.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "talweg/intrinsic/exact_distance/nearest_on_curve.hpp"
#include "talweg/intrinsic/exact_distance/vertex_distances.hpp"
#include "talweg/intrinsic/exact_distance/work_tally.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Finds upper bounds where exact distances would cost far more: among needles, the number of
/// windows grows with the square of the number of edges. The surface must outlive the object.
class EdgePathDistances {
 public:
  explicit EdgePathDistances(const Surface& surface) : surface_(&surface) {}

  /// Must be called when the distances of the vertices have been reset.
  void clear() { from_ = -1; }

  /// The nearest point of the curves over a path along edges, from a vertex v farther than `exact`
  /// from the curves to a vertex within `exact`. All distances up to `exact` must be known.
  /// Infinite if there is no such path. Reports its cost to `work`; the search continues at the
  /// next query if the report throws.
  NearestOnCurve shortest(VertexId v, double exact, const VertexDistances& known, WorkTally& work);

 private:
  struct Reached {
    VertexId vertex;
    double way = 0;  // along edges
    bool settled = false;
  };
  struct Path {
    NearestOnCurve nearest;
    VertexId vertex;
  };
  struct IsLater {
    bool operator()(const Path& a, const Path& b) const {
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
  std::vector<Reached> reached_;  // vertices reached by the last search_near()
  // The search from all exact distances: its limit, queue and settled vertices.
  double from_ = -1;
  std::vector<Path> queue_;
  std::unordered_map<VertexId, NearestOnCurve> settled_;
};

}  // namespace talweg
