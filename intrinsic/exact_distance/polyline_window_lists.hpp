// The window lists hold the windows of all edges, by edge.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "talweg/intrinsic/exact_distance/polyline_window.hpp"
#include "talweg/intrinsic/surface/ids.hpp"

namespace talweg {

/// Nearly every edge has only a few windows, which form a list through EdgeWindow::next. The long
/// sides of needles can have thousands, of which a new window meets two or three. For such edges
/// the windows' extents are stored side by side, so that a search does not fetch all windows from
/// memory.
class WindowLists {
 public:
  using Id = std::uint32_t;

  explicit WindowLists(std::size_t edge_count) : first_(edge_count, kNone) {}

  /// O(edges that had windows).
  void clear() {
    for (const EdgeId e : touched_) first_[e.index()] = kNone;
    touched_.clear();
    crowds_.clear();
    windows_.clear();
  }

  /// The number of windows added since clear(); an id is at most this.
  [[nodiscard]] std::size_t size() const { return windows_.size(); }
  /// Also valid for windows that were removed.
  [[nodiscard]] const EdgeWindow& operator[](Id id) const { return windows_[id]; }

  Id add(EdgeId edge, const EdgeWindow& window) {
    const auto id = static_cast<Id>(windows_.size());
    windows_.push_back(window);
    Id& first = first_[edge.index()];
    if (is_crowd(first)) {
      crowds_[first & ~kCrowd].push_back({window.begin, window.end, id});
    } else {
      if (first == kNone) touched_.push_back(edge);
      windows_.back().next = std::exchange(first, id);
    }
    return id;
  }

  /// Calls use(const EdgeWindow&) for all windows of an edge, the newest first.
  template <class Use>
  void each(EdgeId edge, Use use) const {
    const Id first = first_[edge.index()];
    if (is_crowd(first)) {
      const auto& crowd = crowds_[first & ~kCrowd];
      for (std::size_t i = crowd.size(); i-- > 0;) use(windows_[crowd[i].id]);
    } else {
      for (Id i = first; i != kNone; i = windows_[i].next) use(windows_[i]);
    }
  }

  /// A range along an edge; empty where end < begin.
  struct Range {
    double begin = 1, end = 0;
    [[nodiscard]] bool is_empty() const { return end < begin; }
    [[nodiscard]] bool meets(double from, double to) const { return from <= end && begin <= to; }
  };
  /// Calls use(EdgeWindow&) for the windows that meet a range. It returns the range to continue
  /// with, and may cut the window, which is removed when it is empty.
  template <class Use>
  void each_meeting(Range range, EdgeId edge, Use use) {
    const Id first = first_[edge.index()];
    if (is_crowd(first)) {
      each_in(crowds_[first & ~kCrowd], range, use);
    } else if (each_in(&first_[edge.index()], range, use) > kMany) {
      make_crowd(edge);
    }
  }

  /// Prefetches the memory that the next call for this edge needs.
  void fetch(EdgeId edge) const { __builtin_prefetch(&first_[edge.index()]); }
  void fetch(Id window) const { __builtin_prefetch(&windows_[window]); }

 private:
  static constexpr Id kNone = 0xFFFFFFFFU;
  static constexpr Id kCrowd = 0x80000000U;  // the other bits are the index of the crowd
  static constexpr std::size_t kMany = 32;
  struct Extent {
    double begin, end;
    Id id;
  };
  using Crowd = std::vector<Extent>;  // the newest is last

  static bool is_crowd(Id first) { return first != kNone && (first & kCrowd) != 0; }

  /// Returns the number of windows visited.
  template <class Use>
  std::size_t each_in(Id* link, Range range, Use& use) {
    std::size_t count = 0;
    for (; !range.is_empty() && *link != kNone; ++count) {
      EdgeWindow& window = windows_[*link];
      if (range.meets(window.begin, window.end)) range = use(window);
      if (window.is_empty()) {
        *link = window.next;
      } else {
        link = &window.next;
      }
    }
    return count;
  }

  template <class Use>
  void each_in(Crowd& crowd, Range range, Use& use) {
    for (std::size_t i = crowd.size(); !range.is_empty() && i-- > 0;) {
      Extent& extent = crowd[i];
      if (!range.meets(extent.begin, extent.end)) continue;
      EdgeWindow& window = windows_[extent.id];
      range = use(window);
      extent.begin = window.begin;
      extent.end = window.end;
      if (window.is_empty()) crowd.erase(crowd.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  void make_crowd(EdgeId edge) {
    Crowd crowd;
    each(edge, [&](const EdgeWindow& w) {
      crowd.push_back({w.begin, w.end, static_cast<Id>(&w - windows_.data())});
    });
    std::reverse(crowd.begin(), crowd.end());
    crowds_.push_back(std::move(crowd));
    first_[edge.index()] = kCrowd | static_cast<Id>(crowds_.size() - 1);
  }

  std::vector<Id> first_;  // per edge
  std::vector<Crowd> crowds_;
  std::vector<EdgeWindow> windows_;
  std::vector<EdgeId> touched_;
};

}  // namespace talweg
