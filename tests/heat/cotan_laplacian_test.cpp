#include "talweg/heat/cotan_laplacian.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "heat/test_surfaces.hpp"

namespace talweg {
namespace {

using test::grid;
using test::sphere;

double entry(const SymmetricMatrix& matrix, std::size_t i, std::size_t j) {
  std::vector<double> unit(matrix.size(), 0.0);
  unit[j] = 1;
  return multiply(matrix, unit)[i];
}

TEST(TriangleShape, KnownTriangles) {
  const TriangleShape right = triangle_shape({3, 4, 5});
  EXPECT_NEAR(right.area, 6, 1e-14);
  // The right angle lies at corner 1, between sides 0 and 1.
  EXPECT_NEAR(right.cotangent[1], 0, 1e-15);
  EXPECT_NEAR(right.cotangent[0], 3.0 / 4, 1e-15);
  EXPECT_NEAR(right.cotangent[2], 4.0 / 3, 1e-15);
  const TriangleShape equilateral = triangle_shape({2, 2, 2});
  for (const double c : equilateral.cotangent) EXPECT_NEAR(c, 1 / std::sqrt(3), 1e-15);
  EXPECT_NEAR(equilateral.area, std::sqrt(3), 1e-15);
}

TEST(TriangleShape, NeedlesKeepTheirDigits) {
  // Isosceles with a base of 1e-9: base angles have cot = (b / 2) / height, the apex ~ height / b.
  const double base = 1e-9, height = std::sqrt(1 - base * base / 4);
  const TriangleShape needle = triangle_shape({base, 1, 1});
  EXPECT_NEAR(needle.area, base * height / 2, 1e-15 * base);
  EXPECT_NEAR(needle.cotangent[2] / (height / base), 1, 1e-14);
  EXPECT_NEAR(needle.cotangent[0], base / 2 / height, 1e-15);
  // A cap: apex 1e-6 above the middle of a side of length 2. The length 1 + h²/2 is known to one
  // ulp, so h² has a relative error of 2 ε / h² and the cotangent 1/h one of ε / h² = 2e-4.
  const double apex = 1e-6, side = std::hypot(1.0, apex);
  const TriangleShape cap = triangle_shape({2, side, side});
  EXPECT_NEAR(cap.cotangent[0] * apex, 1, 3e-4);
  EXPECT_LT(cap.cotangent[2], 0);
}

TEST(TriangleShape, NoAreaGivesZerosAndNoNaN) {
  for (const std::array<double, 3>& length :
       {std::array<double, 3>{0, 0, 0}, {0, 1, 1}, {1, 1, 2}, {1, 1, 3}}) {
    const TriangleShape shape = triangle_shape(length);
    EXPECT_EQ(shape.area, 0);
    for (const double c : shape.cotangent) EXPECT_EQ(c, 0);
  }
}

TEST(CotanLaplacian, WeightsOfTheUnitSquare) {
  // Two right isosceles triangles: the sides weigh cot 45° / 2, the diagonal 2 · cot 90° / 2.
  const auto laplacian = cotan_laplacian(4, metric_triangles(grid(1, 1).surface()));
  EXPECT_NEAR(entry(laplacian.stiffness, 0, 1), -0.5, 1e-15);
  EXPECT_NEAR(entry(laplacian.stiffness, 0, 3), 0, 1e-15);
  EXPECT_NEAR(entry(laplacian.stiffness, 0, 0), 1, 1e-15);
  EXPECT_NEAR(laplacian.mass[0], 1.0 / 3, 1e-15);
  EXPECT_NEAR(laplacian.mass[1], 1.0 / 6, 1e-15);
}

TEST(CotanLaplacian, RowsSumToZeroAndMassesToTheArea) {
  const test::TestMesh mesh = test::jittered(grid(20, 15), 0.3);
  for (const auto& triangles :
       {metric_triangles(mesh.surface()), delaunay_triangles(mesh.surface())}) {
    const auto laplacian = cotan_laplacian(mesh.positions.size(), triangles);
    const std::vector<double> sums =
        multiply(laplacian.stiffness, std::vector<double>(mesh.positions.size(), 1.0));
    double area = 0;
    for (const MetricTriangle& triangle : triangles) area += triangle_shape(triangle.length).area;
    for (const double sum : sums) EXPECT_NEAR(sum, 0, 1e-13);
    EXPECT_NEAR(std::accumulate(laplacian.mass.begin(), laplacian.mass.end(), 0.0), area,
                1e-13 * area);
  }
}

TEST(CotanLaplacian, LinearFunctionsAreHarmonicInsideThePlane) {
  const test::TestMesh mesh = test::jittered(grid(12, 12), 0.3);
  const Surface surface = mesh.surface();
  const auto laplacian = cotan_laplacian(surface.vertex_count(), delaunay_triangles(surface));
  std::vector<double> linear;
  for (const auto& p : mesh.positions) linear.push_back(2 * p[0] - 3 * p[1]);
  const std::vector<double> result = multiply(laplacian.stiffness, linear);
  for (std::size_t v = 0; v < result.size(); ++v) {
    if (surface.on_boundary(VertexId{v})) continue;
    EXPECT_NEAR(result[v], 0, 1e-11) << v;
  }
}

TEST(CotanLaplacian, InnerWeightsAreNonNegativeOnDelaunayTriangles) {
  const Surface surface = test::scaled(sphere(3), 1e-6).surface();
  const auto laplacian = cotan_laplacian(surface.vertex_count(), delaunay_triangles(surface));
  const SymmetricMatrix& s = laplacian.stiffness;
  for (std::size_t j = 0; j < s.size(); ++j) {
    for (std::int32_t k = s.column_start[j] + 1; k < s.column_start[j + 1]; ++k) {
      EXPECT_LE(s.value[k], 1e-12);
    }
  }
}

TEST(CotanLaplacian, IsolatedVerticesHaveAZeroRow) {
  const auto laplacian = cotan_laplacian(5, metric_triangles(grid(1, 1).surface()));
  EXPECT_EQ(laplacian.stiffness.diagonal(4), 0);
  EXPECT_EQ(laplacian.mass[4], 0);
}

}  // namespace
}  // namespace talweg
