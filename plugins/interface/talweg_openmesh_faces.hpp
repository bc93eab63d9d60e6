// Checks whether OpenMesh can represent a list of triangles, since OpenMesh prints a message for
// triangles that it cannot.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "talweg_arrays.hpp"
#include "talweg_plugin.h"

namespace talweg::openmesh {
namespace detail {

[[noreturn]] inline void bad_face(std::uint32_t face, const std::string& problem) {
  throw plugin::Failure(TALWEG_BAD_MESH, "Face " + std::to_string(face) + " " + problem + ".");
}

/// The corner of a face at a vertex: `to` is the end of the edge that leaves the vertex, `from` the
/// start of the edge that enters it.
struct Corner {
  std::uint32_t to, from, face;
};

/// The faces around one vertex, which OpenMesh represents as fans: one closed fan, or any number of
/// open ones.
class Fans {
 public:
  void check(std::uint32_t vertex, std::vector<Corner>& corners) {
    std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
      return a.to != b.to ? a.to < b.to : a.face < b.face;
    });
    for (std::size_t k = 1; k < corners.size(); ++k) {
      if (corners[k].to != corners[k - 1].to) continue;
      bad_face(corners[k].face, "has the edge from vertex " + std::to_string(vertex) + " to " +
                                    std::to_string(corners[k].to) + ", and so has face " +
                                    std::to_string(corners[k - 1].face) +
                                    ": more than two faces share the edge, or one of the two "
                                    "has the opposite orientation");
    }
    link(corners);
    std::size_t in_open_fans = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (!has_previous_[k]) in_open_fans += walk(k);
    }
    if (in_open_fans == 0) walk(0);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (seen_[k]) continue;
      bad_face(corners[k].face, "meets other faces at vertex " + std::to_string(vertex) +
                                    " without a common edge, and one of the fans of faces there "
                                    "is closed");
    }
  }

 private:
  static constexpr std::size_t kNone = SIZE_MAX;

  void link(const std::vector<Corner>& corners) {
    next_.assign(corners.size(), kNone);
    has_previous_.assign(corners.size(), false);
    seen_.assign(corners.size(), false);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto after =
          std::lower_bound(corners.begin(), corners.end(), corners[k].from,
                           [](const Corner& corner, std::uint32_t to) { return corner.to < to; });
      if (after == corners.end() || after->to != corners[k].from) continue;
      next_[k] = static_cast<std::size_t>(after - corners.begin());
      has_previous_[next_[k]] = true;
    }
  }
  /// The number of corners in the fan from corner k on.
  std::size_t walk(std::size_t k) {
    std::size_t count = 0;
    for (; k != kNone && !seen_[k]; k = next_[k], ++count) seen_[k] = true;
    return count;
  }

  std::vector<std::size_t> next_;
  std::vector<bool> has_previous_, seen_;
};

}  // namespace detail

/// Throws plugin::Failure(TALWEG_BAD_MESH), which names a face, unless OpenMesh can represent these
/// triangles together. O(n log n) for any number of faces at a vertex.
inline void check_faces(const std::vector<std::uint32_t>& corners, std::size_t vertices) {
  if (vertices > INT32_MAX || corners.size() > INT32_MAX / 2) {
    throw plugin::Failure(TALWEG_BAD_MESH, "The mesh is too large for OpenMesh.");
  }
  std::vector<std::uint32_t> first(vertices + 1, 0);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const auto face = static_cast<std::uint32_t>(c / 3);
    if (corners[c] >= vertices) {
      detail::bad_face(face, "has vertex " + std::to_string(corners[c]) + ", and the mesh has " +
                                 std::to_string(vertices) + " vertices");
    }
    const std::uint32_t next = corners[c - c % 3 + (c + 1) % 3];
    if (corners[c] == next) {
      detail::bad_face(face, "has vertex " + std::to_string(next) + " twice");
    }
    ++first[corners[c] + 1];
  }
  for (std::size_t v = 0; v < vertices; ++v) first[v + 1] += first[v];
  std::vector<std::uint32_t> order(corners.size());  // corners by their vertex
  std::vector<std::uint32_t> place(first.begin(), first.end());
  for (std::uint32_t c = 0; c < corners.size(); ++c) order[place[corners[c]]++] = c;
  detail::Fans fans;
  std::vector<detail::Corner> around;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    around.clear();
    for (std::uint32_t k = first[v]; k < first[v + 1]; ++k) {
      const std::uint32_t c = order[k], face = c / 3;
      around.push_back({corners[3 * face + (c + 1) % 3], corners[3 * face + (c + 2) % 3], face});
    }
    if (!around.empty()) fans.check(v, around);
  }
}

}  // namespace talweg::openmesh
