// The lifetime of the solvers that an opened mesh keeps.
#include "talweg/core/mesh/opened_mesh.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/core/drawing/curve_through.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg {
namespace {

TEST(OpenedMesh, KeepsTheTwoSetsOfFactorsThatWereAskedForLast) {
  const auto opened = OpenedMesh::open(test::grid(12, 12));
  const std::weak_ptr<const HeatDistance> ten = opened->heat(10), twenty = opened->heat(20);
  EXPECT_FALSE(ten.expired());
  EXPECT_FALSE(twenty.expired());
  EXPECT_EQ(opened->heat(10), ten.lock());  // the same solver, now the most recently used
  const std::weak_ptr<const HeatDistance> thirty = opened->heat(30);
  EXPECT_TRUE(twenty.expired());
  EXPECT_FALSE(ten.expired());
  EXPECT_FALSE(thirty.expired());
}

TEST(OpenedMesh, ASliderOfTheHeatTimeCostsTheMemoryOfTwo) {
  const auto opened = OpenedMesh::open(test::grid(12, 12));
  CurveSmoother smoother(opened);
  const SurfaceCurve drawn =
      curve_through(opened->surface(), test::ids({27, 28, 42, 43, 57, 58, 72}));
  std::vector<std::weak_ptr<const HeatDistance>> all;
  for (int k = 1; k <= 10; ++k) {
    smoother.set_curve(drawn, {.method = Method::kPaper, .heat_time = 3.0 * k});
    all.push_back(opened->heat(3.0 * k));
  }
  const auto kept =
      std::count_if(all.begin(), all.end(), [](const auto& h) { return !h.expired(); });
  EXPECT_EQ(kept, 2);
}

TEST(OpenedMesh, FactorsWithAnotherOwnerStay) {
  const auto opened = OpenedMesh::open(test::grid(12, 12));
  const auto held = opened->heat(10);
  const std::vector<WeightedVertex> sources{{VertexId{40}, 1}, {VertexId{41}, 1}};
  const std::vector<double> before = held->solve(sources);
  for (const double time : {20.0, 30.0, 40.0}) static_cast<void>(opened->heat(time));
  EXPECT_EQ(held->solve(sources), before);
  const auto again = opened->heat(10);
  EXPECT_NE(again, held);
  EXPECT_EQ(again->solve(sources), before);
}

TEST(OpenedMesh, IsAskedByManyThreadsAndCancelledByAny) {
  const auto opened = OpenedMesh::open(test::grid(30, 30));
  const std::vector<WeightedVertex> sources{{VertexId{40}, 1}, {VertexId{41}, 1}};
  const std::vector<double> expected = HeatDistance(opened->surface(), {}).solve(sources);
  std::atomic<int> wrong = 0, right = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int k = 0; k < 6; ++k) {
        const bool stop = (t + k) % 3 == 0;
        const auto heat =
            opened->heat(k % 2 == 0 ? 10 : 11 + t, [&](const char*, double) { return !stop; });
        if (heat == nullptr) {
          if (!stop) ++wrong;
        } else if (k % 2 == 0) {
          ++(heat->solve(sources) == expected ? right : wrong);
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(right, 0);
  EXPECT_EQ(opened->heat(10)->solve(sources), expected);
}

}  // namespace
}  // namespace talweg
