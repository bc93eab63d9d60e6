#include "talweg/core/drawing/crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "talweg/core/space/box_tree.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

double orient(const std::array<double, 3>& a, const std::array<double, 3>& b,
              const std::array<double, 3>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool cross(const FaceSegment& p, const FaceSegment& q) {
  constexpr double kTouch = 1e-12;  // as part of the face's area
  const auto apart = [](double a, double b) {
    return (a > kTouch && b < -kTouch) || (a < -kTouch && b > kTouch);
  };
  return apart(orient(p.from, p.to, q.from), orient(p.from, p.to, q.to)) &&
         apart(orient(q.from, q.to, p.from), orient(q.from, q.to, p.to));
}

/// Boxes around segments in the plane of two barycentrics, wider by more than the tolerance of
/// cross(). The boxes' axes follow the mean direction of the segments, so that boxes of long
/// segments beside each other do not overlap.
std::vector<SpaceBox> boxes_of(std::span<const FaceSegment> segments) {
  constexpr double kWider = 1e-9;
  double cosines = 0, sines = 0;  // sums for twice the angle, since directions have no sign
  for (const FaceSegment& s : segments) {
    const double x = s.to[0] - s.from[0], y = s.to[1] - s.from[1];
    cosines += x * x - y * y;
    sines += 2 * x * y;
  }
  const double angle = std::atan2(sines, cosines) / 2, c = std::cos(angle), d = std::sin(angle);
  const auto turned = [&](const std::array<double, 3>& b) {
    return Point(c * b[0] + d * b[1], c * b[1] - d * b[0], 0);
  };
  std::vector<SpaceBox> boxes;
  boxes.reserve(segments.size());
  for (const FaceSegment& s : segments) {
    SpaceBox& box = boxes.emplace_back(SpaceBox::around(std::array{turned(s.from), turned(s.to)}));
    box.low.array() -= kWider;
    box.high.array() += kWider;
  }
  return boxes;
}

/// Calls found() for each pair of crossing segments of a face. The first segment of a pair is among
/// the first `own` segments. If there are many segments, a tree of boxes finds the pairs.
template <class Found>
void find_crossings(std::span<const FaceSegment> segments, std::size_t own, const Found& found) {
  constexpr std::size_t kMany = 32;
  const auto meet = [&](std::size_t i, std::size_t k) {
    if (cross(segments[i], segments[k])) found(segments[i], segments[k]);
  };
  if (segments.size() > kMany) {
    const std::vector<SpaceBox> boxes = boxes_of(segments);
    const BoxTree::BoxOf box = [&](std::uint32_t i) { return boxes[i]; };
    const BoxTree tree(segments.size(), box);
    for (std::size_t i = 0; i < own; ++i) {
      tree.visit(boxes[i], box, [&](std::size_t k) {
        if (k > i) meet(i, k);
      });
    }
    return;
  }
  for (std::size_t i = 0; i < own; ++i) {
    for (std::size_t k = i + 1; k < segments.size(); ++k) meet(i, k);
  }
}

/// A segment and its face, without coordinates: most faces have only one segment, which crosses no
/// other.
struct SegmentPlace {
  FaceId face;
  std::size_t curve = 0, number = 0;
};

/// Calls use() with the number and the face of each segment.
template <class Use>
void each_segment(const Surface& surface, const SurfaceCurve& curve, const Use& use) {
  const auto& points = curve.points;
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < points.size(); ++i) {
    const FaceId face = common_face(surface, points[i], points[(i + 1) % points.size()]);
    if (!face.valid()) {
      throw Error(ErrorCode::kBadCurve,
                  "Segment " + std::to_string(i + 1) + " of the curve lies in no face.");
    }
    use(i, face);
  }
}

std::vector<SegmentPlace> segments_by_face(const Surface& surface,
                                           std::span<const SurfaceCurve> curves) {
  std::vector<SegmentPlace> places;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    each_segment(surface, curves[c], [&](std::size_t i, FaceId face) {
      places.push_back({face, c, i});
    });
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const auto& a, const auto& b) { return a.face < b.face; });
  return places;
}

FaceSegment segment_at(const Surface& surface, const SurfaceCurve& curve, const SegmentPlace& at) {
  const auto& points = curve.points;
  const auto in_face = [&](std::size_t i) {
    return coordinates_in(surface, points[i % points.size()], at.face).barycentric;
  };
  return {at.curve, at.number, in_face(at.number), in_face(at.number + 1)};
}

/// A path at one of its vertices, followed in its own direction or against it.
struct Passage {
  std::size_t path = 0, at = 0;  // the vertex is the tail of halfedge number `at`
  bool against = false;
};

class Paths {
 public:
  Paths(const SignpostTriangulation& triangulation, std::span<const EdgePath> paths)
      : triangulation_(triangulation), paths_(paths) {}

  /// The halfedges from the vertex to the next and to the previous vertex of the path; invalid at
  /// an end.
  [[nodiscard]] HalfedgeId onward(const Passage& p) const {
    return p.against ? before(p) : after(p);
  }
  [[nodiscard]] HalfedgeId back(const Passage& p) const { return p.against ? after(p) : before(p); }
  [[nodiscard]] Passage next(Passage p) const {
    const std::size_t n = paths_[p.path].halfedges().size();
    const std::size_t vertices = n + (paths_[p.path].closed() ? 0 : 1);
    p.at = (p.at + (p.against ? vertices - 1 : 1)) % vertices;
    return p;
  }
  /// Whether h, which leaves the passage's vertex, is on the left of the path.
  [[nodiscard]] bool is_left(const Passage& p, HalfedgeId h) const {
    const HalfedgeId stop = back(p);
    for (HalfedgeId k = turned(onward(p)); k != stop; k = turned(k)) {
      if (k == h) return true;
    }
    return false;
  }
  /// The halfedges that leave the passage's vertex, numbered counterclockwise.
  [[nodiscard]] std::map<HalfedgeId, std::size_t> turns_around(const Passage& p) const {
    const HalfedgeId first = onward(p).valid() ? onward(p) : back(p);
    std::map<HalfedgeId, std::size_t> turns;
    HalfedgeId h = first;
    do {
      turns.emplace(h, turns.size());
      h = turned(h);
    } while (h != first);
    return turns;
  }
  /// Whether path b crosses path a at this vertex, or along the common stretch that begins here: b
  /// leaves a on the other side than it came from. False if both come over the same edge.
  [[nodiscard]] bool cross_from(Passage a, Passage b) const {
    if (!back(a).valid() || !back(b).valid() || back(a) == back(b)) return false;
    if (!onward(a).valid() || onward(a) == back(b) || back(a) == onward(b)) return false;
    const bool left = is_left(a, back(b));
    for (std::size_t k = paths_[a.path].halfedges().size();; --k) {
      if (!onward(a).valid() || !onward(b).valid() || k == 0) return false;
      if (onward(a) != onward(b)) break;
      a = next(a);
      b = next(b);
    }
    if (onward(a) == back(a) || onward(b) == back(b)) return false;  // a path turns back
    return is_left(a, onward(b)) != left;
  }

 private:
  [[nodiscard]] HalfedgeId after(const Passage& p) const {
    const auto h = paths_[p.path].halfedges();
    return p.at < h.size() ? h[p.at] : HalfedgeId{};
  }
  [[nodiscard]] HalfedgeId before(const Passage& p) const {
    const auto h = paths_[p.path].halfedges();
    if (p.at > 0) return twin(h[p.at - 1]);
    return paths_[p.path].closed() ? twin(h.back()) : HalfedgeId{};
  }
  /// The next halfedge counterclockwise; after the last halfedge of a boundary vertex, the first.
  [[nodiscard]] HalfedgeId turned(HalfedgeId h) const {
    if (triangulation_.has_face(h)) return triangulation_.turn_ccw(h);
    for (HalfedgeId cw = triangulation_.turn_cw(h); cw.valid(); cw = triangulation_.turn_cw(cw)) {
      h = cw;
    }
    return h;
  }

  const SignpostTriangulation& triangulation_;
  std::span<const EdgePath> paths_;
};

/// The passages of one vertex that come over the same edge `back` and leave over the same edge
/// `onward`. The edges alone tell whether the passages of two classes without a common edge cross.
struct PassageClass {
  HalfedgeId back, onward;
  std::size_t back_turn = 0, onward_turn = 0;  // numbers of the edges, as in turns_around()
  std::vector<std::uint32_t> members = {};     // ascending

  [[nodiscard]] bool is_left(std::size_t turn) const {
    const bool after = turn > onward_turn, before = turn < back_turn;
    return onward_turn < back_turn ? after && before : after || before;
  }
  /// Whether the passages of both classes cross. The classes must have no common edge.
  [[nodiscard]] bool crosses(const PassageClass& other) const {
    return is_left(other.back_turn) != is_left(other.onward_turn);
  }
};

/// Counts the crossings of paths, vertex by vertex.
class ContactCounter {
 public:
  ContactCounter(const SignpostTriangulation& triangulation, std::span<const EdgePath> paths)
      : course_(triangulation, paths) {
    result_.crossings.assign(paths.size(), 0);
    result_.tangled.assign(paths.size(), false);
  }

  /// Counts the crossings at a vertex from all its passages, in the order of the paths.
  void count(std::span<const Passage> passages) {
    passages_ = passages;
    for (std::size_t i = 0; i + 1 < passages.size(); ++i) {
      if (passages[i].path == passages[i + 1].path) result_.tangled[passages[i].path] = true;
    }
    set_classes();
    for (std::size_t i = 0; i < classes_.size(); ++i) {
      for (std::size_t k = i + 1; k < classes_.size(); ++k) meet(classes_[i], classes_[k]);
    }
  }

  PathContacts result() && { return std::move(result_); }

 private:
  /// Sorts the passages into classes, without the ends of paths, which cross no path.
  void set_classes() {
    classes_.clear();
    const std::map<HalfedgeId, std::size_t> turns = course_.turns_around(passages_.front());
    std::map<std::pair<HalfedgeId, HalfedgeId>, std::size_t> known;
    for (std::uint32_t i = 0; i < passages_.size(); ++i) {
      const HalfedgeId back = course_.back(passages_[i]), onward = course_.onward(passages_[i]);
      if (!back.valid() || !onward.valid()) continue;
      const auto [at, is_new] = known.try_emplace({back, onward}, classes_.size());
      if (is_new) classes_.push_back({back, onward, turns.at(back), turns.at(onward)});
      classes_[at->second].members.push_back(i);
    }
  }

  void meet(const PassageClass& x, const PassageClass& y) {
    if (x.back == y.back) return;
    if (x.onward == y.onward || x.onward == y.back || x.back == y.onward) {
      compare_all(x, y);
    } else if (x.crosses(y)) {
      all_cross(x, y);
      all_cross(y, x);
    }
  }

  /// Compares passages of classes with a common edge one by one: the end of the common stretch
  /// shows whether the paths cross.
  void compare_all(const PassageClass& x, const PassageClass& y) {
    for (const std::uint32_t i : x.members) {
      for (const std::uint32_t k : y.members) {
        const Passage a = passages_[std::min(i, k)];
        Passage b = passages_[std::max(i, k)];
        bool crossing = course_.cross_from(a, b);
        b.against = true;  // for a common stretch passed in opposite directions
        crossing |= course_.onward(a) == course_.onward(b) && course_.cross_from(a, b);
        if (!crossing) continue;
        ++result_.crossings[a.path];
        result_.tangled[a.path] = result_.tangled[b.path] = true;
      }
    }
  }

  /// Counts, for each path of x, the passages of y that are later in the order of the paths.
  void all_cross(const PassageClass& x, const PassageClass& y) {
    auto later = y.members.begin();
    for (const std::uint32_t i : x.members) {
      later = std::lower_bound(later, y.members.end(), i);
      const std::size_t path = passages_[i].path;
      result_.crossings[path] += static_cast<std::size_t>(y.members.end() - later);
      result_.tangled[path] = true;
    }
  }

  Paths course_;
  std::span<const Passage> passages_;
  std::vector<PassageClass> classes_;
  PathContacts result_;
};

}  // namespace

PathContacts path_contacts(const SignpostTriangulation& triangulation,
                           std::span<const EdgePath> paths) {
  std::vector<std::pair<VertexId, Passage>> visits;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const auto h = paths[p].halfedges();
    for (std::size_t i = 0; i < h.size(); ++i) visits.push_back({triangulation.tail(h[i]), {p, i}});
    if (!paths[p].closed()) visits.push_back({triangulation.head(h.back()), {p, h.size()}});
  }
  std::stable_sort(visits.begin(), visits.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  ContactCounter counter(triangulation, paths);
  std::vector<Passage> passages;
  for (std::size_t i = 0; i < visits.size();) {
    passages.clear();
    const VertexId vertex = visits[i].first;
    for (; i < visits.size() && visits[i].first == vertex; ++i)
      passages.push_back(visits[i].second);
    if (passages.size() > 1) counter.count(passages);
  }
  return std::move(counter).result();
}

namespace {

/// Calls found() for each pair of crossing segments.
template <class Found>
void find_crossings(const Surface& surface, std::span<const SurfaceCurve> curves,
                    const Found& found) {
  const std::vector<SegmentPlace> places = segments_by_face(surface, curves);
  std::vector<FaceSegment> segments;  // the segments of one face
  for (std::size_t first = 0, last = 0; first < places.size(); first = last) {
    while (last < places.size() && places[last].face == places[first].face) ++last;
    if (last == first + 1) continue;
    segments.clear();
    for (std::size_t i = first; i < last; ++i) {
      segments.push_back(segment_at(surface, curves[places[i].curve], places[i]));
    }
    find_crossings(segments, segments.size(), found);
  }
}

void sort_once(std::vector<std::size_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

std::vector<std::size_t> crossing_curves(const Surface& surface,
                                         std::span<const SurfaceCurve> curves) {
  std::vector<std::size_t> crossing;
  find_crossings(surface, curves, [&](const FaceSegment& p, const FaceSegment& q) {
    crossing.push_back(p.curve);
    crossing.push_back(q.curve);
  });
  sort_once(crossing);
  return crossing;
}

CurvesByFace::CurvesByFace(const Surface& surface, std::span<const SurfaceCurve> curves)
    : surface_(&surface), passed_(curves.size()) {
  for (std::size_t c = 0; c < curves.size(); ++c) add(c, curves[c]);
}

CurvesByFace::Faces CurvesByFace::faces_of(std::size_t number, const SurfaceCurve& curve) const {
  Faces faces;
  each_segment(*surface_, curve, [&](std::size_t i, FaceId face) {
    faces[face].push_back(segment_at(*surface_, curve, {face, number, i}));
  });
  return faces;
}

void CurvesByFace::add(std::size_t number, const SurfaceCurve& curve) {
  for (const auto& [face, segments] : faces_of(number, curve)) {
    std::vector<FaceSegment>& there = faces_[face];
    there.insert(there.end(), segments.begin(), segments.end());
    passed_[number].push_back(face);
  }
}

void CurvesByFace::replace(std::size_t number, const SurfaceCurve& curve) {
  for (const FaceId face : passed_[number]) {
    std::erase_if(faces_[face], [&](const FaceSegment& s) { return s.curve == number; });
  }
  passed_[number].clear();
  add(number, curve);
}

std::vector<SurfacePoint> CurvesByFace::crossed_points(std::size_t number,
                                                       const SurfaceCurve& curve) const {
  std::vector<std::size_t> crossed;
  Faces own = faces_of(number, curve);
  for (auto& [face, segments] : own) {
    const std::size_t count = segments.size();
    if (const auto there = faces_.find(face); there != faces_.end()) {
      std::copy_if(there->second.begin(), there->second.end(), std::back_inserter(segments),
                   [&](const FaceSegment& s) { return s.curve != number; });
    }
    find_crossings(segments, count, [&](const FaceSegment& p, const FaceSegment& q) {
      for (const FaceSegment* segment : {&p, &q}) {
        if (segment->curve == number) crossed.push_back(segment->number);
      }
    });
  }
  sort_once(crossed);
  std::vector<SurfacePoint> points;
  points.reserve(crossed.size());
  for (const std::size_t i : crossed) points.push_back(curve.points[i]);
  return points;
}

}  // namespace talweg
