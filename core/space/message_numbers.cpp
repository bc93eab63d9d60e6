#include "talweg/core/space/message_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace talweg {
namespace {

constexpr double kAllDigits = 17;  // these tell any two doubles apart
constexpr double kUnknown = std::numeric_limits<double>::infinity();

std::string coordinate_text(double x, double decimals) {
  if (x == 0) return "0";  // without the sign of -0
  const double digits = std::floor(std::log10(std::abs(x))) + 1 + decimals;
  if (digits < 1) return "0";
  if (!(digits < kAllDigits)) return fmt::format("{}", x);  // the fewest that read back exactly
  return fmt::format("{:.{}g}", x, static_cast<int>(digits));
}

}  // namespace

std::string position_text(const Point& at, double edge) {
  // A unit has three decimals more than an edge of its size; whole numbers are never rounded.
  const double decimals =
      edge > 0 && std::isfinite(edge) ? std::max(0.0, 3 - std::floor(std::log10(edge))) : kUnknown;
  return fmt::format("({}, {}, {})", coordinate_text(at.x(), decimals),
                     coordinate_text(at.y(), decimals), coordinate_text(at.z(), decimals));
}

std::string count_text(std::size_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t k = digits.size(); k > 3; k -= 3) digits.insert(k - 3, 1, ',');
  return digits;
}

}  // namespace talweg
