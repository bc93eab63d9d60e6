// Lid clearance finds contacts of a lid with the piece that it closes, with other lids, and with
// itself.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "talweg/core/cutting/plane_filling.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/space/box_tree.hpp"
#include "talweg/core/space/triangle_contact.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Triangles over one rim, or over an outer rim and its holes.
struct Lid {
  std::vector<Triangle> triangles;
  std::vector<Point> inner;  ///< additional points, numbered after those of the piece
  bool plane = false;
  double sunk_by = 0;  ///< mesh units: largest move of an inner point by sink()
};

/// An undirected side of triangles.
using Chord = std::pair<std::uint32_t, std::uint32_t>;
inline Chord chord(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// The faces near rims, and the lids that have been placed.
class LidClearance {
 public:
  /// `part_of_face`: per face of the piece, its connected part. The piece must outlive the object,
  /// and its faces must not change. O(faces + k log k) for k faces near rims. Searches for contacts
  /// report their work to `poller`, which must outlive the object, and throw Cancelled.
  LidClearance(const MeshLists& piece, std::span<const std::uint32_t> part_of_face,
               std::span<const Loop> rims, ProgressPoller& poller);

  /// The connected part of a rim.
  [[nodiscard]] std::uint32_t part_of(const Loop& rim) const { return part_of_vertex_.at(rim[0]); }

  /// A triangle of a lid, and a triangle that it touches or crosses: a face of the piece, or a
  /// triangle of this or an earlier lid.
  struct Contact {
    std::size_t triangle;
    PointTriangle other;
  };
  /// The contacts of a lid; touching and doubtful cases count. Only faces and lids of `parts`, the
  /// parts that the lid closes, are tested: other parts may meet the lid, as the two sides of a
  /// seam do. `twin`: the number of a placed lid to ignore.
  [[nodiscard]] std::vector<Contact> contacts(const Lid& lid, const std::set<std::uint32_t>& parts,
                                              std::size_t twin = kNoTwin) const;
  static constexpr std::size_t kNoTwin = static_cast<std::size_t>(-1);
  /// The contacts of a lid with faces of the piece only.
  [[nodiscard]] std::vector<Contact> contacts_with_piece(
      const Lid& lid, const std::set<std::uint32_t>& parts) const;
  /// The largest depth of penetration of the given contacts, mesh units; about 0 for contacts that
  /// only touch. A penetration exactly at a corner or a side is found by moving the triangle by
  /// `shift` (mesh units) in both directions.
  [[nodiscard]] double depth(const Lid& lid, std::span<const Contact> contacts,
                             const std::set<std::uint32_t>& parts, double shift) const;

  /// Whether the segment between two points of a rim penetrates a face of the rim's part by more
  /// than `tolerance` (mesh units).
  [[nodiscard]] bool pierces(std::uint32_t a, std::uint32_t b, double tolerance) const;
  /// The number of faces that all searches together have visited.
  [[nodiscard]] std::size_t faces_seen() const { return faces_seen_; }

  /// Whether an edge joins two vertices of rims.
  [[nodiscard]] bool has_edge(std::uint32_t a, std::uint32_t b) const {
    return edges_.count(chord(a, b)) > 0;
  }
  /// The sides of a lid's triangles that already are edges, without the edges of rims.
  [[nodiscard]] std::vector<Chord> taken(const Lid& lid) const;
  /// Whether a triangle of the lid has the same corners as an existing triangle.
  [[nodiscard]] bool repeats_triangle(const Lid& lid) const;

  /// Adds a lid that later lids must keep clear of. Lids are numbered in the order of these calls.
  void place(const Lid& lid, const std::set<std::uint32_t>& parts);

  /// The number of a lid's first inner point.
  [[nodiscard]] std::uint32_t first_inner() const {
    return static_cast<std::uint32_t>(piece_.points.size());
  }
  [[nodiscard]] const Point& at(const Lid& lid, std::uint32_t vertex) const {
    const std::uint32_t n = first_inner();
    return vertex < n ? piece_.points[vertex] : lid.inner[vertex - n];
  }
  [[nodiscard]] PointTriangle at(const Lid& lid, const Triangle& t) const {
    return {at(lid, t[0]), at(lid, t[1]), at(lid, t[2])};
  }

 private:
  struct Placed {
    std::vector<PointTriangle> triangles;
    BoxTree tree;
    std::set<std::uint32_t> parts;
  };

  /// Face k of the near faces.
  [[nodiscard]] PointTriangle near_face(std::uint32_t k) const;
  /// Calls visit(k) for the near faces whose boxes meet a triangle.
  template <class Visit>
  void visit_near(const BoxesAtTriangle& place, Visit visit) const {
    tree_.visit(
        place, [this](std::uint32_t k) { return near_box(k); }, visit);
  }
  [[nodiscard]] SpaceBox near_box(std::uint32_t k) const {
    ++faces_seen_;
    return SpaceBox::around(near_face(k));
  }

  void add_edges(const Triangle& triangle);
  [[nodiscard]] double reach_through(const PointTriangle& t,
                                     const std::set<std::uint32_t>& parts) const;
  [[nodiscard]] std::vector<PointTriangle> triangles_of(const Lid& lid) const;

  const MeshLists& piece_;
  ProgressPoller& poller_;
  mutable std::size_t faces_seen_ = 0;
  std::map<std::uint32_t, std::uint32_t> part_of_vertex_;  // vertices of the rims
  std::set<Chord> edges_;                                  // between vertices of rims
  std::set<Chord> rims_;
  std::set<std::array<std::uint32_t, 3>> triangles_;  // between vertices of rims, sorted corners
  std::vector<std::uint32_t> near_, near_part_;       // the near faces and their parts
  BoxTree tree_;                                      // over the near faces
  std::vector<Placed> placed_;
};

}  // namespace talweg
