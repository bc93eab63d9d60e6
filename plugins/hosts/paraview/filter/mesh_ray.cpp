#include "mesh_ray.hpp"

#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include "mesh_input.hpp"

namespace talweg::paraview {

MeshRay::MeshRay() = default;
MeshRay::~MeshRay() = default;

std::optional<std::array<double, 3>> MeshRay::meet(vtkDataSet& mesh,
                                                   const std::array<double, 3>& from,
                                                   const std::array<double, 3>& to) {
  if (mesh.GetNumberOfCells() == 0) return std::nullopt;
  if (locator_ == nullptr || mesh_ != &mesh || time_ != mesh.GetMTime()) {
    surface_ = vtkSmartPointer<vtkPolyData>::New();  // a copy that no other filter changes
    surface_->ShallowCopy(polydata_of(mesh));
    mesh_ = &mesh;
    time_ = mesh.GetMTime();
    locator_ = vtkSmartPointer<vtkStaticCellLocator>::New();
    locator_->SetDataSet(surface_);
    locator_->BuildLocator();
  }
  std::array<double, 3> found = {};
  double t = 0, parametric[3] = {};
  int part = 0;
  const int hit = locator_->IntersectWithLine(
      from.data(), to.data(), kNoGap * surface_->GetLength(), t, found.data(), parametric, part);
  if (hit == 0) return std::nullopt;
  return found;
}

}  // namespace talweg::paraview
