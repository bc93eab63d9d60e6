// A coordinate frame is the unit of the coordinates in a file and the directions of their axes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

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

/// The space of coordinates of a patient, as 3D Slicer names it: x grows to the left and y to the
/// back (LPS), or x to the right and y to the front (RAS). z grows upwards in both.
enum class PatientSpace : std::uint8_t { kNotSaid, kLps, kRas };

/// The name of a space in files: "LPS", "RAS", or "" for kNotSaid.
constexpr std::string_view space_name(PatientSpace space) {
  if (space == PatientSpace::kNotSaid) return "";
  return space == PatientSpace::kLps ? "LPS" : "RAS";
}

/// The frame of a mesh. A mesh that names no space is taken to be in LPS, as 3D Slicer takes it.
struct CoordinateFrame {
  CoordinateFrame() = default;
  CoordinateFrame(LengthUnit of_unit, PatientSpace of_space = PatientSpace::kNotSaid)
      : unit(std::move(of_unit)), space(of_space) {}

  LengthUnit unit;
  PatientSpace space = PatientSpace::kNotSaid;

  /// Whether x and y of positions in `other` change their sign in this frame.
  [[nodiscard]] bool turns(PatientSpace other) const {
    return other != PatientSpace::kNotSaid &&
           (other == PatientSpace::kRas) != (space == PatientSpace::kRas);
  }
};

/// The frame that a text names: a unit (LengthUnit::named), a space, or both ("mm RAS"). An empty
/// text means millimetres and kNotSaid. Throws Error(kBadUsage) that lists the known names.
CoordinateFrame frame_named(std::string_view text);
/// The unit and the space that a mesh names, as a text for frame_named(); empty if it names
/// neither.
std::string frame_text(const std::optional<LengthUnit>& unit, PatientSpace space);

}  // namespace talweg
