// Intersects rays with a mesh, for the mouse.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <vtkSmartPointer.h>

class vtkDataSet;
class vtkPolyData;
class vtkStaticCellLocator;

namespace talweg::paraview {

/// Tolerance of a ray at a face, as a part of the mesh's diagonal. With it no ray passes between
/// two faces, or at a vertex, because of rounding.
constexpr double kNoGap = 1e-9;

/// Finds the first point of a mesh on a ray. The search structure is kept while the mesh is the
/// same.
class MeshRay {
 public:
  MeshRay();
  ~MeshRay();
  MeshRay(const MeshRay&) = delete;
  MeshRay& operator=(const MeshRay&) = delete;

  /// The first point on the segment between two places; empty if the segment does not meet the
  /// mesh.
  [[nodiscard]] std::optional<std::array<double, 3>> meet(vtkDataSet& mesh,
                                                          const std::array<double, 3>& from,
                                                          const std::array<double, 3>& to);

 private:
  vtkSmartPointer<vtkStaticCellLocator> locator_;
  vtkSmartPointer<vtkPolyData> surface_;
  const void* mesh_ = nullptr;
  std::uint64_t time_ = 0;
};

}  // namespace talweg::paraview
