// Curve tickets remember of which curves the thread's outcomes are: the drawing has gone on since.
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
  /// A request about those curves of the drawing that have two points or more.
  void asked(std::uint64_t ticket, const editing::Drawing& drawing) {
    std::vector<std::uint32_t>& numbers = numbers_[ticket];
    for (const auto& curve : drawing.curves) {
      if (curve->points.size() >= 2) numbers.push_back(curve->number);
    }
  }
  /// The numbers of its curves, in the order of the outcome's. Requests before it, and it, are
  /// forgotten.
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

/// Where a drawing has the curve with that number; nothing if it has none.
inline std::optional<std::size_t> index_of(const editing::Drawing& drawing, std::uint32_t number) {
  const auto& curves = drawing.curves;
  const auto at = std::find_if(curves.begin(), curves.end(),
                               [number](const auto& curve) { return curve->number == number; });
  if (at == curves.end()) return std::nullopt;
  return static_cast<std::size_t>(at - curves.begin());
}

}  // namespace talweg::openflipper
