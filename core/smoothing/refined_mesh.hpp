// A refined mesh has divided faces along a drawing, as fine as the drawing.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A part of a mesh as a separate mesh with smaller faces, and curves on it.
struct RefinedMesh {
  MeshLists lists;
  std::vector<FaceId> face_of;  ///< per face of `lists`, the original face that contains it
  using Corners = std::array<std::array<double, 3>, 3>;
  std::vector<Corners> corners_of;  ///< per face, its corners in the original face
  struct Place {
    FaceId face;                        ///< of `lists`
    std::array<double, 3> barycentric;  ///< in the face; exactly 0 on its sides
    std::size_t drawn = 0;              ///< the point of the drawing here, or the previous one
    double part = 0;                    ///< fraction of the way to the next point, in [0, 1)
  };
  /// Per vertex of `lists`: whether the original surface continues beyond this part.
  std::vector<bool> at_cut;
  /// Per curve, its points in order: the points of the drawing, and its crossings with new edges.
  std::vector<std::vector<Place>> curves;

  /// The curves on the mesh that was opened from `lists`.
  [[nodiscard]] std::vector<SurfaceCurve> refined(const Surface& fine,
                                                  std::span<const SurfaceCurve> drawn) const;
  /// Converts a curve on the refined mesh to the original mesh.
  [[nodiscard]] SurfaceCurve coarse(const Surface& fine, const Surface& original,
                                    const SurfaceCurve& curve) const;
};

/// The faces that are too large for the drawing. In such a face the drawing deviates from the
/// straight line through the face by more than four slacks (half a slack, if the face's edges are
/// longer than eight slacks), so a curve with points on edges cannot follow the drawing. A face
/// with more than 64 consecutive points of the drawing is also too large, because the cost is
/// quadratic in their number. Curves along edges have no such faces. O(points).
std::vector<FaceId> too_large_faces(const SurfaceMesh& mesh, const SurfaceCurve& drawn,
                                    double slack);

/// Divides `faces` along the curves by bisecting longest edges (M.-C. Rivara, 1984; conforming,
/// with no angle below half of the smallest) until the edges are not longer than the curve's
/// `longest` (mesh units, > 0) and no face has more than 64 segments. The result contains the faces
/// within `reach` of the curves (mesh units, along edges; infinite for whole components). The
/// drawing is unchanged up to rounding. O(n log n) for faces in reach and points. Throws Cancelled
/// (stage "solve").
RefinedMesh refine_along(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                         std::span<const FaceId> faces, std::span<const double> longest,
                         double reach, const Progress& progress = {});

}  // namespace talweg
