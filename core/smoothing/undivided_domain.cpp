#include "talweg/core/smoothing/undivided_domain.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/smoothing/mesh_domain.hpp"
#include "talweg/core/smoothing/unrolled_domain.hpp"

namespace talweg {

std::unique_ptr<SmoothingDomain> undivided_domain_for(SmoothingMemory& memory,
                                                      const OrderedDrawing& drawing,
                                                      const CurveOptions& options,
                                                      const std::vector<bool>* fence,
                                                      std::optional<std::vector<double>> distance,
                                                      const Progress& progress) {
  auto whole = std::make_unique<MeshDomain>(memory, drawing, options,
                                            EmbeddedDrawing::Ground{Loops::kKeep, fence}, progress);
  const Straightening& straightening = memory.straightening();
  const PathContacts contacts = path_contacts(straightening.triangulation(), straightening.paths());
  const auto& tangled = contacts.tangled;
  if (std::find(tangled.begin(), tangled.end(), true) != tangled.end() &&
      (fence != nullptr ||
       !whole->let_cross(
           std::accumulate(contacts.crossings.begin(), contacts.crossings.end(), std::size_t{0}),
           progress))) {
    return std::make_unique<UnrolledDomain>(memory, drawing, options, contacts.tangled,
                                            std::move(distance), progress);
  }
  if (distance) {
    whole->set_distance(*std::move(distance));
  } else {
    whole->solve(progress);
  }
  return whole;
}

}  // namespace talweg
