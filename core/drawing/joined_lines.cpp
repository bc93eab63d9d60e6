#include "talweg/core/drawing/joined_lines.hpp"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <utility>

namespace talweg {
namespace {

struct LineEnd {
  std::uint32_t point;
  std::size_t line;
  bool at_back;
  friend auto operator<=>(const LineEnd&, const LineEnd&) = default;
};

void drop_repeated_segments(std::vector<Line>& lines) {
  using Segment = std::pair<std::pair<std::uint32_t, std::uint32_t>, std::size_t>;
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (lines[k].size() == 2) segments.push_back({std::minmax(lines[k][0], lines[k][1]), k});
  }
  std::sort(segments.begin(), segments.end());
  for (std::size_t k = 1; k < segments.size(); ++k) {
    if (segments[k].first == segments[k - 1].first) lines[segments[k].second].clear();
  }
  std::erase_if(lines, [](const Line& line) { return line.empty(); });
}

class Joiner {
 public:
  explicit Joiner(std::vector<Line> lines) : lines_(std::move(lines)), used_(lines_.size()) {
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      if (is_loop(lines_[k])) continue;
      ends_.push_back({lines_[k].front(), k, false});
      ends_.push_back({lines_[k].back(), k, true});
    }
    std::sort(ends_.begin(), ends_.end());
  }

  std::vector<Line> join() {
    std::vector<Line> result;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      if (used_[k]) continue;
      used_[k] = true;
      Line curve = lines_[k];
      if (!is_loop(curve)) {
        extend(curve, {curve.back(), k, true});
        if (!is_loop(curve)) {
          Line before(1, curve.front());
          extend(before, {curve.front(), k, false});
          std::reverse(before.begin(), before.end());
          before.insert(before.end(), curve.begin() + 1, curve.end());
          curve = std::move(before);
        }
      }
      result.push_back(std::move(curve));
    }
    return result;
  }

 private:
  static bool is_loop(const Line& line) { return line.size() > 1 && line.front() == line.back(); }

  /// Extends a curve at an end of a line while exactly one other line has an end at the same point.
  void extend(Line& curve, LineEnd end) {
    for (;;) {
      const auto first = std::lower_bound(ends_.begin(), ends_.end(), LineEnd{end.point, 0, false});
      auto last = first;
      while (last != ends_.end() && last->point == end.point && last - first < 3) ++last;
      if (last - first != 2) return;
      const LineEnd other = *first == end ? *(first + 1) : *first;
      if (used_[other.line]) return;
      used_[other.line] = true;
      const Line& line = lines_[other.line];
      if (other.at_back) {
        curve.insert(curve.end(), line.rbegin() + 1, line.rend());
      } else {
        curve.insert(curve.end(), line.begin() + 1, line.end());
      }
      end = {curve.back(), other.line, !other.at_back};
    }
  }

  std::vector<Line> lines_;
  std::vector<char> used_;
  std::vector<LineEnd> ends_;
};

}  // namespace

std::vector<Line> joined(std::vector<Line> lines) {
  drop_repeated_segments(lines);
  return Joiner(std::move(lines)).join();
}

}  // namespace talweg
