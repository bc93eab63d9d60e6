// Repair makes a surface of raw lists, keeps the geometry, and tells every change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/repair/repair_map.hpp"

namespace talweg {

/// What repair() may do, in the order it is done.
struct RepairSteps {
  bool weld = true;    ///< vertices at one position become one (vertex_welding.hpp)
  bool drop = true;    ///< faces without area or there twice are left out
  bool orient = true;  ///< faces are turned to agree with their neighbours
  bool split = true;   ///< crowded edges and bow-ties are cut into sheets (sheet_splitting.hpp)
};

/// From names separated by commas: weld, drop, orient, split, or all.
/// Throws Error(kBadUsage) naming a word that is none of them, and for an empty list.
RepairSteps repair_steps(std::string_view list);

/// What was done. Numbers are those of the lists before the repair.
struct MeshChanges {
  double weld_tolerance = 0;              ///< mesh units; 0 where nothing was to be welded
  double weld_distance = 0;               ///< mesh units: the farthest that a corner was moved
  Defect<RepeatPlace> welded_vertices;    ///< and the vertex that replaces each
  Defect<std::uint32_t> collapsed_faces;  ///< dropped: a vertex twice, in the file or by welding
  Defect<RepeatPlace> duplicate_faces;    ///< dropped: the same three vertices as an earlier one
  Defect<std::uint32_t> zero_area_faces;  ///< dropped: of zero area, and no gap is left by them
  Defect<std::uint32_t> turned_faces;     ///< their corners 1 and 2 exchanged
  Defect<EdgePlace> split_edges;          ///< that had more than two faces
  Defect<std::uint32_t> split_vertices;   ///< that became several
  std::size_t vertex_copies = 0;          ///< vertices added by that

  [[nodiscard]] bool any() const;
};

/// One sentence for each kind of change, with how many and the first places.
std::vector<std::string> sentences(const MeshChanges& changes);

struct RepairedMesh {
  MeshLists lists;
  RepairMap map;
  MeshChanges changes;
};

/// Does the steps, each where it is needed. No position changes but by welding, and no face but
/// those that are dropped goes missing.
///
/// Weld: as weld_vertices(); a vertex that splitting would part again keeps its own number.
/// Drop: of faces with the same vertices the first stays; a face of zero area goes only where its
/// neighbours keep theirs, or where it is a flap on the boundary.
/// Orient: of each part joined over edges with two faces the fewer faces are turned, the part's
/// first face is kept in doubt; a one-sided part stays as it is.
/// What is left undone, inspect() tells; a usable mesh with nothing to weld or drop is unchanged.
/// O(faces log faces).
///
/// Throws Error(kBadMesh) for what no repair can mend: no vertices, no faces, an index out of
/// range, a coordinate that is not finite or beyond 1e40, a mesh or edges that are too small.
RepairedMesh repair(const MeshLists& lists, const RepairSteps& steps = {});

/// Tries the steps that a kRepairable verdict on the lists names, because what faces do to each
/// other is seen only then: without those that go, the rest may turn out one-sided. Where they do
/// not help, the verdict becomes kUnusable and the reason says why. Other verdicts stay.
/// Time and memory as of repair().
void try_repair(const MeshLists& lists, MeshInspection& inspection);

/// A usable mesh whose vertices at one place have become one.
struct WeldedMesh {
  std::string steps;         ///< of repair_steps(): "weld", and what has to follow on it
  std::size_t vertices = 0;  ///< that were welded onto others
  MeshInspection after;
};

/// What welding would give where vertices lie at one place, as in a soup of single triangles.
/// Nothing where that joins no parts and closes no boundary, or the mesh is not usable before or
/// after. Time and memory as of repair().
std::optional<WeldedMesh> try_weld(const MeshLists& lists, const MeshInspection& before);

}  // namespace talweg
