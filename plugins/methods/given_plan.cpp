#include "given_plan.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include "array_views.hpp"
#include "talweg/core/cutting/vertex_origin.hpp"

namespace talweg::plugins {

void give(const plugin::TakeCutPlan& take, const CutPlan& plan, const HostMesh& mesh) {
  if (mesh.map() != nullptr) {
    throw plugin::Failure(TALWEG_UNSUPPORTED,
                          "The mesh was repaired before it was cut, so the plan does not fit the "
                          "mesh that was given.");
  }
  std::vector<std::array<std::uint32_t, 3>> vertices;
  std::vector<std::array<double, 3>> weights, positions;
  for (std::size_t k = 0; k < plan.points.size(); ++k) {
    const VertexOrigin origin = origin_of(plan.vertex_from[k], mesh.mesh().surface());
    vertices.push_back(origin.vertices);
    weights.push_back(origin.weights);
    positions.push_back({plan.points[k].x(), plan.points[k].y(), plan.points[k].z()});
  }
  std::vector<std::uint32_t> parts, closed, lengths, chains;
  for (std::size_t k = 0; k < plan.faces.size(); ++k) {
    parts.push_back(static_cast<std::uint32_t>(plan.parts(k).size()));
  }
  for (const CutChain& chain : plan.chains) {
    closed.push_back(chain.closed ? 1 : 0);
    lengths.push_back(static_cast<std::uint32_t>(chain.vertices.size()));
    chains.insert(chains.end(), chain.vertices.begin(), chain.vertices.end());
  }
  talweg_cut_plan given = {};
  given.curve_count = static_cast<std::uint32_t>(plan.chains.size());
  given.vertex_count = mesh.vertex_count();
  given.triangle_count = mesh.face_count();
  given.vertices = view_of(vertices);
  given.weights = view_of(weights);
  given.positions = view_of(positions);
  given.divided = view_of(plan.faces);
  given.parts = view_of(parts);
  given.triangles = view_of(plan.triangles);
  given.closed = view_of(closed);
  given.lengths = view_of(lengths);
  given.chains = view_of(chains);
  take(given);
}

}  // namespace talweg::plugins
