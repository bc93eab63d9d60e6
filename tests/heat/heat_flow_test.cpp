#include "talweg/heat/heat_flow.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "heat/test_surfaces.hpp"
#include "talweg/heat/heat_systems.hpp"
#include "talweg/heat/mollification.hpp"
#include "talweg/heat/unit_gradient.hpp"

namespace talweg {
namespace {

struct Flow {
  explicit Flow(const Surface& surface, double time_scale)
      : triangles(heat_triangles(metric_triangles(surface))) {
    const Components components = components_of(surface);
    const auto laplacian = cotan_laplacian(surface.vertex_count(), metric_triangles(surface));
    const SymmetricMatrix matrix = neumann_heat_matrix(
        laplacian, components, mean_edge_lengths(surface, components), time_scale);
    factor.emplace(SymbolicFactor(matrix), matrix);
  }
  std::vector<HeatTriangle> triangles;
  std::optional<CholeskyFactor> factor;
};

double log_of(const ScaledField& u, std::size_t v) {
  return std::log(u.value[v]) - u.stage[v] * ScaledField::kStageBits * std::numbers::ln2;
}

TEST(HeatFlow, StaysExactFarBeyondUnderflow) {
  // On a long thin torus heated along one column, u satisfies u/h² + s (2u - u₋ - u₊) = 0. So u
  // falls by the constant factor r with r + 1/r = 2 + 1/(s h²), except at the far end.
  const std::size_t columns = 14000, rows = 3;
  const Surface surface = test::torus(std::vector<double>(columns, 1.0), rows);
  const double s = 10, h = (2 + std::numbers::sqrt2) / 3;
  const Flow flow(surface, s);
  std::vector<double> source(columns * rows, 0.0);
  for (std::size_t y = 0; y < rows; ++y) source[y * columns] = 1.0 / static_cast<double>(rows);
  const ScaledField u =
      heat_flow(*flow.factor, flow.triangles, s, source, std::vector<char>(source.size(), 1));

  const double q = 1 + 1 / (2 * s * h * h), fall = std::log(q - std::sqrt(q * q - 1));
  for (std::size_t x = 1; x < columns / 2 - 100; ++x) {
    EXPECT_NEAR(log_of(u, x) - log_of(u, x - 1), fall, 1e-11) << x;
    EXPECT_NEAR(log_of(u, columns + x), log_of(u, x), 1e-11) << x;
  }
  EXPECT_LT(log_of(u, columns / 2), -1600);  // doubles end at -745
  EXPECT_GE(u.stage[columns / 2], 2);
}

TEST(HeatFlow, AverageIgnoresAStraightBoundary) {
  // Method of images: a tube of R rows is half of a torus of 2 R rows. Its Neumann solution is the
  // torus solution for the source plus the mirror image, its Dirichlet solution for the source
  // minus the image. The average is exactly the torus solution for the source alone.
  const std::size_t columns = 9, rows = 8;
  const std::vector<double> width(columns, 1.0), h = {1.0};
  const auto matrix_of = [&](const Surface& surface) {
    return neumann_heat_matrix(cotan_laplacian(surface.vertex_count(), metric_triangles(surface)),
                               components_of(surface), h, 2.0);
  };
  const Surface torus = test::band(width, 2 * rows, true), tube = test::band(width, rows, false);
  const auto solve = [&](const SymmetricMatrix& matrix, const Surface& surface,
                         const std::vector<char>& reached) {
    std::vector<double> source(surface.vertex_count(), 0.0);
    source[2 * columns + 4] = 1;
    const CholeskyFactor factor(SymbolicFactor(matrix), matrix);
    return heat_flow(factor, heat_triangles(metric_triangles(surface)), 2.0, source, reached);
  };
  const std::vector<char> everywhere(torus.vertex_count(), 1);
  std::vector<char> boundary, inside;
  for (std::size_t v = 0; v < tube.vertex_count(); ++v) {
    boundary.push_back(tube.on_boundary(VertexId{v}) ? 1 : 0);
    inside.push_back(boundary.back() != 0 ? 0 : 1);
  }
  SymmetricMatrix matrix = matrix_of(tube);
  ScaledField mean = solve(matrix, tube, everywhere);
  replace_by_identity(matrix, boundary);
  mean = average(std::move(mean), solve(matrix, tube, inside), everywhere);
  const ScaledField expected = solve(matrix_of(torus), torus, everywhere);
  for (std::size_t v = 0; v < mean.value.size(); ++v) {
    EXPECT_NEAR(mean.value[v] / expected.value[v], 1, 1e-12) << v;
  }
}

TEST(HeatFlow, UnreachedVerticesStayZero) {
  const Surface surface = test::together(test::grid(3, 3), test::grid(2, 2)).surface();
  const Flow flow(surface, 1);
  std::vector<double> source(surface.vertex_count(), 0.0);
  std::vector<char> reached(source.size(), 0);
  source[0] = 1;
  std::fill_n(reached.begin(), 16, 1);
  const ScaledField u = heat_flow(*flow.factor, flow.triangles, 1, source, reached);
  for (std::size_t v = 0; v < 16; ++v) EXPECT_GT(u.value[v], 0);
  for (std::size_t v = 16; v < source.size(); ++v) EXPECT_EQ(u.value[v], 0);
}

TEST(HeatFlow, AverageOfFieldsAtDifferentStages) {
  const ScaledField a{{4, 4, 4}, {0, 1, 1}}, b{{2, 2, 2}, {0, 1, 2}};
  const ScaledField mean = average(a, b, {0, 1, 1});
  EXPECT_EQ(mean.value[0], 4);
  EXPECT_EQ(mean.value[1], 3);
  EXPECT_EQ(mean.value[2], 2 + 0x1p-800);
  EXPECT_EQ(mean.stage, a.stage);
}

TEST(UnitGradient, OfALinearFieldIsTheFieldOfUnitSlope) {
  // For a linear u = -c f, with f of slope 1, S f is the divergence of the unit gradient, exactly
  // in every triangle.
  const test::TestMesh mesh = test::jittered(test::grid(10, 10), 0.3);
  const auto triangles = metric_triangles(mesh.surface());
  std::vector<double> slope_one;
  ScaledField u;
  for (const auto& p : mesh.positions) {
    slope_one.push_back(0.6 * p[0] + 0.8 * p[1]);
    u.value.push_back(1e-280 * (20 - slope_one.back()));
    u.stage.push_back(1);
  }
  const auto divergence = unit_gradient_divergence(heat_triangles(triangles), u);
  const auto expected =
      multiply(cotan_laplacian(mesh.positions.size(), triangles).stiffness, slope_one);
  for (std::size_t v = 0; v < expected.size(); ++v) EXPECT_NEAR(divergence[v], expected[v], 1e-11);
}

TEST(UnitGradient, ConstantAndZeroFieldsGiveZero) {
  const auto triangles = heat_triangles(metric_triangles(test::grid(3, 3).surface()));
  for (const double value : {0.0, 2.5}) {
    const ScaledField u{std::vector<double>(16, value), std::vector<std::int32_t>(16, 0)};
    for (const double d : unit_gradient_divergence(triangles, u)) EXPECT_EQ(d, 0);
  }
}

}  // namespace
}  // namespace talweg
