#include "talweg/core/lifting/relaxation.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

constexpr double kStep = 2.0 / 3;    // damps all short waves by 1/3 or better
constexpr double kEndMargin = 1e-6;  // smallest gap to an end or another point, in edge lengths

/// A point that slides along the edge origin + t · along.
struct Slider {
  std::size_t curve = 0;
  std::size_t index = 0;  ///< in the curve
  EdgeId edge;
  double t = 0;
  double low = 0;
  double high = 1;
  Point origin;
  Point along;
};

/// A point of a curve on an edge.
struct SlidingPoint {
  EdgeId edge;
  double t = 0;
  Slider* slider = nullptr;  ///< null for a point that stays
};

class Sliders {
 public:
  Sliders(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
          std::span<const SurfacePoint> fixed_points) {
    const PointLookup fixed(fixed_points);
    for (std::size_t c = 0; c < curves.size(); ++c) {
      for (std::size_t i = 0; i < curves[c].points.size(); ++i) {
        const auto* at = std::get_if<OnEdge>(&curves[c].points[i].where());
        if (at == nullptr) continue;
        const bool end = !curves[c].closed && (i == 0 || i + 1 == curves[c].points.size());
        if (end || fixed.contains(curves[c].points[i])) {
          places_.push_back({at->edge, at->t, nullptr});
          continue;
        }
        const HalfedgeId h = halfedge_of(at->edge);
        const Point& origin = mesh.point(mesh.surface().tail(h));
        sliders_.push_back(
            {c, i, at->edge, at->t, 0, 1, origin, mesh.point(mesh.surface().head(h)) - origin});
      }
    }
    for (Slider& s : sliders_) places_.push_back({s.edge, s.t, &s});
    // The order along each edge is found once and kept by all rounds.
    std::stable_sort(places_.begin(), places_.end(),
                     [](const SlidingPoint& a, const SlidingPoint& b) {
                       return a.edge != b.edge ? a.edge < b.edge : a.t < b.t;
                     });
  }
  Sliders(const Sliders&) = delete;
  Sliders& operator=(const Sliders&) = delete;

  std::vector<Slider>& all() { return sliders_; }
  void limit();

 private:
  std::vector<Slider> sliders_;
  std::vector<SlidingPoint> places_;
};

/// Limits each move: two points on one edge may each use half of the gap between them.
void Sliders::limit() {
  for (SlidingPoint& place : places_) {
    if (place.slider == nullptr) continue;
    place.t = place.slider->t;
    place.slider->low = std::min(place.t, kEndMargin);
    place.slider->high = std::max(place.t, 1 - kEndMargin);
  }
  for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
    const SlidingPoint& a = places_[i];
    const SlidingPoint& b = places_[i + 1];
    if (a.edge != b.edge) continue;
    const double share = std::max(0.0, b.t - a.t - kEndMargin) / 2;
    if (a.slider != nullptr) a.slider->high = std::min(a.slider->high, a.t + share);
    if (b.slider != nullptr) b.slider->low = std::max(b.slider->low, b.t - share);
  }
}

/// The slider's parameter after a step towards the best place between its two neighbours.
double moved(const Slider& s, const Point& at, const Point& before, const Point& after) {
  const double squared = s.along.squaredNorm();
  const double first = (before - at).norm();
  const double second = (after - at).norm();
  // The weight of a neighbour at the same place would be infinite, so the point stays.
  if (!(squared > 0) || !(first > 0) || !(second > 0)) return s.t;
  // Both weights are multiplied by first · second.
  const double pull = second * (before - at).dot(s.along) + first * (after - at).dot(s.along);
  const double best = s.t + pull / ((first + second) * squared);
  return s.t + kStep * (std::clamp(best, s.low, s.high) - s.t);
}

}  // namespace

void RelaxationOptions::validate() const {
  if (rounds < 0 || rounds > 1'000'000) {
    throw Error(ErrorCode::kBadUsage,
                "rounds must be from 0 to 1000000, not " + std::to_string(rounds) + ".");
  }
}

void relax(const SurfaceMesh& mesh, std::span<SurfaceCurve> curves,
           const RelaxationOptions& options, const Progress& progress) {
  options.validate();
  ProgressPoller poller(progress, "relax");
  if (options.rounds == 0) return;
  Sliders sliders(mesh, curves, options.fixed);
  std::vector<std::vector<Point>> points;
  for (const SurfaceCurve& curve : curves) points.push_back(positions_of(mesh, curve));
  std::vector<double> t(sliders.all().size());
  for (int round = 0; round < options.rounds; ++round) {
    poller.set_fraction(static_cast<double>(round) / options.rounds);
    poller.add_work(t.size());
    sliders.limit();
    for (std::size_t k = 0; k < t.size(); ++k) {
      const Slider& s = sliders.all()[k];
      const std::vector<Point>& p = points[s.curve];
      t[k] =
          moved(s, p[s.index], p[(s.index + p.size() - 1) % p.size()], p[(s.index + 1) % p.size()]);
    }
    for (std::size_t k = 0; k < t.size(); ++k) {
      Slider& s = sliders.all()[k];
      s.t = t[k];
      points[s.curve][s.index] = s.origin + s.t * s.along;
    }
  }
  for (const Slider& s : sliders.all()) {
    curves[s.curve].points[s.index] = SurfacePoint::on_edge(mesh.surface(), s.edge, s.t);
  }
}

void relax(const SurfaceMesh& mesh, SurfaceCurve& curve, const RelaxationOptions& options,
           const Progress& progress) {
  relax(mesh, std::span<SurfaceCurve>(&curve, 1), options, progress);
}

}  // namespace talweg
