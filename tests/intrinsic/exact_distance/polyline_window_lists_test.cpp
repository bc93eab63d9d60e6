// The windows of edges, against a plain list.
#include "talweg/intrinsic/exact_distance/polyline_window_lists.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace talweg {
namespace {

using Range = WindowLists::Range;

EdgeWindow window(double begin, double end) {
  EdgeWindow w;
  w.begin = begin;
  w.end = end;
  return w;
}

/// Adds a window after it has cut, emptied or left alone those that it meets, as a march does.
class Against {
 public:
  explicit Against(unsigned seed) : random_(seed) {}

  void add(EdgeId edge) {
    const double begin = uniform_(random_), length = 0.02 * uniform_(random_);
    const Range range{begin, begin + length};
    const double until = uniform_(random_) < 0.2 ? begin + length / 2 : range.end;
    std::vector<double> met, expected;
    lists_.each_meeting(range, edge, [&](EdgeWindow& w) {
      met.push_back(w.offset);
      w.cut(range.begin, range.end, 0, 0);
      return met.size() < 3 ? Range{range.begin, until} : Range{};
    });
    for (std::size_t i = plain_.size(), seen = 0; i-- > 0 && seen < 3;) {
      EdgeWindow& w = plain_[i];
      if (!Range{range.begin, seen == 0 ? range.end : until}.meets(w.begin, w.end)) continue;
      expected.push_back(w.offset);
      w.cut(range.begin, range.end, 0, 0);
      if (w.is_empty()) plain_.erase(plain_.begin() + static_cast<std::ptrdiff_t>(i));
      ++seen;
    }
    ASSERT_EQ(met, expected);
    EdgeWindow fresh = window(range.begin, range.end);
    fresh.offset = count_++;
    plain_.push_back(fresh);
    const auto id = lists_.add(edge, fresh);
    ASSERT_EQ(lists_[id].offset, fresh.offset);
  }

  void compare(EdgeId edge) {
    std::size_t i = plain_.size();
    lists_.each(edge, [&](const EdgeWindow& w) {
      ASSERT_GT(i, 0U);
      --i;
      EXPECT_EQ(w.offset, plain_[i].offset);
      EXPECT_EQ(w.begin, plain_[i].begin);
      EXPECT_EQ(w.end, plain_[i].end);
    });
    EXPECT_EQ(i, 0U);
  }

  void clear() {
    lists_.clear();
    plain_.clear();
  }
  [[nodiscard]] std::size_t left() const { return plain_.size(); }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> uniform_{0, 1};
  WindowLists lists_{3};
  std::vector<EdgeWindow> plain_;  // the newest last
  int count_ = 0;
};

TEST(WindowLists, AreAsPlainListsHoweverMany) {
  const EdgeId edge{1};
  Against both(1);
  for (int round = 0; round < 2; ++round) {
    for (int k = 0; k < 1000; ++k) {
      ASSERT_NO_FATAL_FAILURE(both.add(edge));
      if (k % 50 == 0 || k < 40) both.compare(edge);
    }
    EXPECT_GT(both.left(), 50U);
    EXPECT_LT(both.left(), 900U);
    both.clear();
    both.compare(edge);
  }
}

TEST(WindowLists, OfOtherEdgesStayApart) {
  WindowLists lists(4);
  for (int k = 0; k < 300; ++k)
    lists.add(EdgeId{static_cast<std::uint32_t>(k % 3)}, window(k, k + 1));
  EXPECT_EQ(lists.size(), 300U);
  for (const std::uint32_t e : {0U, 1U, 2U, 3U}) {
    std::size_t count = 0;
    lists.each_meeting({0, 1000}, EdgeId{e}, [](EdgeWindow&) { return Range{0, 1000}; });
    lists.each(EdgeId{e}, [&](const EdgeWindow& w) {
      EXPECT_EQ(static_cast<int>(w.begin) % 3, static_cast<int>(e));
      ++count;
    });
    EXPECT_EQ(count, e < 3 ? 100U : 0U);
  }
}

}  // namespace
}  // namespace talweg
