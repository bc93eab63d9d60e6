#include "talweg/core/smoothing/cut_off_detours.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/space/nearest_segment.hpp"

namespace talweg {
namespace {

/// Two curves as sequences of points from end to end; those of loops begin and end in a face that
/// both pass through.
struct Pair {
  std::vector<SurfacePoint> taut, drawn;
  std::vector<double> far;  // per point of the drawing
};

/// Finds where one may change from one curve to the other inside a face.
class Changes {
 public:
  Changes(const SurfaceMesh& mesh, const SurfaceCurve& taut)
      : mesh_(&mesh), nearest_(segments_of(positions_of(mesh, taut), taut.closed)) {
    const std::size_t n = taut.points.size();
    for (std::size_t k = 0; k + (taut.closed ? 0 : 1) < n; ++k) {
      for (const FaceId face : faces_of(taut.points[k], taut.points[(k + 1) % n])) {
        faces_.emplace_back(face.index(), k);
      }
    }
    std::sort(faces_.begin(), faces_.end());
  }

  [[nodiscard]] NearestSegment::Result nearest(const SurfacePoint& p) const {
    return nearest_.to(mesh_->position(p));
  }

  /// The taut curve's segment from `least` up to `most` in a face of two neighbours on the drawing
  /// that is nearest along it to `near`.
  [[nodiscard]] std::optional<std::size_t> beside(const SurfacePoint& p, const SurfacePoint& q,
                                                  std::size_t near, std::size_t least,
                                                  std::size_t most) const {
    const auto away = [&](std::size_t k) { return k < near ? near - k : k - near; };
    std::optional<std::size_t> best;
    for (const FaceId face : faces_of(p, q)) {
      for (auto it = std::lower_bound(faces_.begin(), faces_.end(), std::pair(face.index(), least));
           it != faces_.end() && it->first == face.index() && it->second <= most; ++it) {
        const std::size_t k = it->second;
        if (!best || away(k) < away(*best) || (away(k) == away(*best) && k < *best)) best = k;
      }
    }
    return best;
  }

 private:
  /// All that contain both points: two where these lie on one edge.
  [[nodiscard]] std::vector<FaceId> faces_of(const SurfacePoint& p, const SurfacePoint& q) const {
    std::vector<FaceId> faces = faces_at(mesh_->surface(), p), common;
    const std::vector<FaceId> others = faces_at(mesh_->surface(), q);
    for (const FaceId face : faces) {
      if (std::find(others.begin(), others.end(), face) != others.end()) common.push_back(face);
    }
    return common;
  }

  const SurfaceMesh* mesh_;
  NearestSegment nearest_;
  std::vector<std::pair<std::size_t, std::size_t>> faces_;  // face, segment
};

constexpr double kEqual = 1e-6;

/// What belongs to the points of a loop, from the point after this one on.
template <class Value>
std::vector<Value> begun_after(std::vector<Value> points, std::size_t last) {
  const auto first = static_cast<std::ptrdiff_t>((last + 1) % points.size());
  std::rotate(points.begin(), points.begin() + first, points.end());
  return points;
}

/// Loops are opened where both pass through one face, as near each other as anywhere; none if they
/// never do.
std::optional<Pair> opened(const SurfaceMesh& mesh, const SurfaceCurve& taut,
                           const SurfaceCurve& drawn, std::span<const double> far) {
  if (!taut.closed) return Pair{taut.points, drawn.points, {far.begin(), far.end()}};
  const Changes changes(mesh, taut);
  const std::size_t n = drawn.points.size();
  std::vector<NearestSegment::Result> there;
  for (const SurfacePoint& p : drawn.points) there.push_back(changes.nearest(p));
  const auto apart = [&](std::size_t i) {
    return std::max(there[i].distance, there[(i + 1) % n].distance);
  };
  std::optional<std::size_t> first, segment;
  for (std::size_t i = 0; i < n; ++i) {
    const double near = std::min(far[i], far[(i + 1) % n]) / 2;
    // Rounding does not choose between places that are equally near.
    if (apart(i) > near || (first && apart(i) >= apart(*first) - kEqual * near)) continue;
    const auto k = changes.beside(drawn.points[i], drawn.points[(i + 1) % n], there[i].segment, 0,
                                  taut.points.size() - 1);
    if (!k) continue;
    first = i;
    segment = k;
  }
  if (!first) return std::nullopt;
  return Pair{begun_after(taut.points, *segment), begun_after(drawn.points, *first),
              begun_after(std::vector<double>(far.begin(), far.end()), *first)};
}

/// A stretch of the drawing, from one of its points to another, that replaces segments of the taut
/// curve.
struct Detour {
  std::size_t first, last;  ///< points of the drawing
  std::size_t from, to;     ///< segments of the taut curve where it leaves and comes back
};

class DetourSearch {
 public:
  DetourSearch(const SurfaceMesh& mesh, const Pair& pair)
      : pair_(&pair), changes_(mesh, {false, pair.taut}) {
    for (const SurfacePoint& p : pair.drawn) there_.push_back(changes_.nearest(p));
  }

  [[nodiscard]] std::vector<Detour> detours() const {
    std::vector<Detour> found;
    const std::size_t n = there_.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (there_[i].distance <= pair_->far[i]) continue;
      const std::size_t known = found.empty() ? 0 : found.back().last;
      const std::size_t least = found.empty() ? 0 : found.back().to + 1;
      const auto detour = around(i, known, least);
      if (!detour) continue;
      found.push_back(*detour);
      i = detour->last;
    }
    return found;
  }

 private:
  /// The detour that has this point.
  [[nodiscard]] std::optional<Detour> around(std::size_t point, std::size_t known,
                                             std::size_t least) const {
    const std::vector<SurfacePoint>& drawn = pair_->drawn;
    const std::size_t most = pair_->taut.size() - 2;
    Detour detour{};
    std::optional<std::size_t> from, to;
    for (std::size_t i = point; i > known && !from; --i) {
      if (there_[i - 1].distance > pair_->far[i - 1] / 2) continue;
      from = changes_.beside(drawn[i - 1], drawn[i], there_[i - 1].segment, least, most);
      detour.first = i;
    }
    if (!from) return std::nullopt;
    for (std::size_t i = point; i + 1 < drawn.size() && !to; ++i) {
      if (there_[i + 1].distance > pair_->far[i + 1] / 2) continue;
      to = changes_.beside(drawn[i], drawn[i + 1], there_[i + 1].segment, *from, most);
      detour.last = i;
    }
    if (!to) return std::nullopt;
    detour.from = *from;
    detour.to = *to;
    return detour;
  }

  const Pair* pair_;
  Changes changes_;
  std::vector<NearestSegment::Result> there_;  // per point of the drawing
};

}  // namespace

WithDetours with_detours(const SurfaceMesh& mesh, const SurfaceCurve& taut,
                         const SurfaceCurve& drawn, std::span<const double> far) {
  if (taut.points.size() < 2 || drawn.points.size() < 2) return {taut};
  const std::optional<Pair> pair = opened(mesh, taut, drawn, far);
  if (!pair) return {taut};
  const std::vector<Detour> detours = DetourSearch(mesh, *pair).detours();
  if (detours.empty()) return {taut};
  WithDetours result{{taut.closed, {}}, detours.size()};
  std::vector<SurfacePoint>& points = result.curve.points;
  const auto add = [&](const SurfacePoint& p) {
    if (points.empty() || !(points.back() == p)) points.push_back(p);
  };
  std::size_t next = 0;
  for (const Detour& detour : detours) {
    for (; next <= detour.from; ++next) add(pair->taut[next]);
    for (std::size_t i = detour.first; i <= detour.last; ++i) add(pair->drawn[i]);
    next = detour.to + 1;
  }
  for (; next < pair->taut.size(); ++next) add(pair->taut[next]);
  return result;
}

}  // namespace talweg
