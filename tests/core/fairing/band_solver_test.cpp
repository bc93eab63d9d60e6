// The band solver against Eigen.
#include "talweg/core/fairing/band_solver.hpp"

#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace talweg {
namespace {

/// The system: a sum of squares of rows over three neighbours, plus a diagonal.
void expect_solution_of_eigen(std::size_t n, bool ring, std::size_t held) {
  std::mt19937 random(static_cast<unsigned>(n));
  std::uniform_real_distribution<double> number(-1, 1);
  BandSystem system(n, ring);
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  for (std::size_t i = 0; i < n; ++i) {
    if (!ring && (i == 0 || i + 1 == n)) continue;
    const std::size_t at[3] = {(i + n - 1) % n, i, (i + 1) % n};
    const double row[3] = {number(random), number(random), number(random)};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto k = static_cast<Eigen::Index>(at[a]);
      for (std::size_t b = 0; b <= a; ++b) {
        system.add(at[a], at[b], row[a] * row[b]);
        const auto l = static_cast<Eigen::Index>(at[b]);
        matrix(k, l) += row[a] * row[b];
        if (k != l) matrix(l, k) += row[a] * row[b];
      }
      system.right(at[a]) += row[a];
      right(k) += row[a];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    system.add(i, i, 0.1);
    matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) += 0.1;
  }
  if (held < n) {
    system.hold(held);
    const auto k = static_cast<Eigen::Index>(held);
    matrix.row(k).setZero();
    matrix.col(k).setZero();
    matrix(k, k) = 1;
    right(k) = 0;
  }
  const Eigen::VectorXd expected = matrix.ldlt().solve(right);
  std::vector<double> found;
  ASSERT_TRUE(system.solve(found));
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(found[i], expected(static_cast<Eigen::Index>(i)), 1e-9) << n << " " << ring;
  }
}

TEST(BandSystem, HasTheSolutionOfEigen) {
  for (const bool ring : {false, true}) {
    for (const std::size_t n : {8U, 9U, 30U, 31U}) {
      expect_solution_of_eigen(n, ring, n);
      expect_solution_of_eigen(n, ring, 0);
      expect_solution_of_eigen(n, ring, n / 2);
    }
  }
}

TEST(BandSystem, RejectsIndefiniteMatrices) {
  BandSystem system(6, false);
  for (std::size_t i = 0; i < 6; ++i) system.add(i, i, i == 3 ? -1 : 1);
  std::vector<double> solution;
  EXPECT_FALSE(system.solve(solution));
}

}  // namespace
}  // namespace talweg
