// The window lists hold the windows of all edges, by edge.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "talweg/intrinsic/exact_distance/edge_bounds.hpp"
#include "talweg/intrinsic/exact_distance/polyline_window.hpp"
#include "talweg/intrinsic/surface/ids.hpp"

namespace talweg {

/// Nearly every edge has only a few windows, which form a list through EdgeWindow::next. The long
/// sides of needles can have thousands, of which a new window meets two or three. For such edges
/// the windows' extents are stored side by side, so that a search does not fetch all windows from
/// memory, and bounds tell at once where a new window is not shorter.
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
      Crowd& crowd = crowds_[first & ~kCrowd];
      crowd.extents.push_back({window.begin, window.end, id});
      if (crowd.bounds) crowd.bounds->add(window);
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
      const auto& extents = crowds_[first & ~kCrowd].extents;
      for (std::size_t i = extents.size(); i-- > 0;) use(windows_[extents[i].id]);
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
  /// The range of a new window without parts at its ends where ways that are known are shorter by
  /// more than `same`. Only looked for where there are many windows.
  Range not_longer(EdgeId edge, const EdgeWindow& window, double length, double same) {
    const Id first = first_[edge.index()];
    constexpr double kShort = 1e-290;  // so short edges cannot be divided into parts
    if (!is_crowd(first) || length < kShort) return {window.begin, window.end};
    Crowd& crowd = crowds_[first & ~kCrowd];
    if (!crowd.bounds || crowd.bounds->parts() < crowd.extents.size()) bound(crowd, length);
    const auto [begin, end] = crowd.bounds->not_longer(window, same);
    return {begin, end};
  }
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
  struct Crowd {
    std::vector<Extent> extents;  // the newest is last
    std::optional<EdgeBounds> bounds;
  };

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
    std::vector<Extent>& extents = crowd.extents;
    for (std::size_t i = extents.size(); !range.is_empty() && i-- > 0;) {
      Extent& extent = extents[i];
      if (!range.meets(extent.begin, extent.end)) continue;
      EdgeWindow& window = windows_[extent.id];
      range = use(window);
      extent.begin = window.begin;
      extent.end = window.end;
      if (window.is_empty()) extents.erase(extents.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  void make_crowd(EdgeId edge) {
    Crowd crowd;
    each(edge, [&](const EdgeWindow& w) {
      crowd.extents.push_back({w.begin, w.end, static_cast<Id>(&w - windows_.data())});
    });
    std::reverse(crowd.extents.begin(), crowd.extents.end());
    crowds_.push_back(std::move(crowd));
    first_[edge.index()] = kCrowd | static_cast<Id>(crowds_.size() - 1);
  }

  /// Makes bounds of four parts a window, so that they serve until there are as many windows more.
  void bound(Crowd& crowd, double length) {
    std::size_t parts = 1;
    while (parts < 4 * crowd.extents.size()) parts *= 2;
    crowd.bounds.emplace(length, parts);
    for (const Extent& extent : crowd.extents) crowd.bounds->add(windows_[extent.id]);
  }

  std::vector<Id> first_;  // per edge
  std::vector<Crowd> crowds_;
  std::vector<EdgeWindow> windows_;
  std::vector<EdgeId> touched_;
};

}  // namespace talweg
