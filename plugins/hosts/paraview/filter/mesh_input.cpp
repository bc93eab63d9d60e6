#include "mesh_input.hpp"

#include <algorithm>
#include <stdexcept>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>
#include <vtkVector.h>
#include <vtkVectorOperators.h>

namespace talweg::paraview {
namespace {

talweg_array view_of(const void* data, std::uint64_t rows, std::uint32_t type) {
  return {data, rows, 0, 3, type};
}

std::vector<vtkIdType> corners_of(vtkCellArrayIterator& cell) {
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  cell.GetCurrentCell(count, corners);
  return {corners, corners + count};
}

/// Whether the fan from the first corner covers the polygon: no triangle of the fan is inverted.
bool fan_covers(vtkPoints& points, const std::vector<vtkIdType>& corners) {
  const auto at = [&](std::size_t k) {
    vtkVector3d p;
    points.GetPoint(corners[k], p.GetData());
    return p;
  };
  std::vector<vtkVector3d> areas;
  vtkVector3d sum(0.0);
  for (std::size_t k = 2; k < corners.size(); ++k) {
    areas.push_back((at(k - 1) - at(0)).Cross(at(k) - at(0)));
    sum = sum + areas.back();
  }
  const double limit = -1e-12 * sum.SquaredNorm();
  return std::none_of(areas.begin(), areas.end(),
                      [&](const vtkVector3d& area) { return area.Dot(sum) < limit; });
}

/// The corners of triangles that fill the polygon, one after the other; empty if VTK finds none, as
/// for a polygon that crosses itself.
std::vector<vtkIdType> inside(vtkPoints& points, const std::vector<vtkIdType>& corners) {
  vtkNew<vtkPolygon> polygon;
  polygon->Initialize(static_cast<int>(corners.size()), corners.data(), &points);
  vtkNew<vtkIdList> triangles;
  std::vector<vtkIdType> found;
  if (polygon->Triangulate(triangles) == 0) return found;
  if (triangles->GetNumberOfIds() != static_cast<vtkIdType>(3 * (corners.size() - 2))) return found;
  for (const vtkIdType k : *triangles) found.push_back(corners[static_cast<std::size_t>(k)]);
  return found;
}

}  // namespace

vtkSmartPointer<vtkPolyData> polydata_of(vtkDataSet& input) {
  if (auto* polydata = vtkPolyData::SafeDownCast(&input)) return polydata;
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(&input);
  surface->PassThroughPointIdsOn();
  surface->Update();
  return surface->GetOutput();
}

MeshInput::State MeshInput::state_of(vtkDataSet& input) {
  auto* polydata = vtkPolyData::SafeDownCast(&input);
  if (polydata == nullptr) return {&input, nullptr, nullptr, input.GetMTime()};
  // The data set itself is not compared: pipelines pass the same geometry on in another data set.
  return {nullptr, polydata->GetPoints(), polydata->GetPolys(), polydata->GetMeshMTime()};
}

bool MeshInput::update(vtkDataSet& input) {
  const State state = state_of(input);
  auto* polydata = vtkPolyData::SafeDownCast(&input);
  if (surface_ != nullptr && state == state_) {
    if (polydata != nullptr) surface_ = polydata;  // arrays may be new
    return false;
  }
  forget();
  surface_ = polydata_of(input);
  if (polydata == nullptr) note_ = "The mesh is the outer surface of the data set.";
  cut_into_triangles();
  state_ = state;
  return true;
}

void MeshInput::forget() {
  state_ = {};
  surface_ = nullptr;
  triangles_.clear();
  cells_.clear();
  note_.clear();
}

void MeshInput::cut_into_triangles() {
  vtkPolyData& mesh = *surface_;
  vtkIdType cell = mesh.GetNumberOfVerts() + mesh.GetNumberOfLines();
  const bool faces_only = cell == 0;
  bool cut = mesh.GetNumberOfStrips() > 0;
  const auto polygons = vtk::TakeSmartPointer(mesh.GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell()) {
    const std::vector<vtkIdType> corners = corners_of(*polygons);
    cut = cut || corners.size() > 3;
    add_polygon(corners, cell++);
  }
  const auto strips = vtk::TakeSmartPointer(mesh.GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell()) {
    add_strip(corners_of(*strips), cell++);
  }
  as_given_ = faces_only && !cut;
  if (cut)
    note_ += std::string(note_.empty() ? "" : " ") + "The mesh's polygons were cut into triangles.";
}

void MeshInput::add_polygon(const std::vector<vtkIdType>& corners, vtkIdType cell) {
  if (corners.size() < 3) {
    throw std::runtime_error("Cell " + std::to_string(cell) + " of the mesh has " +
                             std::to_string(corners.size()) + " corners; a face has at least 3.");
  }
  const vtkIdType count = surface_->GetNumberOfPoints();
  const bool known = std::all_of(corners.begin(), corners.end(),
                                 [&](vtkIdType v) { return v >= 0 && v < count; });  // otherwise
                                                                                     // refused
  if (known && corners.size() > 3 && !fan_covers(*surface_->GetPoints(), corners)) {
    const std::vector<vtkIdType> triangles = inside(*surface_->GetPoints(), corners);
    for (std::size_t k = 0; k < triangles.size(); k += 3) {
      add(triangles[k], triangles[k + 1], triangles[k + 2], cell);
    }
    if (!triangles.empty()) return;
  }
  for (std::size_t k = 2; k < corners.size(); ++k)
    add(corners[0], corners[k - 1], corners[k], cell);
}

void MeshInput::add_strip(const std::vector<vtkIdType>& corners, vtkIdType cell) {
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const std::size_t turned = k % 2;  // the orientation of triangles in a strip alternates
    add(corners[k - 2 + turned], corners[k - 1 - turned], corners[k], cell);
  }
}

void MeshInput::add(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell) {
  const auto index = [](vtkIdType v) { return static_cast<std::uint32_t>(v); };
  triangles_.push_back({index(a), index(b), index(c)});
  cells_.push_back(cell);
}

talweg_array MeshInput::positions() {
  vtkPoints* points = surface_->GetPoints();
  const auto count = static_cast<std::uint64_t>(surface_->GetNumberOfPoints());
  if (count == 0) return view_of(nullptr, 0, TALWEG_FLOAT64);
  vtkDataArray& data = *points->GetData();
  if (data.HasStandardMemoryLayout() && data.GetDataType() == VTK_DOUBLE) {
    return view_of(data.GetVoidPointer(0), count, TALWEG_FLOAT64);
  }
  if (data.HasStandardMemoryLayout() && data.GetDataType() == VTK_FLOAT) {
    return view_of(data.GetVoidPointer(0), count, TALWEG_FLOAT32);
  }
  converted_.resize(3 * count);
  for (std::uint64_t k = 0; k < count; ++k) {
    points->GetPoint(static_cast<vtkIdType>(k), &converted_[3 * k]);
  }
  return view_of(converted_.data(), count, TALWEG_FLOAT64);
}

talweg_array MeshInput::triangles() const {
  return view_of(triangles_.data(), triangles_.size(), TALWEG_UINT32);
}

void MeshInput::copy_to(vtkPolyData& out) const {
  out.SetPoints(surface_->GetPoints());
  out.GetPointData()->ShallowCopy(surface_->GetPointData());
  out.GetFieldData()->ShallowCopy(surface_->GetFieldData());
  if (as_given_) {
    out.SetPolys(surface_->GetPolys());
    out.GetCellData()->ShallowCopy(surface_->GetCellData());
    return;
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& triangle : triangles_) {
    const vtkIdType corners[] = {triangle[0], triangle[1], triangle[2]};
    polygons->InsertNextCell(3, corners);
  }
  out.SetPolys(polygons);
  vtkCellData* values = out.GetCellData();
  values->CopyAllocate(surface_->GetCellData(), static_cast<vtkIdType>(cells_.size()));
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    values->CopyData(surface_->GetCellData(), cells_[k], static_cast<vtkIdType>(k));
  }
}

}  // namespace talweg::paraview
