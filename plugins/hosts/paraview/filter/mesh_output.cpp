#include "mesh_output.hpp"

#include <array>
#include <map>
#include <utility>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include "carried_arrays.hpp"

namespace talweg::paraview {
namespace {

vtkSmartPointer<vtkPoints> double_points() {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  return points;
}

/// The vertices of a curve's chain, by their places.
using Chain = std::map<std::uint32_t, std::array<double, 3>>;

std::vector<Chain> chains_of(const std::vector<host::Mesh>& meshes,
                             const std::vector<host::Origin>& origins) {
  std::vector<Chain> chains(origins.empty() ? 0 : origins.front().lengths.size());
  for (std::size_t m = 0; m < origins.size(); ++m) {
    for (const auto& [curve, place, vertex] : origins[m].chains) {
      chains.at(curve).try_emplace(place, meshes.at(m).positions.at(vertex));
    }
  }
  return chains;
}

}  // namespace

void give(const host::Mesh& mesh, const host::Origin& origin, const MeshInput& from,
          vtkPolyData& out) {
  const auto points = double_points();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.positions.size()));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    points->SetPoint(static_cast<vtkIdType>(v), mesh.positions[v].data());
  }
  out.SetPoints(points);
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(static_cast<vtkIdType>(mesh.triangles.size()),
                           static_cast<vtkIdType>(3 * mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    const vtkIdType corners[] = {triangle[0], triangle[1], triangle[2]};
    triangles->InsertNextCell(3, corners);
  }
  out.SetPolys(triangles);
  std::vector<vtkIdType> cells;
  for (const std::uint32_t t : origin.triangles) {
    cells.push_back(t == TALWEG_NO_TRIANGLE ? -1 : from.cells().at(t));
  }
  carry_points(from.arrays(), origin, *out.GetPointData());
  carry_cells(from.cell_arrays(), cells, *out.GetCellData());
  out.GetFieldData()->ShallowCopy(&from.other_arrays());
  vtkNew<vtkIdTypeArray> array;
  array->SetName("origin_cell");
  for (const vtkIdType cell : cells) array->InsertNextValue(cell);
  out.GetCellData()->AddArray(array);
}

void give_chains(const std::vector<host::Mesh>& meshes, const std::vector<host::Origin>& origins,
                 vtkPolyData& out) {
  const std::vector<Chain> chains = chains_of(meshes, origins);
  const auto points = double_points();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdTypeArray> curves;
  curves->SetName("curve");
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const std::uint32_t length = origins.front().lengths[c];
    const bool whole = chains[c].size() == length;
    std::vector<vtkIdType> line;
    const auto end_line = [&] {
      if (line.size() > 1) {
        lines->InsertNextCell(static_cast<vtkIdType>(line.size()), line.data());
        curves->InsertNextValue(static_cast<vtkIdType>(c));
      }
      line.clear();
    };
    const bool closed = origins.front().closed[c] != 0;
    std::uint32_t first = 0;  // in a gap, if the curve is closed and has gaps
    while (closed && !whole && chains[c].contains(first)) ++first;
    for (std::uint32_t k = 0; k < length; ++k) {
      const auto at = chains[c].find((first + k) % length);
      if (at == chains[c].end()) {
        end_line();
      } else {
        line.push_back(points->InsertNextPoint(at->second.data()));
      }
    }
    if (whole && closed && !line.empty()) line.push_back(line.front());
    end_line();
  }
  out.SetPoints(points);
  out.SetLines(lines);
  out.GetCellData()->AddArray(curves);
}

}  // namespace talweg::paraview
