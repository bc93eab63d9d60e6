// An opened mesh and its curves follow changes of the caller's OpenMesh mesh.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "talweg/core/openmesh/openmesh_adaptor.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A hash of a mesh that tells whether it has changed. Different meshes have equal stamps with a
/// probability of 2^-64.
struct OpenMeshStamp {
  std::uint64_t connectivity = 0;  ///< hash of the corners of faces and the deleted bits
  std::uint64_t points = 0;
  friend bool operator==(const OpenMeshStamp&, const OpenMeshStamp&) = default;
};

namespace detail {

class Hash {
 public:
  void add(std::uint64_t value) {  // the finalizer of splitmix64, chained
    std::uint64_t x = state_ + value + 0x9E3779B97F4A7C15U;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
    state_ = x ^ (x >> 31U);
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace detail

/// O(mesh).
template <OpenMeshKernel Mesh>
OpenMeshStamp stamp_of(const Mesh& mesh) {
  detail::Hash connectivity, points;
  connectivity.add(mesh.n_vertices());
  for (std::size_t i = 0; i < mesh.n_vertices(); ++i) {
    const OpenMesh::VertexHandle v(static_cast<int>(i));
    if (detail::is_deleted(mesh, v)) {
      connectivity.add(i);
      continue;
    }
    const auto& p = mesh.point(v);
    for (int k = 0; k < 3; ++k) points.add(std::bit_cast<std::uint64_t>(static_cast<double>(p[k])));
  }
  connectivity.add(mesh.n_faces());
  for (std::size_t i = 0; i < mesh.n_faces(); ++i) {
    const OpenMesh::FaceHandle f(static_cast<int>(i));
    if (detail::is_deleted(mesh, f)) continue;
    const OpenMesh::HalfedgeHandle first = mesh.halfedge_handle(f);
    OpenMesh::HalfedgeHandle h = first;
    do {
      connectivity.add(static_cast<std::uint64_t>(mesh.to_vertex_handle(h).idx()));
      h = mesh.next_halfedge_handle(h);
    } while (h != first);
    connectivity.add(~std::uint64_t{i});
  }
  return {connectivity.value(), points.value()};
}

/// Opens a mesh again after its vertices have moved: points and edge lengths are new, the
/// connectivity is that of `opened`. `ids` is the numbering of the first opening. Throws
/// Error(kBadUsage) if the connectivity has changed, and Error(kBadMesh) as open_mesh() does for
/// the new points.
template <OpenMeshKernel Mesh>
std::shared_ptr<const OpenedMesh> reopen(const Mesh& mesh, const OpenMeshIds& ids,
                                         const OpenedMesh& opened) {
  OpenMeshIds now;
  MeshLists lists = lists_of(mesh, &now);
  if (now != ids) lists.triangles.clear();  // moved() refuses it
  return OpenedMesh::open(opened.mesh().moved(std::move(lists)));
}

namespace detail {

/// The surface of an opened mesh with its numbering.
struct Numbered {
  const OpenMeshIds& ids;
  const Surface& surface;
};

class CurveKeeper {
 public:
  CurveKeeper(Numbered old, Numbered now) : old_(old), now_(now) {}

  std::vector<SurfaceCurve> run(const SurfaceCurve& curve) {
    const std::size_t n = curve.points.size();
    std::vector<std::optional<SurfacePoint>> points;
    for (const SurfacePoint& point : curve.points) points.push_back(kept(point));
    const std::size_t segments = curve.closed ? n : n - (n > 0 ? 1 : 0);
    std::vector<bool> whole(segments);
    std::size_t begin =
        0;  // after a gap, so that a loop's stretches are not split at its first point
    for (std::size_t k = 0; k < segments; ++k) {
      const std::size_t next = (k + 1) % n;
      whole[k] = points[k] && points[next] && has_face(curve.points[k], curve.points[next]);
      if (!whole[k] && curve.closed) begin = next;
    }
    std::vector<SurfaceCurve> result;
    SurfaceCurve stretch;
    const auto end_stretch = [&] {
      if (stretch.points.size() > 1) result.push_back(std::move(stretch));
      stretch = {};
    };
    for (std::size_t j = 0; j < segments; ++j) {
      const std::size_t k = (begin + j) % n;
      if (!whole[k]) {
        end_stretch();
        continue;
      }
      if (stretch.points.empty()) stretch.points.push_back(*points[k]);
      stretch.points.push_back(*points[(k + 1) % n]);
    }
    if (curve.closed && stretch.points.size() == n + 1) {
      stretch.closed = true;
      stretch.points.pop_back();
    }
    end_stretch();
    return result;
  }

 private:
  [[nodiscard]] VertexId kept(VertexId v) const { return now_.ids.find(old_.ids.handle(v)); }

  /// The triangle with the same corners; invalid if there is none.
  [[nodiscard]] FaceId kept(FaceId f) const {
    const std::array<VertexId, 3> corners = old_.surface.corners(f);
    std::array<VertexId, 3> there;
    for (std::size_t k = 0; k < 3; ++k) {
      there[k] = kept(corners[k]);
      if (!there[k].valid()) return {};
    }
    const HalfedgeId h = now_.surface.find_halfedge(there[0], there[1]);
    if (!h.valid() || !now_.surface.has_face(h)) return {};
    return now_.surface.head(now_.surface.next(h)) == there[2] ? now_.surface.face(h) : FaceId();
  }

  [[nodiscard]] std::optional<SurfacePoint> kept(const SurfacePoint& point) const {
    for (const FaceId f : faces_at(old_.surface, point)) {
      const FaceId there = kept(f);
      if (there.valid()) return in(f, there, point);
    }
    return std::nullopt;
  }

  [[nodiscard]] SurfacePoint in(FaceId old_face, FaceId face, const SurfacePoint& point) const {
    const FaceCoordinates at = coordinates_in(old_.surface, point, old_face);
    const std::array<VertexId, 3> from = old_.surface.corners(old_face);
    const std::array<VertexId, 3> to = now_.surface.corners(face);
    std::array<double, 3> barycentric{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (to[c] == kept(from[k])) barycentric[c] = at.barycentric[k];
      }
    }
    return SurfacePoint::from_barycentric(now_.surface, face, barycentric, 0);
  }

  [[nodiscard]] bool has_face(const SurfacePoint& p, const SurfacePoint& q) const {
    for (const FaceId f : faces_at(old_.surface, p)) {
      if (!kept(f).valid()) continue;
      const auto of_q = faces_at(old_.surface, q);
      if (std::find(of_q.begin(), of_q.end(), f) != of_q.end()) return true;
    }
    return false;
  }

  Numbered old_, now_;
};

}  // namespace detail

/// The stretches of a curve that survive deleting, adding, splitting or flipping of faces, on the
/// mesh that was opened again. A stretch survives in triangles with unchanged vertex handles. The
/// stretches are in the order of the curve; a curve that survives whole is returned whole.
/// garbage_collection() changes handles, so call this function before it.
inline std::vector<SurfaceCurve> kept_stretches(const SurfaceCurve& curve,
                                                const OpenMeshIds& old_ids,
                                                const Surface& old_surface,
                                                const OpenMeshIds& new_ids,
                                                const Surface& new_surface) {
  return detail::CurveKeeper({old_ids, old_surface}, {new_ids, new_surface}).run(curve);
}

}  // namespace talweg
