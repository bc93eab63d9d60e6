// Law of the linear systems of the heat method, on every subject: solutions are within the error
// bound of Cholesky factorization and agree with Eigen.
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Sparse>
#include <gtest/gtest.h>

#include "laws/subjects.hpp"
#include "talweg/heat/cholesky_factor.hpp"
#include "talweg/heat/heat_systems.hpp"
#include "talweg/heat/mollification.hpp"
#include "talweg/intrinsic/flips/delaunay.hpp"

namespace talweg {
namespace {

using Vector = std::vector<double>;
using EigenMatrix = Eigen::SparseMatrix<double>;
using EigenFactor = Eigen::SimplicialLDLT<EigenMatrix>;

struct System {
  const char* name;
  SymmetricMatrix matrix;
};

/// The three matrices that HeatDistance factors.
std::vector<System> systems_of(const Surface& surface) {
  const Components components = components_of(surface);
  Surface thickened = surface;
  thickened.set_lengths(mollify(surface, components).lengths);
  const auto laplacian = cotan_laplacian(surface.vertex_count(), delaunay_triangles(thickened));
  const Vector mean = mean_edge_lengths(surface, components);
  std::vector<char> boundary(surface.vertex_count()), pinned;
  for (std::size_t v = 0; v < boundary.size(); ++v) {
    boundary[v] = surface.on_boundary(VertexId{v}) ? 1 : 0;
  }
  const SymmetricMatrix free = neumann_heat_matrix(laplacian, components, mean, 10);
  SymmetricMatrix cold = free;
  replace_by_identity(cold, boundary);
  return {{"heat, free boundary", free},
          {"heat, cold boundary", cold},
          {"Poisson", pinned_poisson_matrix(laplacian, components, pinned)}};
}

EigenMatrix lower_triangle(const SymmetricMatrix& matrix) {
  const auto n = static_cast<Eigen::Index>(matrix.size());
  return Eigen::Map<const EigenMatrix>(n, n, static_cast<Eigen::Index>(matrix.row.size()),
                                       matrix.column_start.data(), matrix.row.data(),
                                       matrix.value.data());
}

Vector solve(const EigenFactor& factor, const Vector& b) {
  const auto n = static_cast<Eigen::Index>(b.size());
  const Eigen::VectorXd x = factor.solve(Eigen::Map<const Eigen::VectorXd>(b.data(), n));
  return {x.begin(), x.end()};
}

/// |b - A x|, computed in extended precision.
Vector residual(const SymmetricMatrix& matrix, const Vector& x, const Vector& b) {
  std::vector<long double> r(b.begin(), b.end());
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    for (auto k = static_cast<std::size_t>(matrix.column_start[j]);
         k < static_cast<std::size_t>(matrix.column_start[j + 1]); ++k) {
      const auto i = static_cast<std::size_t>(matrix.row[k]);
      r[i] -= static_cast<long double>(matrix.value[k]) * x[j];
      if (i != j) r[j] -= static_cast<long double>(matrix.value[k]) * x[i];
    }
  }
  Vector size(r.size());
  for (std::size_t i = 0; i < size.size(); ++i) size[i] = static_cast<double>(std::abs(r[i]));
  return size;
}

/// Higham, "Accuracy and Stability of Numerical Algorithms" (2002), theorem 10.4: the computed
/// solution solves a system A + E with |E_ij| <= (3 n + 1) u √(a_ii a_jj) / (1 - ...), for any
/// elimination order.
Vector residual_bound(const SymmetricMatrix& matrix, const Vector& x) {
  const double u = std::numeric_limits<double>::epsilon() / 2;
  const double gamma = (3 * static_cast<double>(matrix.size()) + 1) * u;
  double sum = 0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    sum += std::sqrt(matrix.diagonal(j)) * std::abs(x[j]);
  }
  Vector bound(x.size());
  for (std::size_t i = 0; i < bound.size(); ++i) {
    bound[i] = 1.01 * gamma * std::sqrt(matrix.diagonal(i)) * sum;
  }
  return bound;
}

/// Right-hand sides: the heat of one vertex, and a source that is nowhere 0.
std::vector<Vector> sources(std::size_t n) {
  std::vector<Vector> sources(2, Vector(n, 0.0));
  sources[0][n / 3] = 1;
  for (std::size_t i = 0; i < n; ++i) sources[1][i] = std::sin(static_cast<double>(i));
  return sources;
}

/// The subjects of the laws, and real meshes that are large or have slivers and small parts.
std::vector<std::string> mesh_names() {
  std::vector<std::string> names = test::subject_names();
  for (const char* name : {"elephant_106holes_tiny_4k", "degenerate_13k", "cylinder_varying_16k",
                           "terrain_utm_21k", "armadillo_86k", "skull_100k", "tooth_ct_119k"}) {
    names.emplace_back(name);
  }
  return names;
}

MeshLists mesh_of(const std::string& name) {
  MeshLists lists = test::make_subject(name).lists;
  const auto file = test::mesh_folder() / (name + ".ply");
  if (lists.points.empty() && std::filesystem::exists(file)) lists = read_mesh(file);
  return lists;
}

class LinearSystemsLaw : public ::testing::TestWithParam<std::string> {};

TEST_P(LinearSystemsLaw, SolutionsAreThoseOfEigen) {
  const MeshLists lists = mesh_of(GetParam());
  if (lists.points.empty()) GTEST_SKIP() << test::missing(GetParam());
  for (const System& system : systems_of(SurfaceMesh::open(lists).surface())) {
    SCOPED_TRACE(system.name);
    const EigenFactor other(lower_triangle(system.matrix));
    ASSERT_EQ(other.info(), Eigen::Success);
    for (const FactorKind kind : {FactorKind::kSupernodal, FactorKind::kSimplicial}) {
      const CholeskyFactor factor(SymbolicFactor(system.matrix, kind), system.matrix);
      for (const Vector& b : sources(system.matrix.size())) {
        const Vector x = factor.solve(b), y = solve(other, b);
        Vector r = residual(system.matrix, x, b);
        const Vector bound = residual_bound(system.matrix, x), s = residual(system.matrix, y, b);
        for (std::size_t i = 0; i < r.size(); ++i) ASSERT_LE(r[i], bound[i]) << i;
        // The bound holds for any order of summation; the residual must not be much larger than for
        // Eigen.
        EXPECT_LE(*std::max_element(r.begin(), r.end()),
                  10 * *std::max_element(s.begin(), s.end()));
        // |A (x - y)| is at most r + s, and the inverse of the matrix of a Delaunay triangulation
        // has no negative entry.
        for (std::size_t i = 0; i < r.size(); ++i) r[i] += s[i];
        const Vector apart = solve(other, r);
        for (std::size_t i = 0; i < r.size(); ++i) {
          ASSERT_LE(std::abs(x[i] - y[i]), 1.01 * apart[i] + 1e-300) << i;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, LinearSystemsLaw, ::testing::ValuesIn(mesh_names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace talweg
