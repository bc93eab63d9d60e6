// The queue of windows is ordered by distance, in steps of one width.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace talweg {

/// Items leave in order of floor(key / step), and within one step in the order in which they were
/// pushed. Keys far ahead wait in a separate list. Amortised O(1) for items within kRing steps.
class StepQueue {
 public:
  struct Item {
    double key;
    std::uint32_t id;
    std::uint32_t kind;
  };

  /// Empties the queue; `step` > 0 in the unit of the keys.
  void reset(double step) {
    for (auto& bucket : ring_) bucket.clear();
    later_.clear();
    step_ = step;
    current_ = 0;
    first_later_ = kFarthest;
    taken_ = size_ = 0;
  }

  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] double step() const { return step_; }
  /// Every item in the queue has at least this key; infinite when the queue is empty.
  [[nodiscard]] double front() const {
    return empty() ? std::numeric_limits<double>::infinity()
                   : static_cast<double>(current_) * step_;
  }
  /// Whether an item with this key would leave after the current step.
  [[nodiscard]] bool is_later(double key) const { return number_of(key) > current_; }

  /// A key below front() counts as front().
  void push(const Item& item) {
    ++size_;
    const std::uint64_t number = std::max(number_of(item.key), current_);
    if (number - current_ < kRing) {
      ring_[number % kRing].push_back(item);
    } else {
      later_.push_back(item);
      first_later_ = std::min(first_later_, number);
    }
  }

  /// The item that pop() returns after `count` others, if it is in the current step; otherwise
  /// null.
  [[nodiscard]] const Item* ahead(std::size_t count) const {
    const auto& items = ring_[current_ % kRing];
    return taken_ + count < items.size() ? &items[taken_ + count] : nullptr;
  }

  /// Takes the first item of the current step. If there is none, moves to the next step and returns
  /// false.
  bool pop(Item& item) {
    auto& items = ring_[current_ % kRing];
    if (taken_ < items.size()) {
      item = items[taken_++];
      --size_;
      return true;
    }
    items.clear();
    taken_ = 0;
    advance();
    return false;
  }

 private:
  static constexpr std::uint64_t kRing = 256;
  static constexpr std::uint64_t kFarthest = std::uint64_t{1} << 62U;

  [[nodiscard]] std::uint64_t number_of(double key) const {
    const double number = key / step_;
    return number < static_cast<double>(kFarthest) ? static_cast<std::uint64_t>(number) : kFarthest;
  }

  void advance() {
    ++current_;
    if (later_.empty()) return;
    if (later_.size() == size_) current_ = std::max(current_, first_later_);
    if (first_later_ >= current_ + kRing / 2) return;
    std::vector<Item> items;
    items.swap(later_);
    first_later_ = kFarthest;
    size_ -= items.size();
    for (const Item& item : items) push(item);
  }

  std::array<std::vector<Item>, kRing> ring_;
  std::vector<Item> later_;
  double step_ = 1;
  std::uint64_t current_ = 0;
  std::uint64_t first_later_ = kFarthest;
  std::size_t taken_ = 0;
  std::size_t size_ = 0;
};

}  // namespace talweg
