// Drawn curves are what the scene shows of a drawing: its points, its lines as they lie on the
// mesh, and the leg to the mouse.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "CurveNodes.hh"
#include "talweg/editing/mesh_arrays.hpp"

namespace talweg::openflipper {

class DrawnCurves {
 public:
  /// Without a window there are no nodes.
  explicit DrawnCurves(CurveNodes* nodes) : nodes_(nodes) {}

  void show(const editing::Drawing& drawing, const editing::MeshArrays& arrays);
  /// Lines on the mesh, by the numbers of their curves. A curve that has changed keeps its line
  /// until the new one comes.
  void take(std::vector<host::Curve> lines, const std::vector<std::uint32_t>& numbers,
            const editing::Drawing& drawing);
  /// Null where it is not known.
  [[nodiscard]] const host::Curve* line_of(std::uint32_t number) const;
  void show_leg(const host::Curve& leg, std::uint32_t number);
  void hide_leg();

  /// From the next show() on.
  void set_with_points(bool with) { with_points_ = with; }
  /// Hidden points are not there for the mouse either, but the one that closes a curve.
  [[nodiscard]] bool shows_point(const editing::Drawing& drawing, std::size_t curve,
                                 std::size_t point) const;

 private:
  [[nodiscard]] std::vector<PointLook> point_looks(const editing::Drawing& drawing,
                                                   const editing::MeshArrays& arrays) const;
  [[nodiscard]] std::vector<LineLook> line_looks(const editing::Drawing& drawing) const;

  CurveNodes* nodes_;
  std::map<std::uint32_t, host::Curve> lines_;  // by number
  bool with_points_ = true;
};

}  // namespace talweg::openflipper
