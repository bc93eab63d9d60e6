#include "talweg/core/drawing/cone_detour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"

namespace talweg {
namespace {

constexpr double kGain = 1e-3;  // of the section

/// A corner of a face that the line crosses, unfolded along the line, which is the x axis.
struct Corner {
  VertexId vertex;
  PlanePoint at;
};
/// The corners of the edge that the line crosses at a point, to the left and to the right of the
/// line.
struct Crossing {
  VertexId left, right;
};

/// The part of a line between two points, each an end of the line or a vertex.
struct Section {
  double begin = 0, end = 0;  // on the x axis
  std::vector<Corner> corners;
  std::vector<Crossing> crossings;
  VertexId last;  // at the end of the section; invalid at the end of the line
};

class Unfolding {
 public:
  Unfolding(const Surface& surface, std::span<const SurfacePoint> line) : surface_(&surface) {
    sections_.emplace_back();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) add(line[i], line[i + 1]);
  }
  [[nodiscard]] std::span<const Section> sections() const { return sections_; }

 private:
  void add(const SurfacePoint& from, const SurfacePoint& to) {
    const FaceId face = common_face(*surface_, from, to);
    if (face.valid()) lay_out(face, from, to);
    Section& section = sections_.back();
    section.end = x_;
    const auto* vertex = std::get_if<AtVertex>(&to.where());
    if (vertex == nullptr) return;
    section.last = vertex->vertex;
    sections_.emplace_back();
    sections_.back().begin = sections_.back().end = x_;
  }

  /// Unfolds a face such that the line runs along the x axis from the present end.
  void lay_out(FaceId face, const SurfacePoint& from, const SurfacePoint& to) {
    const SideFrame frame = side_frame(*surface_, face, 0);
    const PlanePoint a = frame.at(coordinates_in(*surface_, from, face).barycentric, 0);
    const PlanePoint b = frame.at(coordinates_in(*surface_, to, face).barycentric, 0);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length > 0)) return;
    const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
    const std::array<PlanePoint, 3> corners{PlanePoint{0, 0}, {frame.length, 0}, frame.apex};
    const auto ids = surface_->corners(face);
    Section& section = sections_.back();
    for (std::size_t k = 0; k < 3; ++k) {
      const double dx = corners[k].x - a.x, dy = corners[k].y - a.y;
      section.corners.push_back({ids[k], {x_ + ux * dx + uy * dy, ux * dy - uy * dx}});
    }
    if (const auto* on = std::get_if<OnEdge>(&to.where())) cross(on->edge, section);
    x_ += length;
  }

  void cross(EdgeId edge, Section& section) {
    const VertexId tail = surface_->tail(halfedge_of(edge)),
                   head = surface_->head(halfedge_of(edge));
    const auto last = std::span(section.corners).last(3);
    const auto height = [&](VertexId v) {
      return std::find_if(last.begin(), last.end(), [v](const Corner& c) { return c.vertex == v; })
          ->at.y;
    };
    const bool tail_is_left = height(tail) > height(head);
    section.crossings.push_back(tail_is_left ? Crossing{tail, head} : Crossing{head, tail});
  }

  const Surface* surface_;
  double x_ = 0;
  std::vector<Section> sections_;
};

/// The length of the way around the other side of a corner, relative to the length of the section;
/// 1 or more if that side is not shorter.
double other_side(SignpostTriangulation& triangulation, const Section& section, const Corner& c) {
  const double px = section.begin - c.at.x, qx = section.end - c.at.x, y = -c.at.y;
  const double p = std::hypot(px, y), q = std::hypot(qx, y), length = section.end - section.begin;
  const double seen = std::atan2(std::abs(px * y - qx * y), px * qx + y * y);
  constexpr double kLeastSeen = 0.3;  // radians; cones of less than twice this angle are needles
  if (!(std::min(p, q) > 1e-9 * length) || seen < kLeastSeen) return 1;
  if (triangulation.on_boundary(c.vertex)) return 1;
  const double other = triangulation.cone_angle(c.vertex) - seen;
  if (!(other < seen) || !(other > 0)) return 1;
  return std::sqrt(std::max(0.0, p * p + q * q - 2 * p * q * std::cos(other))) / length;
}

/// Whether edges join successive vertices of the chain, and its first and last vertex share faces
/// with the ends of the line. Rounding in needles may tear the chain.
bool is_whole(const Surface& surface, std::span<const SurfacePoint> line,
              const ConeDetour& detour) {
  const std::vector<VertexId>& chain = detour.chain;
  if (std::find(chain.begin(), chain.end(), detour.over) == chain.end()) return false;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    if (!surface.find_halfedge(chain[i], chain[i + 1]).valid()) return false;
  }
  const auto meets = [&](const SurfacePoint& end, VertexId v) {
    return common_face(surface, end, SurfacePoint::at_vertex(surface, v)).valid();
  };
  return meets(line.front(), chain.front()) && meets(line.back(), chain.back());
}

void append(VertexId vertex, std::vector<VertexId>& chain) {
  if (chain.empty() || chain.back() != vertex) chain.push_back(vertex);
}

}  // namespace

std::optional<ConeDetour> cone_detour(SignpostTriangulation& triangulation, const Surface& surface,
                                      std::span<const SurfacePoint> line) {
  const Unfolding unfolding(surface, line);
  const Section* where = nullptr;
  Corner best;
  double least = 1 - kGain;
  for (const Section& section : unfolding.sections()) {
    for (const Corner& corner : section.corners) {
      const double part = other_side(triangulation, section, corner);
      if (part >= least) continue;
      least = part;
      best = corner;
      where = &section;
    }
  }
  if (where == nullptr) return std::nullopt;
  ConeDetour detour{{}, best.vertex};
  for (const Section& section : unfolding.sections()) {
    const bool left = &section != where || best.at.y > 0;
    for (const Crossing& crossing : section.crossings) {
      append(left ? crossing.left : crossing.right, detour.chain);
    }
    if (section.last.valid() && &section != &unfolding.sections().back()) {
      append(section.last, detour.chain);
    }
  }
  return is_whole(surface, line, detour) ? std::optional(std::move(detour)) : std::nullopt;
}

}  // namespace talweg
