#include "talweg/heat/cholesky_factor.hpp"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <future>
#include <limits>
#include <new>
#include <thread>

#include <gtest/gtest.h>
#ifdef __GLIBC__
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

#include "memory_limits.hpp"
#include "talweg/intrinsic/error.hpp"
#include "test_matrices.hpp"

namespace talweg {
namespace {

/// The second difference matrix on n points with `diagonal` on the diagonal: definite from 2 on.
SymmetricMatrix chain(std::size_t n, double diagonal) {
  SymmetricMatrix matrix;
  matrix.column_start.push_back(0);
  for (std::size_t j = 0; j < n; ++j) {
    matrix.row.push_back(static_cast<std::int32_t>(j));
    matrix.value.push_back(diagonal);
    if (j + 1 < n) {
      matrix.row.push_back(static_cast<std::int32_t>(j + 1));
      matrix.value.push_back(-1);
    }
    matrix.column_start.push_back(static_cast<std::int32_t>(matrix.row.size()));
  }
  return matrix;
}

std::string message_of(const SymmetricMatrix& matrix, ErrorCode expected,
                       FactorKind kind = FactorKind::kSupernodal) {
  try {
    const SymbolicFactor symbolic(matrix, kind);
    const CholeskyFactor factor(symbolic, matrix);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), expected);
    return error.what();
  }
  return "";
}

class CholeskyFactorOfKind : public ::testing::TestWithParam<FactorKind> {};
INSTANTIATE_TEST_SUITE_P(Both, CholeskyFactorOfKind,
                         ::testing::Values(FactorKind::kSupernodal, FactorKind::kSimplicial),
                         [](const auto& test) {
                           return test.param == FactorKind::kSupernodal ? "Supernodal"
                                                                        : "Simplicial";
                         });

TEST_P(CholeskyFactorOfKind, HasTheRequestedKindIfTheLibraryHasIt) {
  const bool supernodes = factor_libraries().find("supernodal") != std::string::npos;
  EXPECT_EQ(SymbolicFactor(chain(5, 2), GetParam()).kind(),
            supernodes ? GetParam() : FactorKind::kSimplicial);
}

TEST_P(CholeskyFactorOfKind, SolvesTheDiscreteParabola) {
  // -x'' = 1 with x = 0 outside: x_j = (j + 1)(n - j) / 2 exactly.
  const std::size_t n = 100;
  const SymmetricMatrix matrix = chain(n, 2);
  const SymbolicFactor symbolic(matrix, GetParam());
  const CholeskyFactor factor(symbolic, matrix);
  const std::vector<double> x = factor.solve(std::vector<double>(n, 1.0));
  for (std::size_t j = 0; j < n; ++j) {
    const double expected = static_cast<double>((j + 1) * (n - j)) / 2;
    EXPECT_NEAR(x[j], expected, 1e-12 * 1250) << j;  // condition number 4 n² / π² · ε
  }
  const std::vector<double> back = multiply(matrix, x);
  for (const double b : back) EXPECT_NEAR(b, 1, 1e-11);
}

TEST_P(CholeskyFactorOfKind, SeveralMatricesShareOneAnalysis) {
  const SymbolicFactor symbolic(chain(50, 2), GetParam());
  EXPECT_EQ(symbolic.size(), 50u);
  EXPECT_GE(symbolic.factor_entries(), 99u);  // at least the entries of the matrix
  for (const double diagonal : {2.0, 3.0, 1e6}) {
    const SymmetricMatrix matrix = chain(50, diagonal);
    const CholeskyFactor factor(symbolic, matrix);
    std::vector<double> x(50);
    for (std::size_t j = 0; j < 50; ++j) x[j] = std::sin(static_cast<double>(j));
    const std::vector<double> solved = factor.solve(multiply(matrix, x));
    for (std::size_t j = 0; j < 50; ++j) EXPECT_NEAR(solved[j], x[j], 1e-12);
  }
}

TEST_P(CholeskyFactorOfKind, GridsOfManySizes) {
  for (const std::size_t side : {1, 2, 5, 17, 40, 130}) {
    const SymmetricMatrix matrix = test::grid_matrix(side, 4);
    const CholeskyFactor factor(SymbolicFactor(matrix, GetParam()), matrix);
    std::vector<double> x(matrix.size());
    for (std::size_t j = 0; j < x.size(); ++j) x[j] = std::sin(static_cast<double>(j));
    const std::vector<double> solved = factor.solve(multiply(matrix, x));
    // Condition number (2 (side + 1) / π)² · 2 at most.
    const double tolerance = 1e-15 * static_cast<double>((side + 1) * (side + 1));
    for (std::size_t j = 0; j < x.size(); ++j) EXPECT_NEAR(solved[j], x[j], 10 * tolerance);
  }
}

TEST_P(CholeskyFactorOfKind, SameBytesEveryTime) {
  const SymmetricMatrix matrix = test::grid_matrix(80, 4.1);
  std::vector<double> b(matrix.size());
  for (std::size_t j = 0; j < b.size(); ++j) b[j] = std::cos(static_cast<double>(j));
  const auto solve = [&] {
    return CholeskyFactor(SymbolicFactor(matrix, GetParam()), matrix).solve(b);
  };
  const std::vector<double> first = solve();
  const std::vector<char> shift(100001);  // later allocations get other addresses
  EXPECT_EQ(solve(), first);
}

TEST_P(CholeskyFactorOfKind, IndefiniteMatrixIsAnErrorInWordsWithItsColumn) {
  SymmetricMatrix matrix = chain(5, 2);
  matrix.diagonal(3) = -7;
  const std::string message = message_of(matrix, ErrorCode::kNumerical, GetParam());
  EXPECT_NE(message.find("not positive definite"), std::string::npos) << message;
  EXPECT_NE(message.find("column"), std::string::npos) << message;
  // In a diagonal matrix the column that fails is known.
  SymmetricMatrix diagonal;
  diagonal.column_start = {0, 1, 2, 3, 4};
  diagonal.row = {0, 1, 2, 3};
  diagonal.value = {1, 1, -1, 1};
  EXPECT_NE(message_of(diagonal, ErrorCode::kNumerical, GetParam()).find("column 2"),
            std::string::npos);
}

TEST(CholeskyFactor, NonFiniteEntryAndBadPatternAreErrors) {
  SymmetricMatrix matrix = chain(5, 2);
  matrix.diagonal(4) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of(matrix, ErrorCode::kNumerical).find("column 4"), std::string::npos);
  matrix = chain(5, 2);
  matrix.row[1] = 7;
  EXPECT_NE(message_of(matrix, ErrorCode::kNumerical).find("column 0"), std::string::npos);
  EXPECT_NE(message_of({}, ErrorCode::kNumerical).find("empty"), std::string::npos);
}

TEST(CholeskyFactor, MoreEntriesThanAnIntCountsIsAnErrorInWords) {
  if (SymbolicFactor(chain(5, 2)).kind() == FactorKind::kSimplicial) {
    GTEST_SKIP() << "skipped: needs CHOLMOD's supernodal module";
  }
  const SymmetricMatrix matrix = test::expander_matrix(150'000);
  EXPECT_NE(message_of(matrix, ErrorCode::kOutOfMemory).find("too many entries"),
            std::string::npos);
}

#ifdef __GLIBC__
/// Mapped memory of the process in bytes, without freed memory.
std::size_t addresses_in_use() {
  malloc_trim(0);
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// The error message of `task` under a limit on mapped memory; "" on success.
template <class Task>
std::string complaint_within(std::size_t megabytes, Task&& task) {
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  rlimit limit = before;
  limit.rlim_cur = addresses_in_use() + (megabytes << 20U);
  setrlimit(RLIMIT_AS, &limit);
  std::string complaint;
  try {
    task();
  } catch (const Error& error) {
    complaint = error.what();
  } catch (const std::bad_alloc&) {
    complaint = "out of memory";
  }
  setrlimit(RLIMIT_AS, &before);
  return complaint;
}

/// Solves under several memory limits. Exits with 0 if every solution is right or an error for lack
/// of memory, and more than two are errors.
[[noreturn]] void solve_with_little_memory(FactorKind kind) {
  const SymmetricMatrix matrix = test::grid_matrix(200, 4.1);
  const std::vector<double> b(matrix.size(), 1.0);
  const auto solve = [&] { return CholeskyFactor(SymbolicFactor(matrix, kind), matrix).solve(b); };
  const std::vector<double> expected = solve();
  int refused = 0;
  for (const std::size_t megabytes : {0, 1, 2, 4, 8, 12, 16, 24, 32, 48, 64}) {
    std::vector<double> x;
    const std::string complaint = complaint_within(megabytes, [&] { x = solve(); });
    if (complaint.empty() && x != expected) std::exit(1);
    if (!complaint.empty() && complaint.find("out of memory") == std::string::npos) std::exit(2);
    refused += complaint.empty() ? 0 : 1;
  }
  std::exit(refused > 2 ? 0 : 3);
}

TEST_P(CholeskyFactorOfKind, WithLittleMemoryIsRightOrAnErrorInWords) {
  if (!test::kMemoryCanBeLimited) GTEST_SKIP() << "skipped: the sanitizer maps all memory there is";
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a new process has no freed memory
  EXPECT_EXIT(solve_with_little_memory(GetParam()), ::testing::ExitedWithCode(0), "");
}
#endif

TEST(CholeskyFactor, RightHandSideOfAnotherSizeIsAnError) {
  const SymmetricMatrix matrix = chain(5, 2);
  const SymbolicFactor symbolic(matrix);
  const CholeskyFactor factor(symbolic, matrix);
  EXPECT_THROW((void)factor.solve({1, 2}), Error);
}

TEST_P(CholeskyFactorOfKind, ThreadsMaySolveTogether) {
  const SymmetricMatrix matrix = chain(2000, 2.5);
  const SymbolicFactor symbolic(matrix, GetParam());
  const CholeskyFactor factor(symbolic, matrix);
  std::vector<double> b(2000);
  for (std::size_t j = 0; j < b.size(); ++j) b[j] = std::cos(static_cast<double>(j));
  const std::vector<double> alone = factor.solve(b);
  std::vector<double> first, second;
  std::thread other([&] {
    for (int i = 0; i < 50; ++i) first = factor.solve(b);
  });
  for (int i = 0; i < 50; ++i) second = factor.solve(b);
  other.join();
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
}

TEST_P(CholeskyFactorOfKind, ThreadsMayFactorTogether) {
  const SymmetricMatrix matrix = test::grid_matrix(120, 4.1);
  const SymbolicFactor symbolic(matrix, GetParam());
  const std::vector<double> b(matrix.size(), 1.0);
  const auto solve = [&] { return CholeskyFactor(symbolic, matrix).solve(b); };
  const std::vector<double> alone = solve();
  std::vector<std::future<std::vector<double>>> solutions;
  for (int i = 0; i < 12; ++i) solutions.push_back(std::async(std::launch::async, solve));
  for (auto& solution : solutions) EXPECT_EQ(solution.get(), alone);
}

TEST(SymmetricMatrix, ReplacingByTheIdentityKeepsThePattern) {
  SymmetricMatrix matrix = chain(4, 2);
  const std::vector<std::int32_t> rows = matrix.row;
  replace_by_identity(matrix, {0, 1, 0, 0});
  EXPECT_EQ(matrix.row, rows);
  EXPECT_EQ(multiply(matrix, {1, 10, 100, 1000}), (std::vector<double>{2, 10, -800, 1900}));
}

}  // namespace
}  // namespace talweg
