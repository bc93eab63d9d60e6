// An unrolled mesh has a strip of surface for a curve that crosses itself, where it does not.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A mesh made of copies of another mesh's faces, and curves on it.
struct UnrolledMesh {
  MeshLists lists;
  std::vector<FaceId> face_of;      ///< per face of `lists`: the face it is a copy of
  std::vector<VertexId> vertex_of;  ///< per vertex, likewise
  /// Ways from the curves that are no longer lie on the strips, mesh units; infinite where no strip
  /// was cut off.
  double near = HUGE_VAL;
  bool may_grow = false;     ///< whether a longer reach would have given more faces
  std::vector<bool> at_cut;  ///< per vertex: whether it is farther from its curve than `near`
  std::size_t faces_of_strips = 0;  ///< the others are those of a whole copy
  struct Place {
    FaceId face;         ///< of `lists`
    SurfacePoint point;  ///< on the original mesh, in the face that this one is a copy of
  };
  std::vector<std::vector<Place>> curves;  ///< per curve its points, one for each

  /// The curves moved to the mesh that was opened from `lists`; their order of points is kept.
  [[nodiscard]] std::vector<SurfaceCurve> unrolled(const SurfaceMesh& from, const Surface& copies,
                                                   std::span<const SurfaceCurve> curves) const;
  /// Moves a curve back. Every point of it lies on a copy of the face, edge or vertex it came from.
  [[nodiscard]] SurfaceCurve folded(const Surface& copies, const Surface& original,
                                    const SurfaceCurve& curve) const;
};

/// Gives each curve with `alone` set a strip of surface of its own: copies of the faces along the
/// curve, one after the other, and of as many faces around them as lie within `reach` (mesh units,
/// along edges). Where the curve comes back to a place on the mesh, it meets other copies of the
/// faces there. Only faces around one vertex of the strip are joined as they are on the mesh. So
/// the strip is a covering of the curve's neighbourhood, on which loops of more than a few edges
/// are apart from each other. A strip that turns around a vertex more than once is left open there.
/// Sides that meet at the end of equally long ways from one place of the curve are joined, so that
/// a handle is laid out once. Curves without `alone` share one whole copy of the mesh. So do a
/// closed curve of so few faces that its strip does not close, and a curve whose strip turns around
/// two neighbouring vertices more than once. O(faces of the strips, log). Throws Cancelled when
/// `progress` (stage "solve") says so.
UnrolledMesh unroll(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                    const std::vector<bool>& alone, double reach, const Progress& progress = {});

}  // namespace talweg
