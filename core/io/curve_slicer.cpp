// 3D Slicer markups (.mrk.json, schema 1.0.3).
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/json_place.hpp"
#include "talweg/core/io/space_note.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/word_scanner.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::formats {
namespace {

/// The space of a markup; LPS by default, as in the schema. Early files have the numbers of an
/// enum.
PatientSpace space_of(const JsonPlace& markup) {
  if (!markup.has("coordinateSystem")) return PatientSpace::kLps;
  const JsonPlace system = markup.member("coordinateSystem");
  const std::string name = system.string();
  if (name == "LPS" || name == "1") return PatientSpace::kLps;
  if (name == "RAS" || name == "0") return PatientSpace::kRas;
  system.fail("expected \"LPS\" or \"RAS\", found \"" + printable(name) + "\"");
}

/// The unit of a markup: a code like "mm", or a coded entry (code, coding scheme, meaning).
/// Millimetres by default.
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

std::vector<Point> positions_of(const JsonPlace& controls, const CoordinateFrame& from,
                                const CoordinateFrame& to, CurveInput& curve) {
  const double scale = from.unit.in(to.unit);
  const double sign = to.turns(from.space) ? -scale : scale;
  std::vector<Point> positions;
  for (std::size_t k = 0; k < controls.size(); ++k) {
    const JsonPlace control = controls.element(k);
    if (control.has("positionStatus") && control.member("positionStatus").string() != "defined") {
      continue;
    }
    const std::array<double, 3> p = control.member("position").triple();
    if (control.has("locked") && control.member("locked").boolean()) {
      curve.pins.push_back(positions.size());
    }
    positions.emplace_back(sign * p[0], sign * p[1], scale * p[2]);
    if (!positions.back().allFinite()) {
      control.member("position").fail("a coordinate is too large in the unit of the mesh");
    }
  }
  return positions;
}

/// The control points of a markup in the frame of the mesh.
CurveInput read_markup(const JsonPlace& markup, bool closed, const Source& source) {
  CurveInput result;
  result.closed = closed;
  const CoordinateFrame from{unit_of(markup), space_of(markup)};
  const JsonPlace controls = markup.member("controlPoints");
  std::vector<Point> positions = positions_of(controls, from, source.frame, result);
  if (positions.empty()) controls.fail("expected at least one point with a defined position");
  const std::string converted = conversion(source.path, from, source.frame);
  if (!converted.empty()) result.notes.push_back(converted);
  if (positions.size() < controls.size()) {
    result.notes.push_back(
        left_out(source.path, controls.size() - positions.size(), controls.size()));
  }
  result.points = std::move(positions);
  result.control_points = true;
  return result;
}

/// Keeps a sentence only at the first curve that has it.
void tell_once(std::vector<CurveInput>& curves) {
  std::vector<std::string> said;
  for (CurveInput& curve : curves) {
    std::erase_if(curve.notes, [&](const std::string& sentence) {
      const bool again = std::find(said.begin(), said.end(), sentence) != said.end();
      if (!again) said.push_back(sentence);
      return again;
    });
  }
}

/// The member `orientation`: a matrix whose third column is the normal. Empty for a curve without
/// normals.
std::string orientation(const PlacedCurve& curve, std::size_t k, double sign) {
  if (curve.normals.size() != curve.positions.size()) return {};
  const Point n(sign * curve.normals[k].x(), sign * curve.normals[k].y(), curve.normals[k].z());
  if (!(n.norm() > 0)) return {};
  const Point x = n.unitOrthogonal(), y = n.cross(x);
  std::vector<double> rows;
  for (int r = 0; r < 3; ++r) rows.insert(rows.end(), {x[r], y[r], n[r]});
  return fmt::format("\"orientation\": [{:.17g}], ", fmt::join(rows, ", "));
}

}  // namespace

std::vector<CurveInput> read_slicer(const JsonPlace& root, const Source& source) {
  const JsonPlace markups = root.member("markups");
  std::vector<CurveInput> curves;
  std::string other;
  for (std::size_t k = 0; k < markups.size(); ++k) {
    const JsonPlace markup = markups.element(k);
    const std::string type = markup.member("type").string();
    if (type == "Curve" || type == "ClosedCurve") {
      curves.push_back(read_markup(markup, type == "ClosedCurve", source));
    } else if (other.empty()) {
      other = " (the first is a " + printable(type) + ")";
    }
  }
  if (curves.empty()) markups.fail("expected a Curve or ClosedCurve among the markups" + other);
  tell_once(curves);
  return curves;
}

CurveInput read_slicer_clicks(const JsonPlace& root, const Source& source) {
  const JsonPlace markups = root.member("markups");
  if (markups.size() != 1) {
    markups.fail(fmt::format("expected one list of points, found {} markups", markups.size()));
  }
  const JsonPlace markup = markups.element(0);
  const std::string type = markup.member("type").string();
  constexpr std::array kOfPoints = {"Fiducial", "PointList", "Line", "Curve", "ClosedCurve"};
  if (std::find(kOfPoints.begin(), kOfPoints.end(), type) == kOfPoints.end()) {
    markup.fail("expected a Fiducial, PointList, Line, Curve or ClosedCurve, found a " +
                printable(type));
  }
  return read_markup(markup, type == "ClosedCurve", source);
}

std::string write_slicer(std::span<const PlacedCurve> curves, const CoordinateFrame& frame) {
  const double sign = frame.turns(PatientSpace::kLps) ? -1 : 1;
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
                   c > 0 ? "," : "", curve.closed ? "ClosedCurve" : "Curve", frame.unit.code(),
                   curve.positions.size());
    for (std::size_t k = 0; k < curve.positions.size(); ++k) {
      const Point& p = curve.positions[k];
      fmt::format_to(to,
                     "{}\n  {{\"id\": \"{}\", \"label\": \"\", \"description\": \"\", "
                     "\"associatedNodeID\": \"\", \"position\": [{:.17g}, {:.17g}, {:.17g}], {}"
                     "\"selected\": true, \"locked\": {}, \"visibility\": true, "
                     "\"positionStatus\": \"defined\"}}",
                     k > 0 ? "," : "", k + 1, sign * p.x(), sign * p.y(), p.z(),
                     orientation(curve, k, sign),
                     std::binary_search(curve.pins.begin(), curve.pins.end(), k));
    }
    fmt::format_to(to, "\n]}}");
  }
  fmt::format_to(to, "\n]\n}}\n");
  return fmt::to_string(out);
}

}  // namespace talweg::formats
