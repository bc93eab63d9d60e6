// One mistake per case, in the place where PICK chooses the second of its two arguments. Every case
// compiles with the first one (the control) and must not compile with the second.
#include <cstddef>
#include <utility>
#include <vector>

#include "talweg/intrinsic/flips/edge_path.hpp"
#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

#ifdef TALWEG_MISTAKE
#define PICK(right, wrong) wrong
#else
#define PICK(right, wrong) right
#endif

using namespace talweg;

#if defined(COMPARES_VERTEX_WITH_EDGE)
bool f(VertexId v, VertexId w, EdgeId e) { return v == PICK(w, e); }
#elif defined(COMPARES_EDGE_WITH_HALFEDGE)
bool f(EdgeId e, HalfedgeId h) { return e == PICK(edge_of(h), h); }
#elif defined(ORDERS_VERTEX_BEFORE_FACE)
bool f(VertexId v, VertexId w, FaceId g) { return v < PICK(w, g); }
#elif defined(COMPARES_VERTEX_WITH_NUMBER)
bool f(VertexId v, std::size_t i) { return PICK(v.index(), v) == i; }
#elif defined(ASSIGNS_EDGE_TO_VERTEX)
void f(VertexId& v, VertexId w, EdgeId e) { v = PICK(w, e); }
#elif defined(MAKES_VERTEX_OF_EDGE)
VertexId f(VertexId w, EdgeId e) { return VertexId{PICK(w, e)}; }
#elif defined(MAKES_VERTEX_OF_NUMBER_SILENTLY)
VertexId f(std::size_t i) { return PICK(VertexId{i}, i); }
#elif defined(MAKES_NUMBER_OF_VERTEX)
std::size_t f(VertexId v) { return PICK(v.index(), v); }
#elif defined(ADDS_TO_VERTEX)
VertexId f(VertexId v) { return PICK(VertexId{v.index() + 1}, v + 1); }
#elif defined(INDEXES_WITH_VERTEX)
double f(const std::vector<double>& a, VertexId v) { return a[PICK(v.index(), v)]; }
#elif defined(TWIN_OF_EDGE)
HalfedgeId f(EdgeId e) { return twin(PICK(halfedge_of(e), e)); }
#elif defined(LENGTH_OF_HALFEDGE)
double f(const Surface& s, HalfedgeId h) { return s.length(PICK(edge_of(h), h)); }
#elif defined(FINDS_BETWEEN_VERTEX_AND_FACE)
HalfedgeId f(const Surface& s, VertexId v, VertexId w, FaceId g) {
  return s.find_halfedge(v, PICK(w, g));
}
#elif defined(POINT_AT_EDGE_AS_VERTEX)
SurfacePoint f(const Surface& s, VertexId v, EdgeId e) {
  return SurfacePoint::at_vertex(s, PICK(v, e));
}
#elif defined(POINT_OF_NOTHING)
SurfacePoint f(const Surface& s, VertexId v) {
  return PICK(SurfacePoint::at_vertex(s, v), SurfacePoint{});
}
#elif defined(POINT_WITHOUT_CHECK)
SurfacePoint f(const Surface& s, VertexId v) {
  return PICK(SurfacePoint::at_vertex(s, v), SurfacePoint(AtVertex{v}));
}
#elif defined(CHANGES_WHERE_A_POINT_IS)
void f(SurfacePoint& p, const SurfacePoint& q) { PICK(p = q, p.where() = q.where()); }
#elif defined(PATH_OF_NOTHING)
EdgePath f(const SignpostTriangulation& t, std::vector<HalfedgeId> h) {
  return PICK(EdgePath::make(t, std::move(h), false), EdgePath{});
}
#elif defined(PATH_WITHOUT_CHECK)
EdgePath f(const SignpostTriangulation& t, std::vector<HalfedgeId> h) {
  return PICK(EdgePath::make(t, std::move(h), false), EdgePath(std::move(h), false));
}
#elif defined(CHANGES_A_PATH)
void f(EdgePath& p, EdgePath q) { PICK(p = q, p.halfedges()[0] = q.halfedges()[0]); }
#else
#error "no such case"
#endif
