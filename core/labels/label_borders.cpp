#include "talweg/core/labels/label_borders.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using Label = std::int64_t;

/// A segment of a border between two consecutive points; the smaller label is on its left.
struct Link {
  std::uint32_t from, to;
  std::array<Label, 2> labels;
};

/// A graph of points and links. Links are joined to chains at points with one link in and one link
/// out.
class BorderGraph {
 public:
  /// The number of the point with this key. Borders end at the point if `ends_here`.
  std::uint32_t point(std::size_t key, bool ends_here) {
    if (key >= number_.size()) number_.resize(key + 1, kNone);
    if (number_[key] == kNone) {
      number_[key] = static_cast<std::uint32_t>(keys_.size());
      keys_.push_back(key);
      ends_.push_back(ends_here);
    }
    return number_[key];
  }
  void link(std::uint32_t left_from, std::uint32_t left_to, Label left, Label right) {
    if (right < left) {
      std::swap(left, right);
      std::swap(left_from, left_to);
    }
    links_.push_back({left_from, left_to, {left, right}});
  }

  /// Calls emit(labels, keys of the points, closed, whether the first point is a junction).
  template <class Emit>
  void chains(const Emit& emit) {
    sort_links();
    used_.assign(links_.size(), false);
    for (std::uint32_t p = 0; p < keys_.size(); ++p) {
      if (is_end(p)) start_at(p, true, emit);
    }
    for (std::uint32_t p = 0; p < keys_.size(); ++p) start_at(p, false, emit);
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  /// Sorts links by the point that they leave: out_[first_[p]] to out_[first_[p + 1] - 1].
  void sort_links() {
    first_.assign(keys_.size() + 1, 0);
    entering_.assign(keys_.size(), 0);
    for (const Link& l : links_) {
      ++first_[l.from + 1];
      ++entering_[l.to];
    }
    for (std::size_t p = 0; p < keys_.size(); ++p) first_[p + 1] += first_[p];
    out_.resize(links_.size());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t l = 0; l < links_.size(); ++l) out_[fill[links_[l].from]++] = l;
  }
  /// Whether borders end at the point. Where a border continues, exactly one link enters and one
  /// leaves, with the same labels on both sides.
  [[nodiscard]] bool is_end(std::uint32_t p) const {
    return ends_[p] || entering_[p] != 1 || first_[p + 1] - first_[p] != 1;
  }

  template <class Emit>
  void start_at(std::uint32_t p, bool junction, const Emit& emit) {
    for (std::uint32_t i = first_[p]; i < first_[p + 1]; ++i) {
      if (used_[out_[i]]) continue;
      std::vector<std::size_t> keys = {keys_[p]};
      std::uint32_t l = out_[i];
      for (;;) {
        used_[l] = true;
        const std::uint32_t to = links_[l].to;
        if (to == p) break;
        keys.push_back(keys_[to]);
        if (is_end(to)) break;
        l = out_[first_[to]];
      }
      const bool closed = links_[l].to == p;
      emit(links_[l].labels, keys, closed, junction);
    }
  }

  std::vector<std::uint32_t> number_;  // by key
  std::vector<std::size_t> keys_;
  std::vector<bool> ends_;
  std::vector<Link> links_;
  std::vector<std::uint32_t> first_, out_, entering_;
  std::vector<bool> used_;
};

template <class PointOf>
std::vector<LabelBorder> borders_of(BorderGraph& graph, const PointOf& point_of) {
  std::vector<LabelBorder> borders;
  graph.chains([&](const std::array<Label, 2>& labels, const std::vector<std::size_t>& keys,
                   bool closed, bool junction) {
    LabelBorder border;
    border.labels = labels;
    border.curve.closed = closed;
    for (const std::size_t key : keys) border.curve.points.push_back(point_of(key));
    if (closed && junction) border.fixed = {border.curve.points.front()};
    borders.push_back(std::move(border));
  });
  if (borders.empty()) {
    throw Error(ErrorCode::kBadCurve, "All neighbours have the same label, so there is no border.");
  }
  return borders;
}

std::vector<LabelBorder> borders_of_faces(const Surface& surface, std::span<const Label> labels) {
  BorderGraph graph;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    if (surface.on_boundary(EdgeId{e})) continue;
    const HalfedgeId h = halfedge_of(EdgeId{e});
    const Label left = labels[surface.face(h).index()];
    const Label right = labels[surface.face(twin(h)).index()];
    if (left == right) continue;
    const auto number = [&](VertexId v) { return graph.point(v.index(), surface.on_boundary(v)); };
    const std::uint32_t from = number(surface.tail(h)), to = number(surface.head(h));
    graph.link(from, to, left, right);
  }
  return borders_of(graph,
                    [&](std::size_t v) { return SurfacePoint::at_vertex(surface, VertexId{v}); });
}

std::vector<LabelBorder> borders_of_vertices(const Surface& surface,
                                             std::span<const Label> labels) {
  BorderGraph graph;
  const auto label = [&](VertexId v) { return labels[v.index()]; };
  // The key of an edge's midpoint is the number of the edge; the key of a face's centroid is the
  // number of edges plus the number of the face.
  const auto midpoint = [&](HalfedgeId h) {
    return graph.point(edge_of(h).index(), surface.on_boundary(edge_of(h)));
  };
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const HalfedgeId first = surface.halfedge(FaceId{f});
    const std::array<HalfedgeId, 3> sides = {first, surface.next(first), surface.prev(first)};
    const auto mixed = [&](HalfedgeId h) {
      return label(surface.tail(h)) != label(surface.head(h));
    };
    const bool three = std::all_of(sides.begin(), sides.end(), mixed);
    for (const HalfedgeId h : sides) {
      if (!mixed(h)) continue;
      const Label tail = label(surface.tail(h)), head = label(surface.head(h));
      if (three) {
        // Seen into the face across its side h, the tail of h lies on the left.
        const std::uint32_t from = midpoint(h);
        graph.link(from, graph.point(surface.edge_count() + f, true), tail, head);
      } else if (mixed(surface.prev(h))) {  // a link from h around the tail of h
        const std::uint32_t from = midpoint(h);
        graph.link(from, midpoint(surface.prev(h)), tail, head);
      }
    }
  }
  return borders_of(graph, [&](std::size_t key) {
    if (key < surface.edge_count()) return SurfacePoint::on_edge(surface, EdgeId{key}, 0.5);
    return SurfacePoint::in_face(surface, FaceId{key - surface.edge_count()},
                                 {1.0 / 3, 1.0 / 3, 1.0 / 3});
  });
}

}  // namespace

std::vector<LabelBorder> label_borders(const Surface& surface, std::span<const Label> labels) {
  if (labels.size() == surface.face_count()) return borders_of_faces(surface, labels);
  if (labels.size() == surface.vertex_count()) return borders_of_vertices(surface, labels);
  throw Error(ErrorCode::kBadCurve, std::to_string(labels.size()) + " labels, but the mesh has " +
                                        std::to_string(surface.face_count()) + " faces and " +
                                        std::to_string(surface.vertex_count()) + " vertices.");
}

std::size_t count_junctions(const Surface& surface, std::span<const LabelBorder> borders) {
  std::set<std::pair<std::size_t, std::size_t>> places;  // kind (0: vertex, 1: face) and number
  const auto add = [&](const SurfacePoint& p) {
    if (const auto* v = std::get_if<AtVertex>(&p.where())) {
      if (!surface.on_boundary(v->vertex)) places.emplace(0, v->vertex.index());
    } else if (const auto* f = std::get_if<InFace>(&p.where())) {
      places.emplace(1, f->face.index());
    }
  };
  for (const LabelBorder& border : borders) {
    for (const SurfacePoint& p : border.fixed) add(p);
    if (border.curve.closed) continue;
    add(border.curve.points.front());
    add(border.curve.points.back());
  }
  return places.size();
}

}  // namespace talweg
