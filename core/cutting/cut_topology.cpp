#include "talweg/core/cutting/cut_topology.hpp"

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/seam_opening.hpp"

namespace talweg {
namespace {

/// Removes the part between two passages of a vertex, for each such vertex.
CutMesh::Chain without_loops(const CutMesh::Chain& chain) {
  CutMesh::Chain simple{chain.closed, {}};
  std::unordered_map<std::uint32_t, std::size_t> place;
  std::vector<std::uint32_t>& kept = simple.vertices;
  for (const std::uint32_t v : chain.vertices) {
    const auto known = place.find(v);
    if (known == place.end()) {
      place.emplace(v, kept.size());
      kept.push_back(v);
      continue;
    }
    const std::size_t first = known->second;
    if (chain.closed && kept.size() - first > chain.vertices.size() / 2) {
      // The loop between the two passages is the longer part and is kept; the rest is removed.
      kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first));
      break;
    }
    for (std::size_t k = first + 1; k < kept.size(); ++k) place.erase(kept[k]);
    kept.resize(first + 1);
  }
  return simple;
}

/// Per piece, vertices - edges + faces, ascending. A face counts one face minus three halves of
/// edges; an edge with one face counts another half. `twice` sums doubled values.
std::vector<std::int64_t> euler_characteristics(const OpenedSeams& seams) {
  const std::vector<Triangle>& triangles = seams.lists.triangles;
  std::vector<std::int64_t> twice(seams.pieces, 0);
  std::vector<bool> met(seams.lists.points.size(), false);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const std::uint32_t piece = seams.piece_of_face[f];
    twice[piece] += 2 - 3;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[f][k], b = triangles[f][(k + 1) % 3];
      if (!met[a]) twice[piece] += 2;
      met[a] = true;
      sides.emplace_back(std::uint64_t{std::min(a, b)} << 32U | std::max(a, b), piece);
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t k = 0; k < sides.size(); ++k) {
    if (k + 1 < sides.size() && sides[k + 1].first == sides[k].first) {
      ++k;
    } else {
      --twice[sides[k].second];
    }
  }
  for (std::int64_t& characteristic : twice) characteristic /= 2;
  std::sort(twice.begin(), twice.end());
  return twice;
}

}  // namespace

std::vector<std::int64_t> pieces_along(const SurfaceMesh& mesh,
                                       std::span<const SurfaceCurve> curves, bool simple) {
  const CutMesh cut = cut_along(mesh, curves);
  std::vector<CutMesh::Chain> chains;
  for (const CutMesh::Chain& chain : cut.chains) {
    chains.push_back(simple ? without_loops(chain) : chain);
    if (chains.back().vertices.size() < (chain.closed ? 3U : 2U)) chains.pop_back();
  }
  return euler_characteristics(open_seams(cut.lists, chains));
}

}  // namespace talweg
