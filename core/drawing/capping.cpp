#include "talweg/core/drawing/capping.hpp"

#include <algorithm>
#include <string>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// Whether a, b and c are the corners of one triangle.
bool in_one_triangle(const Surface& surface, VertexId a, VertexId b, VertexId c) {
  if (a == c) return false;
  const HalfedgeId ab = surface.find_halfedge(a, b);
  if (!ab.valid()) return false;
  for (const HalfedgeId h : {ab, twin(ab)}) {
    if (surface.has_face(h) && surface.head(surface.next(h)) == c) return true;
  }
  return false;
}

class Capper {
 public:
  Capper(const Surface& surface, std::span<const VertexId> pinned)
      : surface_(surface), pinned_(pinned.begin(), pinned.end()) {
    std::sort(pinned_.begin(), pinned_.end());
  }

  [[nodiscard]] bool can_drop(VertexId before, VertexId v, VertexId after) const {
    return !std::binary_search(pinned_.begin(), pinned_.end(), v) &&
           in_one_triangle(surface_, before, v, after);
  }

 private:
  const Surface& surface_;
  std::vector<VertexId> pinned_;
};

/// Drops inner corners of the path, from front to back, but keeps `at_least` vertices.
void cap_inside(const Capper& capper, std::vector<VertexId>& path, std::size_t at_least) {
  std::size_t kept = 0;
  std::size_t total = path.size();
  for (const VertexId v : std::vector<VertexId>(path)) {
    while (kept >= 2 && total > at_least && capper.can_drop(path[kept - 2], path[kept - 1], v)) {
      --kept;
      --total;
    }
    path[kept++] = v;
  }
  path.resize(kept);
}

/// Drops corners where a closed path begins and ends, until there are none.
void cap_ends(const Capper& capper, std::vector<VertexId>& path) {
  std::size_t front = 0;
  while (path.size() - front > 3) {
    const std::size_t back = path.size() - 1;
    if (capper.can_drop(path[back], path[front], path[front + 1])) {
      ++front;
    } else if (capper.can_drop(path[back - 1], path[back], path[front])) {
      path.pop_back();
    } else {
      break;
    }
  }
  path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(front));
}

}  // namespace

std::size_t cap_corners(const Surface& surface, std::vector<VertexId>& path, bool closed,
                        std::span<const VertexId> pinned) {
  for (const VertexId v : path) {
    if (v.index() >= surface.vertex_count()) {
      throw Error(ErrorCode::kBadCurve,
                  "Vertex " + std::to_string(v.index()) + " of the path does not exist.");
    }
  }
  const std::size_t before = path.size();
  const Capper capper(surface, pinned);
  cap_inside(capper, path, closed ? 3 : 2);
  if (closed) cap_ends(capper, path);
  return before - path.size();
}

}  // namespace talweg
