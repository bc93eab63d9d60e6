// Mesh parts are what a cut mesh is taken apart into, with attributes, lids and origins.
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

/// Which pieces are kept: those on that side of every curve along them, so that no piece is on both
/// sides, however curves are nested.
enum class KeptSide : std::uint8_t { kBoth, kLeft, kRight };

struct PartOptions {
  bool open = false;   ///< either side of a seam has vertices of its own
  bool split = false;  ///< a part for each piece; otherwise all are in one part
  KeptSide keep = KeptSide::kBoth;
  std::optional<LidKind> lids;  ///< close what the cut leaves open

  /// Whether seams are opened, which all of these do.
  [[nodiscard]] bool opens() const { return open || split || keep != KeptSide::kBoth || lids; }
};

struct MeshPart {
  MeshLists lists;
  MeshAttributes attributes;
  std::vector<std::uint32_t> vertices, faces;  ///< of the cut mesh; kNoVertex, kNoFace in lids
  Lids lids;
};

struct MeshParts {
  std::vector<MeshPart> parts;  ///< at least one
  std::size_t pieces = 1;       ///< that hang together, before some are left out
  std::size_t between = 0;      ///< left out: on the left of one curve, the right of another
  /// Per curve whether no piece lies on both of its sides, and one on either; none where no seam
  /// was opened.
  std::vector<bool> separates;
  std::vector<std::string> told;      ///< sentences on curves that do not: why, and what would
  std::vector<std::string> left_out;  ///< attributes that are not carried over
};

/// Takes the cut mesh apart. `attributes` are those of the mesh before the cut. Throws
/// Error(kBadCurve) naming a curve that does not separate the mesh where one side is to be kept,
/// with why and what would, and the curves where nothing is left; otherwise as add_lids() and
/// carried_to() do. O(vertices + faces), and what lids cost. Worse: with `split` that for each
/// piece, so many small pieces of a large mesh cost their number times the mesh.
MeshParts take_apart(const SurfaceMesh& mesh, const CutMesh& cut, const MeshAttributes& attributes,
                     const PartOptions& options, const Progress& progress = {});
/// The same; takes the lists of the cut instead of copying them, also where it throws. All else of
/// the cut stays.
MeshParts take_apart(const SurfaceMesh& mesh, CutMesh&& cut, const MeshAttributes& attributes,
                     const PartOptions& options, const Progress& progress = {});

/// Where all of a part comes from.
struct PartOrigins {
  struct Curve {
    bool closed = false;
    /// For each vertex of the chain the vertices of the part that lie there: none where the part
    /// does not reach it, several on both sides of a seam.
    std::vector<std::vector<std::uint32_t>> vertices;
  };
  std::vector<VertexOrigin> vertices;  ///< of the part; without vertices inside lids
  std::vector<std::uint32_t> faces;    ///< of the part; kNoFace in lids
  std::vector<Curve> curves;
};

/// `map`: if the mesh was repaired before it was cut; origins are then in the numbers before.
/// O(the part + points of all chains, log).
PartOrigins origins_of(const MeshPart& part, const CutMesh& cut, const Surface& surface,
                       const RepairMap* map = nullptr);

}  // namespace talweg
