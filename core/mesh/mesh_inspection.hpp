// An inspection tells what a mesh is and what is wrong with it, from its raw lists.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// How often a defect occurs, and its first few places by ascending id.
template <class Place>
struct Defect {
  static constexpr std::size_t kPlaces = 5;

  std::size_t count = 0;
  std::vector<Place> first;  ///< at most kPlaces

  void add(const Place& place) {
    if (count++ < kPlaces) first.push_back(place);
  }
  [[nodiscard]] bool found() const { return count > 0; }
};

struct EdgePlace {
  static constexpr std::size_t kFaces = 8;

  std::array<std::uint32_t, 2> vertices{};  ///< smaller id first
  std::vector<std::uint32_t> faces;         ///< ascending, at most kFaces
};

struct FaceIndexPlace {
  std::uint32_t face = 0;
  std::uint32_t vertex = 0;
};

/// An element and the earlier one that it repeats.
struct RepeatPlace {
  std::uint32_t element = 0;
  std::uint32_t earlier = 0;
};

enum class MeshVerdict { kUsable, kRepairable, kUnusable };

/// Ids are those of the lists. Lengths are in mesh units, angles in radians. Faces with an index
/// out of range or a repeated vertex are ignored in the topology; faces with a non-finite corner
/// are ignored in the measures.
struct MeshInspection {
  // What it is.
  std::size_t vertices = 0;      ///< includes those in no face
  std::size_t faces = 0;         ///< triangles, polygons counted as theirs
  std::size_t polygons = 0;      ///< faces of the file that had more than three corners
  PolygonShapes polygon_shapes;  ///< of the file
  std::size_t edges = 0;
  std::size_t components = 0;             ///< sets of faces joined by edges
  std::size_t boundary_edges = 0;         ///< edges with one face
  std::size_t boundary_loops = 0;         ///< connected sets of boundary edges
  std::int64_t euler_characteristic = 0;  ///< used vertices - edges + faces
  std::optional<std::int64_t> genus;      ///< of all components together, if manifold
  bool orientable = true;          ///< turning faces around would make the orientation consistent
  bool single_precision = false;   ///< the file stores 32-bit floats
  std::optional<LengthUnit> unit;  ///< of the coordinates, if the file has one
  PatientSpace space = PatientSpace::kNotSaid;  ///< of the coordinates, if the file says it
  std::vector<std::string> notes;               ///< of the reader (MeshLists)

  // Defects that keep a mesh from being opened.
  Defect<FaceIndexPlace> indices_out_of_range;  ///< counted once per face
  Defect<std::uint32_t> non_finite_vertices;    ///< of faces; or beyond kLargestCoordinate
  Defect<std::uint32_t> repeated_vertex_faces;  ///< faces that name a vertex twice
  Defect<RepeatPlace> duplicate_faces;          ///< same three vertices, in any order
  Defect<EdgePlace> non_manifold_edges;         ///< more than two faces
  Defect<EdgePlace> misoriented_edges;          ///< two faces that run along it the same way
  Defect<std::uint32_t> non_manifold_vertices;  ///< faces form more than one fan (bow-tie)

  // Oddities that are handled.
  Defect<std::uint32_t> isolated_vertices;  ///< in no face
  Defect<std::uint32_t> stray_vertices;     ///< those of them whose coordinates are not finite
  Defect<RepeatPlace> duplicate_positions;  ///< vertices at exactly the position of an earlier one
  Defect<std::uint32_t> zero_area_faces;    ///< flat up to the rounding of their coordinates
  Defect<std::uint32_t> needle_faces;       ///< smallest angle < 1 degree; includes zero-area faces

  // Measures.
  std::array<double, 3> box_min{};
  std::array<double, 3> box_max{};
  double coordinate_max = 0;     ///< the largest absolute value of a coordinate, but of strays
  double edge_length_min = 0;    ///< mesh units
  double edge_length_mean = 0;   ///< mesh units
  double edge_length_max = 0;    ///< mesh units
  double edge_length_least = 0;  ///< of the edges longer than 0; 0 if there are none
  double smallest_angle = 0;     ///< of the faces whose area is not zero
  double offset = 0;             ///< distance of the box's centre from the origin
  double size = 0;               ///< the box's diagonal

  MeshVerdict verdict = MeshVerdict::kUnusable;  ///< set by judge()
  std::string reason;                            ///< the verdict in one sentence
  std::string steps;  ///< if kRepairable: the needed steps for repair_steps(), "drop,split"
};

/// Inspects everything. O(faces log degree); never throws on bad lists.
MeshInspection inspect(const MeshLists& lists);

/// The first reason not to open the mesh as one sentence, with the number of offenders and the
/// place of the first: "33 edges have more than two faces (first: ...)."; empty if there is none.
std::string obstacle(const MeshInspection& inspection);

/// A sentence like obstacle()'s that names a coordinate or length outside the supported range
/// (measurable_point.hpp); empty if there is none. O(faces); without an inspection if there is
/// none.
std::string out_of_range(const MeshLists& lists);

/// Sets verdict, reason and steps from the other fields. A one-sided surface (Moebius strip) is not
/// usable.
void judge(MeshInspection& inspection);

}  // namespace talweg
