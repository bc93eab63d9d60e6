// A window index holds the extents of the many windows of one edge, and finds the windows in a
// range.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace talweg {

/// A range along an edge; empty where end < begin.
struct EdgeRange {
  double begin = 1, end = 0;
  [[nodiscard]] bool is_empty() const { return end < begin; }
  [[nodiscard]] bool meets(const EdgeRange& other) const {
    return other.begin <= end && begin <= other.end;
  }
};

/// The extents lie in bins of up to kMost, side by side along the edge. Windows of one edge hardly
/// overlap, so a range meets few bins besides the bins that it contains. Among n windows, an
/// addition costs O(kMost + n / kMost); a search costs the same and the windows that it finds.
class WindowIndex {
 public:
  using Id = std::uint32_t;

  [[nodiscard]] std::size_t size() const { return size_; }

  void add(const EdgeRange& extent, Id id) {
    if (bins_.empty()) bins_.emplace_back();
    auto after =
        std::upper_bound(bins_.begin(), bins_.end(), extent.begin,
                         [](double begin, const Bin& bin) { return begin < bin.reach.begin; });
    const auto at = after == bins_.begin() ? after : after - 1;
    at->add({extent, id});
    ++size_;
    if (at->extents.size() == kMost) split(static_cast<std::size_t>(at - bins_.begin()));
  }

  /// Calls use(Id) for all windows.
  template <class Use>
  void each(Use use) const {
    for (const Bin& bin : bins_) {
      for (const Extent& extent : bin.extents) use(extent.id);
    }
  }

  /// Calls use(Id, EdgeRange&) for the windows that meet a range. `use` returns the range to
  /// continue with, and may make the extent smaller; a window with an empty extent is removed.
  /// Returns the number of visited bins and extents.
  template <class Use>
  std::size_t each_meeting(EdgeRange range, Use use) {
    std::size_t visited = 0;
    for (std::size_t h = 0; h < bins_.size() && !range.is_empty(); ++h) {
      ++visited;
      if (!range.meets(bins_[h].reach)) continue;
      std::vector<Extent>& extents = bins_[h].extents;
      visited += extents.size();
      for (std::size_t i = 0; i < extents.size() && !range.is_empty();) {
        if (range.meets(extents[i].range)) range = use(extents[i].id, extents[i].range);
        if (!extents[i].range.is_empty()) {
          ++i;
          continue;
        }
        extents[i] = extents.back();
        extents.pop_back();
        --size_;
      }
    }
    return visited;
  }

 private:
  static constexpr std::size_t kMost = 64;
  struct Extent {
    EdgeRange range;
    Id id;
  };
  struct Bin {
    EdgeRange reach{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
    std::vector<Extent> extents;

    void add(const Extent& extent) {
      extents.push_back(extent);
      reach.begin = std::min(reach.begin, extent.range.begin);
      reach.end = std::max(reach.end, extent.range.end);
    }
  };

  void split(std::size_t at) {
    std::vector<Extent> all = std::exchange(bins_[at], {}).extents;
    const auto middle = all.begin() + kMost / 2;
    std::nth_element(all.begin(), middle, all.end(), [](const Extent& a, const Extent& b) {
      return a.range.begin < b.range.begin;
    });
    bins_.insert(bins_.begin() + static_cast<std::ptrdiff_t>(at) + 1, Bin{});
    for (auto i = all.begin(); i != all.end(); ++i) bins_[i < middle ? at : at + 1].add(*i);
  }

  std::vector<Bin> bins_;  // by reach.begin
  std::size_t size_ = 0;
};

}  // namespace talweg
