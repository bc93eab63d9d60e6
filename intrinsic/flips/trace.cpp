#include "talweg/intrinsic/flips/trace.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {

// The diamond of a flipped edge, as it is before the undo: diagonal h: b → a, with the faces
// (h, a → c, c → b) and (twin, b → d, d → a). The restored diagonal runs from c to d, with corner a
// on its left and corner b on its right.

/// Collects the passages that enter the diamond by `side`, and the strands that start in the
/// diamond and leave by `side`. `half` is the side's half of the restored diamond, `opposite` the
/// corner across its face.
void Tracer::collect_entering(HalfedgeId side, Place half, Place opposite, HalfedgeId diagonal,
                              std::vector<Visit>& visits) {
  const SignpostTriangulation& t = *triangulation_;
  const auto on_diagonal = [&](Index k) {
    return k != kNone && edge_of(crossings_[k].through) == edge_of(diagonal);
  };
  const auto half_of = [&](HalfedgeId leaving) {
    const HalfedgeId a_to_c = t.next(diagonal), d_to_a = t.prev(twin(diagonal));
    return leaving == a_to_c || leaving == d_to_a ? Place::kA : Place::kB;
  };
  for (Index k = crossings_on_[edge_of(side).index()]; k != kNone; k = crossings_[k].next_on_edge) {
    const Crossing& crossing = crossings_[k];
    if (crossing.through == twin(side)) {
      Visit visit{crossing.strand, k, crossing.next, half, opposite};
      if (on_diagonal(visit.after)) {
        visit.to = crossings_[visit.after].through == diagonal ? Place::kD : Place::kC;
        visit.after = crossings_[visit.after].next;
      }
      if (visit.after != kNone) visit.to = half_of(crossings_[visit.after].through);
      visits.push_back(visit);
    }
    if (crossing.through == side) {
      Visit visit{crossing.strand, kNone, k, opposite, half};
      Index before = crossing.prev;
      if (on_diagonal(before)) {
        visit.from = crossings_[before].through == diagonal ? Place::kC : Place::kD;
        before = crossings_[before].prev;
      }
      if (before == kNone) visits.push_back(visit);
    }
  }
}

void Tracer::collect(EdgeId e, std::vector<Visit>& visits) {
  const SignpostTriangulation& t = *triangulation_;
  const HalfedgeId h = halfedge_of(e);
  const HalfedgeId a_to_c = t.next(h), c_to_b = t.prev(h);
  const HalfedgeId b_to_d = t.next(twin(h)), d_to_a = t.prev(twin(h));
  visits.clear();
  collect_entering(a_to_c, Place::kA, Place::kB, h, visits);
  collect_entering(c_to_b, Place::kB, Place::kA, h, visits);
  collect_entering(b_to_d, Place::kB, Place::kA, h, visits);
  collect_entering(d_to_a, Place::kA, Place::kB, h, visits);
  for (Index k = crossings_on_[e.index()]; k != kNone; k = crossings_[k].next_on_edge) {
    const Crossing& crossing = crossings_[k];
    if (crossing.prev != kNone || crossing.next != kNone) continue;
    const bool from_c = crossing.through == h;
    visits.push_back({crossing.strand, kNone, kNone, from_c ? Place::kC : Place::kD,
                      from_c ? Place::kD : Place::kC});
  }
  for (Index s = strands_on_[e.index()]; s != kNone; s = strands_[s].next_along) {
    const bool from_b = strands_[s].along == h;
    visits.push_back(
        {s, kNone, kNone, from_b ? Place::kB : Place::kA, from_b ? Place::kA : Place::kB});
  }
}

Tracer::Index Tracer::insert(Index strand, Index before, Index after, HalfedgeId through) {
  const auto id = static_cast<Index>(crossings_.size());
  Index& head = crossings_on_[edge_of(through).index()];
  crossings_.push_back({through, strand, before, after, head});
  head = id;
  (before == kNone ? strands_[strand].first : crossings_[before].next) = id;
  (after == kNone ? strands_[strand].last : crossings_[after].prev) = id;
  return id;
}

void Tracer::undo_one() {
  const EdgeId e = triangulation_->last_flipped();
  const HalfedgeId h = halfedge_of(e);
  collect(e, visits_);
  triangulation_->undo_flip();
  // Passages that crossed or followed the diagonal are linked again below; the old crossings of the
  // diagonal are dropped.
  crossings_on_[e.index()] = kNone;
  strands_on_[e.index()] = kNone;
  for (const Visit& visit : visits_) {
    Strand& strand = strands_[visit.strand];
    strand.along = {};
    (visit.before == kNone ? strand.first : crossings_[visit.before].next) = visit.after;
    (visit.after == kNone ? strand.last : crossings_[visit.after].prev) = visit.before;
    if (visit.from == Place::kA && visit.to == Place::kB) {
      insert(visit.strand, visit.before, visit.after, h);
    } else if (visit.from == Place::kB && visit.to == Place::kA) {
      insert(visit.strand, visit.before, visit.after, twin(h));
    } else if (visit.before == kNone && visit.after == kNone) {
      strand.along = visit.from == Place::kC ? h : twin(h);
      strand.next_along = strands_on_[e.index()];
      strands_on_[e.index()] = visit.strand;
    }
  }
}

SurfacePoint Tracer::point_on(HalfedgeId h, double t) const {
  const SignpostTriangulation& triangulation = *triangulation_;
  const Surface& surface = triangulation.surface();
  const std::size_t vertices = surface.vertex_count();
  const VertexId tail = triangulation.tail(h), head = triangulation.head(h);
  const EdgeId e = edge_of(h);
  if (e.index() < surface.edge_count() && tail.index() < vertices && head.index() < vertices) {
    return SurfacePoint::on_edge(surface, e, h == halfedge_of(e) ? t : 1 - t);
  }
  const FaceId face = triangulation.surface_face(triangulation.has_face(h) ? h : twin(h));
  const auto p = coordinates_in(surface, triangulation.location(tail), face).barycentric;
  const auto q = coordinates_in(surface, triangulation.location(head), face).barycentric;
  std::array<double, 3> mixed{};
  for (std::size_t k = 0; k < 3; ++k) mixed[k] = (1 - t) * p[k] + t * q[k];
  return SurfacePoint::from_barycentric(surface, face, mixed);
}

namespace {

struct Unfolded {
  PlanePoint tail, head;  // ends of a crossed halfedge
};

PlanePoint minus(const PlanePoint& a, const PlanePoint& b) { return {a.x - b.x, a.y - b.y}; }

/// The corner beyond a crossed edge, placed on the right of tail → head.
PlanePoint beyond(const Unfolded& edge, double base, double from_tail, double from_head) {
  const PlanePoint d = minus(edge.head, edge.tail);
  const double norm = std::hypot(d.x, d.y);
  const PlanePoint along = norm > 0 ? PlanePoint{d.x / norm, d.y / norm} : PlanePoint{1, 0};
  const PlanePoint local = apex(base, from_tail, from_head);
  return {edge.tail.x + local.x * along.x + local.y * along.y,
          edge.tail.y + local.x * along.y - local.y * along.x};
}

}  // namespace

void Tracer::emit(const Strand& strand, SurfaceCurve& curve, std::size_t& clamped) {
  SignpostTriangulation& t = *triangulation_;
  curve.points.push_back(t.location(strand.from));
  if (strand.first == kNone) return;

  std::vector<Unfolded> edges;
  const HalfedgeId h0 = crossings_[strand.first].through;
  const double base = t.length(h0);
  const PlanePoint start = apex(base, t.length(t.prev(h0)), t.length(t.next(h0)));
  edges.push_back({{0, 0}, {base, 0}});
  for (Index k = strand.first;; k = crossings_[k].next) {
    const HalfedgeId out = twin(crossings_[k].through);
    const Unfolded& edge = edges.back();
    const PlanePoint corner =
        beyond(edge, t.length(out), t.length(t.next(out)), t.length(t.prev(out)));
    const Index next = crossings_[k].next;
    if (next == kNone) {
      edges.push_back({corner, corner});
      break;
    }
    const bool keeps_tail = crossings_[next].through == t.next(out);
    edges.push_back(keeps_tail ? Unfolded{edge.tail, corner} : Unfolded{corner, edge.head});
  }

  const PlanePoint line = minus(edges.back().tail, start);
  constexpr double kMargin = 1e-12;  // a crossing is never at an end of its edge
  std::size_t i = 0;
  for (Index k = strand.first; k != kNone; k = crossings_[k].next, ++i) {
    const double at_tail = cross(minus(edges[i].tail, start), line);
    const double at_head = cross(minus(edges[i].head, start), line);
    // The tails lie on one side of the line, the heads on the other.
    double fraction = at_tail / (at_tail - at_head);
    if (!(fraction >= kMargin && fraction <= 1 - kMargin)) {
      ++clamped;
      fraction = std::abs(at_tail) <= std::abs(at_head) ? kMargin : 1 - kMargin;
    }
    curve.points.push_back(point_on(crossings_[k].through, fraction));
  }
}

TraceResult Tracer::trace_and_undo(std::span<const EdgePath> paths, const Progress& progress) {
  try {
    TraceResult result = trace(paths, progress);
    forget();
    return result;
  } catch (...) {
    forget();
    throw;
  }
}

/// Clears the lists of crossings at edges.
void Tracer::forget() {
  for (const Crossing& c : crossings_) crossings_on_[edge_of(c.through).index()] = kNone;
  for (const Strand& s : strands_) {
    if (s.along.valid()) strands_on_[edge_of(s.along).index()] = kNone;
  }
}

TraceResult Tracer::trace(std::span<const EdgePath> paths, const Progress& progress) {
  constexpr std::size_t kOfFlip = 8, kOfStrand = 16;  // units of work
  SignpostTriangulation& t = *triangulation_;
  if (crossings_on_.size() < t.edge_count()) {
    crossings_on_.resize(t.edge_count(), kNone);
    strands_on_.resize(t.edge_count(), kNone);
  }
  strands_.clear();
  crossings_.clear();
  for (const EdgePath& path : paths) {
    for (const HalfedgeId h : path.halfedges()) {
      Index& head = strands_on_[edge_of(h).index()];
      strands_.push_back({t.tail(h), t.head(h), h, kNone, kNone, head});
      head = static_cast<Index>(strands_.size() - 1);
    }
  }
  ProgressPoller poller(progress, "trace");
  while (t.flip_count() > 0) {
    undo_one();
    poller.add_work(kOfFlip + visits_.size());
  }

  TraceResult result;
  Index strand = 0;
  for (const EdgePath& path : paths) {
    SurfaceCurve& curve = result.curves.emplace_back();
    curve.closed = path.closed();
    for (std::size_t k = 0; k < path.halfedges().size(); ++k) {
      emit(strands_[strand++], curve, result.clamped);
      poller.add_work(kOfStrand);
    }
    if (!path.closed()) curve.points.push_back(t.location(strands_[strand - 1].to));
  }
  return result;
}

}  // namespace talweg
