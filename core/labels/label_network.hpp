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
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

struct LabelNetworkOptions {
  double tau = 1;                       ///< [0, infinity), of borders that nothing is in the way of
  std::optional<double> slack;          ///< mesh units, >= 0; default: of each border its own
  std::optional<double> max_deviation;  ///< D, mesh units, > 0: each border within it, both ways
  /// Whether junctions move to where the borders that meet there balance: the sum of their unit
  /// tangents is zero, three meet at 120 degrees. As far as the slack, or 0.75 D, at most.
  bool free_junctions = false;
  /// Whether ends on the mesh's boundary slide along it to where the border meets it at a right
  /// angle; as far as that.
  bool sliding_ends = false;

  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

/// A border as it was smoothed; `border.labels` lie left and right of it.
struct SmoothedBorder {
  LabelBorder border;
  SmoothingReport report;  ///< with the tau and slack that it was smoothed with
  bool as_drawn = false;   ///< nothing smoother left all regions whole, or lay within D
};

/// What became of a region.
struct LabelRegion {
  std::int64_t label = 0;
  std::size_t parts_before = 0, parts_after = 0;  ///< connected parts
  double area_before = 0, area_after = 0;         ///< squared mesh units
  /// It or a part of it would have been lost or torn apart, and is smaller than what lies on the
  /// other side: a border of it is held, see tightened.
  bool held = false;
};

struct LabelNetwork {
  std::vector<SmoothedBorder> borders;  ///< in the order of label_borders()
  SmoothingReport total;                ///< of all
  std::vector<LabelRegion> regions;     ///< by label
  std::size_t junctions = 0;            ///< points where borders end, away from the boundary
  std::size_t tightened = 0;            ///< borders that took a smaller slack, at least in part
  std::size_t as_drawn = 0;             ///< borders that stayed as they were drawn
  std::size_t moved = 0;                ///< junctions and ends that moved
  /// Mean over those that may move of the size of the sum of unit tangents, on the boundary of its
  /// part along it: with all of them where they were drawn, and in the result.
  double imbalance_before = 0, imbalance_after = 0;
  bool cancelled = false;                 ///< then all else is empty
  CutMesh cut;                            ///< the mesh with the borders as edges
  std::vector<std::int64_t> cut_labels;   ///< per face of it: exact
  std::vector<std::int64_t> face_labels;  ///< per face of the mesh: the label of its larger share
};

/// Smooths the borders between labels per face or per vertex as one set with its junctions fixed.
/// Borders that lie farther than D from their drawing get less slack there, see LocalTightening.
/// Then the mesh is cut along them and all regions are followed through the cut: borders that cross
/// or touch, that tear a region apart or lose it, or that collapse, are smoothed again, with four
/// times tau and half the slack, up to three times; what is still in the way stays as drawn. So in
/// the result no two borders touch but at junctions, and each connected part of each region is
/// there, whole, beside the borders it had.
///
/// A few runs of CurveSmoother and as many of cut_along(). Throws Error as label_borders() does,
/// Error(kBadUsage) for bad options.
LabelNetwork smooth_labels(const std::shared_ptr<const OpenedMesh>& mesh,
                           std::span<const std::int64_t> labels,
                           const LabelNetworkOptions& options = {}, const Progress& progress = {});

}  // namespace talweg
