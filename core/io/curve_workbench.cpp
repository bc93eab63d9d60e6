// Border files of connectome-workbench: points between the vertices of a surface.
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/word_scanner.hpp"
#include "talweg/core/io/xml_text.hpp"

namespace talweg::formats {
namespace {

class BorderReader {
 public:
  explicit BorderReader(const Source& source) : source_(source) {
    load_xml(document_, source.path, source.bytes);
  }

  std::vector<CurveInput> read() {
    const pugi::xml_node root = document_.child("BorderFile");
    if (!root) fail(root, "expected <BorderFile>");
    const std::string_view version = root.attribute("Version").value();
    if (version != "3") {
      fail(root, fmt::format("it is of version '{}'; expected 3, which wb_command -file-convert "
                             "-border-version-convert writes",
                             printable(version)));
    }
    vertices_ = root.attribute("SurfaceNumberOfVertices").as_llong(-1);
    if (vertices_ < 1 || vertices_ > kMostVertices) {
      fail(root, "expected the number of vertices as SurfaceNumberOfVertices");
    }
    for (const pugi::xml_node group : root.children("Class")) {
      for (const pugi::xml_node border : group.children("Border")) {
        for (const pugi::xml_node part : border.children("BorderPart")) read_part(part);
      }
    }
    if (curves_.empty()) cannot_read(source_.path, "it has no <BorderPart>, so it holds no curves");
    return std::move(curves_);
  }

 private:
  static constexpr std::int64_t kMostVertices = 0xFFFFFFFE;

  void read_part(const pugi::xml_node& part) {
    const std::string_view closed = part.attribute("Closed").value();
    if (closed != "True" && closed != "False") fail(part, "expected Closed to be True or False");
    const std::vector<double> vertices = numbers(part, "Vertices");
    const std::vector<double> weights = numbers(part, "Weights");
    if (vertices.size() != weights.size() || vertices.size() % 3 != 0) {
      fail(part, fmt::format("expected three vertices and three weights for each point, found {} "
                             "and {}",
                             vertices.size(), weights.size()));
    }
    if (vertices.empty()) fail(part, "it has no points");
    std::vector<CornerCoordinates> points(vertices.size() / 3);
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const double v = vertices[k];
      if (!(v >= 0 && v < static_cast<double>(vertices_) && v == std::floor(v))) {
        fail(part, fmt::format("point {}: there is no vertex {:.17g} (the surface has {})", k / 3,
                               v, vertices_));
      }
      if (!(weights[k] >= 0 && std::isfinite(weights[k]))) {
        fail(part, fmt::format("point {}: expected a weight of 0 or more, found {:.17g}", k / 3,
                               weights[k]));
      }
      points[k / 3].corners[k % 3] = VertexId{static_cast<std::size_t>(v)};
      points[k / 3].weights[k % 3] = weights[k];
    }
    CurveInput& curve = curves_.emplace_back();
    curve.closed = closed == "True";
    curve.points = std::move(points);
  }

  [[nodiscard]] std::vector<double> numbers(const pugi::xml_node& part, const char* name) const {
    const pugi::xml_node node = part.child(name);
    if (!node) fail(part, fmt::format("expected <{}>", name));
    WordScanner words(source_.path, node.child_value());
    std::vector<double> result;
    for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
      double value = 0;
      if (!parse(word, value)) fail(node, "expected a number, found '" + printable(word) + "'");
      result.push_back(value);
    }
    return result;
  }

  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& what) const {
    const std::ptrdiff_t offset = node ? node.offset_debug() : 0;
    const std::size_t at = offset > 0 ? static_cast<std::size_t>(offset) : 0;
    cannot_read(source_.path, fmt::format("line {}, <{}>: {}", line_of(source_.bytes, at),
                                          printable(node.name()), what));
  }

  const Source& source_;
  pugi::xml_document document_;
  std::int64_t vertices_ = 0;
  std::vector<CurveInput> curves_;
};

/// The structure that the file's name gives: "lh.", ".L." and the like.
const char* structure_of(const std::filesystem::path& path) {
  const std::string name = "." + path.filename().string();
  const auto has = [&](const char* part) { return name.find(part) != name.npos; };
  if (has(".lh.") || has(".L.") || has("hemi-L")) return "CORTEX_LEFT";
  if (has(".rh.") || has(".R.") || has("hemi-R")) return "CORTEX_RIGHT";
  return "CORTEX";
}

void put_part(std::string& text, const PlacedCurve& curve) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "<BorderPart Closed=\"{}\">\n<Vertices>", curve.closed ? "True" : "False");
  for (const auto& [a, b, c] : curve.corners) {
    fmt::format_to(out, "{} {} {}\n", a.index(), b.index(), c.index());
  }
  fmt::format_to(out, "</Vertices>\n<Weights>");
  for (const FaceCoordinates& at : curve.faces) {
    const auto& [a, b, c] = at.barycentric;
    fmt::format_to(out, "{:.17g} {:.17g} {:.17g}\n", a, b, c);
  }
  fmt::format_to(out, "</Weights>\n</BorderPart>\n");
}

/// The name of the border of a curve. Curves with the same name become parts of one border.
std::string name_of(std::size_t curve, Sides sides) {
  if (sides.empty()) return fmt::format("curve_{}", curve);
  return fmt::format("{}_{}", sides[curve].left, sides[curve].right);
}

}  // namespace

std::vector<CurveInput> read_workbench(const Source& source) { return BorderReader(source).read(); }

std::string write_workbench(const std::filesystem::path& path, std::span<const PlacedCurve> curves,
                            Sides sides) {
  for (const PlacedCurve& curve : curves) {
    if (curve.corners.size() == curve.faces.size() && curve.vertex_count > 0) continue;
    cannot_write(path,
                 "a .border names the vertices around each point, and the mesh is not known here");
  }
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<BorderFile Version=\"3\" Structure=\"{}\" "
      "SurfaceNumberOfVertices=\"{}\">\n<Class Name=\"talweg\" Red=\"1\" Green=\"0\" Blue=\"0\">\n",
      structure_of(path), curves.front().vertex_count);
  std::vector<std::pair<std::string, std::vector<std::size_t>>> borders;
  std::map<std::string, std::size_t> number;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::string name = name_of(c, sides);
    const auto [at, is_new] = number.try_emplace(name, borders.size());
    if (is_new) borders.emplace_back(name, std::vector<std::size_t>{});
    borders[at->second].second.push_back(c);
  }
  for (const auto& [name, parts] : borders) {
    text += fmt::format("<Border Name=\"{}\" Red=\"0\" Green=\"0\" Blue=\"0\">\n", name);
    for (const std::size_t c : parts) put_part(text, curves[c]);
    text += "</Border>\n";
  }
  return text + "</Class>\n</BorderFile>\n";
}

}  // namespace talweg::formats
