#include "talweg/core/cutting/curve_separation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "talweg/core/mesh/border_points.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/core/space/nearest_segment.hpp"

namespace talweg {
namespace {

std::vector<std::uint32_t> on_both_sides(const OpenedSeams& seams, std::size_t curve) {
  const auto &left = seams.left[curve], &right = seams.right[curve];
  std::vector<std::uint32_t> both;
  std::set_intersection(left.begin(), left.end(), right.begin(), right.end(),
                        std::back_inserter(both));
  return both;
}

/// A boundary vertex at a point of the boundary, or at an end of the point's boundary edge.
VertexId border_vertex(const Surface& surface, const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return v->vertex;
  return surface.tail(halfedge_of(std::get<OnEdge>(point.where()).edge));
}

/// Whether two boundary vertices are on the same boundary loop.
bool on_same_border(const Surface& surface, VertexId a, VertexId b) {
  VertexId v = a;
  do {
    if (v == b) return true;
    v = surface.head(surface.halfedge(v));  // the vertex's halfedge runs along the boundary
  } while (v != a);
  return false;
}

double distance_to_border(const SurfaceMesh& mesh, const Point& position) {
  const Surface& surface = mesh.surface();
  double least = HUGE_VAL;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    if (!surface.on_boundary(EdgeId{e})) continue;
    const HalfedgeId h = halfedge_of(EdgeId{e});
    const Segment side{mesh.point(surface.tail(h)), mesh.point(surface.head(h))};
    least = std::min(least, distance_to(side, position));
  }
  return least;
}

/// Finds the reason why a curve does not separate the mesh, in words.
class Reason {
 public:
  Reason(const SurfaceMesh& mesh, const CutMesh& cut, std::size_t curve)
      : mesh_(&mesh), cut_(&cut), chain_(&cut.chains[curve]) {}

  [[nodiscard]] std::string words() const {
    const auto& vertices = chain_->vertices;
    if (vertices.size() < 2) return "it is a single point";
    if (chain_->closed) return around("loop");
    const bool start = is_inside(vertices.front()), end = is_inside(vertices.back());
    if (start || end) return inside(start, end);
    return leads_between_borders() ? "it leads from one border to another. A second curve between "
                                     "these two borders would separate the mesh together with it"
                                   : around("curve");
  }

 private:
  [[nodiscard]] static std::string around(std::string_view kind) {
    return fmt::format(
        "the mesh is connected around it, as around a handle. A second {} around the same handle "
        "would separate the mesh together with it",
        kind);
  }

  /// Whether an end of the curve lies inside the mesh, neither on the boundary nor on another
  /// passage of a curve.
  [[nodiscard]] bool is_inside(std::uint32_t vertex) const {
    if (is_on_boundary(mesh_->surface(), cut_->vertex_from[vertex])) return false;
    std::ptrdiff_t passes = 0;
    for (const CutChain& chain : cut_->chains) {
      passes += std::count(chain.vertices.begin(), chain.vertices.end(), vertex);
    }
    return passes == 1;
  }

  [[nodiscard]] std::string inside(bool start, bool end) const {
    if (start && end) {
      return fmt::format("its start {}, and its end {}. {}", place(chain_->vertices.front()),
                         place(chain_->vertices.back()), advice());
    }
    const std::uint32_t vertex = start ? chain_->vertices.front() : chain_->vertices.back();
    return fmt::format("its {} {}. {}", start ? "start" : "end", place(vertex), advice());
  }

  [[nodiscard]] std::string place(std::uint32_t vertex) const {
    const Point at = mesh_->position(cut_->vertex_from[vertex]);
    std::string words =
        fmt::format("at {} lies inside", position_text(at, mesh_->mean_edge_length()));
    const double away = distance_to_border(*mesh_, at);
    if (std::isfinite(away)) words += ", " + mesh_units_text(away) + " from the border";
    return words;
  }

  [[nodiscard]] std::string advice() const {
    const Surface& surface = mesh_->surface();
    for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
      if (surface.on_boundary(VertexId{v})) {
        return "Draw it from border to border, or as a loop";
      }
    }
    return "The mesh has no border, so draw a loop";
  }

  [[nodiscard]] bool leads_between_borders() const {
    const Surface& surface = mesh_->surface();
    const SurfacePoint& first = cut_->vertex_from[chain_->vertices.front()];
    const SurfacePoint& last = cut_->vertex_from[chain_->vertices.back()];
    return is_on_boundary(surface, first) && is_on_boundary(surface, last) &&
           !on_same_border(surface, border_vertex(surface, first), border_vertex(surface, last));
  }

  const SurfaceMesh* mesh_;
  const CutMesh* cut_;
  const CutChain* chain_;
};

}  // namespace

bool separates(const OpenedSeams& seams, std::size_t curve) {
  return !seams.left[curve].empty() && !seams.right[curve].empty() &&
         on_both_sides(seams, curve).empty();
}

std::string why_not_separated(const SurfaceMesh& mesh, const CutMesh& cut, const OpenedSeams& seams,
                              std::size_t curve) {
  const auto &left = seams.left[curve], &right = seams.right[curve];
  const bool at_border = left.empty() != right.empty();
  // A curve that crosses itself or others may still separate some pieces.
  const bool in_part = !at_border && (left.size() > 1 || right.size() > 1);
  return fmt::format(
      "Curve {} does not separate the mesh{}: {}.", curve, in_part ? " along its whole length" : "",
      at_border ? "it runs along the border only" : Reason(mesh, cut, curve).words());
}

std::vector<std::string> separation_notes(const SurfaceMesh& mesh, const CutMesh& cut,
                                          const OpenedSeams& seams) {
  constexpr std::size_t kMost = 8;
  std::vector<std::string> notes;
  std::size_t more = 0;
  for (std::size_t c = 0; c < seams.left.size(); ++c) {
    if (separates(seams, c)) continue;
    if (notes.size() < kMost) {
      notes.push_back(why_not_separated(mesh, cut, seams, c));
    } else {
      ++more;
    }
  }
  if (more > 0) notes.push_back(fmt::format("{} more curves do not separate the mesh.", more));
  return notes;
}

}  // namespace talweg
