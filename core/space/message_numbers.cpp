#include "talweg/core/space/message_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace talweg {
namespace {

constexpr double kAllDigits = 17;  // these tell any two doubles apart
constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr double kExponentFrom = 1e15;   // longer lengths are written with an exponent
constexpr double kLeastFraction = 1e-6;  // least fraction of the upper bound that a lower bound has

std::string with_commas(std::string digits) {
  for (std::size_t k = digits.size(); k > 3; k -= 3) digits.insert(k - 3, 1, ',');
  return digits;
}

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

std::string count_text(std::size_t count) { return with_commas(std::to_string(count)); }

std::string length_text(double length, int digits) {
  // Lengths of 10^(digits - 1) or more have no decimals; 0.05 is half of the last decimal below.
  const double whole_from = std::pow(10, digits - 1) - 0.05;
  const bool is_whole = length >= whole_from && length < kExponentFrom;
  return is_whole ? with_commas(fmt::format("{:.0f}", length))
                  : fmt::format("{:.{}g}", length, digits);
}

std::string mesh_units_text(double length, int digits) {
  const std::string text = length_text(length, digits);
  return text + (text == "1" ? " mesh unit" : " mesh units");
}

std::string bounds_text(double least, double most) {
  constexpr int kDigits = 6;
  std::string at_least = "at least " + length_text(least, kDigits);
  if (std::isinf(most)) return at_least;
  const std::string at_most = "at most " + length_text(most, kDigits);
  return least >= kLeastFraction * most ? at_most + " and " + at_least : at_most;
}

}  // namespace talweg
