#include "talweg/core/relaxation.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr double kMargin = 1e-6;     // of the edge, between a point and the edge's ends
constexpr double kOwnShare = 0.499;  // of the gap between two points of one edge

/// A point that slides along the edge origin + t · along.
struct Slider {
  std::size_t index = 0;  ///< in the curve
  EdgeId edge;
  double t = 0;
  double low = 0;
  double high = 1;
  Point origin;
  Point along;
};

std::vector<Slider> sliders_of(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  std::vector<Slider> sliders;
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto* on_edge = std::get_if<OnEdge>(&curve.points[i].where());
    if (on_edge == nullptr || (!curve.closed && (i == 0 || i + 1 == n))) continue;
    Slider s;
    s.index = i;
    s.edge = on_edge->edge;
    s.t = on_edge->t;
    const HalfedgeId h = halfedge_of(s.edge);
    s.origin = mesh.point(mesh.surface().tail(h));
    s.along = mesh.point(mesh.surface().head(h)) - s.origin;
    sliders.push_back(s);
  }
  return sliders;
}

/// All points of the curve on edges, sorted along them: fixed ends of the curve take part, too.
struct Place {
  EdgeId edge;
  double t;
  Slider* slider;  ///< null for a point that stays
};

void limit(const SurfaceCurve& curve, std::vector<Slider>& sliders) {
  std::vector<Place> places;
  for (Slider& s : sliders) places.push_back({s.edge, s.t, &s});
  if (!curve.closed && !curve.points.empty()) {
    for (const SurfacePoint& end : {curve.points.front(), curve.points.back()}) {
      if (const auto* e = std::get_if<OnEdge>(&end.where())) {
        places.push_back({e->edge, e->t, nullptr});
      }
    }
  }
  std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.t < b.t;
  });
  for (std::size_t i = 0; i < places.size(); ++i) {
    Slider* s = places[i].slider;
    if (s == nullptr) continue;
    s->low = std::min(s->t, kMargin);
    s->high = std::max(s->t, 1 - kMargin);
    if (i > 0 && places[i - 1].edge == s->edge) {
      s->low = std::max(s->low, s->t - kOwnShare * (s->t - places[i - 1].t));
    }
    if (i + 1 < places.size() && places[i + 1].edge == s->edge) {
      s->high = std::min(s->high, s->t + kOwnShare * (places[i + 1].t - s->t));
    }
  }
}

/// Half the way to the best place between two neighbours.
double moved(const Slider& s, const Point& at, const Point& before, const Point& after) {
  const double squared = s.along.squaredNorm();
  const double first = (before - at).norm();
  const double second = (after - at).norm();
  // Where a neighbour coincides, nothing pulls (and the weight would be infinite).
  if (!(squared > 0) || !(first > 0) || !(second > 0)) return s.t;
  // Both weights times first · second.
  const double pull = second * (before - at).dot(s.along) + first * (after - at).dot(s.along);
  const double best = s.t + pull / ((first + second) * squared);
  return s.t + (std::clamp(best, s.low, s.high) - s.t) / 2;
}

}  // namespace

void RelaxationOptions::validate() const {
  if (rounds < 0 || rounds > 1'000'000) {
    throw Error(ErrorCode::kBadUsage,
                "rounds must be from 0 to 1000000, not " + std::to_string(rounds) + ".");
  }
}

void relax(const SurfaceMesh& mesh, SurfaceCurve& curve, const RelaxationOptions& options) {
  options.validate();
  const std::size_t n = curve.points.size();
  if (n < 3) return;
  std::vector<Slider> sliders = sliders_of(mesh, curve);
  std::vector<Point> points = positions_of(mesh, curve);
  std::vector<double> t(sliders.size());
  for (int round = 0; round < options.rounds; ++round) {
    limit(curve, sliders);
    for (std::size_t k = 0; k < sliders.size(); ++k) {
      const std::size_t i = sliders[k].index;
      t[k] = moved(sliders[k], points[i], points[(i + n - 1) % n], points[(i + 1) % n]);
    }
    for (std::size_t k = 0; k < sliders.size(); ++k) {
      Slider& s = sliders[k];
      s.t = t[k];
      points[s.index] = s.origin + s.t * s.along;
    }
  }
  for (const Slider& s : sliders) {
    curve.points[s.index] = SurfacePoint::on_edge(mesh.surface(), s.edge, s.t);
  }
}

}  // namespace talweg
