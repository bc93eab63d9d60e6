#include "talweg/core/cutting/lid_clearance.hpp"

#include <algorithm>

namespace talweg {
namespace {

constexpr std::size_t kOfVisit = 32,
                      kOfPair = 12;  // units of work: a tree search, a test of two triangles

SpaceBox box_of(const PointTriangle& t) { return SpaceBox::around(t); }

PointTriangle face_at(const MeshLists& piece, std::uint32_t face) {
  const Triangle& t = piece.triangles[face];
  return {piece.points[t[0]], piece.points[t[1]], piece.points[t[2]]};
}

/// The bounding box of a rim, enlarged by its diagonal on all sides: the space that a lid can
/// reach.
SpaceBox reach_of(const MeshLists& piece, const Loop& rim) {
  SpaceBox box{piece.points[rim[0]], piece.points[rim[0]]};
  for (const std::uint32_t v : rim) box = box.with({piece.points[v], piece.points[v]});
  const Point margin = Point::Constant((box.high - box.low).norm());
  return {box.low - margin, box.high + margin};
}

std::vector<std::uint32_t> faces_near(const MeshLists& piece, std::span<const Loop> rims) {
  std::vector<SpaceBox> reach;
  for (const Loop& rim : rims) reach.push_back(reach_of(piece, rim));
  SpaceBox all = reach.front();
  for (const SpaceBox& box : reach) all = all.with(box);
  std::vector<std::uint32_t> near;
  for (std::uint32_t f = 0; f < piece.triangles.size(); ++f) {
    const SpaceBox own = box_of(face_at(piece, f));
    if (own.overlaps(all) && std::any_of(reach.begin(), reach.end(),
                                         [&](const SpaceBox& box) { return own.overlaps(box); })) {
      near.push_back(f);
    }
  }
  return near;
}

auto boxes_of(const std::vector<PointTriangle>& triangles) {
  return [&triangles](std::uint32_t i) { return box_of(triangles[i]); };
}

std::array<std::uint32_t, 3> sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return {t[0], t[1], t[2]};
}

bool have_one_in_common(const std::set<std::uint32_t>& a, const std::set<std::uint32_t>& b) {
  return std::any_of(a.begin(), a.end(), [&](std::uint32_t part) { return b.count(part) > 0; });
}

}  // namespace

LidClearance::LidClearance(const MeshLists& piece, std::span<const std::uint32_t> part_of_face,
                           std::span<const Loop> rims, ProgressPoller& poller)
    : piece_(piece),
      poller_(poller),
      near_(faces_near(piece, rims)),
      tree_(near_.size(), [this](std::uint32_t k) { return box_of(near_face(k)); }) {
  std::vector<bool> on_rim(piece.points.size(), false);
  for (const Loop& rim : rims) {
    for (std::size_t i = 0; i < rim.size(); ++i) {
      on_rim[rim[i]] = true;
      rims_.insert(chord(rim[i], rim[(i + 1) % rim.size()]));
    }
  }
  near_part_.reserve(near_.size());
  for (const std::uint32_t f : near_) {
    near_part_.push_back(part_of_face[f]);
    const Triangle& t = piece.triangles[f];
    std::size_t corners = 0;
    for (const std::uint32_t v : t) {
      if (!on_rim[v]) continue;
      ++corners;
      part_of_vertex_[v] = part_of_face[f];
    }
    if (corners > 1) add_edges(t);
    if (corners == 3) triangles_.insert(sorted(t));
  }
}

PointTriangle LidClearance::near_face(std::uint32_t k) const { return face_at(piece_, near_[k]); }

std::vector<PointTriangle> LidClearance::triangles_of(const Lid& lid) const {
  std::vector<PointTriangle> triangles;
  triangles.reserve(lid.triangles.size());
  for (const Triangle& t : lid.triangles) triangles.push_back(at(lid, t));
  return triangles;
}

void LidClearance::add_edges(const Triangle& t) {
  for (std::size_t k = 0; k < 3; ++k) edges_.insert(chord(t[k], t[(k + 1) % 3]));
}

std::vector<LidClearance::Contact> LidClearance::contacts_with_piece(
    const Lid& lid, const std::set<std::uint32_t>& parts) const {
  std::vector<Contact> found;
  for (std::size_t i = 0; i < lid.triangles.size(); ++i) {
    poller_.add_work(kOfVisit);
    const PointTriangle own = at(lid, lid.triangles[i]);
    visit_near(BoxesAtTriangle(own[0], own[1], own[2]), [&](std::uint32_t k) {
      poller_.add_work(kOfPair);
      if (parts.count(near_part_[k]) == 0) return;
      const PointTriangle other = near_face(k);
      if (!certainly_apart(own, other)) found.push_back({i, other});
    });
  }
  return found;
}

std::vector<LidClearance::Contact> LidClearance::contacts(const Lid& lid,
                                                          const std::set<std::uint32_t>& parts,
                                                          std::size_t twin) const {
  std::vector<Contact> found = contacts_with_piece(lid, parts);
  const std::vector<PointTriangle> own = triangles_of(lid);
  const BoxTree among(own.size(), boxes_of(own));
  for (std::size_t i = 0; i < own.size(); ++i) {
    poller_.add_work(kOfVisit);
    const auto meet = [&](const PointTriangle& other) {
      poller_.add_work(kOfPair);
      if (!certainly_apart(own[i], other)) found.push_back({i, other});
    };
    const BoxesAtTriangle here(own[i][0], own[i][1], own[i][2]);
    among.visit(here, boxes_of(own), [&](std::uint32_t k) {
      if (k > i) meet(own[k]);
    });
    for (std::size_t k = 0; k < placed_.size(); ++k) {
      if (k == twin || !have_one_in_common(placed_[k].parts, parts)) continue;
      const Placed& other = placed_[k];
      other.tree.visit(here, boxes_of(other.triangles),
                       [&](std::uint32_t t) { meet(other.triangles[t]); });
    }
  }
  return found;
}

/// The largest crossing_reach() of a face of the given parts through a triangle.
double LidClearance::reach_through(const PointTriangle& t,
                                   const std::set<std::uint32_t>& parts) const {
  double reach = 0;
  poller_.add_work(kOfVisit);
  visit_near(BoxesAtTriangle(t[0], t[1], t[2]), [&](std::uint32_t k) {
    if (parts.count(near_part_[k]) == 0) return;
    reach = std::max(reach, crossing_reach(t, near_face(k)));
  });
  return reach;
}

double LidClearance::depth(const Lid& lid, std::span<const Contact> contacts,
                           const std::set<std::uint32_t>& parts, double shift) const {
  double deepest = 0;
  std::set<std::size_t> touched;
  for (const Contact& contact : contacts) {
    const PointTriangle own = at(lid, lid.triangles[contact.triangle]);
    deepest = std::max(deepest, crossing_depth(own, contact.other));
    touched.insert(contact.triangle);
  }
  for (const std::size_t triangle : touched) {
    PointTriangle above = at(lid, lid.triangles[triangle]), below = above;
    const Point by = shift * (above[1] - above[0]).cross(above[2] - above[0]).stableNormalized();
    for (Point& p : above) p += by;
    for (Point& p : below) p -= by;
    deepest = std::max(deepest, std::min(reach_through(above, parts), reach_through(below, parts)));
  }
  return deepest;
}

bool LidClearance::pierces(std::uint32_t a, std::uint32_t b, double tolerance) const {
  const Point &p = piece_.points[a], &q = piece_.points[b];
  const std::uint32_t part = part_of_vertex_.at(a);
  poller_.add_work(kOfVisit);
  return tree_.any_of(
      BoxesAtTriangle(p, q, q), [this](std::uint32_t k) { return near_box(k); },
      [&](std::uint32_t k) {
        return near_part_[k] == part && piercing_depth(p, q, near_face(k)) > tolerance;
      });
}

std::vector<Chord> LidClearance::taken(const Lid& lid) const {
  std::vector<Chord> found;
  for (const Triangle& t : lid.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Chord side = chord(t[k], t[(k + 1) % 3]);
      if (edges_.count(side) > 0 && rims_.count(side) == 0) found.push_back(side);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool LidClearance::repeats_triangle(const Lid& lid) const {
  return std::any_of(lid.triangles.begin(), lid.triangles.end(),
                     [&](const Triangle& t) { return triangles_.count(sorted(t)) > 0; });
}

void LidClearance::place(const Lid& lid, const std::set<std::uint32_t>& parts) {
  const std::uint32_t n = first_inner();
  for (const Triangle& t : lid.triangles) {
    if (t[0] < n && t[1] < n && t[2] < n) triangles_.insert(sorted(t));
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] < n && t[(k + 1) % 3] < n) edges_.insert(chord(t[k], t[(k + 1) % 3]));
    }
  }
  std::vector<PointTriangle> own = triangles_of(lid);
  BoxTree tree(own.size(), boxes_of(own));
  placed_.push_back({std::move(own), std::move(tree), parts});
}

}  // namespace talweg
