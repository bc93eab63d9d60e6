#include "face_sides.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::plugins {
namespace {

constexpr char kUnknown = 2;

std::pair<std::uint32_t, std::uint32_t> ends(std::uint32_t a, std::uint32_t b) {
  return std::minmax(a, b);
}

/// The edges along which curves run an odd number of times, in ascending order.
std::vector<std::pair<std::uint32_t, std::uint32_t>> borders_of(const CutMesh& cut) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all, odd;
  for (const CutMesh::Chain& chain : cut.chains) {
    const std::size_t n = chain.vertices.size();
    for (std::size_t k = 0; k + (chain.closed ? 0 : 1) < n; ++k) {
      all.push_back(ends(chain.vertices[k], chain.vertices[(k + 1) % n]));
    }
  }
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size();) {
    const auto end = std::upper_bound(all.begin(), all.end(), all[i]) - all.begin();
    if ((static_cast<std::size_t>(end) - i) % 2 != 0) odd.push_back(all[i]);
    i = static_cast<std::size_t>(end);
  }
  return odd;
}

[[noreturn]] void throw_no_sides(const Point& at, double edge, std::size_t curves) {
  throw Error(
      ErrorCode::kBadCurve,
      fmt::format("The drawn {} not separate the mesh into two sides: at {} a path leads to the "
                  "other side without crossing the drawing. This method needs loops that "
                  "enclose something, or curves from boundary to boundary.",
                  curves > 1 ? "curves do" : "curve does", position_text(at, edge)));
}

/// The sides of the faces of the cut mesh.
std::vector<char> sides_of_cut(const CutMesh& cut, const Surface& surface) {
  const auto borders = borders_of(cut);
  std::vector<char> side(surface.face_count(), kUnknown);
  std::vector<FaceId> queue;
  for (std::size_t seed = 0; seed < side.size(); ++seed) {
    if (side[seed] != kUnknown) continue;
    side[seed] = 0;
    queue.emplace_back(seed);
    while (!queue.empty()) {
      const FaceId f = queue.back();
      queue.pop_back();
      HalfedgeId h = surface.halfedge(f);
      for (int k = 0; k < 3; ++k, h = surface.next(h)) {
        if (!surface.has_face(twin(h))) continue;
        const auto a = static_cast<std::uint32_t>(surface.tail(h).index());
        const auto b = static_cast<std::uint32_t>(surface.head(h).index());
        const bool crosses = std::binary_search(borders.begin(), borders.end(), ends(a, b));
        const char there = static_cast<char>(crosses ? 1 - side[f.index()] : side[f.index()]);
        char& other = side[surface.face(twin(h)).index()];
        if (other == kUnknown) {
          other = there;
          queue.push_back(surface.face(twin(h)));
        } else if (other != there) {
          const Point &p = cut.lists.points[a], &q = cut.lists.points[b];
          throw_no_sides((p + q) / 2, (q - p).norm(), cut.chains.size());
        }
      }
    }
  }
  return side;
}

}  // namespace

FaceSides sides_of(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves) {
  const CutMesh cut = cut_along(mesh, curves);
  const Surface pieces = Surface::from_triangles(cut.lists.points.size(), cut.lists.triangles);
  const std::vector<char> side = sides_of_cut(cut, pieces);
  std::vector<std::array<double, 2>> area(mesh.surface().face_count(), {0, 0});
  for (std::size_t f = 0; f < side.size(); ++f) {
    const Triangle& t = cut.lists.triangles[f];
    const Point& p = cut.lists.points[t[0]];
    const Point normal = (cut.lists.points[t[1]] - p).cross(cut.lists.points[t[2]] - p);
    area[cut.face_from[f]][static_cast<std::size_t>(side[f])] += normal.norm() / 2;
  }
  FaceSides result;
  bool any = false;
  for (const auto& [first, second] : area) {
    result.side.push_back(second > first ? 1 : 0);
    result.exact = result.exact && !(first > 0 && second > 0);
    any = any || second > first;
  }
  if (!any) {
    throw Error(ErrorCode::kBadCurve,
                "The mesh is too coarse for the drawing: no face lies mostly on the smaller side "
                "of it, where this method starts.");
  }
  return result;
}

}  // namespace talweg::plugins
