#include "talweg/heat/blas.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <thread>
#include <vector>

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "talweg/heat/cholesky_factor.hpp"

namespace talweg {
namespace {

template <class Function>
Function* find(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

/// The number of threads of the process or of the calling thread. The test sets it to a value that
/// no other code sets.
class Number {
 public:
  Number(const char* get, const char* set) : get_(find<int()>(get)), set_(find<void(int)>(set)) {
    if (!there()) return;
    before_ = get_();
    set_(kOurs);
  }
  ~Number() {
    if (there()) set_(before_);
  }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;

  static constexpr int kOurs = 3;
  [[nodiscard]] bool there() const { return get_ != nullptr && set_ != nullptr; }
  [[nodiscard]] int now() const { return get_(); }
  void set(int number) { set_(number); }

 private:
  int (*get_)();
  void (*set_)(int);
  int before_ = 1;
};

bool openblas_has_threads() {
  auto* parallel = find<int()>("openblas_get_parallel");
  return parallel != nullptr && parallel() == 1;
}
constexpr const char* kNoThreads = "skipped: needs OpenBLAS with threads (libopenblas0-pthread)";

TEST(OneBlasThread, OpenMpHasOneThreadDuringTheGuard) {
  Number threads("omp_get_max_threads", "omp_set_num_threads");
  Number levels("omp_get_max_active_levels", "omp_set_max_active_levels");
  if (!threads.there()) GTEST_SKIP() << "skipped: needs CHOLMOD with OpenMP";
  {
    const OneBlasThread one(BlasWork::kSolve);
    EXPECT_EQ(threads.now(), 1);
    EXPECT_EQ(levels.now(), 0);
  }
  EXPECT_EQ(threads.now(), Number::kOurs);
  EXPECT_EQ(levels.now(), Number::kOurs);
}

TEST(OneBlasThread, OpenBlasHasOneThreadUntilTheLastOneGoes) {
  if (!openblas_has_threads()) GTEST_SKIP() << kNoThreads;
  Number number("openblas_get_num_threads", "openblas_set_num_threads");
  std::optional<OneBlasThread> first(BlasWork::kFactor), second;
  EXPECT_EQ(number.now(), 1);
  std::thread([&] { second.emplace(BlasWork::kSolve); }).join();
  first.reset();
  EXPECT_EQ(number.now(), 1);
  second.reset();
  EXPECT_EQ(number.now(), Number::kOurs);
}

TEST(OneBlasThread, ANumberSetMeanwhileByOtherCodeStays) {
  if (!openblas_has_threads()) GTEST_SKIP() << kNoThreads;
  Number number("openblas_get_num_threads", "openblas_set_num_threads");
  {
    const OneBlasThread one(BlasWork::kSolve);
    number.set(2);
  }
  EXPECT_EQ(number.now(), 2);
}

TEST(OneBlasThread, FactorsAndSolutionsPutTheNumbersBack) {
  Number omp("omp_get_max_threads", "omp_set_num_threads");
  Number openblas("openblas_get_num_threads", "openblas_set_num_threads");
  const int before = openblas.there() ? openblas.now() : 0;
  const SymmetricMatrix matrix{{0, 2, 3}, {0, 1, 1}, {2, -1, 2}};
  (void)CholeskyFactor(SymbolicFactor(matrix), matrix).solve({1, 1});
  SymmetricMatrix indefinite = matrix;
  indefinite.diagonal(1) = -2;
  EXPECT_ANY_THROW(CholeskyFactor(SymbolicFactor(indefinite), indefinite));
  EXPECT_EQ(omp.there() ? omp.now() : Number::kOurs, Number::kOurs);
  EXPECT_EQ(openblas.there() ? openblas.now() : before, before);
}

/// A dense matrix: OpenBLAS with several threads would split its factorization.
SymmetricMatrix dense_matrix(std::int32_t n) {
  SymmetricMatrix matrix{{0}, {}, {}};
  for (std::int32_t j = 0; j < n; ++j) {
    for (std::int32_t i = j; i < n; ++i) {
      matrix.row.push_back(i);
      matrix.value.push_back(std::sin(0.1 * i * j) / 2 + (i == j ? n : 0));
    }
    matrix.column_start.push_back(static_cast<std::int32_t>(matrix.row.size()));
  }
  return matrix;
}

TEST(OneBlasThread, ThreadsOfOpenBlasChangeNoByte) {
  if (!openblas_has_threads()) GTEST_SKIP() << kNoThreads;
  const SymmetricMatrix matrix = dense_matrix(900);
  const std::vector<double> b(matrix.size(), 1.0);
  const auto solve = [&] { return CholeskyFactor(SymbolicFactor(matrix), matrix).solve(b); };
  Number number("openblas_get_num_threads", "openblas_set_num_threads");
  const std::vector<double> with_three = solve();
  number.set(1);
  EXPECT_EQ(solve(), with_three);
}

TEST(FactorLibraries, TellTheirNames) {
  const std::string text = factor_libraries();
  EXPECT_EQ(text.rfind("CHOLMOD ", 0), 0u) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  const bool with_blas = text.find("supernodal") != std::string::npos;
  EXPECT_NE(text.find(with_blas ? "libblas" : "simplicial"), std::string::npos) << text;
}

}  // namespace
}  // namespace talweg
