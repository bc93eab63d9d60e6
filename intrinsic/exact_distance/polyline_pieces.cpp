#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"

#include <algorithm>
#include <string>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

HalfedgeId side_of(const Surface& surface, FaceId face, std::size_t k) {
  const HalfedgeId h = surface.halfedge(face);
  return k == 0 ? h : k == 1 ? surface.next(h) : surface.prev(h);
}

bool exists(const Surface& surface, const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) {
    return v->vertex.index() < surface.vertex_count();
  }
  if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    return e->edge.index() < surface.edge_count();
  }
  return std::get<InFace>(point.where()).face.index() < surface.face_count();
}

/// The edge along which two neighbouring points lie; invalid if they run through a face.
EdgeId edge_along(const Surface& surface, const SurfacePoint& p, const SurfacePoint& q) {
  const auto* vp = std::get_if<AtVertex>(&p.where());
  const auto* vq = std::get_if<AtVertex>(&q.where());
  const auto* ep = std::get_if<OnEdge>(&p.where());
  const auto* eq = std::get_if<OnEdge>(&q.where());
  if (vp && vq) {
    const HalfedgeId h = surface.find_halfedge(vp->vertex, vq->vertex);
    return h.valid() ? edge_of(h) : EdgeId{};
  }
  const auto is_end = [&](EdgeId e, VertexId v) {
    return surface.tail(halfedge_of(e)) == v || surface.head(halfedge_of(e)) == v;
  };
  if (ep && eq) return ep->edge == eq->edge ? ep->edge : EdgeId{};
  if (ep && vq) return is_end(ep->edge, vq->vertex) ? ep->edge : EdgeId{};
  if (vp && eq) return is_end(eq->edge, vp->vertex) ? eq->edge : EdgeId{};
  return {};
}

std::array<FaceId, 2> faces_of(const Surface& surface, EdgeId e) {
  return {surface.face(halfedge_of(e)), surface.face(twin(halfedge_of(e)))};
}

class Cutter {
 public:
  Cutter(const Surface& surface, PolylinePieces& pieces) : surface_(surface), pieces_(pieces) {}

  void cut(const SurfaceCurve& curve, std::uint32_t id) {
    const std::size_t n = curve.points.size();
    if (n == 0) bad(id, 0, "has no points");
    for (std::size_t i = 0; i < n; ++i) {
      if (!exists(surface_, curve.points[i])) bad(id, i, "has a point that is not on the mesh");
    }
    double arc = 0;
    std::vector<double>& arcs = pieces_.arcs.emplace_back();
    for (std::size_t i = 0; i < n; ++i) {
      arcs.push_back(arc);
      add_point(curve.points[i], id, arc);
      if (i + 1 == n && !(curve.closed && n > 1)) break;
      arc += add_segment(curve.points[i], curve.points[(i + 1) % n], id, i, arc);
    }
    if (arc == 0) add_lone_point(curve.points.front(), id);
    pieces_.lengths.push_back(arc);
  }

 private:
  [[noreturn]] static void bad(std::uint32_t curve, std::size_t point, const std::string& what) {
    throw Error(ErrorCode::kBadCurve, "Curve " + std::to_string(curve) + " " + what + " (point " +
                                          std::to_string(point) + ").");
  }

  void add_point(const SurfacePoint& point, std::uint32_t curve, double arc) {
    if (const auto* v = std::get_if<AtVertex>(&point.where())) {
      pieces_.points.push_back({FaceId{}, curve, {}, {}, arc, v->vertex});
      return;
    }
    const auto add = [&](FaceId face) {
      const auto b = coordinates_in(surface_, point, face).barycentric;
      pieces_.points.push_back({face, curve, b, b, arc, VertexId{}});
    };
    if (const auto* e = std::get_if<OnEdge>(&point.where())) {
      for (const FaceId face : faces_of(surface_, e->edge)) {
        if (face.valid()) add(face);
      }
    } else {
      add(std::get<InFace>(point.where()).face);
    }
  }

  /// Adds a segment of length 0 for a curve of length 0, so that the faces of its point have a
  /// piece of the curve.
  void add_lone_point(const SurfacePoint& point, std::uint32_t curve) {
    if (point.is_vertex()) return;
    for (const FaceId face : faces_at(surface_, point)) {
      const auto b = coordinates_in(surface_, point, face).barycentric;
      pieces_.segments.push_back({face, curve, b, b, 0, VertexId{}});
    }
  }

  /// Returns the segment's length.
  double add_segment(const SurfacePoint& p, const SurfacePoint& q, std::uint32_t curve,
                     std::size_t index, double arc) {
    if (p == q) return 0;
    const EdgeId along = edge_along(surface_, p, q);
    std::array<FaceId, 2> faces;
    if (along.valid()) {
      faces = faces_of(surface_, along);
    } else {
      faces[0] = common_face(surface_, p, q);
    }
    double length = -1;
    for (const FaceId face : faces) {
      if (!face.valid()) continue;
      const FaceCoordinates a = coordinates_in(surface_, p, face);
      const FaceCoordinates b = coordinates_in(surface_, q, face);
      if (length < 0) length = distance_in_face(surface_, a, b);
      pieces_.segments.push_back({face, curve, a.barycentric, b.barycentric, arc, VertexId{}});
    }
    if (length < 0) bad(curve, index, "leaves the mesh: a point and the next have no common face");
    return length;
  }

  const Surface& surface_;
  PolylinePieces& pieces_;
};

}  // namespace

SideFrame side_frame(const Surface& surface, FaceId face, std::size_t k) {
  SideFrame frame;
  frame.side = side_of(surface, face, k);
  const auto length = [&](std::size_t i) {
    return surface.length(edge_of(side_of(surface, face, (k + i) % 3)));
  };
  frame.length = length(0);
  frame.apex = apex(frame.length, length(2), length(1));
  return frame;
}

std::span<const PolylinePiece> PolylinePieces::segments_in(FaceId face) const {
  PolylinePiece key;
  key.face = face;
  const auto range = std::equal_range(
      segments.begin(), segments.end(), key,
      [](const PolylinePiece& a, const PolylinePiece& b) { return a.face < b.face; });
  const auto first = static_cast<std::size_t>(range.first - segments.begin());
  return std::span(segments).subspan(first, static_cast<std::size_t>(range.second - range.first));
}

PolylinePieces pieces_of(const Surface& surface, std::span<const SurfaceCurve> curves) {
  PolylinePieces pieces;
  Cutter cutter(surface, pieces);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    cutter.cut(curves[i], static_cast<std::uint32_t>(i));
  }
  std::stable_sort(pieces.segments.begin(), pieces.segments.end(),
                   [](const PolylinePiece& a, const PolylinePiece& b) { return a.face < b.face; });
  return pieces;
}

}  // namespace talweg
