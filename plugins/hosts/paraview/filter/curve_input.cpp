#include "curve_input.hpp"

#include <array>
#include <limits>
#include <stdexcept>
#include <utility>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStripper.h>

#include "mesh_input.hpp"

namespace talweg::paraview {
namespace {

using Line = std::vector<vtkIdType>;

/// The lines of a data set; lines that touch only at their ends are joined.
std::vector<Line> lines_of(vtkPolyData& data) {
  vtkSmartPointer<vtkCellArray> cells = data.GetLines();
  if (cells->GetNumberOfCells() > 1) {
    vtkNew<vtkPolyData> lines;
    lines->SetPoints(data.GetPoints());
    lines->SetLines(cells);
    vtkNew<vtkStripper> stripper;
    stripper->SetInputData(lines);
    stripper->SetMaximumLength(std::numeric_limits<int>::max());
    stripper->JoinContiguousSegmentsOn();
    stripper->Update();
    cells = stripper->GetOutput()->GetLines();
  }
  std::vector<Line> lines;
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    cell->GetCurrentCell(count, points);
    lines.emplace_back(points, points + count);
  }
  if (!lines.empty()) return lines;
  Line all(static_cast<std::size_t>(data.GetNumberOfPoints()));
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<vtkIdType>(k);
  return {all};
}

std::array<double, 3> position(vtkPolyData& data, vtkIdType point) {
  std::array<double, 3> x = {};
  data.GetPoint(point, x.data());
  return x;
}

std::uint32_t vertex_at(vtkDataArray& array, vtkIdType point) {
  const double value = array.GetTuple1(point);
  const bool is_index = value >= 0 && value < static_cast<double>(TALWEG_NO_VERTEX);
  if (!is_index || value != static_cast<double>(static_cast<std::uint32_t>(value))) {
    throw std::runtime_error("The array " + std::string(array.GetName()) + " has " +
                             std::to_string(value) + " at point " + std::to_string(point) +
                             ", which is not a vertex number.");
  }
  return static_cast<std::uint32_t>(value);
}

vtkDataArray* vertex_numbers_of(vtkPolyData& data, const std::string& name) {
  if (name.empty()) return nullptr;
  vtkDataArray* array = data.GetPointData()->GetArray(name.c_str());
  if (array == nullptr || array->GetNumberOfComponents() != 1) {
    throw std::runtime_error("The curve has no point array " + name + " of one component.");
  }
  return array;
}

/// Whether a line ends at its beginning: at the same point, vertex or place.
bool closed(vtkPolyData& data, const Line& line, vtkDataArray* vertices) {
  if (line.size() < 2) return false;
  if (line.front() == line.back()) return true;
  if (line.size() < 4) return false;
  if (vertices != nullptr) {
    return vertex_at(*vertices, line.front()) == vertex_at(*vertices, line.back());
  }
  return position(data, line.front()) == position(data, line.back());
}

void add_curves(vtkDataSet& input, const std::string& vertex_array,
                std::vector<host::Curve>& curves) {
  const vtkSmartPointer<vtkPolyData> data = polydata_of(input);
  vtkDataArray* vertices = vertex_numbers_of(*data, vertex_array);
  vtkDataArray* pins = data->GetPointData()->GetArray("pin");
  vtkDataArray* exact = data->GetPointData()->GetArray(TALWEG_EXACT);
  for (const Line& line : lines_of(*data)) {
    host::Curve curve;
    curve.closed = closed(*data, line, vertices);
    for (std::size_t k = 0; k < line.size() - (curve.closed ? 1 : 0); ++k) {
      if (vertices != nullptr) {
        curve.vertices.push_back(vertex_at(*vertices, line[k]));
      } else {
        curve.positions.push_back(position(*data, line[k]));
      }
      if (pins != nullptr && pins->GetComponent(line[k], 0) != 0) {
        curve.pins.push_back(static_cast<std::uint32_t>(k));
      }
      if (exact != nullptr) curve.exact.push_back(exact->GetComponent(line[k], 0));
    }
    curves.push_back(std::move(curve));
  }
}

}  // namespace

std::vector<vtkDataSet*> data_sets_of(vtkDataObject& input) {
  if (auto* data = vtkDataSet::SafeDownCast(&input)) return {data};
  std::vector<vtkDataSet*> blocks;
  auto* composite = vtkCompositeDataSet::SafeDownCast(&input);
  if (composite == nullptr) return blocks;
  const auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem()) {
    auto* data = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject());
    if (data != nullptr && data->GetNumberOfPoints() > 0) blocks.push_back(data);
  }
  return blocks;
}

std::vector<host::Curve> curves_of(vtkDataObject& input, const std::string& vertex_array) {
  std::vector<host::Curve> curves;
  for (vtkDataSet* data : data_sets_of(input)) add_curves(*data, vertex_array, curves);
  if (curves.empty()) throw std::runtime_error("The input Curve has no points.");
  return curves;
}

host::Curve curve_through(std::vector<std::uint32_t> vertices) {
  host::Curve curve;
  curve.closed = vertices.size() > 1 && vertices.front() == vertices.back();
  if (curve.closed) vertices.pop_back();
  curve.vertices = std::move(vertices);
  return curve;
}

}  // namespace talweg::paraview
