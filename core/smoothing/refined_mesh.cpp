#include "talweg/core/smoothing/refined_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include "talweg/intrinsic/surface/spokes.hpp"
#include "talweg/intrinsic/surface/zeroed_memory.hpp"

namespace talweg {
namespace {

using Barycentric = std::array<double, 3>;

constexpr std::uint32_t kNothing = 0xFFFFFFFFU;
constexpr std::size_t kMostSegments = 64;  // most segments of a drawing in one face
constexpr std::size_t kOfFace = 8;         // units of work
// In slacks. A face is too large if the drawing deviates by more than kAside from the straight line
// through the face; for faces with edges longer than kWide, by more than kBentAt.
constexpr double kAside = 4, kWide = 8, kBentAt = 0.5;

double distance_to_chord(const Point& p, const Point& a, const Point& b) {
  const Point ab = b - a;
  const double square = ab.squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(ab) / square, 0.0, 1.0) : 0.0;
  return (p - a - t * ab).norm();
}

double longest_side(const Surface& surface, FaceId face) {
  const HalfedgeId h = surface.halfedge(face), next = surface.next(h);
  return std::max({surface.length(edge_of(h)), surface.length(edge_of(next)),
                   surface.length(edge_of(surface.next(next)))});
}

/// A triangulation that is refined by bisection, with the segments of curves in its triangles.
class Bisection {
 public:
  Bisection(const SurfaceMesh& mesh, std::span<const FaceId> faces, ProgressPoller& poller);

  void add(std::size_t curve, const SurfaceCurve& drawn);
  void divide(std::span<const FaceId> faces, std::span<const double> longest);
  [[nodiscard]] RefinedMesh result(std::size_t curves) &&;

 private:
  using Index = std::uint32_t;
  struct Piece {  // a triangle of the refined mesh
    std::array<Index, 3> corners;
    std::array<Index, 3> across;  // the piece across the side from corner k to the next
    std::array<bool, 3> cut;      // whether the mesh continues beyond this side
    FaceId face;
    RefinedMesh::Corners in_face;
    bool divided = false;         // whether it is bisected until small enough
    std::vector<Index> segments;  // in the order of the curve
  };
  struct Segment {
    Index piece;
    Barycentric from, to;   // barycentric coordinates in the piece
    Index next = kNothing;  // along the curve
    Index curve = 0;
    Index drawn = 0;  // the segment of the drawing that contains it
    double begin = 0, end = 1;
  };

  [[nodiscard]] double length(Index a, Index b) const {
    return (points_[std::max(a, b)] - points_[std::min(a, b)]).norm();
  }
  [[nodiscard]] std::size_t longest_side(Index piece) const;
  [[nodiscard]] std::size_t side_towards(Index piece, Index from, Index to) const;
  Index split(Index piece, std::size_t side, Index middle);
  void share_segments(Index piece, Index other, std::size_t side);
  void bisect(Index piece);
  [[nodiscard]] bool is_too_large(const Piece& piece, std::span<const double> longest) const;

  const SurfaceMesh& mesh_;
  ProgressPoller& poller_;
  std::vector<Point> points_;
  std::vector<Piece> pieces_;
  ZeroedVector<Index> of_face_;  // per face, its piece plus 1
  std::vector<Segment> segments_;
  std::vector<Index> first_;  // per curve, its first segment
};

Bisection::Bisection(const SurfaceMesh& mesh, std::span<const FaceId> faces, ProgressPoller& poller)
    : mesh_(mesh), poller_(poller), of_face_(mesh.surface().face_count()) {
  const Surface& surface = mesh.surface();
  ZeroedVector<Index> known(surface.vertex_count());  // per vertex, its number plus 1
  for (const FaceId face : faces) {
    poller_.add_work(kOfFace);
    Piece piece{{}, {}, {}, face, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, false, {}};
    const auto corners = surface.corners(face);
    for (std::size_t k = 0; k < 3; ++k) {
      Index& id = known[corners[k].index()];
      if (id == 0) {
        points_.push_back(mesh.point(corners[k]));
        id = static_cast<Index>(points_.size());
      }
      piece.corners[k] = id - 1;
    }
    pieces_.push_back(std::move(piece));
    of_face_[face.index()] = static_cast<Index>(pieces_.size());
  }
  for (Piece& piece : pieces_) {
    poller_.add_work(kOfFace);
    HalfedgeId h = surface.halfedge(piece.face);
    for (std::size_t k = 0; k < 3; ++k, h = surface.next(h)) {
      const bool inner = surface.has_face(twin(h));
      piece.across[k] =
          inner ? of_face_[surface.face(twin(h)).index()] - 1 : kNothing;  // 0 - 1: none
      piece.cut[k] = inner && piece.across[k] == kNothing;
    }
  }
}

void Bisection::add(std::size_t curve, const SurfaceCurve& drawn) {
  const std::size_t n = drawn.points.size(), count = n - (drawn.closed ? 0 : 1);
  const Surface& surface = mesh_.surface();
  first_.push_back(static_cast<Index>(segments_.size()));
  for (std::size_t i = 0; i < count; ++i) {
    const SurfacePoint &p = drawn.points[i], &q = drawn.points[(i + 1) % n];
    const FaceId face = common_face(surface, p, q);
    Segment s{of_face_[face.index()] - 1, coordinates_in(surface, p, face).barycentric,
              coordinates_in(surface, q, face).barycentric};
    s.curve = static_cast<Index>(curve);
    s.drawn = static_cast<Index>(i);
    const auto id = static_cast<Index>(segments_.size());
    if (i + 1 < count) s.next = id + 1;
    pieces_[s.piece].segments.push_back(id);
    segments_.push_back(s);
  }
}

/// The longest side of a piece. Ties are broken by the ends, so both adjacent triangles choose the
/// same side.
std::size_t Bisection::longest_side(Index piece) const {
  const auto& corners = pieces_[piece].corners;
  const auto order = [&](std::size_t k) {
    const Index a = corners[k], b = corners[(k + 1) % 3];
    return std::tuple(length(a, b), std::min(a, b), std::max(a, b));
  };
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (order(k) > order(longest)) longest = k;
  }
  return longest;
}

std::size_t Bisection::side_towards(Index piece, Index from, Index to) const {
  const auto& corners = pieces_[piece].corners;
  std::size_t side = 0;
  while (corners[side] != from || corners[(side + 1) % 3] != to) ++side;
  return side;
}

/// Bisects a triangle at its longest side, after neighbours across this side whose longest side is
/// another.
void Bisection::bisect(Index piece) {
  std::vector<Index> stack{piece};
  while (!stack.empty()) {
    poller_.add_work(kOfFace);
    const Index t = stack.back();
    const std::size_t side = longest_side(t);
    const Index a = pieces_[t].corners[side], b = pieces_[t].corners[(side + 1) % 3];
    const Index other = pieces_[t].across[side];
    std::size_t there = 0;
    if (other != kNothing) {
      there = side_towards(other, b, a);
      if (longest_side(other) != there) {
        stack.push_back(other);
        continue;
      }
    }
    const auto middle = static_cast<Index>(points_.size());
    points_.emplace_back(0.5 * (points_[std::min(a, b)] + points_[std::max(a, b)]));
    const Index fresh = split(t, side, middle);
    if (other != kNothing) {
      const Index fresh_there = split(other, there, middle);
      pieces_[t].across[side] = fresh_there;
      pieces_[fresh_there].across[there] = t;
      pieces_[fresh].across[side] = other;
      pieces_[other].across[there] = fresh;
    }
    stack.pop_back();
  }
}

/// Splits a triangle at its side from a to b, with c opposite: (a, middle, c) keeps the number,
/// (middle, b, c) is new.
Bisection::Index Bisection::split(Index piece, std::size_t side, Index middle) {
  const auto fresh = static_cast<Index>(pieces_.size());
  pieces_.push_back(pieces_[piece]);
  Piece &t = pieces_[piece], &u = pieces_[fresh];
  const std::size_t ia = side, ib = (side + 1) % 3, ic = (side + 2) % 3;
  if (const Index beyond = t.across[ib]; beyond != kNothing) {
    pieces_[beyond].across[side_towards(beyond, t.corners[ic], t.corners[ib])] = fresh;
  }
  Barycentric in_face{};
  for (std::size_t k = 0; k < 3; ++k) in_face[k] = (t.in_face[ia][k] + t.in_face[ib][k]) / 2;
  t.corners[ib] = u.corners[ia] = middle;
  t.in_face[ib] = u.in_face[ia] = in_face;
  t.across[ib] = fresh;
  u.across[ic] = piece;
  t.cut[ib] = u.cut[ic] = false;
  share_segments(piece, fresh, side);
  return fresh;
}

/// Distributes a triangle's segments to its halves. On the line from the middle of the side to the
/// opposite corner, the barycentric coordinates of the side's ends are equal; the coordinates in
/// the halves follow without a division.
void Bisection::share_segments(Index piece, Index other, std::size_t side) {
  const std::size_t ia = side, ib = (side + 1) % 3;
  const std::vector<Index> segments = std::exchange(pieces_[piece].segments, {});
  pieces_[other].segments.clear();
  const auto put = [&](Index id, bool beyond) {
    Segment& s = segments_[id];
    const std::size_t far = beyond ? ib : ia, middle = beyond ? ia : ib;
    for (Barycentric* at : {&s.from, &s.to}) {
      const double least = (*at)[middle];
      (*at)[middle] = 2 * least;
      (*at)[far] = std::max((*at)[far] - least, 0.0);
    }
    s.piece = beyond ? other : piece;
    pieces_[s.piece].segments.push_back(id);
  };
  for (const Index id : segments) {
    const Segment s = segments_[id];
    const double from = s.from[ia] - s.from[ib], to = s.to[ia] - s.to[ib];
    if (!(from > 0 && to < 0) && !(from < 0 && to > 0)) {
      put(id, from < 0 || to < 0);
      continue;
    }
    const double t = from / (from - to);
    Barycentric at{};
    for (std::size_t k = 0; k < 3; ++k) at[k] = (1 - t) * s.from[k] + t * s.to[k];
    at[ia] = at[ib] = (at[ia] + at[ib]) / 2;
    Segment rest = s;
    rest.from = segments_[id].to = at;
    rest.begin = segments_[id].end = s.begin + t * (s.end - s.begin);
    const auto fresh = static_cast<Index>(segments_.size());
    segments_[id].next = fresh;
    segments_.push_back(rest);
    put(id, from < 0);
    put(fresh, to < 0);
  }
}

bool Bisection::is_too_large(const Piece& piece, std::span<const double> longest) const {
  if (!piece.divided || piece.segments.empty()) return false;
  double edge = 0, size = 0, most = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    edge = std::max(edge, length(piece.corners[k], piece.corners[(k + 1) % 3]));
    size = std::max(size, points_[piece.corners[k]].cwiseAbs().maxCoeff());
  }
  for (const Index s : piece.segments) most = std::min(most, longest[segments_[s].curve]);
  if (!(edge > std::ldexp(size, -36))) return false;  // positions must distinguish corners
  return edge > most || (piece.segments.size() > kMostSegments && edge > most / 16);
}

void Bisection::divide(std::span<const FaceId> faces, std::span<const double> longest) {
  const std::size_t most = 4 * pieces_.size() + 64 * segments_.size() + 4096;
  std::queue<Index> queue;
  for (const FaceId face : faces) {
    queue.push(of_face_[face.index()] - 1);
    pieces_[queue.back()].divided = true;
  }
  while (!queue.empty() && pieces_.size() < most) {
    const Index piece = queue.front();
    queue.pop();
    poller_.add_work(kOfFace);
    const auto first = static_cast<Index>(pieces_.size());
    while (is_too_large(pieces_[piece], longest) && pieces_.size() < most) bisect(piece);
    for (Index k = first; k < pieces_.size(); ++k) queue.push(k);
  }
}

RefinedMesh Bisection::result(std::size_t curves) && {
  RefinedMesh result;
  result.lists.points = std::move(points_);
  result.at_cut.assign(result.lists.points.size(), false);
  for (const Piece& piece : pieces_) {
    poller_.add_work(kOfFace);
    for (std::size_t k = 0; k < 3; ++k) {
      if (piece.cut[k]) {
        result.at_cut[piece.corners[k]] = result.at_cut[piece.corners[(k + 1) % 3]] = true;
      }
    }
    result.lists.triangles.push_back(piece.corners);
    result.face_of.push_back(piece.face);
    result.corners_of.push_back(piece.in_face);
  }
  result.curves.resize(curves);
  for (std::size_t c = 0; c < curves; ++c) {
    for (Index id = first_[c]; id != kNothing; id = segments_[id].next) {
      const Segment& s = segments_[id];
      result.curves[c].push_back({FaceId{s.piece}, s.from, s.drawn, s.begin});
      if (s.next == kNothing) result.curves[c].push_back({FaceId{s.piece}, s.to, s.drawn + 1UL, 0});
    }
  }
  return result;
}

/// Calls use(halfedge, face) for the faces around a vertex, counterclockwise.
template <typename Use>
void around(const Surface& surface, VertexId v, Use&& use) {
  const HalfedgeId first = surface.halfedge(v);
  for (HalfedgeId h = first; h.valid() && surface.has_face(h);) {
    use(h, surface.face(h).index());
    h = surface.turn_ccw(h);
    if (h == first) break;
  }
}

/// Adds all faces around vertices where the faces form more than one fan.
void fill_pinches(const Surface& surface, std::vector<std::size_t>& faces) {
  ZeroedVector<char> taken(surface.face_count());
  for (const std::size_t face : faces) taken[face] = 1;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const VertexId v : surface.corners(FaceId{faces[i]})) {
      int runs = 0;
      around(surface, v, [&](HalfedgeId h, std::size_t face) {
        const HalfedgeId clockwise = twin(h);
        const bool starts =
            !surface.has_face(clockwise) || taken[surface.face(clockwise).index()] == 0;
        if (taken[face] != 0 && starts) ++runs;
      });
      if (runs < 2) continue;
      around(surface, v, [&](HalfedgeId, std::size_t face) {
        if (taken[face] == 0) faces.push_back(face);
        taken[face] = 1;
      });
    }
  }
}

/// The faces along the curves and within `reach` of them (mesh units, along edges), ascending.
std::vector<FaceId> faces_around(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                 double reach, ProgressPoller& poller) {
  const Surface& surface = mesh.surface();
  ZeroedVector<double> nearness(surface.vertex_count());  // 1 / (1 + way); 0 if not reached
  using Item = std::pair<double, std::size_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  const auto offer = [&](VertexId v, double way) {
    double& known = nearness[v.index()];
    if (known >= 1 / (1 + way)) return;
    known = 1 / (1 + way);
    if (way <= reach) queue.emplace(way, v.index());
  };
  for (const SurfaceCurve& curve : curves) {
    for (const SurfacePoint& point : curve.points) {
      for (const FaceId face : faces_at(surface, point)) {
        for (const VertexId v : surface.corners(face)) offer(v, 0);
      }
    }
  }
  std::vector<std::size_t> faces;
  while (!queue.empty()) {
    const auto [way, id] = queue.top();
    queue.pop();
    poller.add_work(kOfFace);
    const VertexId v{id};
    if (nearness[id] > 1 / (1 + way)) continue;
    for_each_spoke(surface, v, [&, before = way](HalfedgeId h) {
      offer(surface.head(h), before + surface.length(edge_of(h)));
      if (surface.has_face(h)) faces.push_back(surface.face(h).index());
    });
  }
  poller.poll();
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  fill_pinches(surface, faces);
  std::sort(faces.begin(), faces.end());
  poller.poll();
  std::vector<FaceId> result;
  result.reserve(faces.size());
  for (const std::size_t f : faces) result.emplace_back(f);
  return result;
}

}  // namespace

std::vector<FaceId> too_large_faces(const SurfaceMesh& mesh, const SurfaceCurve& drawn,
                                    double slack) {
  const std::size_t n = drawn.points.size();
  const auto face_at = [&](std::size_t i) {
    const auto* inside = std::get_if<InFace>(&drawn.points[i].where());
    return inside != nullptr ? inside->face : FaceId{};
  };
  std::vector<FaceId> faces;
  for (std::size_t i = 0, end = 0; i < n; i = end) {
    const FaceId face = face_at(i);
    end = i + 1;
    if (!face.valid()) continue;
    while (end < n && face_at(end) == face) ++end;
    const std::size_t before = i > 0 ? i - 1 : drawn.closed ? n - 1 : i;
    const std::size_t after = end < n ? end : drawn.closed ? 0 : end - 1;
    const Point a = mesh.position(drawn.points[before]), b = mesh.position(drawn.points[after]);
    double aside = 0;
    for (std::size_t k = i; k < end; ++k) {
      aside = std::max(aside, distance_to_chord(mesh.position(drawn.points[k]), a, b));
    }
    const bool wide = longest_side(mesh.surface(), face) > kWide * slack;
    const bool too_large = end - i > kMostSegments || aside > (wide ? kBentAt : kAside) * slack;
    if (too_large) faces.push_back(face);
  }
  return faces;
}

RefinedMesh refine_along(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                         std::span<const FaceId> faces, std::span<const double> longest,
                         double reach, const Progress& progress) {
  ProgressPoller poller(progress, "solve");
  Bisection bisection(mesh, faces_around(mesh, curves, reach, poller), poller);
  for (std::size_t c = 0; c < curves.size(); ++c) bisection.add(c, curves[c]);
  bisection.divide(faces, longest);
  return std::move(bisection).result(curves.size());
}

std::vector<SurfaceCurve> RefinedMesh::refined(const Surface& fine,
                                               std::span<const SurfaceCurve> drawn) const {
  std::vector<SurfaceCurve> result;
  for (std::size_t c = 0; c < drawn.size(); ++c) {
    SurfaceCurve& curve = result.emplace_back();
    curve.closed = drawn[c].closed;
    const std::size_t count = curves[c].size() - (curve.closed ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i) {
      const Place& place = curves[c][i];
      curve.points.push_back(
          SurfacePoint::from_barycentric(fine, place.face, place.barycentric, 0));
    }
  }
  return result;
}

SurfaceCurve RefinedMesh::coarse(const Surface& fine, const Surface& original,
                                 const SurfaceCurve& curve) const {
  SurfaceCurve result{curve.closed, {}};
  for (const SurfacePoint& point : curve.points) {
    const FaceId face = any_face(fine, point);
    const Barycentric at = coordinates_in(fine, point, face).barycentric;
    const Corners& corners = corners_of[face.index()];
    Barycentric there{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (at[j] > 0) there[k] += at[j] * corners[j][k];
      }
    }
    result.points.push_back(
        SurfacePoint::from_barycentric(original, face_of[face.index()], there, 0));
  }
  return result;
}

}  // namespace talweg
