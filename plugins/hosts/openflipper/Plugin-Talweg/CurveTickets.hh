// Stores which curves each request to the thread is about, since the drawing may have changed
// before its outcome.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "talweg/editing/drawing.hpp"

namespace talweg::openflipper {

class CurveTickets {
 public:
  /// Stores a request about the curves of the drawing with two points or more.
  void asked(std::uint64_t ticket, const editing::Drawing& drawing) {
    std::vector<std::uint32_t>& numbers = numbers_[ticket];
    for (const auto& curve : drawing.curves) {
      if (curve->points.size() >= 2) numbers.push_back(curve->number);
    }
  }
  /// The numbers of the request's curves, in the order of its outcome. Removes the request and all
  /// earlier ones.
  std::vector<std::uint32_t> take(std::uint64_t ticket) {
    const auto found = numbers_.find(ticket);
    if (found == numbers_.end()) return {};
    std::vector<std::uint32_t> numbers = std::move(found->second);
    numbers_.erase(numbers_.begin(), std::next(found));
    return numbers;
  }
  void clear() { numbers_.clear(); }

 private:
  std::map<std::uint64_t, std::vector<std::uint32_t>> numbers_;
};

/// The index of the curve with this number in a drawing; nothing if the drawing does not have the
/// curve.
inline std::optional<std::size_t> index_of(const editing::Drawing& drawing, std::uint32_t number) {
  const auto& curves = drawing.curves;
  const auto at = std::find_if(curves.begin(), curves.end(),
                               [number](const auto& curve) { return curve->number == number; });
  if (at == curves.end()) return std::nullopt;
  return static_cast<std::size_t>(at - curves.begin());
}

}  // namespace talweg::openflipper
