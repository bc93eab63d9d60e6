#include "talweg/intrinsic/flips/edge_path.hpp"

#include <string>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using namespace test;

std::string refused(const SignpostTriangulation& t, const std::vector<HalfedgeId>& halfedges,
                    bool closed) {
  try {
    EdgePath::make(t, halfedges, closed);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

TEST(EdgePath, ChainsTipToTail) {
  const Surface s = surface_of(grid(2, 2));
  SignpostTriangulation t(s);
  const EdgePath open = path_through(t, {0, 1, 2, 5});
  EXPECT_FALSE(open.closed());
  EXPECT_EQ(open.halfedges().size(), 3U);
  EXPECT_DOUBLE_EQ(path_length(t, open), 3);
  const EdgePath closed = path_through(t, {0, 1, 4, 3}, true);
  EXPECT_TRUE(closed.closed());
  EXPECT_DOUBLE_EQ(path_length(t, closed), 4);
  // Back and forth on one edge, open and closed.
  EXPECT_DOUBLE_EQ(path_length(t, path_through(t, {0, 1, 0, 1})), 3);
  EXPECT_DOUBLE_EQ(path_length(t, path_through(t, {0, 1}, true)), 2);
}

TEST(EdgePath, RefusesBrokenChains) {
  const Surface s = surface_of(grid(2, 2));
  SignpostTriangulation t(s);
  const auto chain = halfedges_through(t, {0, 1, 2, 5});
  EXPECT_NE(refused(t, {}, false).find("at least one"), std::string::npos);
  EXPECT_NE(refused(t, {}, true).find("at least one"), std::string::npos);
  EXPECT_NE(refused(t, {chain[0], chain[2]}, false).find("Edge 0"), std::string::npos);
  EXPECT_NE(refused(t, chain, true).find("Edge 2"), std::string::npos);
  EXPECT_NE(refused(t, {chain[0], HalfedgeId{}}, false).find("Edge 1"), std::string::npos);
  EXPECT_NE(refused(t, {HalfedgeId{2 * s.edge_count()}}, false).find("Edge 0"), std::string::npos);
  EXPECT_NE(refused(t, {chain[0]}, true).find("Edge 0"), std::string::npos);
}

TEST(EdgePath, OneEdgeLoopIsLegal) {
  const std::vector<Triangle> one = {{0, 0, 1}};
  Surface s = Surface::from_gluing(2, one, std::vector<std::uint32_t>{Surface::kNoSide, 2, 1});
  s.set_lengths({1, 3});
  SignpostTriangulation t(s);
  EXPECT_EQ(path_length(t, EdgePath::make(t, {HalfedgeId{0}}, true)), 1);
}

}  // namespace
}  // namespace talweg
