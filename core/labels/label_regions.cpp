#include "talweg/core/labels/label_regions.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "talweg/core/mesh/union_find.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kNoIndex = 0xFFFFFFFFU;

double area_of(const MeshLists& lists, const Triangle& t) {
  const Point& a = lists.points[t[0]];
  return (lists.points[t[1]] - a).cross(lists.points[t[2]] - a).norm() / 2;
}

double area_of(const SurfaceMesh& mesh, FaceId face) {
  const auto c = mesh.surface().corners(face);
  const Point& a = mesh.point(c[0]);
  return (mesh.point(c[1]) - a).cross(mesh.point(c[2]) - a).norm() / 2;
}

/// Numbers the sets in the order of their first elements; elements that are `left_out` have no
/// part.
template <class LeftOut>
void number_parts(UnionFind& sets, std::span<const std::int64_t> labels, const LeftOut& left_out,
                  RegionParts& result) {
  std::vector<std::uint32_t> number(labels.size(), kNoIndex);
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    if (left_out(i)) {
      result.of_element.push_back(kNoIndex);
      continue;
    }
    std::uint32_t& part = number[sets.find(i)];
    if (part == kNoIndex) {
      part = static_cast<std::uint32_t>(result.parts.size());
      result.parts.push_back({labels[i], 0});
    }
    result.of_element.push_back(part);
  }
}

/// The share of a corner in the area of a face that is divided at the midpoints of its sides and
/// its centroid.
double share(const std::array<std::uint32_t, 3>& parts, std::size_t corner) {
  const std::uint32_t own = parts[corner];
  const std::uint32_t p = parts[(corner + 1) % 3], q = parts[(corner + 2) % 3];
  if (own == p && own == q) return 1.0 / 3;
  if (own != p && own != q) return p == q ? 1.0 / 4 : 1.0 / 3;
  return 3.0 / 8;
}

RegionParts parts_by_face(const SurfaceMesh& mesh, std::span<const std::int64_t> labels,
                          std::span<const LabelBorder> borders) {
  const Surface& surface = mesh.surface();
  UnionFind sets(labels.size());
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    if (surface.on_boundary(EdgeId{e})) continue;
    const HalfedgeId h = halfedge_of(EdgeId{e});
    const auto f = static_cast<std::uint32_t>(surface.face(h).index());
    const auto g = static_cast<std::uint32_t>(surface.face(twin(h)).index());
    if (labels[f] == labels[g]) sets.join(f, g);
  }
  RegionParts result;
  number_parts(
      sets, labels, [](std::uint32_t) { return false; }, result);
  for (std::size_t f = 0; f < labels.size(); ++f) {
    result.parts[result.of_element[f]].area += area_of(mesh, FaceId{f});
  }
  for (const LabelBorder& border : borders) {
    const auto vertex = [&](std::size_t i) {
      return std::get<AtVertex>(border.curve.points[i].where()).vertex;
    };
    const HalfedgeId h = surface.find_halfedge(vertex(0), vertex(1));
    result.beside.push_back({result.of_element[surface.face(h).index()],
                             result.of_element[surface.face(twin(h)).index()]});
  }
  return result;
}

RegionParts parts_by_vertex(const SurfaceMesh& mesh, std::span<const std::int64_t> labels,
                            std::span<const LabelBorder> borders) {
  const Surface& surface = mesh.surface();
  UnionFind sets(labels.size());
  const auto ends = [&](EdgeId e) {
    const HalfedgeId h = halfedge_of(e);
    return std::array{static_cast<std::uint32_t>(surface.tail(h).index()),
                      static_cast<std::uint32_t>(surface.head(h).index())};
  };
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const auto [p, q] = ends(EdgeId{e});
    if (labels[p] == labels[q]) sets.join(p, q);
  }
  RegionParts result;
  result.by_face = false;
  const auto is_isolated = [&](std::uint32_t v) { return !surface.halfedge(VertexId{v}).valid(); };
  number_parts(sets, labels, is_isolated, result);
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto corners = surface.corners(FaceId{f});
    std::array<std::uint32_t, 3> parts{};
    for (std::size_t c = 0; c < 3; ++c) parts[c] = result.of_element[corners[c].index()];
    const double area = area_of(mesh, FaceId{f});
    for (std::size_t c = 0; c < 3; ++c) result.parts[parts[c]].area += area * share(parts, c);
  }
  for (const LabelBorder& border : borders) {
    const auto on_edge = std::find_if(
        border.curve.points.begin(), border.curve.points.end(),
        [](const SurfacePoint& p) { return std::holds_alternative<OnEdge>(p.where()); });
    auto [p, q] = ends(std::get<OnEdge>(on_edge->where()).edge);
    if (labels[p] != border.labels[0]) std::swap(p, q);
    result.beside.push_back({result.of_element[p], result.of_element[q]});
  }
  return result;
}

/// A face at an edge, or a link of a chain along the edge.
struct AtEdge {
  std::uint32_t high;         // the edge's end with the larger number
  std::uint32_t face, chain;  // one of them is kNoIndex
  bool rising;                // whether its direction is from the smaller end to the larger
};

/// The faces and chain links at each edge of a cut mesh, sorted by the smaller end of the edge.
class EdgeLists {
 public:
  explicit EdgeLists(const CutMesh& cut) : first_(cut.lists.points.size() + 1, 0) {
    each(cut, [&](std::uint32_t p, std::uint32_t q, auto, auto) { ++first_[std::min(p, q) + 1]; });
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    entries_.resize(first_.back());
    std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
    each(cut, [&](std::uint32_t p, std::uint32_t q, std::uint32_t face, std::uint32_t chain) {
      entries_[at[std::min(p, q)]++] = {std::max(p, q), face, chain, p < q};
    });
  }
  /// Calls visit(smaller end, items) for each edge.
  template <class Visit>
  void each_edge(const Visit& visit) {
    for (std::uint32_t v = 0; v + 1 < first_.size(); ++v) {
      const auto list = std::span(entries_).subspan(first_[v], first_[v + 1] - first_[v]);
      std::stable_sort(list.begin(), list.end(),
                       [](const AtEdge& a, const AtEdge& b) { return a.high < b.high; });
      for (std::size_t i = 0, end = 0; i < list.size(); i = end) {
        while (end < list.size() && list[end].high == list[i].high) ++end;
        visit(v, std::span<const AtEdge>(list.subspan(i, end - i)));
      }
    }
  }

 private:
  template <class Visit>
  static void each(const CutMesh& cut, const Visit& visit) {
    for (std::uint32_t f = 0; f < cut.lists.triangles.size(); ++f) {
      const Triangle& t = cut.lists.triangles[f];
      for (std::size_t c = 0; c < 3; ++c) visit(t[c], t[(c + 1) % 3], f, kNoIndex);
    }
    for (std::uint32_t k = 0; k < cut.chains.size(); ++k) {
      const auto& v = cut.chains[k].vertices;
      for (std::size_t i = 0; i + (cut.chains[k].closed ? 0 : 1) < v.size(); ++i) {
        if (v[i] != v[(i + 1) % v.size()]) visit(v[i], v[(i + 1) % v.size()], kNoIndex, k);
      }
    }
  }

  std::vector<std::uint32_t> first_;
  std::vector<AtEdge> entries_;
};

/// One side of a link of a chain.
struct LinkSide {
  std::uint32_t chain, part,
      face;  // the part on this side in the drawing, the face here in the cut mesh
  double length;
};

class Follower {
 public:
  Follower(const CutMesh& cut, const RegionParts& drawn, std::span<const LabelBorder> borders)
      : cut_(cut), drawn_(drawn), borders_(borders), pieces_(cut.lists.triangles.size()) {}

  CutRegions run() {
    gather();
    name_pieces();
    check_sides();
    check_meetings();
    CutRegions result;
    result.area.assign(drawn_.parts.size(), 0);
    result.pieces.assign(drawn_.parts.size(), 0);
    for (std::uint32_t f = 0; f < cut_.lists.triangles.size(); ++f) {
      result.part_of_face.push_back(owner_[pieces_.find(f)]);
      const std::uint32_t part = result.part_of_face.back();
      result.area[part] += area_of(cut_.lists, cut_.lists.triangles[f]);
      if (pieces_.find(f) == f) ++result.pieces[part];
    }
    std::sort(wrong_.begin(), wrong_.end());
    wrong_.erase(std::unique(wrong_.begin(), wrong_.end()), wrong_.end());
    result.wrong = std::move(wrong_);
    return result;
  }

 private:
  /// Joins faces across edges without a chain to components (pieces_), and collects the sides of
  /// all chains.
  void gather() {
    EdgeLists edges(cut_);
    edges.each_edge([&](std::uint32_t low, std::span<const AtEdge> here) {
      std::uint32_t rising = kNoIndex, falling = kNoIndex;
      std::size_t chains = 0;
      for (const AtEdge& at : here) {
        if (at.face == kNoIndex) ++chains;
        if (at.face != kNoIndex) (at.rising ? rising : falling) = at.face;
      }
      if (chains == 0) {
        if (rising != kNoIndex && falling != kNoIndex) pieces_.join(rising, falling);
        return;
      }
      const double length = (cut_.lists.points[low] - cut_.lists.points[here[0].high]).norm();
      for (const AtEdge& at : here) {
        if (at.face != kNoIndex) continue;
        const auto& [left, right] = drawn_.beside[at.chain];
        if (chains > 1) wrong_.push_back(at.chain);  // several chains share the edge
        const std::uint32_t on_left = at.rising ? rising : falling;
        const std::uint32_t on_right = at.rising ? falling : rising;
        if (on_left != kNoIndex) sides_.push_back({at.chain, left, on_left, length});
        if (on_right != kNoIndex) sides_.push_back({at.chain, right, on_right, length});
      }
    });
    for (LinkSide& side : sides_) side.face = pieces_.find(side.face);
  }

  /// Assigns each component to the part that borders the greatest length of its boundary.
  void name_pieces() {
    owner_.assign(cut_.lists.triangles.size(), kNoIndex);
    std::sort(sides_.begin(), sides_.end(), [](const LinkSide& a, const LinkSide& b) {
      return std::tie(a.face, a.part, a.chain) < std::tie(b.face, b.part, b.chain);
    });
    std::vector<double> best(drawn_.parts.size(), -1);
    main_.assign(drawn_.parts.size(), kNoIndex);
    double most = -1;
    for (std::size_t i = 0, end = 0; i < sides_.size(); i = end) {
      if (i == 0 || sides_[i].face != sides_[i - 1].face) most = -1;
      double length = 0;
      for (; end < sides_.size() && sides_[end].face == sides_[i].face &&
             sides_[end].part == sides_[i].part;
           ++end) {
        length += sides_[end].length;
      }
      if (length > most) {
        most = length;
        owner_[sides_[i].face] = sides_[i].part;
      }
      if (length > best[sides_[i].part]) {
        best[sides_[i].part] = length;
        main_[sides_[i].part] = sides_[i].face;
      }
    }
    for (std::uint32_t f = 0; f < owner_.size(); ++f) {  // components without a border
      std::uint32_t& owner = owner_[pieces_.find(f)];
      if (owner == kNoIndex) owner = part_before(f);
    }
  }

  /// The part of a face in the drawing, for faces of components without a border.
  [[nodiscard]] std::uint32_t part_before(std::uint32_t face) const {
    if (drawn_.by_face) return drawn_.of_element[cut_.face_from[face]];
    for (const std::uint32_t v : cut_.lists.triangles[face]) {
      if (v < drawn_.of_element.size()) return drawn_.of_element[v];
    }
    return 0;
  }

  void check_sides() {
    for (const LinkSide& side : sides_) {
      if (owner_[side.face] != side.part || main_[side.part] != side.face) {
        wrong_.push_back(side.chain);
      }
    }
    // A part without a component was lost: no chain has a face on its side.
    for (std::size_t c = 0; c < borders_.size(); ++c) {
      for (const std::uint32_t part : drawn_.beside[c]) {
        if (main_[part] == kNoIndex) wrong_.push_back(c);
      }
    }
  }

  [[nodiscard]] bool is_end(std::size_t chain, std::size_t i) const {
    const auto& [closed, vertices] = cut_.chains[chain];
    if (!closed) return i == 0 || i + 1 == vertices.size();
    const auto& fixed = borders_[chain].fixed;
    return !fixed.empty() && cut_.vertex_from[vertices[i]] == fixed.front();
  }

  /// Records chains that meet at a vertex which is not an end of all of them.
  void check_meetings() {
    struct Visit {
      std::uint32_t vertex;
      std::size_t chain;
      bool end;
    };
    std::vector<Visit> visits;
    for (std::size_t c = 0; c < cut_.chains.size(); ++c) {
      const auto& vertices = cut_.chains[c].vertices;
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        visits.push_back({vertices[i], c, is_end(c, i)});
      }
    }
    std::stable_sort(visits.begin(), visits.end(),
                     [](const Visit& a, const Visit& b) { return a.vertex < b.vertex; });
    for (std::size_t i = 0, next = 0; i < visits.size(); i = next) {
      bool all_end = true;
      for (; next < visits.size() && visits[next].vertex == visits[i].vertex; ++next) {
        all_end = all_end && visits[next].end;
      }
      if (all_end || next - i == 1) continue;
      for (std::size_t k = i; k < next; ++k) wrong_.push_back(visits[k].chain);
    }
  }

  const CutMesh& cut_;
  const RegionParts& drawn_;
  std::span<const LabelBorder> borders_;
  UnionFind pieces_;
  std::vector<LinkSide> sides_;       // `face` represents its component
  std::vector<std::uint32_t> owner_;  // the part, per face that represents a component
  std::vector<std::uint32_t> main_;   // per part, the component with the longest border
  std::vector<std::size_t> wrong_;
};

}  // namespace

RegionParts parts_of_regions(const SurfaceMesh& mesh, std::span<const std::int64_t> labels,
                             std::span<const LabelBorder> borders) {
  const Surface& surface = mesh.surface();
  if (labels.size() == surface.face_count()) return parts_by_face(mesh, labels, borders);
  return parts_by_vertex(mesh, labels, borders);
}

CutRegions regions_of_cut(const CutMesh& cut, const RegionParts& drawn,
                          std::span<const LabelBorder> borders) {
  return Follower(cut, drawn, borders).run();
}

std::vector<std::int64_t> majority_labels(const CutMesh& cut, const RegionParts& drawn,
                                          const CutRegions& regions, std::size_t face_count) {
  struct Share {
    std::uint32_t face;
    std::int64_t label;
    double area;
  };
  std::vector<Share> shares;
  for (std::size_t f = 0; f < cut.face_from.size(); ++f) {
    shares.push_back({cut.face_from[f], drawn.parts[regions.part_of_face[f]].label,
                      area_of(cut.lists, cut.lists.triangles[f])});
  }
  std::stable_sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) {
    return std::tie(a.face, a.label) < std::tie(b.face, b.label);
  });
  std::vector<std::int64_t> labels(face_count, 0);
  std::vector<double> most(face_count, -1);
  for (std::size_t i = 0, next = 0; i < shares.size(); i = next) {
    const Share& first = shares[i];
    double area = 0;
    while (next < shares.size() && shares[next].face == first.face &&
           shares[next].label == first.label) {
      area += shares[next++].area;
    }
    if (area <= most[first.face]) continue;
    most[first.face] = area;
    labels[first.face] = first.label;
  }
  return labels;
}

}  // namespace talweg
