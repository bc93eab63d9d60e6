// Fair mending leaves those stretches of a curve taut that cannot be made fair, and no others.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "talweg/core/smoothing/corridor_hold.hpp"
#include "talweg/core/smoothing/fair_group.hpp"
#include "talweg/core/smoothing/taut_stretches.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct MendedCurve {
  SurfaceCurve curve;
  std::string warning;  ///< a sentence about what is left taut; empty if that is no worse than fair
};

/// Makes a curve fair from its taut curve. Where that leaves the walls, crosses, lies along the
/// boundary or bends more than before, the taut curve stays, with a margin that is doubled from
/// round to round, and the rest is faired on from it. For groups of one curve, without legs. Refers
/// to all that it is made from. Cost: at most 8 fairings of the whole curve.
class FairMending {
 public:
  /// Where a curve crosses itself or others of its set.
  using Crossed = std::function<std::vector<SurfacePoint>(const SurfaceCurve&)>;

  FairMending(CorridorHold& hold, const FairGroup& group, const Taus& taus,
              const SurfaceCurve& taut, const Crossed& crossed, Asker& asker)
      : hold_(&hold),
        group_(&group),
        taus_(&taus),
        taut_(&taut),
        crossed_(&crossed),
        asker_(&asker) {}

  /// From a curve that is the taut one but for detours of the drawing; none of them is left as it
  /// is drawn. None where most of the curve would be left taut. Throws Cancelled.
  std::optional<MendedCurve> from(const SurfaceCurve& start);

 private:
  /// A fair curve, and where it is not as it must be.
  struct Try {
    std::optional<SurfaceCurve> curve;
    std::vector<SurfacePoint> bad;
  };
  struct Setting;
  Setting setting_for(const SurfaceCurve& start);
  [[nodiscard]] CurveTrace traced(const HeldCurve& held) const;
  Try faired(Setting& setting, const std::optional<HeldCurve>& held);
  void judge(Setting& setting, Try& result) const;
  [[nodiscard]] std::vector<SurfacePoint> most_bent(Setting& setting,
                                                    const SurfaceCurve& curve) const;
  [[nodiscard]] bool is_fair(const SurfaceCurve& curve);
  [[nodiscard]] bool leaves_drawing(const Setting& setting) const;

  CorridorHold* hold_;
  const FairGroup* group_;
  const Taus* taus_;
  const SurfaceCurve* taut_;
  const Crossed* crossed_;
  Asker* asker_;
};

}  // namespace talweg
