// The window lists of edges against a plain list.
#include "talweg/intrinsic/exact_distance/polyline_window_lists.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace talweg {
namespace {

using Range = EdgeRange;

EdgeWindow window(double begin, double end) {
  EdgeWindow w;
  w.begin = begin;
  w.end = end;
  return w;
}

/// Adds a window after it has cut or emptied the windows that it meets, like a march.
class Against {
 public:
  explicit Against(unsigned seed) : random_(seed) {}

  void add(EdgeId edge) {
    const double begin = uniform_(random_), length = 0.02 * uniform_(random_);
    const Range range{begin, begin + length};
    std::vector<double> met, expected;
    lists_.each_meeting(range, edge, [&](EdgeWindow& w) {
      met.push_back(w.offset);
      w.cut(range.begin, range.end, 0, 0);
      return range;
    });
    for (EdgeWindow& w : plain_) {
      if (!range.meets({w.begin, w.end})) continue;
      expected.push_back(w.offset);
      w.cut(range.begin, range.end, 0, 0);
    }
    std::erase_if(plain_, [](const EdgeWindow& w) { return w.is_empty(); });
    std::sort(met.begin(), met.end());
    ASSERT_EQ(met, expected);
    EdgeWindow fresh = window(range.begin, range.end);
    fresh.offset = count_++;
    plain_.push_back(fresh);
    const auto id = lists_.add(edge, fresh);
    ASSERT_EQ(lists_[id].offset, fresh.offset);
  }

  /// The callback may shrink the range of the query.
  void meet_fewer(EdgeId edge) {
    std::size_t met = 0;
    lists_.each_meeting({0, 1}, edge, [&](const EdgeWindow&) {
      return ++met < 3 ? Range{0, 1} : Range{};
    });
    EXPECT_EQ(met, std::min<std::size_t>(3, plain_.size()));
  }

  void compare(EdgeId edge) {
    std::vector<EdgeWindow> all;
    lists_.each(edge, [&](const EdgeWindow& w) { all.push_back(w); });
    std::sort(all.begin(), all.end(),
              [](const EdgeWindow& a, const EdgeWindow& b) { return a.offset < b.offset; });
    ASSERT_EQ(all.size(), plain_.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(all[i].offset, plain_[i].offset);
      EXPECT_EQ(all[i].begin, plain_[i].begin);
      EXPECT_EQ(all[i].end, plain_[i].end);
    }
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

TEST(WindowLists, AgreeWithPlainListsOfAnySize) {
  const EdgeId edge{1};
  Against both(1);
  for (int round = 0; round < 2; ++round) {
    for (int k = 0; k < 1000; ++k) {
      ASSERT_NO_FATAL_FAILURE(both.add(edge));
      if (k % 50 == 0 || k < 40) {
        ASSERT_NO_FATAL_FAILURE(both.compare(edge));
        both.meet_fewer(edge);
      }
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

TEST(WindowLists, FindAFewAmongMany) {
  WindowLists lists(1);
  const EdgeId edge{0};
  for (const int count : {1'000, 100'000}) {
    lists.clear();
    for (int k = 0; k < count; ++k) {
      const int shuffled = static_cast<int>((k * 7919LL) % count);
      lists.add(edge, window(shuffled, shuffled + 0.5));
      lists.each_meeting({0, 0}, edge, [](const EdgeWindow&) { return Range{}; });
    }
    lists.take_work();
    int met = 0;
    lists.each_meeting({500.1, 502.1}, edge, [&](const EdgeWindow&) {
      ++met;
      return Range{500.1, 502.1};
    });
    EXPECT_EQ(met, 3);
    EXPECT_LT(lists.take_work(), count / 200U);
  }
}

}  // namespace
}  // namespace talweg
