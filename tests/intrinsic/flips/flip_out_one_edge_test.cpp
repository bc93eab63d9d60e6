// Loops of a single edge: they open, or stay exactly as they are.
#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/flips/flip_out.hpp"
#include "talweg/intrinsic/flips/trace.hpp"

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
  // A loop that is opened and then meets another path is restored, and all flips of the attempt are
  // undone.
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

/// A Δ-complex from pairs of glued sides; a side is 3 · face + number.
Surface glued(std::size_t vertices, const std::vector<Triangle>& triangles,
              const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  std::vector<std::uint32_t> gluing(3 * triangles.size(), Surface::kNoSide);
  for (const auto& [a, b] : pairs) {
    gluing[a] = b;
    gluing[b] = a;
  }
  return Surface::from_gluing(vertices, triangles, gluing);
}

TEST(FlipOutOneEdge, AnnulusGivesItsClosedGeodesic) {
  // An equilateral triangle of side 1 stands on the loop; the two triangles (apex, w) and (w, apex)
  // close the annulus with an angle of 50° at the loop's vertex, from where w is at a distance r.
  // The other boundary, apex - w - apex, is convex, so the opened loop must be pulled back from it.
  // Laid out around the loop, the two images of w are 1 - 2 r cos(60° + 25°) apart.
  for (const double r : {0.1, 0.3, 0.6}) {
    Surface s = glued(3, {{0, 0, 1}, {0, 1, 2}, {0, 2, 1}}, {{2, 3}, {5, 6}, {8, 1}});
    const double half = 25 * kPi / 180;
    std::vector<double> lengths(s.edge_count(), 1);
    const double rim = std::sqrt(1 + r * r - 2 * r * std::cos(half));
    for (std::size_t e = 0; e < lengths.size(); ++e) {
      const HalfedgeId h = halfedge_of(EdgeId{e});
      if (s.tail(h).index() + s.head(h).index() == 2) lengths[e] = r;    // 0 to w
      if (s.tail(h).index() + s.head(h).index() == 3) lengths[e] = rim;  // apex to w
    }
    s.set_lengths(lengths);
    SignpostTriangulation t(s);
    const HalfedgeId loop = s.halfedge(FaceId{0});
    const FlipOutResult result = FlipOut(t).run(std::vector{EdgePath::make(t, {loop}, true)}, {});
    EXPECT_EQ(result.paths[0].termination, Termination::kConverged);
    EXPECT_NEAR(result.paths[0].length_after, 1 - 2 * r * std::cos(kPi / 3 + half), 1e-12) << r;
    while (t.flip_count() > 0) t.undo_flip();
  }
}

TEST(FlipOutOneEdge, AnOpeningThatFailsAfterFlipsIsTakenBack) {
  // The loop gets shorter only on its far side, where the second path lies. Alone the loop is
  // shortened; beside that path the attempt is undone completely. The length of an edge is the sum
  // of the weights of its ends, so inside there is another loop of the same length.
  Surface s = glued(4, {{0, 0, 1}, {2, 1, 0}, {3, 0, 0}, {1, 2, 0}, {2, 0, 0}},
                    {{1, 4}, {2, 11}, {3, 9}, {5, 12}, {6, 8}, {7, 13}, {10, 14}});
  const std::array<double, 4> weight = {11.6, 12.3, 0.07, 0.05};
  std::vector<double> lengths(s.edge_count());
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    lengths[e] = weight[s.tail(h).index()] + weight[s.head(h).index()];
  }
  s.set_lengths(lengths);
  SignpostTriangulation t(s);
  const EdgePath loop = EdgePath::make(t, {s.halfedge(FaceId{0})}, true);
  const FlipOutResult alone = FlipOut(t).run(std::vector{loop}, {});
  EXPECT_LT(alone.paths[0].length_after, alone.paths[0].length_before);
  while (t.flip_count() > 0) t.undo_flip();

  const FlipOutResult held = FlipOut(t).run(std::vector{loop, path_through(t, {2, 1})}, {});
  EXPECT_EQ(held.flips, 0U);
  EXPECT_EQ(held.paths[0].length_after, held.paths[0].length_before);
  ASSERT_EQ(held.paths[0].path.halfedges().size(), 1U);
  EXPECT_EQ(held.paths[0].path.halfedges()[0], loop.halfedges()[0]);
}

}  // namespace
}  // namespace talweg
