// A refined mesh has faces along a drawing divided until they are as fine as it is.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A part of a mesh's surface as a mesh of its own with smaller faces, and curves on it.
struct RefinedMesh {
  MeshLists lists;
  std::vector<FaceId> face_of;  ///< per face of `lists`: the face of the mesh that it is a part of
  using Corners = std::array<std::array<double, 3>, 3>;
  std::vector<Corners> corners_of;  ///< per face: the barycentrics there of its three corners
  struct Place {
    FaceId face;                        ///< of `lists`
    std::array<double, 3> barycentric;  ///< there; exactly 0 on its sides
    std::size_t drawn = 0;  ///< the point of the drawing that this is, or the one before it
    double part = 0;        ///< of the way to the next one, in [0, 1)
  };
  /// Per vertex of `lists`: whether the original surface goes on there beyond this part.
  std::vector<bool> at_cut;
  /// Per curve its points: those of the drawing, in their order, and those where it crosses new
  /// edges.
  std::vector<std::vector<Place>> curves;

  /// The curves on the mesh that was opened from `lists`.
  [[nodiscard]] std::vector<SurfaceCurve> refined(const Surface& fine,
                                                  std::span<const SurfaceCurve> drawn) const;
  /// A curve on the refined mesh, moved to the original mesh.
  [[nodiscard]] SurfaceCurve coarse(const Surface& fine, const Surface& original,
                                    const SurfaceCurve& curve) const;
};

/// The faces that are too large for the drawing. In such a face the drawing deviates from the
/// straight line through it by more than four times the slack (or half the slack, if the face's
/// edges are longer than eight slacks), so that no curve with its points on the edges can follow
/// it. A face is also too large if it has more than 64 points of the drawing in a row, because the
/// cost is quadratic in them. Curves along edges have no such faces. O(points).
std::vector<FaceId> too_large_faces(const SurfaceMesh& mesh, const SurfaceCurve& drawn,
                                    double slack);

/// Divides `faces` along the curves by bisecting longest edges (M.-C. Rivara, 1984; conforming, and
/// no angle below half the smallest one) until the edges are no longer than the curve's `longest`
/// (mesh units, > 0) and no face has more than 64 of its segments. The result includes the faces up
/// to `reach` around the curves (mesh units, along edges; infinite: everything connected with
/// them). The drawing stays the same up to rounding. O(faces in reach + points, log). Throws
/// Cancelled when `progress` (stage "solve") says so.
RefinedMesh refine_along(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                         std::span<const FaceId> faces, std::span<const double> longest,
                         double reach, const Progress& progress = {});

}  // namespace talweg
