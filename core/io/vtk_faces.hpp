// The cells of VTK files become faces, and the arrays of points and cells become attributes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::formats {

/// The types of cells of an unstructured grid (vtkCellType.h) that matter here.
enum class VtkCell : std::uint8_t { kLess, kPolygon, kPixel, kStrip, kVolume };

/// An array of numbers, one tuple per point or cell of a piece.
struct VtkArray {
  std::string name;
  NumberType type = NumberType::kFloat64;
  std::size_t components = 1;
  std::vector<double> numbers;
};

/// Collects the pieces of a file. Cells are added in the order of their numbers.
class VtkFaces {
 public:
  /// Attributes are collected if `attributes` is not null.
  VtkFaces(MeshLists& lists, MeshAttributes* attributes) : lists_(lists), attributes_(attributes) {}

  /// Throws a file's error with the place.
  using Fail = std::function<void(const std::string&)>;

  /// Begins a piece; three coordinates for each point.
  void begin_piece(std::span<const double> coordinates);
  /// Adds a cell of the piece, given by point numbers that count from the first point of the piece.
  void add_cell(VtkCell kind, std::span<const double> corners, const Fail& fail);
  /// Counts cells without faces for the notes; `what` names their kind ("vertices", "lines").
  void skip_cells(std::size_t count, std::string_view what);
  /// Ends a piece, with the arrays of its points and cells. Arrays that do not fit are named in
  /// `left_out`.
  void end_piece(std::vector<VtkArray> of_points, std::vector<VtkArray> of_cells);
  /// Adds the skipped cells to the notes of the mesh.
  void end();

 private:
  void add_columns(std::vector<AttributeColumn>& columns, std::vector<VtkArray>& arrays,
                   std::size_t tuples, std::span<const std::uint32_t> tuple_of, std::size_t before);
  void leave_out(const std::string& name, const char* why);

  MeshLists& lists_;
  MeshAttributes* attributes_;
  std::size_t first_point_ = 0, points_ = 0;    // of the piece
  std::size_t first_triangle_ = 0, cells_ = 0;  // of the piece
  std::size_t pieces_ = 0;
  std::vector<std::uint32_t> cell_of_triangle_;  // of the piece
  std::vector<std::uint32_t> corners_;
  std::vector<std::pair<std::string, std::size_t>> skipped_;
};

/// The kind of a type number of vtkCellType.h.
VtkCell cell_kind(double type);
/// The number of corners among the points of a cell. The corners of quadratic cells come first.
std::size_t cell_corners(double type, std::size_t points);

}  // namespace talweg::formats
