// The window store holds all windows by number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "talweg/intrinsic/exact_distance/polyline_window.hpp"

namespace talweg {

/// Windows are stored in blocks and never move: a growing vector would for a moment hold millions
/// of windows twice.
class WindowStore {
 public:
  using Id = std::uint32_t;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] EdgeWindow& operator[](Id id) { return blocks_[id / kOfBlock][id % kOfBlock]; }
  [[nodiscard]] const EdgeWindow& operator[](Id id) const {
    return blocks_[id / kOfBlock][id % kOfBlock];
  }

  Id add(const EdgeWindow& window) {
    if (size_ == blocks_.size() * kOfBlock) {
      blocks_.push_back(std::make_unique<EdgeWindow[]>(kOfBlock));
    }
    const auto id = static_cast<Id>(size_++);
    (*this)[id] = window;
    return id;
  }

  /// Removes all windows and keeps the memory.
  void clear() { size_ = 0; }

 private:
  static constexpr std::size_t kOfBlock = 4096;

  std::vector<std::unique_ptr<EdgeWindow[]>> blocks_;
  std::size_t size_ = 0;
};

}  // namespace talweg
