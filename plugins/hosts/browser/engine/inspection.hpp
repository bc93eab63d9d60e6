// The results of talweg.repair about a mesh.
#pragma once

#include <optional>

#include "answer.hpp"
#include "talweg/editing/mesh_arrays.hpp"
#include "talweg/editing/workplace.hpp"

namespace talweg::browser {

/// Faces. Larger meshes are only checked by opening them: a search for all defects takes several
/// times as long and as much memory.
constexpr std::size_t kInspected = 300'000;

host::Results inspected(const editing::Plugins& plugins, const editing::MeshArrays& mesh);

/// The effect of welding.
struct WeldOffer {
  double tolerance = 0;  ///< mesh units; 0: only vertices at the same place are welded
  Json told;             ///< `Weld` in src/engine/types.ts
};

/// Nothing unless the mesh can be used unrepaired, but has parts that only touch, as a triangle
/// soup has. The search is done only if vertices coincide, or are many.
std::optional<WeldOffer> weld_offer(const editing::Plugins& plugins,
                                    const editing::MeshArrays& mesh);

/// The changes of a repair, `Repaired` in src/engine/types.ts; without the list of changes for
/// larger meshes.
Json repair_told(const editing::Plugins& plugins, const editing::MeshArrays& mesh,
                 double weld_tolerance);

}  // namespace talweg::browser
