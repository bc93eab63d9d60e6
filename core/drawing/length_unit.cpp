#include "talweg/core/drawing/length_unit.hpp"

#include <fmt/format.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

struct KnownUnit {
  std::string_view name;
  const char* code;
  double millimetres;
};

constexpr KnownUnit kUnits[] = {{"pm", "pm", 1e-9},
                                {"nm", "nm", 1e-6},
                                {"um", "um", 1e-3},
                                {"mm", "mm", 1},
                                {"cm", "cm", 10},
                                {"dm", "dm", 100},
                                {"m", "m", 1e3},
                                {"km", "km", 1e6},
                                {"[in_i]", "[in_i]", 25.4},
                                {"in", "[in_i]", 25.4},
                                {"[ft_i]", "[ft_i]", 304.8},
                                {"ft", "[ft_i]", 304.8},
                                // Both the micro sign and the letter mu are accepted.
                                {"\xC2\xB5m", "um", 1e-3},
                                {"\xCE\xBCm", "um", 1e-3}};

}  // namespace

LengthUnit LengthUnit::named(std::string_view code) {
  for (const KnownUnit& unit : kUnits) {
    if (unit.name == code) return {unit.code, unit.millimetres};
  }
  throw Error(
      ErrorCode::kBadUsage,
      fmt::format("\"{}\" is no unit of length that is known; known are pm, nm, um, mm, cm, "
                  "dm, m, km, in and ft.",
                  code.substr(0, 40)));
}

}  // namespace talweg
