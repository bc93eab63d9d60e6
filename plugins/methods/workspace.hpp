// A workspace is the common base of plugins on curves: an opened mesh, and a drawing on it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host_curves.hpp"
#include "mesh_workspace.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/strokes/border_ends.hpp"
#include "talweg/core/strokes/drawn_loops.hpp"

namespace talweg::plugins {

/// The description of a plugin on curves; its strings must be constants.
talweg_plugin about_curves(const char* id, const char* label, const char* doc);

/// Base of the plugin classes (talweg_plugin.hpp).
class Workspace : public MeshWorkspace {
 public:
  using MeshWorkspace::MeshWorkspace;

  void set_curves(std::span<const talweg_curve* const> curves);

 protected:
  ~Workspace() = default;

  /// Puts curves, in the numbers of the opened mesh, on the mesh to make the drawing.
  virtual void put(const std::vector<CurveInput>& curves);
  /// Overriding classes must call this function first.
  void forget() override;

  [[nodiscard]] StraightLines& lines();
  [[nodiscard]] const SnappedDrawing& drawing() const { return drawing_; }
  /// Closes the curves that are meant as loops, and extends the ends of the curves chosen by
  /// `extended` to the border. Before this call no curve is changed.
  void finish_ends(CurveEnds ends, std::optional<ExtendedCurves> extended = {});
  /// Warnings on the drawing, and sentences on the repair.
  [[nodiscard]] std::vector<std::string> reading_warnings() const;
  /// Counts the drawings and meshes that were set; a change of pins alone does not count.
  [[nodiscard]] std::uint64_t drawings() const { return drawings_; }

 private:
  void put_again() override;
  [[nodiscard]] std::vector<CurveInput> from_host(const std::vector<CurveInput>& curves) const;

  std::optional<StraightLines> lines_;  // made when first needed
  std::vector<CurveInput> curves_;      // in the host's numbers
  SnappedDrawing snapped_;
  SnappedDrawing drawing_;  // with loops closed, and ends extended to the border
  CurveEnds ends_ = CurveEnds::kOpen;
  std::optional<ExtendedCurves> extended_;
  std::uint64_t drawings_ = 0;
};

}  // namespace talweg::plugins
