#include "talweg/core/mesh/surface_mesh.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "talweg/core/mesh/measurable_point.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/space/point_distance.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// Checks for the defects that Surface::from_triangles() does not find, except pillows and sizes.
bool acceptable(const MeshLists& lists) {
  if (lists.points.empty() || lists.triangles.empty()) return false;
  return all_measurable(lists);
}

/// Moves isolated vertices that cannot be measured to the position of a measurable vertex. Boxes
/// around all points stay finite, and no curve passes an isolated vertex.
void place_strays(std::vector<Point>& points) {
  const auto measurable = std::find_if(points.begin(), points.end(), can_be_measured);
  if (measurable == points.end()) return;
  const Point place = *measurable;
  std::replace_if(
      points.begin(), points.end(), [](const Point& p) { return !can_be_measured(p); }, place);
}

[[noreturn]] void refuse(const MeshLists& lists, const std::string& otherwise) {
  const std::string why = obstacle(inspect(lists));
  throw Error(ErrorCode::kBadMesh, why.empty() ? otherwise : why);
}

Surface connect(const MeshLists& lists) {
  try {
    return Surface::from_triangles(lists.points.size(), lists.triangles);
  } catch (const Error& error) {
    refuse(lists, error.what());
  }
}

/// Whether two faces share all three edges (a closed pillow), which Surface::from_triangles()
/// accepts.
bool has_pillow(const Surface& surface) {
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const HalfedgeId h = surface.halfedge(FaceId{f});
    const HalfedgeId across = twin(h);
    if (!surface.has_face(across)) continue;
    const FaceId other = surface.face(across);
    const HalfedgeId second = twin(surface.next(h));
    const HalfedgeId third = twin(surface.prev(h));
    if (surface.has_face(second) && surface.face(second) == other && surface.has_face(third) &&
        surface.face(third) == other) {
      return true;
    }
  }
  return false;
}

Surface checked_surface(const MeshLists& lists) {
  if (!acceptable(lists)) refuse(lists, "The mesh cannot be used.");
  Surface surface = connect(lists);
  if (has_pillow(surface)) refuse(lists, "Two faces have the same three vertices.");
  if (!large_enough(lists)) refuse(lists, "The mesh is too small.");
  return surface;
}

/// An edge of length 0 gets this fraction of the longest side of its faces. No edge of a face with
/// a side of length 0 can be flipped, so a path across a row of such faces could not be
/// straightened.
constexpr double kNoLength = 1e-12;

double instead_of_zero(const Surface& surface, const std::vector<double>& lengths, EdgeId e) {
  double longest = 0;
  for (const HalfedgeId h : {halfedge_of(e), twin(halfedge_of(e))}) {
    if (!surface.has_face(h)) continue;
    for (const HalfedgeId side : {surface.next(h), surface.prev(h)}) {
      longest = std::max(longest, lengths[edge_of(side).index()]);
    }
  }
  return kNoLength * longest;
}

}  // namespace

bool all_measurable(const MeshLists& lists) {
  if (std::all_of(lists.points.begin(), lists.points.end(), can_be_measured)) return true;
  const std::size_t n = lists.points.size();
  return std::all_of(lists.triangles.begin(), lists.triangles.end(), [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](std::uint32_t v) { return v >= n || can_be_measured(lists.points[v]); });
  });
}

bool large_enough(const MeshLists& lists) {
  const auto first = std::find_if(lists.points.begin(), lists.points.end(), can_be_measured);
  if (first == lists.points.end()) return true;
  Point low = *first, high = low;
  for (const Point& p : lists.points) {
    if (!can_be_measured(p)) continue;  // no face uses it
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (high - low).stableNorm();
  if (size > 0 && size < kSmallestSize) return false;
  if (size == 0) return true;
  // Tests the same edges and lengths as inspect().
  return std::all_of(lists.triangles.begin(), lists.triangles.end(), [&](const Triangle& t) {
    const std::size_t n = lists.points.size();
    if (t[0] >= n || t[1] >= n || t[2] >= n) return true;
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = lists.points[t[k]];
      const Point& q = lists.points[t[(k + 1) % 3]];
      if ((q - p).squaredNorm() > 2 * kShortestEdge * kShortestEdge)
        continue;  // avoids the square root
      const double length = point_distance(p, q);
      if (length > 0 && length < kShortestEdge) return false;
    }
    return true;
  });
}

SurfaceMesh SurfaceMesh::open(const MeshLists& lists) {
  SurfaceMesh mesh;
  mesh.surface_ = checked_surface(lists);
  mesh.points_ = lists.points;
  place_strays(mesh.points_);
  mesh.measure();
  return mesh;
}

SurfaceMesh SurfaceMesh::open(MeshLists&& lists) {
  SurfaceMesh mesh;
  mesh.surface_ = checked_surface(lists);
  mesh.points_ = std::move(lists.points);
  place_strays(mesh.points_);
  mesh.measure();
  return mesh;
}

SurfaceMesh SurfaceMesh::moved(MeshLists&& lists) const {
  bool same =
      lists.points.size() == points_.size() && lists.triangles.size() == surface_.face_count();
  for (std::size_t f = 0; same && f < lists.triangles.size(); ++f) {
    const std::array<VertexId, 3> corners = surface_.corners(FaceId{f});
    for (std::size_t k = 0; k < 3; ++k) {
      same = same && corners[k].index() == lists.triangles[f][k];
    }
  }
  if (!same) {
    throw Error(ErrorCode::kBadUsage,
                "The mesh has other vertices or faces than when it was opened.");
  }
  if (!acceptable(lists)) refuse(lists, "The mesh cannot be used.");
  if (!large_enough(lists)) refuse(lists, "The mesh is too small.");
  return moved(std::move(lists.points));
}

SurfaceMesh SurfaceMesh::moved(std::vector<Point>&& points) const {
  SurfaceMesh mesh;
  mesh.surface_ = surface_;
  mesh.points_ = std::move(points);
  place_strays(mesh.points_);
  mesh.measure();
  return mesh;
}

/// Computes the edge lengths and their mean.
void SurfaceMesh::measure() {
  std::vector<double> lengths(surface_.edge_count());
  double total = 0;
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    lengths[e] = point_distance(point(surface_.tail(h)), point(surface_.head(h)));
    total += lengths[e];
  }
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    if (lengths[e] == 0) lengths[e] = instead_of_zero(surface_, lengths, EdgeId{e});
  }
  mean_edge_length_ = total / static_cast<double>(lengths.size());
  surface_.set_lengths(std::move(lengths));
}

Point SurfaceMesh::position(const SurfacePoint& point) const {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return this->point(v->vertex);
  if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    const HalfedgeId h = halfedge_of(e->edge);
    return (1 - e->t) * this->point(surface_.tail(h)) + e->t * this->point(surface_.head(h));
  }
  const auto& inside = std::get<InFace>(point.where());
  const std::array<VertexId, 3> corner = surface_.corners(inside.face);
  // Interpolation relative to a corner loses no digits far from the origin.
  const Point& base = this->point(corner[0]);
  return base + inside.barycentric[1] * (this->point(corner[1]) - base) +
         inside.barycentric[2] * (this->point(corner[2]) - base);
}

std::vector<Point> positions_of(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  std::vector<Point> positions;
  positions.reserve(curve.points.size());
  for (const SurfacePoint& point : curve.points) positions.push_back(mesh.position(point));
  return positions;
}

}  // namespace talweg
