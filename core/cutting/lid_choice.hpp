// The choice of a lid finds one that closes a rim and meets nothing that is there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "talweg/core/cutting/lid_clearance.hpp"
#include "talweg/core/cutting/loop_filling.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"

namespace talweg {

/// Makes the lids of a piece, one after the other; each keeps clear of the earlier ones. Cost of a
/// lid: a run of fill_plane(), or for other rims up to six of fill_loop(), and where all of these
/// meet the mesh up to six of sink(). Its rim is compared with all earlier ones. What looks for
/// other lids than the first one ends after some millions of faces that are looked at.
class LidChooser {
 public:
  /// `origin` maps the piece's vertex numbers to those of the cut mesh, which the chains use. Two
  /// rims along the same vertices of the cut mesh, the two sides of one cut, get the same lid if
  /// they are on one part.
  LidChooser(const std::vector<Point>& points, LidClearance& clearance,
             std::function<std::uint32_t(std::uint32_t)> origin,
             std::span<const CutMesh::Chain> chains, ProgressPoller& poller)
      : points_(points),
        clearance_(clearance),
        origin_(std::move(origin)),
        chains_(chains),
        poller_(poller) {}

  /// Chooses a lid over one rim, or over a plane rim and the holes in it, and places it. Throws
  /// Cancelled.
  Lid choose(const std::vector<Loop>& rims, LidKind kind);

 private:
  struct Best {
    std::optional<Lid> lid;
    double depth = 0;
  };
  struct Twin {
    std::vector<std::uint32_t> origins;  // ascending
    std::vector<Loop> rims;
    Lid lid;
  };

  bool offer(Lid lid, std::size_t twin = LidClearance::kNoTwin);
  bool offer_plane();
  bool offer_twin();
  bool offer_least_area();
  bool offer_other_triangulations();
  bool offer_sunk();
  bool offer_sunk(const std::vector<Triangle>& triangles, bool in_one_direction);
  [[nodiscard]] std::size_t find_twin() const;
  [[noreturn]] void refuse(LidKind kind) const;

  const std::vector<Point>& points_;
  LidClearance& clearance_;
  std::function<std::uint32_t(std::uint32_t)> origin_;
  std::span<const CutMesh::Chain> chains_;
  ProgressPoller& poller_;
  std::vector<Twin> made_;  // in the order of their numbers

  // For the rims that are being closed.
  std::vector<Loop> rims_;
  std::set<std::uint32_t> parts_;
  std::vector<std::uint32_t> origins_;
  double extent_ = 0;
  std::vector<LidClearance::Contact> contacts_;  // of the last offer
  std::vector<std::vector<Triangle>> starts_;
  Best best_;
};

}  // namespace talweg
