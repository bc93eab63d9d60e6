#include "talweg/core/cutting/part_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "talweg/core/cutting/tagged_edges.hpp"
#include "talweg/core/mesh/polygon_triangulation.hpp"
#include "talweg/core/mesh/union_find.hpp"

namespace talweg {
namespace {

constexpr double kPlanePart = 1e-9;  // fraction of the polygon's size
constexpr std::size_t kNoPolygon = static_cast<std::size_t>(-1);

using Ends = std::pair<std::uint32_t, std::uint32_t>;

class PolygonFinder {
 public:
  PolygonFinder(const MeshPart& part, const PartOrigins& origins, std::span<const Polygon> of_file)
      : part_(part), origins_(origins), of_file_(of_file) {
    for (const TaggedEdge& edge : tagged_edges(part.lists.triangles, origins.curves)) {
      curves_.push_back(std::minmax(edge.from, edge.to));
    }
    std::sort(curves_.begin(), curves_.end());
  }

  FaceOutlines run() {
    find_members();
    FaceOutlines faces;
    for (std::uint32_t f = 0; f < part_.lists.triangles.size(); ++f) {
      const std::size_t polygon = polygon_of(f);
      if (polygon == kNoPolygon) {
        add_triangle(faces, f);
      } else if (members(polygon).front() == f) {
        add_polygon(faces, polygon);
      }
    }
    return faces;
  }

 private:
  [[nodiscard]] std::size_t polygon_of(std::uint32_t f) const {
    const std::uint32_t face = origins_.faces[f];
    auto at = std::upper_bound(of_file_.begin(), of_file_.end(), face,
                               [](std::uint32_t g, const Polygon& p) { return g < p.first; });
    if (face == kNoFace || at == of_file_.begin()) return kNoPolygon;
    --at;
    if (face - at->first >= at->corners - 2) return kNoPolygon;
    return static_cast<std::size_t>(at - of_file_.begin());
  }

  void find_members() {
    first_.assign(of_file_.size() + 1, 0);
    for (std::uint32_t f = 0; f < part_.lists.triangles.size(); ++f) {
      const std::size_t polygon = polygon_of(f);
      if (polygon != kNoPolygon) ++first_[polygon + 1];
    }
    for (std::size_t p = 0; p < of_file_.size(); ++p) first_[p + 1] += first_[p];
    members_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t f = 0; f < part_.lists.triangles.size(); ++f) {
      const std::size_t polygon = polygon_of(f);
      if (polygon != kNoPolygon) members_[next[polygon]++] = f;
    }
  }
  [[nodiscard]] std::span<const std::uint32_t> members(std::size_t polygon) const {
    return std::span(members_).subspan(first_[polygon], first_[polygon + 1] - first_[polygon]);
  }

  static void add_triangle(FaceOutlines& faces, std::uint32_t f) {
    faces.add(std::array<PolygonCorner, 3>{{{f, 0}, {f, 1}, {f, 2}}});
  }

  void add_polygon(FaceOutlines& faces, std::size_t polygon) const {
    const auto triangles = members(polygon);
    const std::vector<std::vector<std::uint32_t>> pieces = pieces_of(triangles);
    const bool whole = pieces.size() == 1 && triangles.size() == of_file_[polygon].corners - 2;
    const bool plane = whole || is_plane(triangles);
    for (const std::vector<std::uint32_t>& piece : pieces) {
      const auto corners =
          plane ? outline(part_.lists.triangles, piece) : std::vector<PolygonCorner>();
      if (!corners.empty()) {
        faces.add(corners);
      } else {
        for (const std::uint32_t f : piece) add_triangle(faces, f);
      }
    }
  }

  /// The sets of triangles that are connected across edges without a curve.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> pieces_of(
      std::span<const std::uint32_t> triangles) const {
    UnionFind groups(triangles.size());
    std::map<Ends, std::uint32_t> seen;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      const Triangle& t = part_.lists.triangles[triangles[i]];
      for (std::size_t k = 0; k < 3; ++k) {
        const Ends ends = std::minmax(t[k], t[(k + 1) % 3]);
        const auto [other, is_new] = seen.emplace(ends, i);
        if (is_new || std::binary_search(curves_.begin(), curves_.end(), ends)) continue;
        groups.join(other->second, i);
      }
    }
    std::map<std::uint32_t, std::vector<std::uint32_t>> pieces;  // by the first triangle
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      pieces[groups.find(i)].push_back(triangles[i]);
    }
    std::vector<std::vector<std::uint32_t>> result;
    result.reserve(pieces.size());
    for (auto& [first, piece] : pieces) result.push_back(std::move(piece));
    return result;
  }

  [[nodiscard]] bool is_plane(std::span<const std::uint32_t> triangles) const {
    const std::vector<Point>& points = part_.lists.points;
    const Point origin = points[part_.lists.triangles[triangles[0]][0]];
    Point normal = Point::Zero();
    double size = 0;
    for (const std::uint32_t f : triangles) {
      const auto& [a, b, c] = part_.lists.triangles[f];
      normal += (points[b] - points[a]).cross(points[c] - points[a]);
      for (const std::uint32_t v : {a, b, c}) size = std::max(size, (points[v] - origin).norm());
    }
    normal = normal.stableNormalized();
    for (const std::uint32_t f : triangles) {
      for (const std::uint32_t v : part_.lists.triangles[f]) {
        if (std::abs((points[v] - origin).dot(normal)) > kPlanePart * size) return false;
      }
    }
    return true;
  }

  const MeshPart& part_;
  const PartOrigins& origins_;
  std::span<const Polygon> of_file_;
  std::vector<Ends> curves_;            // edges along curves, sorted
  std::vector<std::uint32_t> first_;    // per polygon, the index of its first triangle in members_
  std::vector<std::uint32_t> members_;  // triangles of the part, by polygon
};

}  // namespace

FaceOutlines polygons_of(const MeshPart& part, const PartOrigins& origins,
                         std::span<const Polygon> of_file) {
  return PolygonFinder(part, origins, of_file).run();
}

}  // namespace talweg
