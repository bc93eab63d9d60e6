// A label network consists of all borders of a segmentation, smoothed together. Every connected
// part of a region stays, in one piece.
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
  double tau = 1;               ///< [0, infinity); borders that fail a check get a larger tau
  std::optional<double> slack;  ///< mesh units, >= 0; default: estimated per border
  std::optional<double> max_deviation;  ///< D, mesh units, > 0: bound on deviation, both ways
  /// Whether junctions move to balance: the sum of the unit tangents of the borders is zero, so
  /// three borders meet at 120 degrees. A junction moves by at most the slack, or 0.75 D.
  bool free_junctions = false;
  /// Whether ends on the boundary of the mesh slide along it until the border meets it at a right
  /// angle, by at most the slack, or 0.75 D.
  bool sliding_ends = false;
  /// When the budget is used up, fairing, measuring and moving of junctions end; borders that have
  /// not passed the checks stay as drawn, and `total.termination` is kLimit.
  Budget budget;

  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

/// A smoothed border; `border.labels` are the labels left and right of it.
struct SmoothedBorder {
  LabelBorder border;
  SmoothingReport report;  ///< with the tau and slack of the border
  bool as_drawn = false;   ///< no smoothed curve passed the checks
};

/// The change of a region by smoothing.
struct LabelRegion {
  std::int64_t label = 0;
  std::size_t parts_before = 0, parts_after = 0;  ///< connected parts
  double area_before = 0, area_after = 0;         ///< squared mesh units
  /// Whether smoothing would have lost or divided a part of the region that is smaller than the
  /// part across the border. A border of the region is then held near the drawing.
  bool held = false;
};

struct LabelNetwork {
  std::vector<SmoothedBorder> borders;  ///< in the order of label_borders()
  SmoothingReport total;                ///< of all borders
  std::vector<LabelRegion> regions;     ///< by label
  std::size_t junctions = 0;            ///< points where borders end, not on the boundary
  std::size_t tightened = 0;            ///< smoothed borders with a reduced slack somewhere
  std::size_t as_drawn = 0;             ///< borders that stayed as they were drawn
  std::size_t moved = 0;                ///< junctions and ends that moved
  /// The mean, over the nodes that may move, of the length of the sum of unit tangents (on the
  /// boundary: of the component along it), with the nodes at their drawn places and in the result.
  double imbalance_before = 0, imbalance_after = 0;
  bool cancelled = false;                 ///< then all other fields are empty
  CutMesh cut;                            ///< the mesh with the borders as edges
  std::vector<std::int64_t> cut_labels;   ///< per face of `cut`: its exact label
  std::vector<std::int64_t> face_labels;  ///< per face of the mesh: its largest label
};

/// Smooths the borders between labels per face or per vertex as one set with fixed junctions.
/// Borders farther than D from their drawing get less slack near the far stretches
/// (LocalTightening). Then the mesh is cut along the borders, and its faces are assigned to the
/// regions. Borders that cross or touch, that divide or lose a part of a region, or that collapse,
/// are smoothed again with four times tau and half the slack, up to three times; borders that still
/// fail stay as drawn. In the result, borders touch only at junctions, and each connected part of
/// each region exists, in one piece, beside the same borders. Last, nodes move if the options allow
/// it.
///
/// Costs a few runs of CurveSmoother and as many of cut_along(). Throws Error as label_borders()
/// does, Error(kBadUsage) for bad options.
LabelNetwork smooth_labels(const std::shared_ptr<const OpenedMesh>& mesh,
                           std::span<const std::int64_t> labels,
                           const LabelNetworkOptions& options = {}, const Progress& progress = {});

}  // namespace talweg
