// Talweg's JSON: faces, barycentrics and positions, without loss.
#include <algorithm>

#include <fmt/format.h>

#include "talweg/core/drawing/point_marks.hpp"
#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/json_place.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg::formats {
namespace {

constexpr std::uint32_t kVersion = 1;

/// The mark of the member `exact`: true for a click, a tolerance for an inexact click, false for a
/// painted point.
double mark_of(const JsonPlace& exact) {
  if (exact.is_boolean()) return exact.boolean() ? 0 : kPainted;
  constexpr const char* kExpected = "expected true, false or a tolerance of 0 or more, mesh units";
  if (!exact.is_number() || !(exact.number() >= 0)) exact.fail(kExpected);
  return exact.number();
}

/// The member `exact`; empty for a point without a mark.
std::string exact_member(const PlacedCurve& curve, std::size_t k) {
  const double mark = curve.exact.empty() ? kNotSaid : curve.exact[k];
  if (mark == kPainted) return ", \"exact\": false";
  if (!(mark >= 0)) return {};
  return mark == 0 ? ", \"exact\": true" : fmt::format(", \"exact\": {:.17g}", mark);
}

/// The member `pinned`; empty for a point that is not a pin.
std::string pinned_member(const PlacedCurve& curve, std::size_t k) {
  return std::binary_search(curve.pins.begin(), curve.pins.end(), k) ? ", \"pinned\": true" : "";
}

/// The member `normal`; empty for a curve without normals.
std::string normal_member(const PlacedCurve& curve, std::size_t k) {
  if (curve.normals.size() != curve.positions.size()) return {};
  const Point& n = curve.normals[k];
  return fmt::format(", \"normal\": [{:.17g}, {:.17g}, {:.17g}]", n.x(), n.y(), n.z());
}

CurveInput read_curve(const JsonPlace& curve) {
  CurveInput result;
  result.closed = curve.member("closed").boolean();
  const JsonPlace points = curve.member("points");
  std::vector<FaceCoordinates> coordinates;
  std::vector<double> marks;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const JsonPlace point = points.element(k);
    coordinates.push_back(
        {FaceId{point.member("face").index()}, point.member("barycentric").triple()});
    // Face and barycentrics give the position, so `xyz` is only checked.
    if (point.has("xyz")) static_cast<void>(point.member("xyz").triple());
    if (point.has("pinned") && point.member("pinned").boolean()) result.pins.push_back(k);
    marks.push_back(point.has("exact") ? mark_of(point.member("exact")) : kNotSaid);
  }
  if (coordinates.empty()) points.fail("expected at least one point");
  result.points = std::move(coordinates);
  set_marks(result, marks);
  return result;
}

}  // namespace

std::vector<CurveInput> read_json(const Source& source) {
  const nlohmann::json document = parsed_json(source);
  const JsonPlace root(source.path, document, "");
  if (root.has("markups")) return read_slicer(root, source);
  const JsonPlace format = root.member("format");
  if (format.string() != "talweg-curves") {
    format.fail("expected \"talweg-curves\", found \"" + printable(format.string()) + "\"");
  }
  const JsonPlace version = root.member("version");
  if (version.index() != kVersion) {
    version.fail(fmt::format("this program reads version {}, and the file is of version {}",
                             kVersion, version.index()));
  }
  const JsonPlace curves = root.member("curves");
  std::vector<CurveInput> result;
  for (std::size_t k = 0; k < curves.size(); ++k) result.push_back(read_curve(curves.element(k)));
  if (result.empty()) curves.fail("expected at least one curve");
  return result;
}

std::string write_json(std::span<const PlacedCurve> curves, Sides sides) {
  fmt::memory_buffer out;
  const auto to = fmt::appender(out);
  fmt::format_to(to, "{{\"format\": \"talweg-curves\", \"version\": {}, \"curves\": [", kVersion);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const PlacedCurve& curve = curves[c];
    fmt::format_to(to, "{}\n{{\"closed\": {}, ", c > 0 ? "," : "", curve.closed);
    if (!sides.empty()) {
      fmt::format_to(to, "\"left\": {}, \"right\": {}, ", sides[c].left, sides[c].right);
    }
    fmt::format_to(to, "\"points\": [");
    for (std::size_t k = 0; k < curve.faces.size(); ++k) {
      const auto& b = curve.faces[k].barycentric;
      const Point& p = curve.positions[k];
      fmt::format_to(to,
                     "{}\n  {{\"face\": {}, \"barycentric\": [{:.17g}, {:.17g}, {:.17g}], "
                     "\"xyz\": [{:.17g}, {:.17g}, {:.17g}]{}{}{}}}",
                     k > 0 ? "," : "", curve.faces[k].face.index(), b[0], b[1], b[2], p.x(), p.y(),
                     p.z(), exact_member(curve, k), pinned_member(curve, k),
                     normal_member(curve, k));
    }
    fmt::format_to(to, "\n]}}");
  }
  fmt::format_to(to, "\n]}}\n");
  return fmt::to_string(out);
}

}  // namespace talweg::formats
