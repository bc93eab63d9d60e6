// An unrolled mesh has a strip of surface for a curve that crosses itself; on the strip the curve
// does not cross.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A mesh of copies of another mesh's faces, and curves on it.
struct UnrolledMesh {
  MeshLists lists;
  std::vector<FaceId> face_of;      ///< per face of `lists`, the original face
  std::vector<VertexId> vertex_of;  ///< per vertex of `lists`, the original vertex
  /// Mesh units: all ways from the curves up to this length lie on the strips; infinite if no strip
  /// was cut off.
  double near = HUGE_VAL;
  bool may_grow = false;     ///< whether a longer reach would add faces
  std::vector<bool> at_cut;  ///< per vertex, whether it is farther from its curve than `near`
  std::size_t faces_of_strips = 0;  ///< the other faces belong to a whole copy of the mesh
  struct Place {
    FaceId face;         ///< of `lists`
    SurfacePoint point;  ///< on the original mesh, in the face's original
  };
  std::vector<std::vector<Place>> curves;  ///< per curve, the places of its points

  /// Converts the curves to the mesh that was opened from `lists`, in the same order of points.
  [[nodiscard]] std::vector<SurfaceCurve> unrolled(const SurfaceMesh& from, const Surface& copies,
                                                   std::span<const SurfaceCurve> curves) const;
  /// Converts a curve back to the original mesh.
  [[nodiscard]] SurfaceCurve folded(const Surface& copies, const Surface& original,
                                    const SurfaceCurve& curve) const;
};

/// Makes a separate strip of surface for each curve with `alone` set: copies of the faces along the
/// curve, and of the faces within `reach` of it (mesh units, along edges). Where the curve comes
/// back to a place on the mesh, the strip has other copies of the faces. Copies are joined as on
/// the mesh only around one vertex of the strip. The strip is therefore a covering of the curve's
/// neighbourhood, on which the parts of a loop of more than a few edges do not meet. A strip that
/// turns around a vertex more than once stays open there. Sides that are reached by ways from
/// nearby places of the curve are joined, so a handle is laid out once. Curves without `alone`
/// share one whole copy of the mesh; so do closed curves of too few faces for a closed strip, and
/// curves whose strips turn around two neighbouring vertices more than once. O(n log n) for n faces
/// of the strips. Throws Cancelled (stage "solve").
UnrolledMesh unroll(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                    const std::vector<bool>& alone, double reach, const Progress& progress = {});

}  // namespace talweg
