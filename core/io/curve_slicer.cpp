// 3D Slicer markups (.mrk.json, schema 1.0.3).
#include <algorithm>

#include <fmt/format.h>

#include "talweg/core/drawing/length_unit.hpp"
#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/json_place.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/word_scanner.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::formats {
namespace {

/// True if x and y change their sign: our mesh is taken to be in LPS, as Slicer writes meshes.
bool is_flipped(const JsonPlace& markup) {
  if (!markup.has("coordinateSystem")) return false;
  const JsonPlace system = markup.member("coordinateSystem");
  const std::string name = system.string();
  if (name != "LPS" && name != "RAS") {
    system.fail("expected \"LPS\" or \"RAS\", found \"" + printable(name) + "\"");
  }
  return name == "RAS";
}

/// Reads a code like "mm", or a coded entry: code, coding scheme, meaning. Millimetres if there is
/// none.
LengthUnit unit_of(const JsonPlace& markup) {
  if (!markup.has("coordinateUnits")) return {};
  JsonPlace code = markup.member("coordinateUnits");
  if (code.is_array()) {
    if (code.size() < 2) code.fail("expected a code and its coding scheme");
    const JsonPlace scheme = code.element(1);
    if (scheme.string() != "UCUM") {
      scheme.fail("expected \"UCUM\", found \"" + printable(scheme.string()) + "\"");
    }
    code = code.element(0);
  }
  try {
    return LengthUnit::named(code.string());
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kBadUsage) throw;
    code.fail("expected a unit of length such as \"mm\", \"cm\" or \"um\", found \"" +
              printable(code.string()) + "\"");
  }
}

CurveInput read_markup(const JsonPlace& markup, bool closed, const LengthUnit& mesh_unit) {
  CurveInput result;
  result.closed = closed;
  const double scale = unit_of(markup).in(mesh_unit);
  const double sign = is_flipped(markup) ? -scale : scale;
  const JsonPlace controls = markup.member("controlPoints");
  std::vector<Point> positions;
  for (std::size_t k = 0; k < controls.size(); ++k) {
    const JsonPlace control = controls.element(k);
    if (control.has("positionStatus") && control.member("positionStatus").string() != "defined") {
      continue;
    }
    const std::array<double, 3> p = control.member("position").triple();
    if (control.has("locked") && control.member("locked").boolean()) {
      result.pins.push_back(positions.size());
    }
    positions.emplace_back(sign * p[0], sign * p[1], scale * p[2]);
    if (!positions.back().allFinite()) {
      control.member("position").fail("a coordinate is too large in the unit of the mesh");
    }
  }
  if (positions.empty()) controls.fail("expected at least one point with a defined position");
  result.points = std::move(positions);
  result.control_points = true;
  return result;
}

}  // namespace

std::vector<CurveInput> read_slicer(const JsonPlace& root, const LengthUnit& mesh_unit) {
  const JsonPlace markups = root.member("markups");
  std::vector<CurveInput> curves;
  std::string other;
  for (std::size_t k = 0; k < markups.size(); ++k) {
    const JsonPlace markup = markups.element(k);
    const std::string type = markup.member("type").string();
    if (type == "Curve" || type == "ClosedCurve") {
      curves.push_back(read_markup(markup, type == "ClosedCurve", mesh_unit));
    } else if (other.empty()) {
      other = " (the first is a " + printable(type) + ")";
    }
  }
  if (curves.empty()) markups.fail("expected a Curve or ClosedCurve among the markups" + other);
  return curves;
}

std::string write_slicer(std::span<const PlacedCurve> curves, const LengthUnit& unit) {
  fmt::memory_buffer out;
  const auto to = fmt::appender(out);
  fmt::format_to(
      to,
      "{{\n\"@schema\": \"https://raw.githubusercontent.com/slicer/slicer/master/Modules/"
      "Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json#\",\n"
      "\"markups\": [");
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const PlacedCurve& curve = curves[c];
    fmt::format_to(to,
                   "{}\n{{\"type\": \"{}\", \"coordinateSystem\": \"LPS\", \"coordinateUnits\": "
                   "\"{}\", \"locked\": false, \"fixedNumberOfControlPoints\": false, "
                   "\"labelFormat\": \"%N-%d\", \"lastUsedControlPointNumber\": {}, "
                   "\"controlPoints\": [",
                   c > 0 ? "," : "", curve.closed ? "ClosedCurve" : "Curve", unit.code(),
                   curve.positions.size());
    for (std::size_t k = 0; k < curve.positions.size(); ++k) {
      const Point& p = curve.positions[k];
      fmt::format_to(to,
                     "{}\n  {{\"id\": \"{}\", \"label\": \"\", \"description\": \"\", "
                     "\"associatedNodeID\": \"\", \"position\": [{:.17g}, {:.17g}, {:.17g}], "
                     "\"selected\": true, \"locked\": {}, \"visibility\": true, "
                     "\"positionStatus\": \"defined\"}}",
                     k > 0 ? "," : "", k + 1, p.x(), p.y(), p.z(),
                     std::binary_search(curve.pins.begin(), curve.pins.end(), k));
    }
    fmt::format_to(to, "\n]}}");
  }
  fmt::format_to(to, "\n]\n}}\n");
  return fmt::to_string(out);
}

}  // namespace talweg::formats
