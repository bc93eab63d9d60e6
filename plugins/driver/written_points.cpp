#include "written_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/drawing/surface_normals.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {
namespace {

[[noreturn]] void bad_resample(const std::string& text) {
  throw Error(ErrorCode::kBadUsage,
              fmt::format("--resample must be a number of points such as 50, or a spacing above 0 "
                          "such as 2.5 (mesh units) or 2mm, not \"{}\".",
                          text));
}

bool is_of_unit(char c) {
  return (c >= 'a' && c <= 'z' && c != 'e') || static_cast<unsigned char>(c) >= 0x80;
}

/// A whole number is a number of points; a number with a point, an exponent or a unit is a spacing.
EvenPoints even_points(const std::string& text, const CoordinateFrame& frame) {
  const bool whole = text.find_first_not_of("0123456789") == text.npos;
  EvenPoints even;
  if (whole) {
    std::int64_t count = 0;
    constexpr std::int64_t kMost = kMostEvenPoints;
    if (!parse(text, count) || count < 2 || count > kMost) bad_resample(text);
    even.count = static_cast<std::size_t>(count);
    return even;
  }
  const auto unit = std::find_if(text.begin(), text.end(), is_of_unit);
  const std::string code(unit, text.end());
  if (!parse(std::string(text.begin(), unit), even.spacing)) bad_resample(text);
  if (!code.empty()) even.spacing *= LengthUnit::named(code).in(frame.unit);
  if (!(even.spacing > 0 && even.spacing < HUGE_VAL)) bad_resample(text);
  return even;
}

}  // namespace

void add_point_options(CLI::App& app, WrittenPoints& points) {
  app.add_option("--resample", points.resample,
                 "Write evenly spaced points instead of the curve's own: their number, such as 50, "
                 "or their spacing, such as 2.5 (mesh units) or 2mm");
  app.add_flag("--normals", points.normals,
               "Also write the surface's normal at each point (.vtp, .vtk, .ply, .json, and as "
               "orientation in .mrk.json)");
}

void check_points(const WrittenPoints& points) {
  if (!points.resample.empty()) even_points(points.resample, {});
}

ReadyCurve ready(const SurfaceMesh& mesh, const SurfaceCurve& curve, std::size_t number,
                 const WrittenPoints& points, const CoordinateFrame& frame) {
  ReadyCurve made;
  if (points.resample.empty()) {
    made.curve = place(mesh, curve, number);
  } else {
    ResampledCurve even = resampled(mesh, curve, even_points(points.resample, frame));
    made.curve = std::move(even.curve);
    made.spacing = even.spacing;
  }
  if (points.normals) set_normals(mesh, made.curve);
  return made;
}

std::string spacing_text(const ReadyCurve& curve) {
  return fmt::format("{} points, {} apart", curve.curve.positions.size(),
                     mesh_units_text(curve.spacing.value_or(0), 6));
}

}  // namespace talweg::driver
