#include "tools/picture/curve_turning.hpp"

#include <optional>
#include <utility>

#include "talweg/core/drawing/snapped_drawing.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/repair/mesh_repair.hpp"

namespace talweg::picture {
namespace {

/// The curves, each joined straight over the surface.
std::vector<SurfaceCurve> on_mesh(const SurfaceMesh& mesh, std::span<const CurveInput> curves,
                                  const RepairMap* map) {
  std::vector<SnappedCurve> snapped;
  for (const CurveInput& curve : curves) {
    snapped.push_back(snap(mesh, map != nullptr ? map->to_repaired(curve, mesh.surface()) : curve));
  }
  StraightLines lines(mesh.surface());
  SnappedDrawing drawing;
  drawing.add(mesh, snapped, lines);
  return std::move(drawing.curves);
}

}  // namespace

CurveTurning turning_of(const MeshLists& lists, std::span<const CurveInput> curves) {
  std::optional<RepairedMesh> repaired;
  if (inspect(lists).verdict != MeshVerdict::kUsable) repaired = repair(lists);
  const SurfaceMesh mesh = SurfaceMesh::open(repaired ? repaired->lists : lists);
  const std::vector<SurfaceCurve> on = on_mesh(mesh, curves, repaired ? &repaired->map : nullptr);
  CurveTurning result;
  result.edge = edge_length_near(mesh.surface(), on.front());
  for (const SurfaceCurve& curve : on) {
    result.steps.push_back(curvature_along(turns_of(mesh.surface(), curve), result.edge / 2));
  }
  return result;
}

}  // namespace talweg::picture
