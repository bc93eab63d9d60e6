// Straight legs are the legs between way-points, each straightened by itself and cached.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/lifting/straightening.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A straightened leg depends on the drawn leg only, so it is cached for the next drawing on the
/// same mesh: a user who drags a way-point waits only for the two legs beside the way-point. The
/// cache holds the legs of the last drawing. Cost: a run of Straightening for each leg that is not
/// cached. In the worst case, cached legs with the same end elements and the same number of points
/// are compared one by one.
class StraightLegs {
 public:
  /// The curves with their legs straightened and their strokes as they are; none where a leg cannot
  /// be straightened alone. `straightening` has the last straightened leg embedded afterwards.
  /// Throws Cancelled.
  std::optional<Straightened> straightened(const SurfaceMesh& mesh, Straightening& straightening,
                                           std::span<const SurfaceCurve> curves,
                                           std::span<const DrawnLegs> legs,
                                           const Straightening::Options& options,
                                           const Progress& progress);

 private:
  struct Leg {
    SurfaceCurve drawn, straight;  // in the leg's own canonical direction
    StraightenedPath path;
    StraighteningCounts counts;
  };
  using Key = std::tuple<SurfaceElement, SurfaceElement, std::size_t>;  // ends, number of points
  using Legs = std::multimap<Key, std::shared_ptr<const Leg>>;

  static std::shared_ptr<const Leg> find(const Legs& legs, const SurfaceCurve& drawn);
  static Key key_of(const SurfaceCurve& drawn);

  Legs kept_;
};

/// Whether curves with straightened legs cross each other or themselves, or touch at points other
/// than fixed points. Joint straightening would keep the curves apart. O(n log n), and what
/// crossing_curves() costs.
bool legs_meet(const Surface& surface, std::span<const SurfaceCurve> curves,
               std::span<const DrawnLegs> legs);

}  // namespace talweg
