#include "talweg/intrinsic/surface/surface.hpp"

#include <cmath>
#include <string>

#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/spokes.hpp"

namespace talweg {
namespace {

[[noreturn]] void bad_mesh(const std::string& message) {
  throw Error(ErrorCode::kBadMesh, message);
}

std::string text(std::size_t n) { return std::to_string(n); }

VertexId corner(std::span<const Triangle> triangles, std::size_t side, std::size_t offset) {
  return VertexId{triangles[side / 3][(side % 3 + offset) % 3]};
}

void check_indices(std::size_t vertex_count, std::span<const Triangle> triangles) {
  if (vertex_count >= VertexId::kInvalid || triangles.size() >= FaceId::kInvalid / 6) {
    bad_mesh("The mesh has more elements than 32-bit indices can count.");
  }
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (const std::uint32_t v : triangles[f]) {
      if (v >= vertex_count) {
        bad_mesh("Face " + text(f) + " refers to vertex " + text(v) + ", but there are only " +
                 text(vertex_count) + " vertices.");
      }
    }
  }
}

/// Sides sorted by their tail vertex: `sides[first[v]] ... sides[first[v + 1] - 1]` start at v.
struct SidesByTail {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> sides;
};

SidesByTail sort_by_tail(std::size_t vertex_count, std::span<const Triangle> triangles) {
  SidesByTail sorted;
  sorted.first.assign(vertex_count + 1, 0);
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) ++sorted.first[v + 1];
  }
  for (std::size_t v = 0; v < vertex_count; ++v) sorted.first[v + 1] += sorted.first[v];
  sorted.sides.resize(3 * triangles.size());
  std::vector<std::uint32_t> fill(sorted.first.begin(), sorted.first.end() - 1);
  for (std::size_t s = 0; s < sorted.sides.size(); ++s) {
    sorted.sides[fill[triangles[s / 3][s % 3]]++] = static_cast<std::uint32_t>(s);
  }
  return sorted;
}

std::string edge_text(std::span<const Triangle> triangles, std::size_t side) {
  return "the edge between vertices " + text(corner(triangles, side, 0).index()) + " and " +
         text(corner(triangles, side, 1).index());
}

/// The side of the neighbouring face along the same edge, or kNoSide at the boundary. Throws if the
/// edge is not manifold.
std::uint32_t opposite(std::span<const Triangle> triangles, const SidesByTail& sorted,
                       std::size_t side) {
  const VertexId a = corner(triangles, side, 0);
  const VertexId b = corner(triangles, side, 1);
  std::uint32_t found = Surface::kNoSide;
  const auto look = [&](std::uint32_t candidate) {
    if (corner(triangles, candidate, 0) != b || corner(triangles, candidate, 1) != a) return;
    if (found != Surface::kNoSide) {
      bad_mesh("Faces " + text(found / 3) + " and " + text(candidate / 3) + " run along " +
               edge_text(triangles, candidate) + " in the same direction.");
    }
    found = candidate;
  };
  // Searches the sides that start at b or the sides that end at a, whichever are fewer: many sides
  // meet at the hub of a fan.
  const auto degree = [&](VertexId v) {
    return sorted.first[v.index() + 1] - sorted.first[v.index()];
  };
  const bool starting = degree(b) <= degree(a);
  const VertexId center = starting ? b : a;
  for (std::uint32_t i = sorted.first[center.index()]; i < sorted.first[center.index() + 1]; ++i) {
    const std::uint32_t spoke = sorted.sides[i];
    look(starting ? spoke : spoke % 3 == 0 ? spoke + 2 : spoke - 1);
  }
  if (found != Surface::kNoSide) return found;
  for (std::uint32_t i = sorted.first[a.index()]; i < sorted.first[a.index() + 1]; ++i) {
    const std::uint32_t other = sorted.sides[i];
    if (other != side && corner(triangles, other, 1) == b) {
      bad_mesh("Faces " + text(side / 3) + " and " + text(other / 3) + " run along " +
               edge_text(triangles, side) + " in the same direction.");
    }
  }
  return Surface::kNoSide;
}

}  // namespace

Surface Surface::from_triangles(std::size_t vertex_count, std::span<const Triangle> triangles) {
  check_indices(vertex_count, triangles);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const Triangle& t = triangles[f];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      bad_mesh("Face " + text(f) + " uses a vertex twice.");
    }
  }
  const SidesByTail sorted = sort_by_tail(vertex_count, triangles);
  std::vector<std::uint32_t> gluing(3 * triangles.size());
  for (std::size_t s = 0; s < gluing.size(); ++s) gluing[s] = opposite(triangles, sorted, s);
  Surface surface;
  surface.glue(vertex_count, triangles, gluing);
  return surface;
}

Surface Surface::from_gluing(std::size_t vertex_count, std::span<const Triangle> triangles,
                             std::span<const std::uint32_t> gluing) {
  check_indices(vertex_count, triangles);
  if (gluing.size() != 3 * triangles.size()) {
    bad_mesh("The list of neighbouring sides has " + text(gluing.size()) +
             " entries, but there are " + text(3 * triangles.size()) + " sides.");
  }
  for (std::size_t s = 0; s < gluing.size(); ++s) {
    const std::uint32_t other = gluing[s];
    if (other == kNoSide) continue;
    if (other >= gluing.size() || gluing[other] != s || other == s) {
      bad_mesh("Side " + text(s) + " has side " + text(other) +
               " as its neighbour, but not the reverse.");
    }
    if (corner(triangles, s, 0) != corner(triangles, other, 1) ||
        corner(triangles, s, 1) != corner(triangles, other, 0)) {
      bad_mesh("Sides " + text(s) + " and " + text(other) +
               " are neighbours but join different vertices.");
    }
  }
  Surface surface;
  surface.glue(vertex_count, triangles, gluing);
  return surface;
}

void Surface::glue(std::size_t vertex_count, std::span<const Triangle> triangles,
                   std::span<const std::uint32_t> gluing) {
  // Edges are numbered in the order of their first sides.
  std::vector<HalfedgeId> of_side(gluing.size());
  std::size_t edges = 0;
  for (std::size_t s = 0; s < gluing.size(); ++s) {
    const bool second = gluing[s] != kNoSide && gluing[s] < s;
    of_side[s] = second ? twin(of_side[gluing[s]]) : HalfedgeId{2 * edges++};
  }
  halfedges_.assign(2 * edges, Halfedge{});
  face_halfedge_.resize(triangles.size());
  for (std::size_t s = 0; s < gluing.size(); ++s) {
    Halfedge& h = halfedges_[of_side[s].index()];
    h.next = of_side[s % 3 == 2 ? s - 2 : s + 1];
    h.tail = corner(triangles, s, 0);
    h.face = FaceId{s / 3};
    if (gluing[s] == kNoSide) halfedges_[twin(of_side[s]).index()].tail = corner(triangles, s, 1);
    if (s % 3 == 0) face_halfedge_[s / 3] = of_side[s];
  }
  lengths_.assign(edges, 0.0);

  vertex_halfedge_.assign(vertex_count, HalfedgeId{});
  std::vector<std::uint32_t> corners_at(vertex_count, 0);
  for (std::size_t s = 0; s < gluing.size(); ++s) {
    const std::size_t v = corner(triangles, s, 0).index();
    ++corners_at[v];
    if (!vertex_halfedge_[v].valid() || gluing[s] == kNoSide) vertex_halfedge_[v] = of_side[s];
  }
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const HalfedgeId first = vertex_halfedge_[v];
    if (!first.valid()) continue;
    std::uint32_t seen = 0;
    HalfedgeId h = first;
    do {
      ++seen;
      h = turn_ccw(h);
    } while (h != first && has_face(h));
    if (seen != corners_at[v]) {
      bad_mesh("The faces around vertex " + text(v) + " form more than one fan.");
    }
  }
}

void Surface::set_lengths(std::vector<double> lengths) {
  if (lengths.size() != edge_count()) {
    bad_mesh("There are " + text(lengths.size()) + " lengths for " + text(edge_count()) +
             " edges.");
  }
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    if (!(std::isfinite(lengths[e]) && lengths[e] >= 0)) {
      bad_mesh("The length of the edge between vertices " +
               text(tail(halfedge_of(EdgeId{e})).index()) + " and " +
               text(head(halfedge_of(EdgeId{e})).index()) + " is " + std::to_string(lengths[e]) +
               ".");
    }
  }
  lengths_ = std::move(lengths);
}

std::array<VertexId, 3> Surface::corners(FaceId f) const {
  const HalfedgeId h = halfedge(f);
  return {tail(h), tail(next(h)), tail(prev(h))};
}

HalfedgeId Surface::find_halfedge(VertexId a, VertexId b) const {
  const HalfedgeId first = halfedge(a);
  if (!first.valid()) return {};
  HalfedgeId h = first;
  do {
    if (head(h) == b) return h;
    if (!has_face(h)) break;
    h = turn_ccw(h);
  } while (h != first);
  return {};
}

Components components_of(const Surface& surface) {
  constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  Components result;
  result.of_vertex.assign(surface.vertex_count(), kNone);
  std::vector<VertexId> stack;
  for (std::size_t seed = 0; seed < surface.vertex_count(); ++seed) {
    if (result.of_vertex[seed] != kNone) continue;
    const auto id = static_cast<std::uint32_t>(result.count++);
    result.of_vertex[seed] = id;
    stack.push_back(VertexId{seed});
    while (!stack.empty()) {
      const VertexId v = stack.back();
      stack.pop_back();
      for_each_spoke(surface, v, [&](HalfedgeId h) {
        std::uint32_t& component = result.of_vertex[surface.head(h).index()];
        if (component != kNone) return;
        component = id;
        stack.push_back(surface.head(h));
      });
    }
  }
  return result;
}

}  // namespace talweg
