// Snapping puts the curves of a file onto a mesh.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/core/mesh/closest_point.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

struct SnapOptions {
  /// If set, successive vertex ids need not be neighbours, because the caller connects the
  /// vertices.
  bool connect = false;
};

/// The part of a stroke that was cut off at one end, because it ran over the border of the mesh.
struct BeyondBorder {
  std::size_t points = 0;
  double farthest = 0;  ///< mesh units: the largest distance of these samples from the mesh
};

/// A curve's points on a mesh; consecutive ones differ but need not share a face.
struct SnappedCurve {
  bool closed = false;                    ///< the first point is not repeated
  std::vector<SurfacePoint> points;       ///< at least two, at least three where closed
  double largest_snap_distance = 0;       ///< of 3D positions, mesh units
  std::size_t merged = 0;                 ///< points dropped because they equal the point before
  std::vector<std::size_t> pins;          ///< indices of points, ascending
  std::vector<InputWayPoint> way_points;  ///< ascending; each index once
  std::vector<std::size_t> painted;       ///< ascending; no way-points
  /// An open stroke of a hand: given as positions, or painted, and without way-points. A stroke
  /// that runs over the border is never a loop.
  bool of_hand = false, may_be_loop = false;
  std::array<BeyondBorder, 2> beyond_border;  ///< at the start and at the end
  std::vector<std::string> notes;  ///< sentences of the input, and on points put elsewhere
  std::string better_fit;          ///< the text of better_fit()
  std::string why_stroke;          ///< a sentence if control points were not taken for way-points
};

/// Puts a curve on the mesh.
///
/// Vertex ids must exist, and each must be a neighbour of the id before (unless `connect`). Points
/// in faces stay as they are, except that pins, way-points, and points that share no face with a
/// neighbour are settled (straight_lines.hpp). Points between vertices are treated alike; the
/// vertices whose weights are not 0 must be corners of one face.
///
/// Positions are moved to the nearest point of the mesh. A nearest point is then moved to a vertex,
/// or else an edge, that lies within 1e-9 of the face's longest side or within the rounding of
/// single-precision coordinates (1.2e-7 of the largest coordinate, but no more than 1e-4 of the
/// longest side). So mesh vertices are recognised in files with 9 digits or 32-bit floats. Before
/// they are moved, the positions of a stroke are rid of spikes (stroke_spikes.hpp), put on one side
/// of thin walls (sheet_matching.hpp), and cut off where an open stroke runs over the border of the
/// mesh (border_runs.hpp), so that the stroke ends exactly on the border.
///
/// Points in faces and positions that coincide with the point before are merged. The point that
/// stays inherits the marks of all merged points: it is a way-point with the smallest tolerance, or
/// painted, if any of them was.
///
/// Throws Error(kBadCurve) naming the position in the curve (from 0) and the ids: for an id or face
/// out of range, neighbours that share no edge, barycentrics out of range, a position that is not
/// finite or lies farther from the mesh than both an eighth of the diagonal of its box and ten mean
/// edges, a pin, way-point or painted point that is not a point of the curve, a tolerance below 0,
/// fewer than two points, or a closed curve with fewer than three. Throws Cancelled when
/// `progress` (stage "snap") says so. O(degree) for a vertex and O(log faces) for a position, for
/// which a ClosestPoint is built first. In addition, each painted point is compared with each
/// way-point of its curve.
SnappedCurve snap(const SurfaceMesh& mesh, const CurveInput& curve, const SnapOptions& options = {},
                  const Progress& progress = {});

/// The same for several curves; the search structure is built once. Errors name the curve too.
std::vector<SnappedCurve> snap(const SurfaceMesh& mesh, std::span<const CurveInput> curves,
                               const SnapOptions& options = {}, const Progress& progress = {});

/// The same with a search structure that the caller keeps; it is made when positions first need it.
std::vector<SnappedCurve> snap(const SurfaceMesh& mesh, std::span<const CurveInput> curves,
                               std::optional<ClosestPoint>& closest,
                               const SnapOptions& options = {}, const Progress& progress = {});

/// The first words of snap_warning()'s sentence where the drawing was moved far.
constexpr std::string_view kFarFromMesh = "The drawing lies far from the mesh";

/// Whether a move is so large that the drawing may belong to another mesh, place or unit: more than
/// three mean edges.
bool moved_far(double largest_snap_distance, const SurfaceMesh& mesh);

/// A sentence on how far a drawing was moved; empty where no point moved by more than rounding,
/// 1e-4 mean edges.
std::string snap_warning(double largest_snap_distance, const SurfaceMesh& mesh);

}  // namespace talweg
