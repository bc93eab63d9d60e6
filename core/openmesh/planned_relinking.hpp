// A planned relinking lists the changes of connectivity that a division plan makes in a mesh.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "talweg/core/openmesh/division_plan.hpp"
#include "talweg/core/openmesh/plan_points.hpp"
#include "talweg/core/openmesh/relinking.hpp"

namespace talweg {

/// Finds the relinking of a plan; the mesh stays unchanged. A divided edge becomes its own first
/// part, from the tail of its halfedge 0; a divided face becomes the first of its triangles. O(n
/// log n) for n elements of the plan and its divided faces.
template <class Mesh, class Numbers>
class RelinkingFinder {
 public:
  RelinkingFinder(const Mesh& mesh, const DivisionPlan& plan, const Numbers& numbers)
      : mesh_(mesh), plan_(plan), points_(mesh, plan, numbers) {}

  Relinking run() {
    const Relinking::Counts before{mesh_.n_vertices(), mesh_.n_edges(), mesh_.n_faces()};
    found_.before = found_.after = before;
    found_.after.vertices += plan_.vertices.size();
    found_.vertices = points_.mixed();
    note_chains();
    std::size_t first = 0;
    for (std::size_t k = 0; k < plan_.faces.size(); ++k) {
      divide(points_.face(plan_.faces[k]), first, plan_.parts[k]);
      first += plan_.parts[k];
    }
    close_edges();
    find_chains();
    check_counts();
    return std::move(found_);
  }

 private:
  using Vertex = OpenMesh::VertexHandle;
  using Halfedge = OpenMesh::HalfedgeHandle;
  using Edge = OpenMesh::EdgeHandle;
  using Face = OpenMesh::FaceHandle;

  /// An old edge with new vertices on it, in the direction of its halfedge 0.
  struct DividedEdge {
    std::vector<Vertex> points;
    int first_new = 0;                       // the handle of the first new edge; the others follow
    std::array<bool, 2> seen{false, false};  // per halfedge, whether a divided face has it
  };
  struct Side {
    Halfedge halfedge = Halfedge();
    bool used = false;
    int part_of =
        -1;  // the index (0 to 2) of the old halfedge that contains this side; -1 inside the face
  };
  using Key = std::uint64_t;
  static Key key(Vertex a, Vertex b) {
    return Key{static_cast<std::uint32_t>(a.idx())} << 32U | static_cast<std::uint32_t>(b.idx());
  }
  static std::size_t side_of(Halfedge h) { return static_cast<std::size_t>(h.idx() & 1); }
  static Halfedge halfedge(int edge, std::size_t side) {
    return Halfedge(2 * edge + static_cast<int>(side));
  }
  [[noreturn]] static void refuse(Face f) {
    PlanPoints<Mesh, Numbers>::refuse("Face " + std::to_string(f.idx()) +
                                      " does not have the sides that are to be divided");
  }

  DividedEdge* divided(Halfedge h) {
    const auto found = divided_.find(h.idx() / 2);
    return found == divided_.end() ? nullptr : &found->second;
  }
  /// Records the division of the edge of `h`; null if no new vertex lies on the edge.
  DividedEdge* divide_edge(Halfedge h) {
    const Halfedge along = halfedge(h.idx() / 2, 0);
    const Vertex tail = mesh_.from_vertex_handle(along), head = mesh_.to_vertex_handle(along);
    const auto [first, last] = points_.on(tail, head);
    if (first == last) return nullptr;
    const auto [place, is_new] = divided_.try_emplace(h.idx() / 2);
    DividedEdge& edge = place->second;
    if (!is_new) return &edge;
    order_.push_back(h.idx() / 2);
    for (auto at = first; at != last; ++at) edge.points.push_back(at->vertex);
    if (head < tail) std::reverse(edge.points.begin(), edge.points.end());
    edge.first_new = static_cast<int>(found_.after.edges);
    found_.after.edges += edge.points.size();
    points_used_ += edge.points.size();
    for (std::size_t k = 0; k < edge.points.size(); ++k) {
      const int part = edge.first_new + static_cast<int>(k);
      const bool is_last = k + 1 == edge.points.size();
      found_.heads.emplace_back(halfedge(part, 0), is_last ? head : edge.points[k + 1]);
      found_.heads.emplace_back(halfedge(part, 1), edge.points[k]);
      found_.halves.emplace_back(Edge(h.idx() / 2), Edge(part));
    }
    found_.heads.emplace_back(along, edge.points.front());
    const Halfedge from_head = halfedge(h.idx() / 2, 1);
    if (mesh_.halfedge_handle(head) == from_head) {
      found_.of_vertices.emplace_back(head, first_of(from_head));
    }
    return &edge;
  }
  /// The parts of a halfedge, in its direction.
  std::vector<Halfedge> parts_of(Halfedge h) {
    std::vector<Halfedge> parts{halfedge(h.idx() / 2, side_of(h))};
    if (const DividedEdge* edge = divided(h); edge != nullptr) {
      for (std::size_t k = 0; k < edge->points.size(); ++k) {
        parts.push_back(halfedge(edge->first_new + static_cast<int>(k), side_of(h)));
      }
    }
    if (side_of(h) == 1) std::reverse(parts.begin(), parts.end());
    return parts;
  }
  Halfedge last_of(Halfedge h) {
    const DividedEdge* edge = divided(h);
    if (edge == nullptr || side_of(h) == 1) return h;
    return halfedge(edge->first_new + static_cast<int>(edge->points.size()) - 1, 0);
  }
  Halfedge first_of(Halfedge h) {
    const DividedEdge* edge = divided(h);
    if (edge == nullptr || side_of(h) == 0) return h;
    return halfedge(edge->first_new + static_cast<int>(edge->points.size()) - 1, 1);
  }

  void divide(Face f, std::size_t first, std::size_t count) {
    sides_.clear();
    corners_.clear();
    face_ = f;
    Halfedge h = mesh_.halfedge_handle(f);
    for (int k = 0; k < 3; ++k, h = mesh_.next_halfedge_handle(h)) {
      old_[static_cast<std::size_t>(k)] = h;
      add_side(k, h);
    }
    const std::size_t around = sides_.size(), inside = count_inside(first, count);
    if (count + 2 != 2 * inside + around) refuse(f);
    for (std::size_t k = first; k < first + count; ++k) {
      Face part = f;
      if (k > first) {
        part = Face(static_cast<int>(found_.after.faces++));
        found_.face_parts.emplace_back(f, part);
      }
      add_triangle(plan_.triangles[k], part);
    }
    for (const auto& [ends, side] : sides_) {
      if (!side.used) refuse(f);
    }
  }
  void add_side(int k, Halfedge h) {
    Vertex from = mesh_.from_vertex_handle(h);
    std::vector<Vertex> way;
    if (DividedEdge* edge = divide_edge(h); edge != nullptr) {
      if (std::exchange(edge->seen[side_of(h)], true)) refuse(face_);
      way = edge->points;
      if (side_of(h) == 1) std::reverse(way.begin(), way.end());
    }
    way.push_back(mesh_.to_vertex_handle(h));
    std::size_t i = 0;
    for (const Halfedge part : parts_of(h)) {
      const Vertex to = way[i++];
      sides_[key(from, to)] = Side{part, false, k};
      corners_.push_back(from);
      from = to;
    }
  }
  /// The number of the triangles' vertices inside the face. Throws PlanError if another vertex is
  /// not on the boundary of the face.
  std::size_t count_inside(std::size_t first, std::size_t count) {
    std::sort(corners_.begin(), corners_.end());
    std::vector<Vertex> inside;
    for (std::size_t k = first; k < first + count; ++k) {
      for (const std::uint32_t number : plan_.triangles[k]) {
        const Vertex v = points_.vertex(number);
        if (std::binary_search(corners_.begin(), corners_.end(), v)) continue;
        if (points_.is_old(v) || !lies_inside(points_.mixed(v))) refuse(face_);
        inside.push_back(v);
      }
    }
    std::sort(inside.begin(), inside.end());
    inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
    points_used_ += inside.size();
    return inside.size();
  }
  bool lies_inside(const Relinking::Mixed& mixed) const {
    return std::all_of(old_.begin(), old_.end(), [&](Halfedge h) {
      const auto& from = mixed.from;
      return std::find(from.begin(), from.end(), mesh_.to_vertex_handle(h)) != from.end();
    });
  }

  void add_triangle(const DivisionPlan::Three& numbers, Face part) {
    std::array<Halfedge, 3> around;
    std::array<Vertex, 3> v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = points_.vertex(numbers[k]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex from = v[k], to = v[(k + 1) % 3];
      if (from == to) refuse(face_);
      auto side = sides_.find(key(from, to));
      if (side == sides_.end()) side = add_inner_edge(from, to);
      if (std::exchange(side->second.used, true)) refuse(face_);
      around[k] = side->second.halfedge;
      note(from, to, around[k]);
      mix_corner(around[k], to, side->second.part_of);
      found_.faces.emplace_back(around[k], part);
      if (!points_.is_old(from) && points_.mixed(from).from[2].is_valid()) {
        found_.of_vertices.emplace_back(from, around[k]);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) found_.nexts.emplace_back(around[k], around[(k + 1) % 3]);
    found_.of_faces.emplace_back(part, around[2]);  // the halfedge that ends at the first corner
  }
  typename std::unordered_map<Key, Side>::iterator add_inner_edge(Vertex from, Vertex to) {
    const int edge = static_cast<int>(found_.after.edges++);
    found_.heads.emplace_back(halfedge(edge, 0), to);
    found_.heads.emplace_back(halfedge(edge, 1), from);
    sides_[key(to, from)] = Side{halfedge(edge, 1), false, -1};
    return sides_.insert_or_assign(key(from, to), Side{halfedge(edge, 0), false, -1}).first;
  }
  /// Records the source of the values at a triangle's corner, unless they are unchanged.
  void mix_corner(Halfedge h, Vertex at, int part_of) {
    Relinking::Corner corner{h, old_, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      corner.weights[k] = weight(at, mesh_.to_vertex_handle(old_[k]));
    }
    const auto nearest = static_cast<std::size_t>(
        std::max_element(corner.weights.begin(), corner.weights.end()) - corner.weights.begin());
    if (part_of < 0) found_.inner.emplace_back(old_[nearest], h);
    if (old_[nearest] != h || corner.weights[nearest] < 1) found_.corners.push_back(corner);
  }
  [[nodiscard]] double weight(Vertex at, Vertex corner) const {
    if (points_.is_old(at)) return at == corner ? 1 : 0;
    const Relinking::Mixed& mixed = points_.mixed(at);
    const auto place = std::find(mixed.from.begin(), mixed.from.end(), corner);
    return place == mixed.from.end()
               ? 0
               : mixed.weights[static_cast<std::size_t>(place - mixed.from.begin())];
  }

  /// Links the parts of divided boundary edges, and gives each new vertex on an edge a halfedge.
  void close_edges() {
    if (points_used_ != plan_.vertices.size()) {
      throw PlanError("The plan has new vertices that none of its faces uses.");
    }
    for (const int e : order_) {
      const DividedEdge& edge = divided_.at(e);
      for (const std::size_t side : {0U, 1U}) {
        const Halfedge h = halfedge(e, side);
        if (edge.seen[side]) continue;
        if (!mesh_.is_boundary(h)) refuse(mesh_.face_handle(h));
        close_boundary(h);
      }
      const bool back = mesh_.is_boundary(halfedge(e, 1));
      for (std::size_t k = 0; k < edge.points.size(); ++k) {
        const int after = edge.first_new + static_cast<int>(k), before = k == 0 ? e : after - 1;
        found_.of_vertices.emplace_back(edge.points[k],
                                        back ? halfedge(before, 1) : halfedge(after, 0));
        note(edge.points[k], head_of(edge, e, k), halfedge(after, 0));
        note(head_of(edge, e, k), edge.points[k], halfedge(after, 1));
      }
      const Vertex tail = mesh_.from_vertex_handle(halfedge(e, 0));
      note(tail, edge.points.front(), halfedge(e, 0));
      note(edge.points.front(), tail, halfedge(e, 1));
    }
  }
  [[nodiscard]] Vertex head_of(const DividedEdge& edge, int e, std::size_t k) const {
    return k + 1 < edge.points.size() ? edge.points[k + 1] : mesh_.to_vertex_handle(halfedge(e, 0));
  }
  void close_boundary(Halfedge h) {
    const std::vector<Halfedge> parts = parts_of(h);
    for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
      found_.nexts.emplace_back(parts[k], parts[k + 1]);
    }
    found_.nexts.emplace_back(last_of(mesh_.prev_halfedge_handle(h)), parts.front());
    found_.nexts.emplace_back(parts.back(), first_of(mesh_.next_halfedge_handle(h)));
  }

  /// Records the pairs of vertices whose halfedges the chains need.
  void note_chains() {
    each_link([&](std::size_t, std::size_t, Vertex a, Vertex b) { wanted_[key(a, b)]; });
  }
  void note(Vertex from, Vertex to, Halfedge h) {
    const auto found = wanted_.find(key(from, to));
    if (found != wanted_.end() && !found->second.is_valid()) found->second = h;
  }
  void find_chains() {
    found_.chains.resize(plan_.chains.size());
    each_link([&](std::size_t c, std::size_t i, Vertex a, Vertex b) {
      Halfedge& h = wanted_[key(a, b)];
      if (!h.is_valid() && points_.is_old(a) && points_.is_old(b)) h = old_halfedge(a, b);
      if (!h.is_valid()) {
        PlanPoints<Mesh, Numbers>::refuse("No edge joins vertex " + std::to_string(i) +
                                          " of chain " + std::to_string(c) + " to the next vertex");
      }
      found_.chains[c].push_back(h);
    });
  }
  /// The halfedge of an undivided old edge; invalid if there is none.
  Halfedge old_halfedge(Vertex a, Vertex b) {
    const Halfedge h = mesh_.find_halfedge(a, b);
    return h.is_valid() && divided(h) == nullptr ? h : Halfedge();
  }
  template <class Take>
  void each_link(Take take) const {
    for (std::size_t c = 0; c < plan_.chains.size(); ++c) {
      const auto& vertices = plan_.chains[c].vertices;
      const std::size_t n = vertices.size();
      if (n < 2) continue;  // a curve of one point
      for (std::size_t i = 0; i + (plan_.chains[c].closed ? 0 : 1) < n; ++i) {
        take(c, i, points_.vertex(vertices[i]), points_.vertex(vertices[(i + 1) % n]));
      }
    }
  }
  void check_counts() const {
    const auto most = static_cast<std::size_t>(std::numeric_limits<int>::max());
    const Relinking::Counts& n = found_.after;
    if (n.vertices < most && n.edges < most / 2 && n.faces < most) return;
    throw PlanError("The mesh would have more elements than handles can tell apart.");
  }

  const Mesh& mesh_;
  const DivisionPlan& plan_;
  PlanPoints<Mesh, Numbers> points_;
  Relinking found_;
  std::unordered_map<int, DividedEdge> divided_;  // by old edge
  std::vector<int> order_;                        // of the keys of divided_, as found
  std::size_t points_used_ = 0;
  std::unordered_map<Key, Halfedge> wanted_;
  // The face that is being divided, and its sides:
  Face face_;
  std::array<Halfedge, 3> old_;
  std::unordered_map<Key, Side> sides_;
  std::vector<Vertex> corners_;
};

}  // namespace talweg
