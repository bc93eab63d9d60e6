// Repair turns raw lists into a manifold surface, keeps the geometry, and records every change.
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

struct NearVertices;  // vertex_welding.hpp

/// The steps of repair(), in their order.
struct RepairSteps {
  bool weld = true;    ///< vertices at the same position are merged (vertex_welding.hpp)
  bool drop = true;    ///< faces without area and repeated faces are dropped
  bool orient = true;  ///< faces are turned to agree with their neighbours
  bool split = true;  ///< edges with more than two faces and bow-ties are cut (sheet_splitting.hpp)
  double weld_tolerance = 0;  ///< mesh units: vertices within it are welded, too; 0: only rounding

  friend bool operator==(const RepairSteps&, const RepairSteps&) = default;
};

/// Parses a comma-separated list of steps: weld, drop, orient, split, or all; weld may have a
/// tolerance, "weld=1e-4". Throws Error(kBadUsage) for an unknown word, for a tolerance that is not
/// a positive number, and for an empty list.
RepairSteps repair_steps(std::string_view list);

/// The changes of a repair. Ids are those of the lists before the repair.
struct MeshChanges {
  double weld_tolerance = 0;  ///< mesh units, rounding included; 0 if the step was not done
  double weld_distance = 0;   ///< mesh units: the largest move of a corner
  Defect<RepeatPlace> welded_vertices;    ///< vertices with their replacements
  std::size_t held_apart = 0;             ///< unwelded vertices within the tolerance (Welding)
  Defect<std::uint32_t> flattened_faces;  ///< faces that lost their area by welding
  Defect<std::uint32_t> collapsed_faces;  ///< dropped: name a vertex twice, also after welding
  Defect<RepeatPlace> duplicate_faces;    ///< dropped: the same three vertices as an earlier face
  Defect<std::uint32_t> zero_area_faces;  ///< dropped: zero area, and removal leaves no gap
  Defect<std::uint32_t> turned_faces;     ///< faces with corners 1 and 2 exchanged
  Defect<EdgePlace> split_edges;          ///< edges of the file with more than two faces
  Defect<std::uint32_t> split_vertices;   ///< vertices that became several
  std::size_t vertex_copies = 0;          ///< vertices added by splitting

  [[nodiscard]] bool any() const;
};

/// One sentence per kind of change, with the number of changes and the first places.
std::vector<std::string> sentences(const MeshChanges& changes);

struct RepairedMesh {
  MeshLists lists;
  RepairMap map;
  MeshChanges changes;
};

/// Repairs a mesh by the given steps. Only welding changes positions, and only the faces reported
/// as dropped are removed.
///
/// Weld: groups of weld_vertices() move to the position of their smallest vertex; a vertex that
/// splitting would separate again keeps its number. Drop: the first of several faces with the same
/// vertices stays; a face of zero area is dropped only if the removal leaves no gap
/// (faces_to_drop()). Orient: in each part joined over edges with two faces the smaller set of
/// faces is turned; if both sets have equal size, the part's first face is kept. A one-sided part
/// stays unchanged. inspect() of the result finds the remaining defects. A usable mesh without
/// vertices to weld or faces to drop is unchanged. O(faces log faces).
///
/// Throws Error(kBadMesh) for a defect that no repair can fix: no vertices, no faces, an index out
/// of range, a coordinate that is not finite or beyond 1e40, a mesh or an edge that is too small.
RepairedMesh repair(const MeshLists& lists, const RepairSteps& steps = {});

/// repair() that also throws Error(kBadMesh) if the repaired mesh is not usable.
RepairedMesh repair_to_surface(const MeshLists& lists, const RepairSteps& steps = {});

/// Tries the steps of a kRepairable inspection of the lists. Only a trial shows how the steps
/// affect each other: after faces are dropped, the rest may be one-sided. If the result is not
/// usable, the verdict becomes kUnusable, and the reason says why. Other verdicts stay. Time and
/// memory are those of repair().
void try_repair(const MeshLists& lists, MeshInspection& inspection);

/// The inspection of a mesh after welding.
struct WeldedMesh {
  std::string steps;         ///< for repair_steps(): "weld" and the steps that must follow
  double tolerance = 0;      ///< mesh units, of the step weld; 0 if only equal positions are welded
  std::size_t vertices = 0;  ///< welded onto others, or with a tolerance near others
  MeshInspection after;
};

/// Tries welding of equal positions, as in a soup of single triangles, and of nearly equal
/// positions (near_vertices()); the result is the welding that joins more. Empty if welding neither
/// joins components nor closes boundary loops, or if the mesh is neither usable nor repairable
/// before, or not usable after. Time and memory are those of repair().
std::optional<WeldedMesh> try_weld(const MeshLists& lists, const MeshInspection& before);
/// The same with a known result `near` of near_vertices(lists, before).
std::optional<WeldedMesh> try_weld(const MeshLists& lists, const MeshInspection& before,
                                   const NearVertices& near);

}  // namespace talweg
