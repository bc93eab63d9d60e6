// A drawing file holds curves, which are read, put on a mesh and joined there.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/io/label_file.hpp"
#include "talweg/core/mesh/closest_point.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/repair/repair_map.hpp"
#include "talweg/core/space/coordinate_frame.hpp"
#include "talweg/core/strokes/border_ends.hpp"
#include "talweg/core/strokes/drawn_loops.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::driver {

/// Reads curves, snaps them to a mesh and joins their points straight over the surface. The search
/// structure is built once. The mesh and the map must outlive the reader.
class DrawingReader {
 public:
  /// With a map, vertex and face numbers in curve files are the ones before the repair.
  explicit DrawingReader(const SurfaceMesh& mesh, const RepairMap* map = nullptr)
      : mesh_(&mesh), map_(map) {}
  /// Sets how the ends of curves read after this call are treated (open by default), and the curves
  /// whose ends are extended to the border (none by default).
  void set_ends(CurveEnds ends, std::optional<ExtendedCurves> extended) {
    ends_ = ends;
    extended_ = extended;
  }
  /// The curves of all files, in their order; `frame` is that of the mesh. Throws Cancelled, and
  /// Error as read_curves(), snap() and StraightLines::join() do, with a hint if welding may help.
  SnappedDrawing read(std::span<const std::string> paths, const CoordinateFrame& frame = {},
                      const Progress& progress = {});

 private:
  void add(const std::vector<CurveInput>& inputs, SnappedDrawing& drawing,
           const Progress& progress);

  const SurfaceMesh* mesh_;
  const RepairMap* map_;
  std::optional<ClosestPoint> closest_;
  std::optional<StraightLines> lines_;
  CurveEnds ends_ = CurveEnds::kOpen;
  std::optional<ExtendedCurves> extended_;
  std::optional<std::string> weld_hint_;  ///< made when a curve is first rejected
};

/// The same for one file.
SnappedDrawing read_drawing(const std::string& path, const SurfaceMesh& mesh,
                            const RepairMap* map = nullptr, const CoordinateFrame& frame = {});

/// The labels of a file, converted to the repaired mesh if there is a map.
struct ReadLabels : LabelFile {
  std::vector<std::int64_t> of_file;  ///< labels as in the file, if there is a map
};

/// The labels of a file; `property` as in LabelFileOptions. Throws Error(kBadFile) as
/// read_label_file() does.
ReadLabels read_labels(const std::string& path, const Surface& surface, const RepairMap* map,
                       const std::string& property = {});

/// The borders between the labels of a file, see read_label_file(). Throws Error as that function
/// and label_borders() do.
SnappedDrawing drawing_of_labels(const std::string& path, const Surface& surface,
                                 const RepairMap* map = nullptr);

/// Warnings for the user about how curves and a mesh were read.
std::vector<std::string> reading_warnings(const SnappedDrawing& drawing, std::size_t polygons);

/// If a drawing was moved far, writes this to the standard error before anything else.
void lead_with_far_move(const SnappedDrawing& drawing, bool quiet);

}  // namespace talweg::driver
