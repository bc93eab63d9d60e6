// The window lists hold the windows of all edges, by edge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "talweg/intrinsic/exact_distance/edge_bounds.hpp"
#include "talweg/intrinsic/exact_distance/polyline_window.hpp"
#include "talweg/intrinsic/exact_distance/window_index.hpp"
#include "talweg/intrinsic/exact_distance/window_store.hpp"
#include "talweg/intrinsic/surface/ids.hpp"

namespace talweg {

/// Nearly every edge has only a few windows, which form a list through EdgeWindow::next. The long
/// sides of needles can have thousands, of which a new window meets two or three. An index finds
/// these few, and bounds exclude the parts where a new window is not shorter.
class WindowLists {
 public:
  using Id = WindowStore::Id;

  explicit WindowLists(std::size_t edge_count) : first_(edge_count, kUntouched) {}

  /// O(edges that had windows).
  void clear() {
    for (const EdgeId e : touched_) first_[e.index()] = kUntouched;
    touched_.clear();
    indices_.clear();
    windows_.clear();
  }

  /// The number of windows added since clear(); ids are smaller.
  [[nodiscard]] std::size_t size() const { return windows_.size(); }
  /// The number of edges that have had windows since clear().
  [[nodiscard]] std::size_t edge_count() const { return touched_.size(); }
  /// Also valid for windows that were removed.
  [[nodiscard]] const EdgeWindow& operator[](Id id) const { return windows_[id]; }

  Id add(EdgeId edge, const EdgeWindow& window) {
    const Id id = windows_.add(window);
    Id& first = first_[edge.index()];
    if (is_indexed(first)) {
      EdgeIndex& index = indices_[first & ~kIndexed];
      index.extents.add({window.begin, window.end}, id);
      if (index.bounds) index.bounds->add(window);
      visited_ += kVisitsOfAdding;
      return id;
    }
    if (first == kUntouched) {
      touched_.push_back(edge);
      first = kNone;
    }
    windows_[id].next = std::exchange(first, id);
    return id;
  }

  /// Calls use(const EdgeWindow&) for all windows of an edge.
  template <class Use>
  void each(EdgeId edge, Use use) const {
    const Id first = first_[edge.index()];
    if (is_indexed(first)) {
      indices_[first & ~kIndexed].extents.each([&](Id id) { use(windows_[id]); });
    } else {
      for (Id i = first; !is_end(i); i = windows_[i].next) use(windows_[i]);
    }
  }

  /// The range of a new window without the parts at its ends where known distances are shorter by
  /// more than `same`. On an edge with few windows, the whole range.
  EdgeRange not_longer(EdgeId edge, const EdgeWindow& window, double length, double same) {
    const Id first = first_[edge.index()];
    constexpr double kShort = 1e-290;  // so short edges cannot be divided into parts
    if (!is_indexed(first) || length < kShort) return {window.begin, window.end};
    EdgeIndex& index = indices_[first & ~kIndexed];
    if (!index.bounds || index.bounds->parts() < index.extents.size()) bound(index, length);
    return index.bounds->not_longer(window, same, visited_);
  }
  /// Calls use(EdgeWindow&) for the windows that meet a range. `use` returns the range to continue
  /// with, and may cut the window; an empty window is removed.
  template <class Use>
  void each_meeting(EdgeRange range, EdgeId edge, Use use) {
    Id& first = first_[edge.index()];
    if (is_indexed(first)) {
      visited_ +=
          indices_[first & ~kIndexed].extents.each_meeting(range, [&](Id id, EdgeRange& extent) {
            const EdgeRange rest = use(windows_[id]);
            extent = {windows_[id].begin, windows_[id].end};
            return rest;
          });
    } else if (each_in(&first, range, use) > kMany) {
      make_index(edge);
    }
  }

  /// The cost of searches in indices since the last call, in units of work.
  std::size_t take_work() {
    constexpr std::size_t kOfUnit = 32;  // visited extents
    const std::size_t units = visited_ / kOfUnit;
    visited_ %= kOfUnit;
    return units;
  }

  /// Prefetches the memory that the next call for this edge needs.
  void fetch(EdgeId edge) const { __builtin_prefetch(&first_[edge.index()]); }
  void fetch(Id window) const { __builtin_prefetch(&windows_[window]); }

 private:
  static constexpr Id kNone = 0xFFFFFFFFU, kUntouched = kNone - 1;
  static constexpr Id kIndexed = 0x80000000U;  // the other bits are a place in indices_
  static constexpr std::size_t kMany = 32;
  static constexpr std::size_t kVisitsOfAdding = 128;  // to an index: cache misses
  struct EdgeIndex {
    WindowIndex extents;
    std::optional<EdgeBounds> bounds;
  };

  static bool is_end(Id id) { return id >= kUntouched; }
  static bool is_indexed(Id first) { return !is_end(first) && (first & kIndexed) != 0; }

  /// Returns the number of windows visited.
  template <class Use>
  std::size_t each_in(Id* link, EdgeRange range, Use& use) {
    std::size_t count = 0;
    for (; !range.is_empty() && !is_end(*link); ++count) {
      EdgeWindow& window = windows_[*link];
      if (range.meets({window.begin, window.end})) range = use(window);
      if (window.is_empty()) {
        *link = window.next;
      } else {
        link = &window.next;
      }
    }
    return count;
  }

  void make_index(EdgeId edge) {
    EdgeIndex index;
    for (Id i = first_[edge.index()]; !is_end(i); i = windows_[i].next) {
      index.extents.add({windows_[i].begin, windows_[i].end}, i);
    }
    indices_.push_back(std::move(index));
    first_[edge.index()] = kIndexed | static_cast<Id>(indices_.size() - 1);
  }

  /// Makes bounds with two to four parts per window. The bounds are rebuilt once there are more
  /// windows than parts.
  void bound(EdgeIndex& index, double length) {
    std::size_t parts = 1;
    while (parts < 2 * index.extents.size()) parts *= 2;
    index.bounds.emplace(length, parts);
    index.extents.each([&](Id id) { index.bounds->add(windows_[id]); });
    visited_ += index.extents.size();
  }

  std::vector<Id> first_;  // per edge
  std::vector<EdgeIndex> indices_;
  WindowStore windows_;
  std::vector<EdgeId> touched_;
  std::size_t visited_ = 0;
};

}  // namespace talweg
