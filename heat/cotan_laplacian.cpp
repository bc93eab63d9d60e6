#include "talweg/heat/cotan_laplacian.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// y + z - x, never less than 0; sorted to avoid needless cancellation.
double slack(double x, double y, double z) {
  if (y < z) std::swap(y, z);
  return std::max(x > y ? z - (x - y) : z + (y - x), 0.0);
}

struct Entry {
  std::int32_t row;
  double weight;
};

/// The sides of all triangles, by the column of their smaller corner; a shared side appears once
/// per triangle.
struct Sides {
  std::vector<std::int32_t> start;
  std::vector<Entry> entry;
};

template <class Visit>
void for_each_side(const MetricTriangle& triangle, Visit&& visit) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = triangle.corner[k].index(), b = triangle.corner[(k + 1) % 3].index();
    if (a != b) visit(std::min(a, b), std::max(a, b), (k + 2) % 3);  // no heat flows along a loop
  }
}

Sides gather_sides(std::size_t vertex_count, std::span<const MetricTriangle> triangles) {
  Sides sides;
  sides.start.assign(vertex_count + 1, 0);
  for (const MetricTriangle& triangle : triangles) {
    for_each_side(triangle,
                  [&](std::size_t column, std::size_t, std::size_t) { ++sides.start[column + 1]; });
  }
  for (std::size_t j = 0; j < vertex_count; ++j) sides.start[j + 1] += sides.start[j];
  sides.entry.resize(sides.start[vertex_count]);
  std::vector<std::int32_t> place(sides.start.begin(), sides.start.end() - 1);
  for (const MetricTriangle& triangle : triangles) {
    const TriangleShape shape = triangle_shape(triangle.length);
    for_each_side(triangle, [&](std::size_t column, std::size_t row, std::size_t opposite) {
      sides.entry[place[column]++] = {static_cast<std::int32_t>(row),
                                      shape.cotangent[opposite] / 2};
    });
  }
  return sides;
}

/// Adds up the duplicates of each column, in the order of the triangles.
SymmetricMatrix assemble(std::size_t vertex_count, Sides sides) {
  SymmetricMatrix matrix;
  matrix.column_start.reserve(vertex_count + 1);
  matrix.row.reserve(vertex_count + sides.entry.size() / 2);
  matrix.value.reserve(vertex_count + sides.entry.size() / 2);
  matrix.column_start.push_back(0);
  for (std::size_t j = 0; j < vertex_count; ++j) {
    const auto begin = sides.entry.begin() + sides.start[j];
    const auto end = sides.entry.begin() + sides.start[j + 1];
    std::stable_sort(begin, end, [](const Entry& a, const Entry& b) { return a.row < b.row; });
    matrix.row.push_back(static_cast<std::int32_t>(j));
    matrix.value.push_back(0.0);
    for (auto it = begin; it != end; ++it) {
      if (matrix.row.back() != it->row) {
        matrix.row.push_back(it->row);
        matrix.value.push_back(0.0);
      }
      matrix.value.back() -= it->weight;
    }
    matrix.column_start.push_back(static_cast<std::int32_t>(matrix.row.size()));
  }
  return matrix;
}

/// Sets the diagonal to minus the sum of the other entries, so rows sum to zero up to rounding.
void fill_diagonal(SymmetricMatrix& matrix) {
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    for (std::int32_t k = matrix.column_start[j] + 1; k < matrix.column_start[j + 1]; ++k) {
      matrix.diagonal(j) -= matrix.value[k];
      matrix.diagonal(matrix.row[k]) -= matrix.value[k];
    }
  }
}

}  // namespace

TriangleShape triangle_shape(const std::array<double, 3>& length) {
  const auto [a, b, c] = length;
  const double perimeter = a + b + c;
  const std::array<double, 3> s = {slack(a, b, c), slack(b, c, a), slack(c, a, b)};
  const double four_areas = std::sqrt(perimeter * s[0]) * std::sqrt(s[1] * s[2]);
  TriangleShape shape;
  if (!(four_areas > 0)) return shape;
  shape.area = four_areas / 4;
  for (std::size_t side = 0; side < 3; ++side) {
    // 4 A cot = (x² + y² - side²) = (perimeter · s[side] - s[x] · s[y]) / 2.
    const double difference = perimeter * s[side] - s[(side + 1) % 3] * s[(side + 2) % 3];
    shape.cotangent[(side + 2) % 3] = difference / (2 * four_areas);
  }
  return shape;
}

CotanLaplacian cotan_laplacian(std::size_t vertex_count,
                               std::span<const MetricTriangle> triangles) {
  constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
  if (vertex_count + 3 * triangles.size() >= kMost) {
    throw Error(ErrorCode::kOutOfMemory, "The mesh has too many triangles (" +
                                             std::to_string(triangles.size()) +
                                             ") for a matrix with 32-bit indices.");
  }
  CotanLaplacian laplacian;
  laplacian.stiffness = assemble(vertex_count, gather_sides(vertex_count, triangles));
  fill_diagonal(laplacian.stiffness);
  laplacian.mass.assign(vertex_count, 0.0);
  for (const MetricTriangle& triangle : triangles) {
    const double third = triangle_shape(triangle.length).area / 3;
    for (const VertexId v : triangle.corner) laplacian.mass[v.index()] += third;
  }
  return laplacian;
}

}  // namespace talweg
