// The choice of a lid finds a lid that closes a rim without contacts.
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

/// Makes the lids of a piece one after the other; each lid keeps clear of the earlier lids. The
/// cost of a lid is a run of fill_plane(), or for rims that are not plane up to six runs of
/// fill_loop(), and if all these lids meet the mesh up to six runs of sink(). Every rim is compared
/// with all earlier rims. The search after the first lid ends after some millions of visited faces.
class LidChooser {
 public:
  /// `origin` maps vertices of the piece to vertices of the cut mesh, which the chains refer to.
  /// Two rims along the same vertices of the cut mesh, which are the two sides of a seam, get the
  /// same lid if the rims are on one connected part.
  LidChooser(const std::vector<Point>& points, LidClearance& clearance,
             std::function<std::uint32_t(std::uint32_t)> origin,
             std::span<const CutMesh::Chain> chains, ProgressPoller& poller)
      : points_(points),
        clearance_(clearance),
        origin_(std::move(origin)),
        chains_(chains),
        poller_(poller) {}

  /// Chooses a lid over one rim, or over a plane rim and its holes, and adds it to the clearance.
  /// Throws Error(kBadCurve) as add_lids() does, and Cancelled.
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
  std::vector<Twin> made_;  // by number

  // State for the rims that are being closed.
  std::vector<Loop> rims_;
  std::set<std::uint32_t> parts_;
  std::vector<std::uint32_t> origins_;
  double extent_ = 0;
  std::vector<LidClearance::Contact> contacts_;  // of the last offered lid
  std::vector<std::vector<Triangle>> starts_;
  Best best_;
};

}  // namespace talweg
