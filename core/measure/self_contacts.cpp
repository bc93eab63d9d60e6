#include "talweg/core/measure/self_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "talweg/core/measure/face_items.hpp"
#include "talweg/core/mesh/union_find.hpp"
#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"

namespace talweg {
namespace {

constexpr double kSame = 1e-9;  // times the longest side of the face: points count as equal
constexpr double kLoop = 1e-6;

/// The contact of two passages of curves. `arc` has the arc lengths of both ends of the contact on
/// each passage, in the order of the first passage.
struct Meeting {
  struct Passage {
    std::uint32_t curve = 0;
    std::array<double, 2> arc{};
  };
  std::array<Passage, 2> passages;
  bool stretch = false;
  double same = 0;  ///< mesh units: points within this distance count as equal
  SurfacePoint at;
};

double along(const FaceItem& item, PlanePoint x) {
  if (!(item.length > 0)) return 0;
  const double ux = (item.b.x - item.a.x) / item.length, uy = (item.b.y - item.a.y) / item.length;
  return std::clamp((x.x - item.a.x) * ux + (x.y - item.a.y) * uy, 0.0, item.length);
}

PlanePoint at_length(const FaceItem& item, double s) {
  const double t = item.length > 0 ? s / item.length : 0;
  return {item.a.x + t * (item.b.x - item.a.x), item.a.y + t * (item.b.y - item.a.y)};
}

/// The signed distance of a point to the left of an item's line.
double aside(const FaceItem& item, PlanePoint x) {
  const double ux = (item.b.x - item.a.x) / item.length, uy = (item.b.y - item.a.y) / item.length;
  return ux * (x.y - item.a.y) - uy * (x.x - item.a.x);
}

/// The contact of two items, as lengths along both: none, one point, or the two ends of a stretch.
struct Common {
  int count = 0;
  std::array<std::array<double, 2>, 2> at{};

  void add(double on_p, double on_q, double same) {
    if (count > 0 && std::abs(on_p - at[0][0]) <= 4 * same) return;
    if (count < 2) {
      at[static_cast<std::size_t>(count++)] = {on_p, on_q};
    } else if (std::abs(on_p - at[0][0]) > std::abs(at[1][0] - at[0][0])) {
      at[1] = {on_p, on_q};
    }
  }
};

Common common_of(const FaceItem& p, const FaceItem& q, double same) {
  Common common;
  for (const double s : {0.0, p.length}) {
    const PlanePoint x = at_length(p, s);
    const double on_q = along(q, x);
    const PlanePoint y = at_length(q, on_q);
    if (std::hypot(x.x - y.x, x.y - y.y) <= same) common.add(s, on_q, same);
  }
  for (const double s : {0.0, q.length}) {
    const PlanePoint x = at_length(q, s);
    const double on_p = along(p, x);
    const PlanePoint y = at_length(p, on_p);
    if (std::hypot(x.x - y.x, x.y - y.y) <= same) common.add(on_p, s, same);
  }
  if (common.count > 0 || !(p.length > 0) || !(q.length > 0)) return common;
  // No end of one item lies on the other, so the items cross or do not meet.
  const double a = aside(p, q.a), b = aside(p, q.b), c = aside(q, p.a), d = aside(q, p.b);
  const auto apart = [&](double x, double y) {
    return std::min(x, y) < -same / 2 && std::max(x, y) > same / 2;
  };
  if (apart(a, b) && apart(c, d)) common.add(p.length * (c / (c - d)), q.length * (a / (a - b)), 0);
  return common;
}

class Finder {
 public:
  Finder(const Surface& surface, std::span<const SurfaceCurve> curves)
      : surface_(&surface), curves_(curves), pieces_(pieces_of(surface, curves)) {}

  std::vector<SelfContact> places() {
    meet_in_faces();
    meet_at_vertices();
    return joined();
  }

 private:
  void meet_in_faces() {
    std::vector<const PolylinePiece*> pieces;
    for (const PolylinePiece& piece : pieces_.segments) pieces.push_back(&piece);
    for (const PolylinePiece& piece : pieces_.points) {
      // Contacts at a point inside a face are found by the segments there.
      const bool on_side = std::count(piece.from.begin(), piece.from.end(), 0.0) > 0;
      if (piece.face.valid() && on_side) pieces.push_back(&piece);
    }
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const auto* p, const auto* q) { return p->face < q->face; });
    for (std::size_t i = 0, end = 0; i < pieces.size(); i = end) {
      while (end < pieces.size() && pieces[end]->face == pieces[i]->face) ++end;
      if (end - i > 1) meet_in_face(std::span(pieces).subspan(i, end - i));
    }
  }

  void meet_in_face(std::span<const PolylinePiece* const> pieces) {
    const SideFrame frame = side_frame(*surface_, pieces.front()->face, 0);
    const double longest = std::max({frame.length, std::hypot(frame.apex.x, frame.apex.y),
                                     std::hypot(frame.apex.x - frame.length, frame.apex.y)});
    const double same = kSame * longest;
    std::vector<FaceItem> items;
    for (const PolylinePiece* piece : pieces) {
      FaceItem item{piece, frame.at(piece->from, 0), frame.at(piece->to, 0), 0};
      item.length = std::hypot(item.b.x - item.a.x, item.b.y - item.a.y);
      items.push_back(item);
    }
    visit_item_pairs(items, same, [&](std::uint32_t i, std::uint32_t k) {
      meet(items[i], items[k], same, kLoop * longest);
    });
  }

  void meet(const FaceItem& p, const FaceItem& q, double same, double loop) {
    const Common common = common_of(p, q, same);
    if (common.count == 0) return;
    const auto arc = [](const FaceItem& item, double s) { return item.piece->arc + s; };
    std::array<Meeting::Passage, 2> passages{{{p.piece->curve, {}}, {q.piece->curve, {}}}};
    const auto last = static_cast<std::size_t>(common.count - 1);
    for (std::size_t k = 0; k < 2; ++k) {
      passages[0].arc[k] = arc(p, common.at[k * last][0]);
      passages[1].arc[k] = arc(q, common.at[k * last][1]);
    }
    // The two passages must not be the same passage of one curve.
    if (!is_far(passages, 0, loop) && !is_far(passages, 1, loop)) return;
    if (passages[0].arc[0] > passages[0].arc[1]) {
      for (auto& passage : passages) std::swap(passage.arc[0], passage.arc[1]);
    }
    const std::size_t first = first_of(passages);
    const FaceItem& item = first == 0 ? p : q;
    const double s = std::min(passages[first].arc[0], passages[first].arc[1]) - item.piece->arc;
    meetings_.push_back({passages, common.count == 2, same, point_on(item, s)});
  }

  [[nodiscard]] SurfacePoint point_on(const FaceItem& item, double s) const {
    const double t = item.length > 0 ? std::clamp(s / item.length, 0.0, 1.0) : 0;
    std::array<double, 3> b{};
    for (std::size_t k = 0; k < 3; ++k) {
      b[k] = (1 - t) * item.piece->from[k] + t * item.piece->to[k];
    }
    return SurfacePoint::from_barycentric(*surface_, item.piece->face, b);
  }

  static std::size_t first_of(const std::array<Meeting::Passage, 2>& passages) {
    const auto key = [](const Meeting::Passage& p) {
      return std::pair(p.curve, std::min(p.arc[0], p.arc[1]));
    };
    return key(passages[1]) < key(passages[0]) ? 1 : 0;
  }

  [[nodiscard]] bool is_far(const std::array<Meeting::Passage, 2>& passages, std::size_t k,
                            double loop) const {
    const auto& [p, q] = passages;
    if (p.curve != q.curve) return true;
    const double apart = std::abs(p.arc[k] - q.arc[k]);
    const double around = curves_[p.curve].closed ? pieces_.lengths[p.curve] - apart : apart;
    return std::min(apart, around) > loop;
  }

  void meet_at_vertices() {
    std::vector<const PolylinePiece*> visits;
    for (const PolylinePiece& piece : pieces_.points) {
      if (piece.vertex.valid()) visits.push_back(&piece);
    }
    std::stable_sort(visits.begin(), visits.end(),
                     [](const auto* p, const auto* q) { return p->vertex < q->vertex; });
    for (std::size_t i = 0; i + 1 < visits.size(); ++i) {
      const PolylinePiece &p = *visits[i], &q = *visits[i + 1];
      if (p.vertex != q.vertex) continue;
      double longest = 0;
      if (const HalfedgeId h = surface_->halfedge(p.vertex); h.valid()) {
        longest = surface_->length(edge_of(h));
      }
      const std::array<Meeting::Passage, 2> passages{
          {{p.curve, {p.arc, p.arc}}, {q.curve, {q.arc, q.arc}}}};
      if (!is_far(passages, 0, kLoop * longest)) continue;
      meetings_.push_back(
          {passages, false, kSame * longest, SurfacePoint::at_vertex(*surface_, p.vertex)});
    }
  }

  /// A piece of a curve (arc lengths) that belongs to a meeting.
  struct Interval {
    std::uint32_t curve;
    double from, to;
    std::uint32_t meeting;
  };

  [[nodiscard]] std::vector<Interval> intervals() const {
    std::vector<Interval> all;
    for (std::size_t i = 0; i < meetings_.size(); ++i) {
      for (const Meeting::Passage& passage : meetings_[i].passages) {
        const auto [from, to] = std::minmax(passage.arc[0], passage.arc[1]);
        all.push_back({passage.curve, from, to, static_cast<std::uint32_t>(i)});
      }
    }
    std::sort(all.begin(), all.end(), [](const Interval& a, const Interval& b) {
      if (a.curve != b.curve) return a.curve < b.curve;
      return a.from != b.from ? a.from < b.from : a.meeting < b.meeting;
    });
    return all;
  }

  /// Joins meetings that share a piece of a curve to one contact.
  std::vector<SelfContact> joined() {
    UnionFind sets(meetings_.size());
    const std::vector<Interval> all = intervals();
    for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
      std::uint32_t farthest = all[i].meeting;
      double reached = all[i].to;
      for (end = i; end < all.size() && all[end].curve == all[i].curve; ++end) {
        const Interval& next = all[end];
        if (next.from <= reached + 8 * meetings_[next.meeting].same) {
          sets.join(farthest, next.meeting);
        }
        if (next.to >= reached) {
          reached = next.to;
          farthest = next.meeting;
        }
      }
      const double length = pieces_.lengths[all[i].curve];
      if (curves_[all[i].curve].closed &&
          all[i].from + length - reached <= 8 * meetings_[all[i].meeting].same) {
        sets.join(all[i].meeting, farthest);
      }
    }
    return places_of(sets, all);
  }

  std::vector<SelfContact> places_of(UnionFind& sets, const std::vector<Interval>& all) {
    std::vector<SelfContact> places;
    std::vector<std::optional<std::size_t>> place(meetings_.size());
    for (const Interval& interval : all) {
      const Meeting& meeting = meetings_[interval.meeting];
      auto& known = place[sets.find(interval.meeting)];
      if (!known) {
        known = places.size();
        places.push_back({meeting.at, interval.curve, false});
      }
      places[*known].stretch = places[*known].stretch || meeting.stretch;
    }
    return places;
  }

  const Surface* surface_;
  std::span<const SurfaceCurve> curves_;
  PolylinePieces pieces_;
  std::vector<Meeting> meetings_;
};

}  // namespace

std::vector<SelfContact> self_contacts(const Surface& surface,
                                       std::span<const SurfaceCurve> curves) {
  return Finder(surface, curves).places();
}

}  // namespace talweg
