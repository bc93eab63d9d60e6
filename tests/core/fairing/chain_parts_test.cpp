#include "talweg/core/fairing/chain_parts.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

class ChainPartsTest : public testing::Test {
 protected:
  /// A chain around a square in a plane. Two corners are fixed, and the ends of an open chain.
  [[nodiscard]] SampleChain chain(bool closed) {
    SurfaceCurve curve{closed, {}};
    const std::uint32_t row = kColumns + 1;
    for (std::uint32_t i = 4; i < 16; ++i) curve.points.push_back(at(4 * row + i));
    for (std::uint32_t i = 4; i < 16; ++i) curve.points.push_back(at(i * row + 16));
    for (std::uint32_t i = 16; i > 4; --i) curve.points.push_back(at(16 * row + i));
    for (std::uint32_t i = 16; i > 4; --i) curve.points.push_back(at(i * row + 4));
    const std::vector fixed{at(4 * row + 16), at(16 * row + 16)};
    auto made = maker.sampled(trace_of(opened->surface(), curve, fixed), 0.7);
    EXPECT_TRUE(made.has_value());
    return *made;
  }
  [[nodiscard]] SurfacePoint at(std::uint32_t vertex) const {
    return SurfacePoint::at_vertex(opened->surface(), VertexId{vertex});
  }
  static void expect_same(const SampleChain& a, const SampleChain& b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(a.closed, b.closed);
    EXPECT_EQ(a.fixed, b.fixed);
    EXPECT_EQ(a.fixed_points, b.fixed_points);
    EXPECT_EQ(a.turns, b.turns);
    EXPECT_EQ(a.crossed, b.crossed);
    ASSERT_EQ(a.joins.size(), b.joins.size());
    for (std::size_t i = 0; i < a.joins.size(); ++i) {
      EXPECT_EQ(a.joins[i].stretch, b.joins[i].stretch) << i;
      EXPECT_EQ(a.joins[i].first, b.joins[i].first) << i;
      EXPECT_EQ(a.joins[i].length, b.joins[i].length) << i;
    }
  }

  static constexpr std::uint32_t kColumns = 20;
  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(kColumns, 20));
  ChainMaker maker{opened->surface()};
};

/// The ranges: at the beginning, around a fixed sample, and from a fixed sample to the end.
TEST_F(ChainPartsTest, APartReplacedByItselfChangesNothing) {
  for (const bool closed : {false, true}) {
    const SampleChain whole = chain(closed);
    std::vector<std::size_t> fixed;
    for (std::size_t i = 1; i + 1 < whole.size(); ++i) {
      if (whole.fixed[i]) fixed.push_back(i);
    }
    ASSERT_EQ(fixed.size(), 2U);
    const std::vector<ChainRange> ranges{
        {0, 6}, {fixed[0] - 5, fixed[0] + 5}, {fixed[1], whole.size() - 1}};
    std::vector<SampleChain> parts;
    for (const ChainRange& range : ranges) {
      const ChainFrame frame{&whole, range};
      auto part =
          framed(opened->surface(), part_of(opened->surface(), whole, frame.inside()), frame);
      ASSERT_TRUE(part.has_value());
      maker.set_turns(*part);
      EXPECT_EQ(part->size(), range.last - range.first + 1);
      EXPECT_TRUE(part->fixed[0] && part->fixed.back());
      EXPECT_EQ(part->fixed[1], frame.has_first());
      parts.push_back(*std::move(part));
    }
    expect_same(with_parts(whole, ranges, parts), whole);
  }
}

TEST(ChainRanges, AreDisjointAndInsideTheChain) {
  const std::vector<std::size_t> samples{3, 40, 45, 98};
  const auto ranges = ranges_about(samples, 5, 100);
  ASSERT_EQ(ranges.size(), 3U);
  EXPECT_EQ(ranges[0].first, 0U);
  EXPECT_EQ(ranges[0].last, 8U);
  EXPECT_EQ(ranges[1].first, 35U);
  EXPECT_EQ(ranges[1].last, 50U);
  EXPECT_EQ(ranges[2].last, 99U);
  EXPECT_FALSE(is_small_part(ranges, 100));
  EXPECT_TRUE(is_small_part(ranges, 1000));
}

}  // namespace
}  // namespace talweg
