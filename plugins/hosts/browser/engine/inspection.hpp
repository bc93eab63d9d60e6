// What talweg.repair finds out about a mesh, and makes of it.
#pragma once

#include <optional>

#include "answer.hpp"
#include "talweg/editing/mesh_arrays.hpp"
#include "talweg/editing/workplace.hpp"

namespace talweg::browser {

/// Of larger meshes only opening tells what is wrong: looking for everything else takes several
/// times as long and as much memory.
constexpr std::size_t kInspected = 300'000;

host::Results inspected(const editing::Plugins& plugins, const editing::MeshArrays& mesh);

/// What welding would give.
struct WeldOffer {
  double tolerance = 0;  ///< mesh units; 0: vertices at one place become one
  Json told;             ///< `Weld` in src/engine/types.ts
};

/// Nothing unless the mesh can be used as it is, but has parts that only lie beside each other, as
/// a soup of triangles has. Looks closely only where vertices lie at one place, or are many.
std::optional<WeldOffer> weld_offer(const editing::Plugins& plugins,
                                    const editing::MeshArrays& mesh);

/// What a repair did, `Repaired` in src/engine/types.ts; without its changes for larger meshes.
Json repair_told(const editing::Plugins& plugins, const editing::MeshArrays& mesh,
                 double weld_tolerance);

}  // namespace talweg::browser
