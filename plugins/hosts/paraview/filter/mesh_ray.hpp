// What the mouse meets on a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <vtkSmartPointer.h>

class vtkDataSet;
class vtkPolyData;
class vtkStaticCellLocator;

namespace talweg::paraview {

/// Rays meet faces within so much of the mesh's diagonal: between two faces, or at a vertex, there
/// is no gap that a rounded number falls into.
constexpr double kNoGap = 1e-9;

/// Finds where rays meet a mesh first. The search structure is kept while the mesh is the same.
class MeshRay {
 public:
  MeshRay();
  ~MeshRay();
  MeshRay(const MeshRay&) = delete;
  MeshRay& operator=(const MeshRay&) = delete;

  /// The first point between two places; empty if the mesh is not between them.
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
