#include "bipartition_field.hpp"

#include <algorithm>
#include <cstdint>

#include "direction_field.hpp"
#include "talweg/heat/cholesky_factor.hpp"
#include "talweg/heat/cotan_laplacian.hpp"
#include "talweg/heat/heat_flow.hpp"
#include "talweg/heat/heat_systems.hpp"
#include "talweg/heat/heat_triangles.hpp"
#include "talweg/heat/mollification.hpp"
#include "talweg/intrinsic/flips/delaunay.hpp"

namespace talweg::plugins {
namespace {

struct Entry {
  std::size_t row = 0;
  double value = 0;
};

struct Border {
  std::vector<char> at_vertex;  // per vertex: whether the vertex is on the border
  std::vector<char> whole;      // per face: whether all three vertices are on the border
  std::vector<char> reached;    // per vertex: whether its component has a border
};

Border border_of(const Surface& surface, const std::vector<char>& side,
                 const Components& components) {
  std::vector<char> seen(surface.vertex_count(), 0);  // one bit per side
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

/// The solution of (M / h² + s S) u = 0 with u = 1 on the border.
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

/// All entries of each column, by ascending row.
std::vector<std::vector<Entry>> columns_of(const SymmetricMatrix& matrix) {
  std::vector<std::vector<Entry>> columns(matrix.size());
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    for (std::int32_t k = matrix.column_start[j]; k < matrix.column_start[j + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const auto row = static_cast<std::size_t>(matrix.row[at]);
      columns[j].push_back({row, matrix.value[at]});
      if (row != j) columns[row].push_back({j, matrix.value[at]});
    }
  }
  return columns;
}

/// The product matrix · matrix, plus a diagonal matrix.
SymmetricMatrix squared(const SymmetricMatrix& matrix, const std::vector<double>& diagonal) {
  const std::vector<std::vector<Entry>> columns = columns_of(matrix);
  SymmetricMatrix result;
  result.column_start = {0};
  std::vector<double> sum(matrix.size(), 0.0);
  std::vector<std::size_t> last(matrix.size(), matrix.size());  // per row, its last column
  std::vector<std::int32_t> rows;
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    rows = {static_cast<std::int32_t>(j)};
    sum[j] = diagonal[j];
    last[j] = j;
    for (const auto& [middle, first] : columns[j]) {
      for (const auto& [row, second] : columns[middle]) {
        if (row < j) continue;
        if (last[row] != j) {
          rows.push_back(static_cast<std::int32_t>(row));
          sum[row] = 0;
          last[row] = j;
        }
        sum[row] += first * second;
      }
    }
    std::sort(rows.begin(), rows.end());
    for (const std::int32_t row : rows) {
      result.row.push_back(row);
      result.value.push_back(sum[static_cast<std::size_t>(row)]);
    }
    result.column_start.push_back(static_cast<std::int32_t>(result.row.size()));
  }
  return result;
}

/// The minimum x of |S x - b|² + anchor² |x on the border|² in components with a border; 0
/// elsewhere.
std::vector<double> fitted(const CotanLaplacian& laplacian, const std::vector<double>& b,
                           const Border& border, double anchor) {
  std::vector<double> anchors;
  std::vector<char> alone;
  for (std::size_t v = 0; v < border.reached.size(); ++v) {
    anchors.push_back(border.at_vertex[v] != 0 ? anchor * anchor : 0);
    alone.push_back(border.reached[v] != 0 ? 0 : 1);
  }
  SymmetricMatrix matrix = squared(laplacian.stiffness, anchors);
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
