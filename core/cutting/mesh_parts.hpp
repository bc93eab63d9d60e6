// Mesh parts are the meshes into which a cut mesh is divided, with attributes, lids and origins.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "talweg/core/cutting/loop_filling.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/vertex_origin.hpp"
#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/repair/repair_map.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// The pieces to keep: pieces that lie on the given side of every curve on their border, so nested
/// curves are handled, too.
enum class KeptSide : std::uint8_t { kBoth, kLeft, kRight };

struct PartOptions {
  bool open = false;   ///< both sides of a seam have separate vertices
  bool split = false;  ///< a part for each piece; otherwise one part with all pieces
  KeptSide keep = KeptSide::kBoth;
  std::optional<LidKind> lids;  ///< lids close the holes that the cut leaves

  /// Whether seams are opened, as every option requires.
  [[nodiscard]] bool opens() const { return open || split || keep != KeptSide::kBoth || lids; }
};

struct MeshPart {
  MeshLists lists;
  MeshAttributes attributes;
  std::vector<std::uint32_t> vertices,
      faces;  ///< their numbers in the cut mesh; kNoVertex, kNoFace in lids
  Lids lids;
};

struct MeshParts {
  std::vector<MeshPart> parts;  ///< at least one
  std::size_t pieces = 1;       ///< connected pieces, before some are left out
  std::size_t between = 0;  ///< pieces left out: on the left of one curve, on the right of another
  /// Per curve, whether it separates the mesh (curve_separation.hpp); empty if no seam was opened.
  std::vector<bool> separates;
  std::vector<std::string> notes;     ///< sentences about curves that do not separate the mesh
  std::vector<std::string> left_out;  ///< descriptions of attributes that are not carried over
};

/// Divides the cut mesh into parts. `attributes` are the attributes of the mesh before the cut. If
/// one side is to be kept, throws Error(kBadCurve) for a curve that does not separate the mesh,
/// with the reason, and if no piece is left; also throws as add_lids() and carried_to() do.
/// O(vertices + faces) plus the cost of lids; with `split`, O((vertices + faces) · pieces).
MeshParts take_apart(const SurfaceMesh& mesh, const CutMesh& cut, const MeshAttributes& attributes,
                     const PartOptions& options, const Progress& progress = {});
/// Moves the lists of the cut instead of copying them, also if it throws. The other fields of the
/// cut stay.
MeshParts take_apart(const SurfaceMesh& mesh, CutMesh&& cut, const MeshAttributes& attributes,
                     const PartOptions& options, const Progress& progress = {});

/// The origins of a part's elements.
struct PartOrigins {
  struct Curve {
    bool closed = false;
    /// Per vertex of the chain, the vertices of the part at this place: none if the part does not
    /// reach it, several on both sides of a seam.
    std::vector<std::vector<std::uint32_t>> vertices;
  };
  std::vector<VertexOrigin> vertices;  ///< per vertex of the part; without vertices inside lids
  std::vector<std::uint32_t> faces;    ///< per face of the part; kNoFace in lids
  std::vector<Curve> curves;
};

/// Finds the origins of a part. `map`: given if the mesh was repaired before the cut; origins then
/// refer to the file. O(n log n) for the elements of the part and the points of all chains.
PartOrigins origins_of(const MeshPart& part, const CutMesh& cut, const Surface& surface,
                       const RepairMap* map = nullptr);

}  // namespace talweg
