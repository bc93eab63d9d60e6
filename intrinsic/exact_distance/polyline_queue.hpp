// The queue of windows is ordered by distance, in steps.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace talweg {

/// Items leave in order of their step, and within one step in the order in which they were pushed.
/// The first kEven steps have the same width, the next kEven steps twice that width, and so on:
/// steps that are narrow enough near the sources would be too many far away. Keys far ahead wait in
/// a separate list. Amortised O(1) for items within kRing steps.
class StepQueue {
 public:
  struct Item {
    double key;
    std::uint32_t id;
    std::uint32_t kind;
  };

  /// Empties the queue; `step` > 0, the first width, in the unit of the keys.
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
    return empty() ? std::numeric_limits<double>::infinity() : begin_of(current_);
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
  static constexpr std::uint64_t kEven = 2048;
  static constexpr std::uint64_t kFarthest = std::uint64_t{1} << 62U;

  /// The number of the step that contains a key. Steps are numbered from 0. Steps kEven k to kEven
  /// (k + 1) - 1 are 2^k first widths wide; the first of them begins at kEven (2^k - 1) first
  /// widths.
  [[nodiscard]] std::uint64_t number_of(double key) const {
    constexpr double kWidths = kEven;
    const double widths = std::max(0.0, key / step_);
    if (widths < kWidths) return static_cast<std::uint64_t>(widths);
    if (!std::isfinite(widths)) return kFarthest;
    const int doubling = std::ilogb(widths / kWidths + 1);
    const double beyond = std::ldexp(widths + kWidths, -doubling) - kWidths;
    const double most = kWidths - 1;  // rounding may reach the next doubling
    return kEven * static_cast<std::uint64_t>(doubling) +
           static_cast<std::uint64_t>(std::clamp(beyond, 0.0, most));
  }
  [[nodiscard]] double begin_of(std::uint64_t number) const {
    constexpr double kWidths = kEven;
    const int doubling = static_cast<int>(number / kEven);
    const double beyond = static_cast<double>(number % kEven);
    return (std::ldexp(kWidths + beyond, doubling) - kWidths) * step_;
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
