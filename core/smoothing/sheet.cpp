#include "talweg/core/smoothing/sheet.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/smoothing/refined_sheet.hpp"
#include "talweg/core/smoothing/unrolled_sheet.hpp"
#include "talweg/core/smoothing/whole_sheet.hpp"

namespace talweg {

bool may_leave(const std::vector<bool>& at_cut, const Surface& part, const Smoothed& result) {
  const auto cut = [&](VertexId v) { return at_cut[v.index()]; };
  const auto touches = [&](const SurfacePoint& point) {
    const auto corners = part.corners(any_face(part, point));
    return std::any_of(corners.begin(), corners.end(), cut);
  };
  return result.at_fence ||
         std::any_of(result.curves.begin(), result.curves.end(), [&](const SmoothedCurve& c) {
           return std::any_of(c.curve.points.begin(), c.curve.points.end(), touches);
         });
}

std::unique_ptr<Sheet> sheet_for(SmoothingMemory& memory, const OrderedDrawing& drawing,
                                 const CurveOptions& options, SheetSetup setup,
                                 const Progress& progress) {
  // The paper's method works on the mesh's own vertices only.
  if (setup.may_divide && options.method == Method::kCorridor) {
    if (const auto faces = faces_to_divide(memory.mesh(), drawing, options); !faces.empty())
      return std::make_unique<RefinedSheet>(memory.mesh(), drawing, options, progress);
  }
  auto whole = std::make_unique<WholeSheet>(
      memory, drawing, options, EmbeddedDrawing::Ground{Loops::kKeep, setup.fence}, progress);
  const Straightening& straightening = memory.straightening();
  const PathContacts contacts = path_contacts(straightening.triangulation(), straightening.paths());
  const auto& tangled = contacts.tangled;
  if (std::find(tangled.begin(), tangled.end(), true) != tangled.end() &&
      (setup.fence != nullptr ||
       !whole->let_cross(
           std::accumulate(contacts.crossings.begin(), contacts.crossings.end(), std::size_t{0}),
           progress))) {
    return std::make_unique<UnrolledSheet>(memory, drawing, options, contacts.tangled,
                                           std::move(setup.distance), progress);
  }
  if (setup.distance) {
    whole->set_distance(*std::move(setup.distance));
  } else {
    whole->solve(progress);
  }
  return whole;
}

}  // namespace talweg
