// A label network is all borders of a segmentation, smoothed together; every region stays, in one
// piece.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/labels/label_borders.hpp"
#include "talweg/core/labels/label_regions.hpp"
#include "talweg/core/measure/report.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/intrinsic/budget.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

struct LabelNetworkOptions {
  double tau = 1;               ///< [0, infinity); the tau of borders that need no larger one
  std::optional<double> slack;  ///< mesh units, >= 0; default: each border has its own
  std::optional<double> max_deviation;  ///< D, mesh units, > 0: bound of each border, both ways
  /// Whether junctions move to where the borders that meet there balance: the sum of their unit
  /// tangents is zero, and three borders meet at 120 degrees. They move by at most the slack, or
  /// 0.75 D.
  bool free_junctions = false;
  /// Whether ends on the mesh's boundary slide along it to where the border meets it at a right
  /// angle; by at most the same distance.
  bool sliding_ends = false;
  /// When it is used up, fairing, measuring and moving junctions end; borders that are not known to
  /// be sound and within D by then stay as drawn. `total.termination` is kLimit then.
  Budget budget;

  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

/// A smoothed border; `border.labels` lie left and right of it.
struct SmoothedBorder {
  LabelBorder border;
  SmoothingReport report;  ///< with the tau and slack that it was smoothed with
  bool as_drawn = false;   ///< no smoother curve kept all regions whole and lay within D
};

/// How smoothing changed a region.
struct LabelRegion {
  std::int64_t label = 0;
  std::size_t parts_before = 0, parts_after = 0;  ///< connected parts
  double area_before = 0, area_after = 0;         ///< squared mesh units
  /// Whether smoothing would have lost the region or a part of it, or torn it apart, and it is
  /// smaller than what lies on the other side; then a border of it is held, see tightened.
  bool held = false;
};

struct LabelNetwork {
  std::vector<SmoothedBorder> borders;  ///< in the order of label_borders()
  SmoothingReport total;                ///< of all borders
  std::vector<LabelRegion> regions;     ///< by label
  std::size_t junctions = 0;            ///< points where borders end, away from the boundary
  std::size_t tightened = 0;            ///< borders that got a smaller slack, at least in part
  std::size_t as_drawn = 0;             ///< borders that stayed as they were drawn
  std::size_t moved = 0;                ///< junctions and ends that moved
  /// The mean length of the sum of unit tangents over the nodes that may move (for nodes on the
  /// boundary, of its component along it): with all nodes where they were drawn, and in the result.
  double imbalance_before = 0, imbalance_after = 0;
  bool cancelled = false;                 ///< then all other fields are empty
  CutMesh cut;                            ///< the mesh with the borders as edges
  std::vector<std::int64_t> cut_labels;   ///< per face of `cut`: its exact label
  std::vector<std::int64_t> face_labels;  ///< per face of the mesh: the label of its larger share
};

/// Smooths the borders between labels per face or per vertex as one set with its junctions fixed.
/// Borders that lie farther than D from their drawing get less slack there, see LocalTightening.
/// Then the mesh is cut along the borders and all regions are followed through the cut. Borders
/// that cross or touch, that tear a region apart or lose it, or that collapse, are smoothed again
/// with four times tau and half the slack, up to three times; if that does not help, they stay as
/// drawn. So in the result borders touch only at junctions, and each connected part of each region
/// still exists, in one piece, beside the borders it had.
///
/// Costs a few runs of CurveSmoother and as many of cut_along(). Throws Error as label_borders()
/// does, Error(kBadUsage) for bad options.
LabelNetwork smooth_labels(const std::shared_ptr<const OpenedMesh>& mesh,
                           std::span<const std::int64_t> labels,
                           const LabelNetworkOptions& options = {}, const Progress& progress = {});

}  // namespace talweg
