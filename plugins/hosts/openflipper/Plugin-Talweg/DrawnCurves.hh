// The drawing in the scene: its points, its lines on the mesh, and the leg to the mouse.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "CurveNodes.hh"
#include "talweg/editing/mesh_arrays.hpp"

namespace talweg::openflipper {

class DrawnCurves {
 public:
  /// `nodes` is null without a window.
  explicit DrawnCurves(CurveNodes* nodes) : nodes_(nodes) {}

  void show(const editing::Drawing& drawing, const editing::MeshArrays& arrays);
  /// Takes lines on the mesh, with the numbers of their curves. A changed curve keeps its line
  /// until the new line arrives.
  void take(std::vector<host::Curve> lines, const std::vector<std::uint32_t>& numbers,
            const editing::Drawing& drawing);
  /// The line of a curve; null if not known.
  [[nodiscard]] const host::Curve* line_of(std::uint32_t number) const;
  void show_leg(const host::Curve& leg, std::uint32_t number);
  void hide_leg();

  /// Takes effect at the next show().
  void set_with_points(bool with) { with_points_ = with; }
  /// Whether a point is shown, and so can be picked. The point that closes a curve can always be
  /// picked.
  [[nodiscard]] bool shows_point(const editing::Drawing& drawing, std::size_t curve,
                                 std::size_t point) const;

 private:
  [[nodiscard]] std::vector<PointLook> point_looks(const editing::Drawing& drawing,
                                                   const editing::MeshArrays& arrays) const;
  [[nodiscard]] std::vector<LineLook> line_looks(const editing::Drawing& drawing) const;

  CurveNodes* nodes_;
  std::map<std::uint32_t, host::Curve> lines_;  // by the numbers of the curves
  bool with_points_ = true;
};

}  // namespace talweg::openflipper
