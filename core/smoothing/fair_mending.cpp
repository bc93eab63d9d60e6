#include "talweg/core/smoothing/fair_mending.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/fairing/curve_fairing.hpp"
#include "talweg/core/fairing/fair_verdict.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/turning_windows.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

constexpr int kRounds = 8;
constexpr double kMendedMargin = 2;  // samples, on either side of what is bad, at first
constexpr double kMostTaut = 0.5;    // of the length

std::string warning_of(const HeldCurve& held, const SurfaceMesh& mesh) {
  const Point at = mesh.position(held.middle);
  const bool one = held.ends.size() == 1;
  return fmt::format(
      "The curve could not be made fair within its walls everywhere: {} of it ({:.2g} % of its "
      "length{} around ({:.6g}, {:.6g}, {:.6g})) {} left taut.",
      one ? "a stretch" : fmt::format("{} stretches", held.ends.size()), 100 * held.share,
      one ? "," : ", the longest", at.x(), at.y(), at.z(), one ? "is" : "are");
}

/// The squared curvature of a curve along it.
class Bends {
 public:
  Bends(const Surface& surface, const SurfaceCurve& curve, double window)
      : steps_(curvature_along(turns_of(surface, curve), window)) {}

  /// The most within so much of a place.
  [[nodiscard]] double near(double arc, double reach) const {
    double most = 0;
    auto step = std::lower_bound(steps_.begin(), steps_.end(), arc - reach,
                                 [](const CurvatureStep& a, double at) { return a.to < at; });
    for (; step != steps_.end() && step->from <= arc + reach; ++step) {
      most = std::max(most, step->curvature * step->curvature);
    }
    return most;
  }

 private:
  std::vector<CurvatureStep> steps_;
};

}  // namespace

/// What stays the same from round to round, and the stretches so far.
struct FairMending::Setting {
  const SurfaceCurve* start;
  PolylineDistance* distance;  // to the start
  TautStretches stretches;
  double most_bending;
  double spacing = 0;  // of samples, mesh units
};

/// The trace from which the rest is faired.
CurveTrace FairMending::traced(const HeldCurve& held) const {
  const EmbeddedDrawing& drawing = hold_->drawing();
  const PointLookup stays(drawing.fixed());
  std::vector<std::size_t> fixed = held.fixed;
  for (std::size_t i = 0; i < held.curve.points.size(); ++i) {
    if (!stays.contains(held.curve.points[i])) continue;
    if (!std::binary_search(held.fixed.begin(), held.fixed.end(), i)) fixed.push_back(i);
  }
  std::sort(fixed.begin(), fixed.end());
  CurveTrace trace = trace_through(drawing.surface(), held.curve, fixed);
  std::vector<SurfacePoint> corners = drawing.corners();
  corners.insert(corners.end(), held.corners.begin(), held.corners.end());
  trace.set_corners(corners);
  return trace;
}

FairMending::Try FairMending::faired(Setting& setting, const std::optional<HeldCurve>& held) {
  Try result;
  hold_->with_fairing(*group_, *taus_, 1, {}, *asker_, [&](CurveFairing& fairing) {
    if (held) fairing.leave_out(held->ends);
    const auto chain =
        fairing.from_curve(held ? traced(*held) : hold_->traced(*group_, *setting.start), *asker_);
    if (!chain) return;
    result.bad = fairing.beyond(*chain);
    if (!result.bad.empty()) return;
    auto faired = fairing.curve_of(*chain, *asker_);
    if (!faired) return;
    if (faired->farthest > 1) result.bad = fairing.beyond(faired->curve);
    result.curve = std::move(faired->curve);
  });
  if (result.curve && result.bad.empty()) judge(setting, result);
  return result;
}

void FairMending::judge(Setting& setting, Try& result) const {
  const EmbeddedDrawing& drawing = hold_->drawing();
  const SurfaceCurve& curve = *result.curve;
  result.bad = (*crossed_)(curve);
  if (!result.bad.empty()) return;
  result.bad = pressed_points(drawing.surface(), curve, *taut_);
  std::erase_if(result.bad, [&](const SurfacePoint& point) {  // the taut curve's own
    return setting.stretches.contain(setting.distance->at(point).arc_length);
  });
  if (!result.bad.empty()) return;
  const double own = bending_between(drawing.surface(), curve, drawing.corners(), group_->edge);
  if (own <= setting.most_bending) return;
  result.bad = most_bent(setting, curve);
  if (result.bad.empty()) result.curve.reset();  // all of it bends more
}

/// Where the curve bends most in comparison with the one it started from, outside the stretches.
std::vector<SurfacePoint> FairMending::most_bent(Setting& setting,
                                                 const SurfaceCurve& curve) const {
  const Surface& surface = hold_->drawing().surface();
  const double window = group_->edge / 2;
  const Bends before(surface, *setting.start, window), after(surface, curve, window);
  std::vector<SurfacePoint> most;
  double excess = 0, arc = 0;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const double place = setting.distance->at(curve.points[i]).arc_length;
    const double more = after.near(arc, 0) - before.near(place, window);
    if (more > excess && !setting.stretches.contain(place)) {
      excess = more;
      most.assign(1, curve.points[i]);
    }
    if (i + 1 < curve.points.size()) {
      const SurfacePoint &p = curve.points[i], &q = curve.points[i + 1];
      arc += segment_between(surface, p, q, common_face(surface, p, q)).length;
    }
  }
  return most;
}

/// Whether a stretch has something that is drawn, and not straightened.
bool FairMending::leaves_drawing(const Setting& setting) const {
  const std::vector<SurfacePoint>& points = setting.start->points;
  const auto arcs = setting.distance->point_arcs(0);
  const PointLookup taut(taut_->points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (setting.stretches.contain(arcs[i]) && !taut.contains(points[i])) return true;
  }
  return false;
}

/// Whether a curve has no kinks and is between its walls, its stretches too.
bool FairMending::is_fair(const SurfaceCurve& curve) {
  const EmbeddedDrawing& drawing = hold_->drawing();
  if (largest_turn_between(drawing.surface(), curve, drawing.corners()) > kMostFairTurn) {
    return false;
  }
  bool within = false;
  hold_->with_fairing(*group_, *taus_, 1, {}, *asker_,
                      [&](const CurveFairing& fairing) { within = fairing.farthest(curve) <= 1; });
  return within;
}

FairMending::Setting FairMending::setting_for(const SurfaceCurve& start) {
  const Surface& surface = hold_->drawing().surface();
  const auto bending = [&](const SurfaceCurve& curve) {
    return bending_between(surface, curve, hold_->drawing().corners(), group_->edge);
  };
  Setting setting{&start, &hold_->free_distance(), TautStretches(surface, start), bending(*taut_)};
  setting.distance->set(std::span(&start, 1));
  bool within = false;
  hold_->with_fairing(*group_, *taus_, 1, {}, *asker_, [&](const CurveFairing& fairing) {
    within = fairing.farthest(*taut_) <= 1;
    setting.spacing = fairing.least_spacing(setting.distance->curve_length(0));
  });
  if (!within || start.points != taut_->points) {
    setting.most_bending = std::max(setting.most_bending, bending(group_->drawn));
  }
  return setting;
}

std::optional<MendedCurve> FairMending::from(const SurfaceCurve& start) {
  const AskedDuring asked(hold_->free_distance(), *asker_);
  Setting setting = setting_for(start);
  double margin = kMendedMargin * setting.spacing;
  std::optional<HeldCurve> held;
  for (int round = 0; round < kRounds; ++round, margin *= 2) {
    if (round > 0 && asker_->ends_early()) return std::nullopt;
    Try result = faired(setting, held);
    if (result.bad.empty()) {
      if (!result.curve) return std::nullopt;
      MendedCurve mended{*std::move(result.curve), {}};
      if (held && !is_fair(mended.curve)) {
        mended.warning = warning_of(*held, hold_->drawing().mesh());
      }
      return mended;
    }
    for (const SurfacePoint& point : result.bad) {
      setting.stretches.add(setting.distance->at(point).arc_length, margin);
    }
    held = setting.stretches.held(setting.spacing);
    if (!held || held->share > kMostTaut || leaves_drawing(setting)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace talweg
