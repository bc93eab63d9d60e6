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

struct NearVertices;  // vertex_welding.hpp

/// What repair() may do, in the order it is done.
struct RepairSteps {
  bool weld = true;    ///< vertices at one position become one (vertex_welding.hpp)
  bool drop = true;    ///< faces without area and repeated faces are dropped
  bool orient = true;  ///< faces are turned to agree with their neighbours
  bool split = true;   ///< crowded edges and bow-ties are cut into sheets (sheet_splitting.hpp)
  double weld_tolerance = 0;  ///< mesh units: vertices that near are welded, too; 0: only rounding

  friend bool operator==(const RepairSteps&, const RepairSteps&) = default;
};

/// Parses names separated by commas: weld, drop, orient, split, or all; weld may have a tolerance,
/// "weld=1e-4". Throws Error(kBadUsage) naming an unknown word or a tolerance that is no positive
/// number, and for an empty list.
RepairSteps repair_steps(std::string_view list);

/// What a repair did. Numbers are those of the lists before the repair.
struct MeshChanges {
  double weld_tolerance = 0;              ///< mesh units; 0 where there was nothing to weld
  double weld_distance = 0;               ///< mesh units: the farthest that a corner was moved
  Defect<RepeatPlace> welded_vertices;    ///< each with the vertex that replaces it
  std::size_t held_apart = 0;             ///< vertices within the tolerance that stay (Welding)
  Defect<std::uint32_t> flattened_faces;  ///< that have no area any more since their corners moved
  Defect<std::uint32_t> collapsed_faces;  ///< dropped: a vertex twice, in the file or after welding
  Defect<RepeatPlace> duplicate_faces;    ///< dropped: the same three vertices as an earlier one
  Defect<std::uint32_t> zero_area_faces;  ///< dropped: zero area, and dropping leaves no gap
  Defect<std::uint32_t> turned_faces;     ///< their corners 1 and 2 exchanged
  Defect<EdgePlace> split_edges;          ///< that had more than two faces
  Defect<std::uint32_t> split_vertices;   ///< vertices that became several
  std::size_t vertex_copies = 0;          ///< vertices added by splitting

  [[nodiscard]] bool any() const;
};

/// One sentence for each kind of change, with how many and the first places.
std::vector<std::string> sentences(const MeshChanges& changes);

struct RepairedMesh {
  MeshLists lists;
  RepairMap map;
  MeshChanges changes;
};

/// Does the steps, each where it is needed. Only welding changes positions, and only the faces
/// reported as dropped are missing afterwards.
///
/// Weld: as weld_vertices(), each group at the place of its vertex with the smallest number; a
/// vertex that splitting would separate again keeps its own number. Drop: of faces with the same
/// vertices the first stays; a face of zero area is dropped only where its neighbours keep theirs,
/// or where it is a flap on the boundary. Orient: in each part joined over edges with two faces the
/// smaller set of faces is turned; if both are equally large, the part's first face is kept. A
/// one-sided part stays as it is. inspect() tells what was left undone; a usable mesh with nothing
/// to weld or drop is unchanged. O(faces log faces).
///
/// Throws Error(kBadMesh) for what no repair can fix: no vertices, no faces, an index out of range,
/// a coordinate that is not finite or beyond 1e40, a mesh or edges that are too small.
RepairedMesh repair(const MeshLists& lists, const RepairSteps& steps = {});

/// The same; also throws Error(kBadMesh) if the repaired lists are no surface, either.
RepairedMesh repair_to_surface(const MeshLists& lists, const RepairSteps& steps = {});

/// Tries the steps that a kRepairable verdict on the lists names, because only a trial shows how
/// they affect each other: after faces are dropped, the rest may turn out one-sided. If the steps
/// do not help, the verdict becomes kUnusable and the reason says why. Other verdicts stay. Time
/// and memory are those of repair().
void try_repair(const MeshLists& lists, MeshInspection& inspection);

/// A mesh in which vertices at the same place have been welded.
struct WeldedMesh {
  std::string steps;     ///< for repair_steps(): "weld", and the steps that must follow it
  double tolerance = 0;  ///< mesh units: that of the steps; 0 where positions are the same
  std::size_t vertices =
      0;  ///< that were welded onto others; with a tolerance, that lie near others
  MeshInspection after;
};

/// The result of welding where vertices lie at the same place, as in a soup of single triangles, or
/// nearly coincide (near_vertices()), whichever joins more. Nothing if welding joins no parts and
/// closes no boundary, or if the mesh is not usable, with other steps at least, before or after.
/// Time and memory are those of repair().
std::optional<WeldedMesh> try_weld(const MeshLists& lists, const MeshInspection& before);
/// The same with near_vertices(lists, before), where it is known.
std::optional<WeldedMesh> try_weld(const MeshLists& lists, const MeshInspection& before,
                                   const NearVertices& near);

}  // namespace talweg
