// Newton's method on a chain of points on edges, where the straight line is known.
#include "talweg/core/smoothing/lifted_chain.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"

namespace talweg {
namespace {

using test::grid;

ExactPotential none() {
  return {[](EdgeId, double) { return PotentialOnEdge{}; },
          [](const SurfacePoint&) { return std::array<double, 2>{}; },
          [](FaceId, const auto&, const auto&) { return PotentialInFace{}; }};
}

/// Over the upright edges of a grid's middle row, from a vertex on its left to
/// one on its right, up and down by turns, with the diagonals in between.
class Chain : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kColumns = 10;
  Chain() : mesh_(SurfaceMesh::open(grid(kColumns, 3))), chain_(mesh_, potential_, 1e-12, 1) {
    const Surface& s = mesh_.surface();
    const auto id = [](std::uint32_t i, std::uint32_t j) { return j * (kColumns + 1) + i; };
    add(SurfacePoint::at_vertex(s, VertexId{id(0, 1)}), true);
    for (std::uint32_t i = 0; i < kColumns; ++i) {
      if (i > 0 && i + 1 < kColumns) add(test::between(s, id(i, 1), id(i + 1, 2), 0.5), false);
      if (i + 1 < kColumns) {
        add(test::between(s, id(i + 1, 1), id(i + 1, 2), i % 2 == 0 ? 0.9 : 0.2), false);
      }
    }
    add(SurfacePoint::at_vertex(s, VertexId{id(kColumns, 2)}), true);
  }
  void add(const SurfacePoint& p, bool keep) { nodes_.push_back(chain_.node_at(p, keep)); }

  SurfaceMesh mesh_;
  ExactPotential potential_ = none();
  LiftedChain chain_;
  LiftedChain::Nodes nodes_;
};

TEST_F(Chain, SettlesToTheStraightLine) {
  const double before = chain_.length(nodes_);
  const double after = chain_.settle(nodes_, 50);
  const double line = std::hypot(kColumns, 1);
  EXPECT_GT(before, 1.05 * line);
  EXPECT_NEAR(after, line, 1e-7 * line);
  for (const ChainNode& node : nodes_) {  // all on y = 1 + x / 10
    EXPECT_NEAR(node.y[1], 1 + node.y[0] / kColumns, 1e-3);
    EXPECT_NEAR((mesh_.position(chain_.place(node)) - node.y.head<3>()).norm(), 0, 1e-12);
  }
}

TEST_F(Chain, EveryStepGainsAndEndsStay) {
  const SurfacePoint first = chain_.place(nodes_.front()), last = chain_.place(nodes_.back());
  double length = chain_.length(nodes_);
  for (int k = 0; k < 20; ++k) {
    const double now = chain_.settle(nodes_, 1);
    EXPECT_LE(now, length);
    EXPECT_NEAR(now, chain_.length(nodes_), 1e-12 * now);
    length = now;
  }
  EXPECT_EQ(chain_.place(nodes_.front()), first);
  EXPECT_EQ(chain_.place(nodes_.back()), last);
}

TEST_F(Chain, APointOnAnEdgeThatIsKeptParts) {
  const std::size_t middle = nodes_.size() / 2;
  const SurfacePoint kept = chain_.place(nodes_[middle]);
  nodes_[middle] = chain_.node_at(kept, true);
  chain_.settle(nodes_, 50);
  EXPECT_EQ(chain_.place(nodes_[middle]), kept);
  const Point p = mesh_.position(kept), a = nodes_.front().y.head<3>(),
              b = nodes_.back().y.head<3>();
  EXPECT_NEAR(chain_.length(nodes_), (p - a).norm() + (b - p).norm(), 1e-6);
}

TEST_F(Chain, PartsComeToTheSameLine) {
  double length = chain_.length(nodes_);
  for (int k = 0; k < 200; ++k) {
    chain_.settle_by_parts(nodes_);
    EXPECT_LE(chain_.length(nodes_), length * (1 + 1e-15));
    length = chain_.length(nodes_);
  }
  EXPECT_NEAR(length, std::hypot(kColumns, 1), 1e-5);
}

// Close around the vertex (1, 1), on three of its edges; the straight line is far from it.
TEST(LiftedChain, PointsCloseAroundAVertexComeAwayFromIt) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(3, 3));
  const ExactPotential flat = none();
  LiftedChain chain(mesh, flat, 1e-9, 1);
  const Surface& s = mesh.surface();
  LiftedChain::Nodes nodes;
  nodes.push_back(chain.node_at(test::between(s, 4, 9, 0.9), true));  // (0.9, 1.9)
  nodes.push_back(chain.node_at(test::between(s, 5, 9, 1.15e-3), false));
  nodes.push_back(chain.node_at(test::between(s, 5, 10, 1.1e-3), false));
  nodes.push_back(chain.node_at(test::between(s, 5, 6, 1.6e-3), false));
  nodes.push_back(chain.node_at(test::between(s, 1, 6, 0.9), true));  // (1.9, 0.9)
  EXPECT_NEAR(chain.settle(nodes, 60), std::sqrt(2.0), 1e-6);
}

// Over the upright edges of a strip, up and down by turns: every Newton step looks at every node,
// which is four units of work at least.
TEST(LiftedChain, AsksInProportionToTheNodesThatItLooksAt) {
  constexpr std::uint32_t kColumns = 6000;
  const SurfaceMesh mesh = SurfaceMesh::open(grid(kColumns, 1));
  const ExactPotential flat = none();
  std::size_t asked = 0;
  Asker asker([&](const char*, double) { return ++asked > 0; }, "polish");
  LiftedChain chain(mesh, flat, 1e-12, 1, &asker);
  LiftedChain::Nodes nodes;
  for (std::uint32_t i = 0; i <= kColumns; ++i) {
    const double t = i % 2 == 0 ? 0.2 : 0.8;
    nodes.push_back(chain.node_at(test::between(mesh.surface(), i, kColumns + 1 + i, t),
                                  i == 0 || i == kColumns));
    if (i == kColumns) break;
    const bool diagonal =
        mesh.surface().find_halfedge(VertexId{i}, VertexId{kColumns + 2 + i}).valid();
    nodes.push_back(chain.node_at(diagonal
                                      ? test::between(mesh.surface(), i, kColumns + 2 + i, 0.5)
                                      : test::between(mesh.surface(), i + 1, kColumns + 1 + i, 0.5),
                                  false));
  }
  const double before = chain.length(nodes);
  asked = 0;
  EXPECT_LT(chain.settle(nodes, 3), before);
  EXPECT_GE(asked, 3 * 4 * nodes.size() / Asker::kEvery);
  EXPECT_GE(asked, 5U);
  Asker refusing([&](const char*, double) { return asked-- > 0; }, "polish");
  LiftedChain cut_short(mesh, flat, 1e-12, 1, &refusing);
  asked = 2;
  EXPECT_THROW(cut_short.settle(nodes, 50), Cancelled);
}

// A ridge between two nodes, of which their own potentials know nothing.
TEST(LiftedChain, SeesWhatLiesBetweenItsNodes) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(2, 1));
  const ExactPotential ridge = {[](EdgeId, double) { return PotentialOnEdge{}; },
                                [](const SurfacePoint&) { return std::array<double, 2>{}; },
                                [](FaceId, const auto&, const auto&) {
                                  return PotentialInFace{{3, 0}, {}, {}};
                                }};
  LiftedChain chain(mesh, ridge, 1e-9, 1);
  const Surface& s = mesh.surface();
  const LiftedChain::Nodes nodes{chain.node_at(test::between(s, 0, 3, 0.5), true),
                                 chain.node_at(test::between(s, 0, 4, 0.5), false)};
  EXPECT_NEAR(chain.length(nodes), 2 * std::hypot(0.25, 3), 1e-9);
}

}  // namespace
}  // namespace talweg
