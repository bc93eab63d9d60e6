// A ParaView data set as a mesh of triangles.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "talweg/plugin/talweg_plugin.h"

class vtkDataSet;

namespace talweg::paraview {

/// The data set itself if it is polydata, otherwise its outer surface; points of lines and single
/// points stay.
vtkSmartPointer<vtkPolyData> polydata_of(vtkDataSet& input);

class MeshInput {
 public:
  /// Reads the triangles of the data set: polygons become fans if these cover them, or are
  /// triangulated by VTK; strips are divided. False if only values of arrays have changed since the
  /// last call. Throws std::runtime_error, which names a face, for a face with fewer than three
  /// corners; the mesh is cleared then.
  bool update(vtkDataSet& input);
  /// Clears the mesh, so that the next update() reads everything.
  void forget();

  /// Valid until the next update(); the points are not copied if they are float or double.
  [[nodiscard]] talweg_array positions();
  [[nodiscard]] talweg_array triangles() const;
  /// The corners of each triangle.
  [[nodiscard]] const std::vector<std::array<std::uint32_t, 3>>& corners() const {
    return triangles_;
  }
  /// The triangles with all arrays of the data set.
  void copy_to(vtkPolyData& out) const;
  /// Point arrays of the mesh.
  [[nodiscard]] vtkPointData& arrays() const { return *surface_->GetPointData(); }
  [[nodiscard]] vtkCellData& cell_arrays() const { return *surface_->GetCellData(); }
  /// For each triangle the cell of the data set that it is a part of.
  [[nodiscard]] const std::vector<vtkIdType>& cells() const { return cells_; }
  [[nodiscard]] vtkFieldData& other_arrays() const { return *surface_->GetFieldData(); }
  /// A sentence on how cells became triangles; empty if all were triangles.
  [[nodiscard]] const std::string& note() const { return note_; }

 private:
  void cut_into_triangles();
  void add_polygon(const std::vector<vtkIdType>& corners, vtkIdType cell);
  void add_strip(const std::vector<vtkIdType>& corners, vtkIdType cell);
  void add(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell);

  /// The identity and time of the geometry at the last update().
  struct State {
    const void* data = nullptr;
    const void* points = nullptr;
    const void* polygons = nullptr;
    std::uint64_t time = 0;
    friend bool operator==(const State&, const State&) = default;
  };
  static State state_of(vtkDataSet& input);

  State state_;
  vtkSmartPointer<vtkPolyData> surface_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<vtkIdType> cells_;  // cell of the surface, for each triangle
  bool as_given_ = false;         // whether the surface's cells are the triangles
  std::vector<double> converted_;
  std::string note_;
};

}  // namespace talweg::paraview
