// A refined mesh has faces along a drawing divided until they are as fine as it is.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The same surface as a part of another mesh, in smaller faces, and curves on it.
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
  /// Per vertex of `lists`: whether the surface goes on there, beyond what was taken along.
  std::vector<bool> at_cut;
  /// Whether there is no such vertex.
  [[nodiscard]] bool is_whole() const {
    return std::find(at_cut.begin(), at_cut.end(), true) == at_cut.end();
  }
  /// Per curve its points: those of the drawing, in their order, and where it passes new edges.
  std::vector<std::vector<Place>> curves;

  /// The curves on the mesh that was opened from `lists`.
  [[nodiscard]] std::vector<SurfaceCurve> refined(const Surface& fine,
                                                  std::span<const SurfaceCurve> drawn) const;
  /// A curve on that mesh as one on the original.
  [[nodiscard]] SurfaceCurve coarse(const Surface& fine, const Surface& original,
                                    const SurfaceCurve& curve) const;
};

/// Faces that are too large for the drawing. Inside them it turns aside from the straight way
/// through by more than four times the slack, or half of it where their edges are longer than
/// eight, so that no curve with its points on the edges can follow it; or it has more than 64
/// points in a row there, which costs their square. None for curves along edges. O(points).
std::vector<FaceId> too_large_faces(const SurfaceMesh& mesh, const SurfaceCurve& drawn,
                                    double slack);

/// Divides `faces` along the curves by bisecting longest edges (M.-C. Rivara, 1984; conforming, and
/// no angle below half the smallest one) until these are no longer than the curve's `longest` (mesh
/// units, > 0) and none has more than 64 of its segments. Takes along the faces up to `reach`
/// around the curves (mesh units, along edges; infinite: all that is connected with them). The
/// drawing stays what it is, to rounding. O(faces in reach + points, log). Throws Cancelled when
/// `progress` (stage "solve") says so.
RefinedMesh refine_along(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                         std::span<const FaceId> faces, std::span<const double> longest,
                         double reach, const Progress& progress = {});

}  // namespace talweg
