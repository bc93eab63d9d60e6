// Loops of a single edge: they open, or stay exactly as they are.
#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/flip_out.hpp"
#include "talweg/intrinsic/trace.hpp"

namespace talweg {
namespace {

using namespace test;

std::vector<HalfedgeId> one_edge_loops(const SignpostTriangulation& t) {
  std::vector<HalfedgeId> loops;
  for (std::size_t i = 0; i < 2 * t.edge_count(); ++i) {
    if (t.tail(HalfedgeId{i}) == t.head(HalfedgeId{i})) loops.emplace_back(i);
  }
  return loops;
}

TEST(FlipOutOneEdge, LoneLoopsBecomeStraightOnBothSides) {
  Random random(51);
  std::size_t opened = 0;
  for (int k = 0; k < 1500; ++k) {
    const Surface s = random_complex(random, 2 + random.below(10), random.uniform(0, 0.3));
    SignpostTriangulation t(s);
    for (const HalfedgeId loop : one_edge_loops(t)) {
      const FlipOutResult result = FlipOut(t).run(std::vector{EdgePath::make(t, {loop}, true)}, {});
      const auto& path = result.paths[0];
      ASSERT_LE(path.length_after, path.length_before) << k;
      if (path.termination == Termination::kConverged) {
        opened += path.length_after < path.length_before ? 1 : 0;
        for (const double angle : side_angles(t, path.path)) ASSERT_GE(angle, kPi - 1e-4) << k;
      }
      while (t.flip_count() > 0) t.undo_flip();
    }
  }
  EXPECT_GT(opened, 100U);
}

TEST(FlipOutOneEdge, LoopsThatOthersHoldStayAsTheyAre) {
  // A loop that is opened and then meets another path is put back, with all flips of the attempt.
  Random random(52);
  std::size_t held = 0;
  for (int k = 0; k < 20000; ++k) {
    const Surface s = random_complex(random, 2 + random.below(20), random.uniform(0, 0.3),
                                     static_cast<double>(random.below(2)));
    SignpostTriangulation t(s);
    const auto loops = one_edge_loops(t);
    if (loops.empty()) continue;
    const HalfedgeId loop = loops[random.below(loops.size())];
    std::vector<EdgePath> paths = {EdgePath::make(t, {loop}, true)};
    const std::size_t others = 1 + random.below(6);
    for (std::size_t i = 0; i < others; ++i) {
      paths.push_back(EdgePath::make(t, random_walk(t, random, 1 + random.below(2)), false));
    }
    const FlipOutResult result = FlipOut(t).run(paths, {});
    std::vector<EdgePath> ends;
    for (const auto& path : result.paths) {
      ASSERT_LE(path.length_after, path.length_before * (1 + 1e-12)) << k;
      const auto h = path.path.halfedges();
      ASSERT_NO_THROW(EdgePath::make(t, {h.begin(), h.end()}, path.path.closed())) << k;
      ends.push_back(path.path);
    }
    const auto after = result.paths[0].path.halfedges();
    if (after.size() == 1 && after[0] == loop &&
        result.paths[0].termination == Termination::kConverged) {
      ++held;
      ASSERT_EQ(result.paths[0].length_after, result.paths[0].length_before) << k;
    }
    Tracer(t).trace_and_undo(ends);
  }
  EXPECT_GT(held, 100U);
}

}  // namespace
}  // namespace talweg
