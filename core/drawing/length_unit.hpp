// A length unit has a code, as files name it, and a size in metres.
#pragma once

#include <string>
#include <string_view>

namespace talweg {

/// A unit of length; a millimetre unless named otherwise.
class LengthUnit {
 public:
  LengthUnit() = default;

  /// The unit with this UCUM code: pm, nm, um, mm, cm, dm, m, km, [in_i] (inch) or [ft_i] (foot);
  /// µm, in and ft are accepted too. Throws Error(kBadUsage) that lists these codes.
  static LengthUnit named(std::string_view code);

  [[nodiscard]] const std::string& code() const { return code_; }
  /// The size of this unit in units of `other`; exactly 1 for the same unit.
  [[nodiscard]] double in(const LengthUnit& other) const {
    return code_ == other.code_ ? 1.0 : millimetres_ / other.millimetres_;
  }

 private:
  LengthUnit(const char* code, double millimetres) : code_(code), millimetres_(millimetres) {}

  std::string code_ = "mm";
  double millimetres_ = 1;
};

}  // namespace talweg
