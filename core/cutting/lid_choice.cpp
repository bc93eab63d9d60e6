#include "talweg/core/cutting/lid_choice.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/cutting/lid_sinking.hpp"
#include "talweg/core/cutting/plane_filling.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// The largest number of rim points for which all triangulations are considered if the first lid
/// does not fit.
constexpr std::size_t kWhole = 640;
/// The limit of visited faces in tests of chords against the mesh (a few seconds); later chords
/// count as excluded. Chords along long faces pass the boxes of most of them.
constexpr std::size_t kMostFaces = 10'000'000;

double extent_of(const std::vector<Point>& points, const Loop& rim) {
  SpaceBox box{points[rim[0]], points[rim[0]]};
  for (const std::uint32_t v : rim) box = box.with({points[v], points[v]});
  return (box.high - box.low).norm();
}

/// The outward direction of a lid: the vector area of its rim, normalised.
Point direction_of(const std::vector<Point>& points, const Loop& rim) {
  Point sum = Point::Zero();
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Point& from = points[rim[0]];
    sum += (points[rim[i]] - from).cross(points[rim[(i + 1) % rim.size()]] - from);
  }
  return sum.stableNormalized();
}

Triangle ascending(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

}  // namespace

/// Whether a lid has no contacts. A lid is kept if it is the best so far.
bool LidChooser::offer(Lid lid, std::size_t twin) {
  contacts_.clear();  // contacts of another lid refer to its triangles
  if (lid.triangles.empty() || clearance_.repeats_triangle(lid) || !clearance_.taken(lid).empty()) {
    return false;
  }
  contacts_ = clearance_.contacts(lid, parts_, twin);
  const double depth = clearance_.depth(lid, contacts_, parts_, kPlaneTolerance / 10 * extent_);
  if (!best_.lid || contacts_.empty() || depth < best_.depth) best_ = {std::move(lid), depth};
  return contacts_.empty();
}

bool LidChooser::offer_plane() {
  const auto triangles = fill_plane(points_, rims_);
  if (!triangles) return false;
  Lid lid{*triangles, {}, true};
  const std::vector<Chord> taken = clearance_.taken(lid);
  if (!taken.empty() || clearance_.repeats_triangle(lid)) {
    lid = with_inner_points(clearance_, lid, rims_, taken);
  }
  // Two plane lids over the sides of one seam coincide, so their contacts are ignored.
  const std::size_t twin = find_twin();
  const bool lie_together = twin != LidClearance::kNoTwin && made_[twin].lid.plane;
  return offer(std::move(lid), lie_together ? twin : LidClearance::kNoTwin);
}

std::size_t LidChooser::find_twin() const {
  for (std::size_t k = 0; k < made_.size(); ++k) {
    if (made_[k].origins == origins_) return k;
  }
  return LidClearance::kNoTwin;
}

/// Offers the lid of the seam's other side, with reversed orientation.
bool LidChooser::offer_twin() {
  const std::size_t twin = find_twin();
  if (twin == LidClearance::kNoTwin) return false;
  std::map<std::uint32_t, std::uint32_t> here;
  for (const Loop& rim : rims_) {
    for (const std::uint32_t v : rim) {
      if (!here.emplace(origin_(v), v).second) return false;  // the rim touches itself
    }
  }
  Lid lid = made_[twin].lid;
  for (Triangle& t : lid.triangles) {
    for (std::uint32_t& v : t) {
      if (v < clearance_.first_inner()) v = here.at(origin_(v));
    }
    std::swap(t[1], t[2]);
  }
  return offer(std::move(lid), twin);
}

bool LidChooser::offer_least_area() {
  if (rims_.size() > 1) return false;
  return offer({fill_loop(points_, rims_[0]), {}});
}

/// Offers the triangulation of least area without excluded chords and triangles; the triangles with
/// contacts are excluded in the next of a few rounds.
bool LidChooser::offer_other_triangulations() {
  constexpr double kTolerance = 1e-9;
  const int rounds = rims_[0].size() <= 256 ? 4 : 2;
  LeftOut left_out;
  left_out.whole = kWhole;
  left_out.poller = &poller_;
  std::unordered_map<std::uint64_t, bool> known;
  const std::size_t most = clearance_.faces_seen() + kMostFaces;
  left_out.chord = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] = known.try_emplace((std::uint64_t{a} << 32U) | b);
    if (is_new) {
      found->second = points_[a] == points_[b] || clearance_.has_edge(a, b) ||
                      clearance_.faces_seen() >= most ||
                      clearance_.pierces(a, b, kTolerance * extent_);
    }
    return found->second;
  };
  for (int round = 0; round < rounds && rims_.size() == 1; ++round) {
    auto triangles = fill_loop(points_, rims_[0], left_out);
    if (!triangles) return false;
    const Lid lid{*triangles, {}};
    starts_.push_back(std::move(*triangles));
    if (offer(lid)) return true;
    for (const auto& contact : contacts_) {
      left_out.triangles.insert(ascending(lid.triangles[contact.triangle]));
    }
    for (const Triangle& t : lid.triangles) {
      if (clearance_.repeats_triangle({{t}, {}})) left_out.triangles.insert(ascending(t));
    }
  }
  return false;
}

bool LidChooser::offer_sunk(const std::vector<Triangle>& triangles, bool in_one_direction) {
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (points_[t[k]] == points_[t[(k + 1) % 3]]) return false;
    }
  }
  std::optional<Point> direction;
  if (in_one_direction) direction = direction_of(points_, rims_[0]);
  if (triangles.empty()) return false;
  Lid lid = with_inner_points(clearance_, {triangles, {}}, rims_);
  lid.sunk_by = sink(lid, clearance_, parts_, direction, extent_);
  return offer(std::move(lid));
}

/// Offers lids with inner points, starting from the plane triangulation of the rim and from lids of
/// least area. The points are moved in one direction, or away from the faces that each triangle
/// meets.
bool LidChooser::offer_sunk() {
  std::vector<std::vector<Triangle>> starts;
  if (auto plane = fill_plane(points_, rims_)) {
    const Best before = best_;
    if (offer({*plane, {}})) return true;
    best_ = before;  // a plane start with contacts must not be kept
    starts.push_back(std::move(*plane));
  }
  if (!starts_.empty()) starts.push_back(starts_.back());
  if (rims_.size() == 1) starts.push_back(fill_loop(points_, rims_[0]));
  for (const bool in_one_direction : {true, false}) {
    for (const std::vector<Triangle>& start : starts) {
      if (offer_sunk(start, in_one_direction)) return true;
    }
  }
  return false;
}

void LidChooser::refuse(LidKind kind) const {
  const Loop& rim = rims_[0];
  const Point& at = points_[rim[0]];
  const auto runs_here = [&](const CutMesh::Chain& chain) {
    return std::find(chain.vertices.begin(), chain.vertices.end(), origin_(rim[0])) !=
           chain.vertices.end();
  };
  const auto curve = std::find_if(chains_.begin(), chains_.end(), runs_here) - chains_.begin();
  const std::string name = fmt::format("The rim of {} points at {} on curve {}", rim.size(),
                                       position_text(at, (points_[rim[1]] - at).norm()), curve);
  const double distance = distance_from_plane(points_, rim);
  if (kind == LidKind::kPlanar && distance > kPlaneTolerance) {
    throw Error(
        ErrorCode::kBadCurve,
        name + fmt::format(
                   " is not planar: its points lie up to {:.2g} of its extent away from a plane.",
                   distance));
  }
  if (kind == LidKind::kPlanar && !best_.lid) {
    throw Error(ErrorCode::kBadCurve,
                name + " is planar but touches or crosses itself, so no planar lid fits it.");
  }
  throw Error(ErrorCode::kBadCurve,
              name + fmt::format(" cannot be closed: every {}lid goes through the mesh there, by "
                                 "{:.2g} of the rim's extent at least.",
                                 kind == LidKind::kPlanar ? "planar " : "", best_.depth / extent_));
}

Lid LidChooser::choose(const std::vector<Loop>& rims, LidKind kind) {
  rims_ = rims;
  parts_.clear();
  origins_.clear();
  for (const Loop& rim : rims_) {
    parts_.insert(clearance_.part_of(rim));
    for (const std::uint32_t v : rim) origins_.push_back(origin_(v));
  }
  std::sort(origins_.begin(), origins_.end());
  extent_ = extent_of(points_, rims_[0]);
  starts_.clear();
  best_ = {std::nullopt, std::numeric_limits<double>::infinity()};
  const bool plane = kind != LidKind::kLeastArea &&
                     (rims.size() > 1 || distance_from_plane(points_, rims[0]) <= kPlaneTolerance);
  const bool done = (plane && offer_plane()) ||
                    (kind != LidKind::kPlanar && (offer_least_area() || offer_twin() ||
                                                  offer_other_triangulations() || offer_sunk()));
  if (!done && !(best_.lid && best_.depth <= kPlaneTolerance * extent_)) refuse(kind);
  clearance_.place(*best_.lid, parts_);
  made_.push_back({origins_, rims_, *best_.lid});
  return *best_.lid;
}

}  // namespace talweg
