// An inspection describes a mesh and its defects, from its raw lists.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// The number of occurrences of a defect, and the places of the first few, by ascending id.
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

/// An element and the earlier element that it repeats.
struct RepeatPlace {
  std::uint32_t element = 0;
  std::uint32_t earlier = 0;
};

enum class MeshVerdict { kUsable, kRepairable, kUnusable };

/// Ids are those of the lists. Lengths are in mesh units, angles in radians. Faces with an index
/// out of range or a repeated vertex are ignored in the topology; faces with a non-finite corner
/// are ignored in the measures.
struct MeshInspection {
  // Description.
  std::size_t vertices = 0;      ///< including vertices without a face
  std::size_t faces = 0;         ///< triangles; a polygon counts with its triangles
  std::size_t polygons = 0;      ///< faces of the file with more than three corners
  PolygonShapes polygon_shapes;  ///< of the file
  std::size_t edges = 0;
  std::size_t components = 0;                   ///< sets of faces joined by edges
  std::size_t boundary_edges = 0;               ///< edges with one face
  std::size_t boundary_loops = 0;               ///< connected sets of boundary edges
  std::int64_t euler_characteristic = 0;        ///< used vertices - edges + faces
  std::optional<std::int64_t> genus;            ///< of all components together, if manifold
  bool orientable = true;                       ///< faces can be turned to a consistent orientation
  bool single_precision = false;                ///< the file stores 32-bit floats
  std::optional<LengthUnit> unit;               ///< of the coordinates, if the file has it
  PatientSpace space = PatientSpace::kNotSaid;  ///< of the coordinates, if the file has it
  std::vector<std::string> notes;               ///< of the reader (MeshLists)

  // Defects that keep a mesh from being opened.
  Defect<FaceIndexPlace> indices_out_of_range;  ///< counted once per face
  Defect<std::uint32_t> non_finite_vertices;  ///< vertices of faces; also beyond kLargestCoordinate
  Defect<std::uint32_t> repeated_vertex_faces;  ///< faces that name a vertex twice
  Defect<RepeatPlace> duplicate_faces;          ///< same three vertices, in any order
  Defect<EdgePlace> non_manifold_edges;         ///< more than two faces
  Defect<EdgePlace> misoriented_edges;          ///< two faces with the same direction along it
  Defect<std::uint32_t> non_manifold_vertices;  ///< faces form more than one fan (bow-tie)

  // Harmless defects.
  Defect<std::uint32_t> isolated_vertices;  ///< in no face
  Defect<std::uint32_t> stray_vertices;  ///< isolated vertices with coordinates that are not finite
  Defect<RepeatPlace> duplicate_positions;  ///< vertices at the position of an earlier vertex
  Defect<std::uint32_t> zero_area_faces;    ///< area 0 up to the rounding of the coordinates
  Defect<std::uint32_t> needle_faces;       ///< smallest angle < 1 degree; includes zero-area faces

  // Measures.
  std::array<double, 3> box_min{};
  std::array<double, 3> box_max{};
  double coordinate_max = 0;     ///< largest absolute coordinate, without stray vertices
  double edge_length_min = 0;    ///< mesh units
  double edge_length_mean = 0;   ///< mesh units
  double edge_length_max = 0;    ///< mesh units
  double edge_length_least = 0;  ///< shortest length above 0, mesh units; 0 if there is none
  double smallest_angle = 0;     ///< radians, of the faces with an area
  double offset = 0;             ///< distance of the box's centre from the origin, mesh units
  double size = 0;               ///< diagonal of the box, mesh units

  MeshVerdict verdict = MeshVerdict::kUnusable;  ///< set by judge()
  std::string reason;                            ///< the verdict in one sentence
  std::string steps;  ///< if kRepairable: the needed steps for repair_steps(), "drop,split"
};

/// Fills every field. O(faces log degree); does not throw on bad lists.
MeshInspection inspect(const MeshLists& lists);

/// The first reason not to open the mesh as one sentence, with the number of defects and the place
/// of the first: "33 edges have more than two faces (first: ...)."; empty if the mesh can be
/// opened.
std::string obstacle(const MeshInspection& inspection);

/// A sentence like that of obstacle() about a coordinate or length outside the supported range
/// (measurable_point.hpp); empty if all are inside. O(faces); the mesh is inspected only if the
/// sentence is needed.
std::string out_of_range(const MeshLists& lists);

/// Sets verdict, reason and steps from the other fields. A one-sided surface (Moebius strip) is not
/// usable.
void judge(MeshInspection& inspection);

}  // namespace talweg
