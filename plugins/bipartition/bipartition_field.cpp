#include "bipartition_field.hpp"

#include <Eigen/SparseCore>

#include "direction_field.hpp"
#include "talweg/heat/cholesky_factor.hpp"
#include "talweg/heat/cotan_laplacian.hpp"
#include "talweg/heat/heat_flow.hpp"
#include "talweg/heat/heat_systems.hpp"
#include "talweg/heat/heat_triangles.hpp"
#include "talweg/heat/mollification.hpp"
#include "talweg/intrinsic/delaunay.hpp"

namespace talweg::plugins {
namespace {

using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int32_t>;

struct Border {
  std::vector<char> at_vertex;  // per vertex
  std::vector<char> whole;      // per face: all three vertices
  std::vector<char> reached;    // per vertex: some border is connected with it
};

Border border_of(const Surface& surface, const std::vector<char>& side,
                 const Components& components) {
  std::vector<char> seen(surface.vertex_count(), 0);  // bit per side
  for (std::size_t f = 0; f < side.size(); ++f) {
    for (const VertexId v : surface.corners(FaceId{f})) {
      seen[v.index()] = static_cast<char>(seen[v.index()] | (1 << side[f]));
    }
  }
  Border border;
  std::vector<char> has_border(components.count, 0);
  for (std::size_t v = 0; v < seen.size(); ++v) {
    border.at_vertex.push_back(seen[v] == 3 ? 1 : 0);
    if (seen[v] == 3) has_border[components.of_vertex[v]] = 1;
  }
  for (std::size_t v = 0; v < seen.size(); ++v) {
    border.reached.push_back(has_border[components.of_vertex[v]]);
  }
  for (std::size_t f = 0; f < side.size(); ++f) {
    const auto c = surface.corners(FaceId{f});
    border.whole.push_back(border.at_vertex[c[0].index()] & border.at_vertex[c[1].index()] &
                           border.at_vertex[c[2].index()]);
  }
  return border;
}

/// (M / h² + s S) u = 0 with u = 1 on the border.
ScaledField heat_of(const CotanLaplacian& laplacian, const std::vector<MetricTriangle>& triangles,
                    const Components& components, const std::vector<double>& mean_edges,
                    const Border& border, double time) {
  SymmetricMatrix matrix = neumann_heat_matrix(laplacian, components, mean_edges, time);
  const std::vector<double> ones(border.at_vertex.begin(), border.at_vertex.end());
  std::vector<double> source = multiply(matrix, ones);
  for (std::size_t v = 0; v < source.size(); ++v) {
    source[v] = border.at_vertex[v] != 0 ? 1 : -source[v];
  }
  replace_by_identity(matrix, border.at_vertex);
  const CholeskyFactor factor(SymbolicFactor(matrix), matrix);
  return heat_flow(factor, heat_triangles(triangles), time, source, border.reached);
}

Sparse full(const SymmetricMatrix& matrix) {
  if (matrix.size() == 0) return {};
  std::vector<Eigen::Triplet<double, std::int32_t>> entries;
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    const auto column = static_cast<std::int32_t>(j);
    for (std::int32_t k = matrix.column_start[j]; k < matrix.column_start[j + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k);
      entries.emplace_back(matrix.row[at], column, matrix.value[at]);
      if (matrix.row[at] != column) entries.emplace_back(column, matrix.row[at], matrix.value[at]);
    }
  }
  const auto n = static_cast<Eigen::Index>(matrix.size());
  Sparse result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

SymmetricMatrix lower(const Sparse& matrix) {
  SymmetricMatrix result;
  result.column_start = {0};
  for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(matrix, j); entry; ++entry) {
      if (entry.row() < j) continue;
      result.row.push_back(static_cast<std::int32_t>(entry.row()));
      result.value.push_back(entry.value());
    }
    result.column_start.push_back(static_cast<std::int32_t>(result.row.size()));
  }
  return result;
}

/// Minimises |S x - b|² + anchor² |x on the border|² where the border is reached; 0 elsewhere.
std::vector<double> fitted(const CotanLaplacian& laplacian, const std::vector<double>& b,
                           const Border& border, double anchor) {
  const Sparse stiffness = full(laplacian.stiffness);
  Sparse anchors(stiffness.rows(), stiffness.cols());
  anchors.setIdentity();  // a diagonal for the pattern, everywhere
  std::vector<char> alone;
  for (std::size_t v = 0; v < border.reached.size(); ++v) {
    anchors.valuePtr()[v] = border.at_vertex[v] != 0 ? anchor * anchor : 0;
    alone.push_back(border.reached[v] != 0 ? 0 : 1);
  }
  const Sparse squared = stiffness * stiffness;
  SymmetricMatrix matrix = lower(squared + anchors);
  replace_by_identity(matrix, alone);
  std::vector<double> right = multiply(laplacian.stiffness, b);
  for (std::size_t v = 0; v < right.size(); ++v) {
    if (alone[v] != 0) right[v] = 0;
  }
  return CholeskyFactor(SymbolicFactor(matrix), matrix).solve(right);
}

}  // namespace

BipartitionField relax_bipartition(const SurfaceMesh& mesh, const std::vector<char>& side,
                                   const BipartitionOptions& options, const Progress& progress) {
  BipartitionField result;
  const auto stopped = [&](const char* stage, double fraction) {
    result.cancelled = !go_on(progress, stage, fraction);
    return result.cancelled;
  };
  if (stopped("heat", 0)) return result;
  const Components components = components_of(mesh.surface());
  const std::vector<double> mean_edges = mean_edge_lengths(mesh.surface(), components);
  Surface thickened = mesh.surface();
  thickened.set_lengths(mollify(mesh.surface(), components).lengths);
  const std::vector<MetricTriangle> triangles = metric_triangles(thickened);
  const CotanLaplacian laplacian = cotan_laplacian(mesh.surface().vertex_count(), triangles);
  const Border border = border_of(mesh.surface(), side, components);
  for (const char at : border.at_vertex) result.border_vertices += at != 0 ? 1 : 0;
  for (const char whole : border.whole) result.source_faces += whole != 0 ? 1 : 0;
  result.known = border.reached;

  const ScaledField u =
      heat_of(laplacian, triangles, components, mean_edges, border, options.heat_time);
  if (stopped("directions", 0.3)) return result;
  DirectionField field = gradient_directions(mesh, u, side, border.whole);
  if (options.guard) fill_directions(mesh.surface(), field);
  smooth_directions(mesh.surface(), field, options.passes);
  if (stopped("fit", 0.4)) return result;
  result.phi =
      fitted(laplacian, divergence(mesh, field, options.area_weights), border, options.anchor);
  return result;
}

}  // namespace talweg::plugins
