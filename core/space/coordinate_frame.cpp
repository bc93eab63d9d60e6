#include "talweg/core/space/coordinate_frame.hpp"

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

PatientSpace space_named(std::string_view name) {
  if (name == "LPS") return PatientSpace::kLps;
  return name == "RAS" ? PatientSpace::kRas : PatientSpace::kNotSaid;
}

}  // namespace

LengthUnit LengthUnit::named(std::string_view code) {
  for (const KnownUnit& unit : kUnits) {
    if (unit.name == code) return {unit.code, unit.millimetres};
  }
  throw Error(ErrorCode::kBadUsage,
              fmt::format("\"{}\" is not a known unit of length; known are pm, nm, um, mm, cm, "
                          "dm, m, km, in and ft.",
                          code.substr(0, 40)));
}

CoordinateFrame frame_named(std::string_view text) {
  CoordinateFrame frame;
  const std::size_t blank = text.rfind(' ');
  const std::string_view last = blank == text.npos ? text : text.substr(blank + 1);
  frame.space = space_named(last);
  if (frame.space != PatientSpace::kNotSaid) {
    text = blank == text.npos ? std::string_view() : text.substr(0, blank);
  } else if (blank != text.npos) {
    throw Error(ErrorCode::kBadUsage,
                fmt::format("\"{}\" is not a space of coordinates; known are LPS and RAS.",
                            last.substr(0, 40)));
  }
  if (!text.empty()) frame.unit = LengthUnit::named(text);
  return frame;
}

std::string frame_text(const std::optional<LengthUnit>& unit, PatientSpace space) {
  std::string text = unit ? unit->code() : std::string();
  if (unit && space != PatientSpace::kNotSaid) text += ' ';
  return text.append(space_name(space));
}

}  // namespace talweg
