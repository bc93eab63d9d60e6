// Planted defects are all kinds of mesh defects, at random places of clean meshes.
#pragma once

#include <span>
#include <string>

#include "stress/random.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::stress {

/// A clean mesh of 100 to 2,000 faces: sphere, sheet, torus, tube, box, flat grid, one-sided strip.
MeshLists random_mesh(Random& random);

/// Plants one defect, or a harmless oddity, into the mesh, at new places in every call.
struct Defect {
  const char* name;
  void (*plant)(MeshLists& lists, Random& random);
};
std::span<const Defect> defects();

/// Plants up to three defects. Returns their names, for the log.
std::string plant_some(MeshLists& lists, Random& random);

}  // namespace talweg::stress
