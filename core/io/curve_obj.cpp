// Wavefront OBJ: `v` and `l`.
#include <limits>

#include <fmt/format.h>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/polylines.hpp"
#include "talweg/core/io/space_note.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg::formats {
namespace {

constexpr auto kMostPoints = std::int64_t{std::numeric_limits<std::uint32_t>::max()};

/// The points of an `l` statement, and its line in the file.
struct ObjLine {
  Line points;
  std::size_t line = 0;
};

Point read_vertex(WordScanner& scanner) {
  Point p;
  for (int k = 0; k < 3; ++k) p[k] = scanner.number(scanner.word_on_line(), "a coordinate");
  return p;
}

/// Reads an `l` statement. Indices count from 1, negative indices back from the newest point.
/// Points may follow the lines that use them, so the upper bound is checked later.
ObjLine read_line(WordScanner& scanner, std::size_t point_count) {
  ObjLine result{{}, scanner.line()};
  for (;;) {
    const std::string_view word = scanner.word_on_line();
    if (word.empty() || word[0] == '#') break;
    const std::string_view vertex = word.substr(0, word.find('/'));
    std::int64_t index = scanner.integer(vertex, "a vertex index");
    if (index < 0) index += static_cast<std::int64_t>(point_count) + 1;
    if (index < 1 || index >= kMostPoints) scanner.fail("a vertex index of the file", word);
    result.points.push_back(static_cast<std::uint32_t>(index - 1));
  }
  if (result.points.size() < 2) scanner.fail("an l needs at least two vertices");
  return result;
}

}  // namespace

std::vector<CurveInput> read_obj(const Source& source) {
  WordScanner scanner(source.path, source.bytes);
  std::vector<Point> points;
  std::vector<ObjLine> found;
  do {
    const std::string_view keyword = scanner.word_on_line();
    if (keyword == "v") points.push_back(read_vertex(scanner));
    if (keyword == "l") found.push_back(read_line(scanner, points.size()));
  } while (scanner.next_line());
  if (found.empty()) cannot_read(source.path, "it has no line elements (l)");
  std::vector<Line> lines;
  for (ObjLine& line : found) {
    for (const std::uint32_t index : line.points) {
      if (index < points.size()) continue;
      cannot_read(source.path, fmt::format("line {}: there is no vertex {} (the file has {})",
                                           line.line, std::size_t{index} + 1, points.size()));
    }
    lines.push_back(std::move(line.points));
  }
  std::vector<CurveInput> curves = curves_of(points, std::move(lines));
  turn_to(source.frame, space_in_comments(source.bytes), source.path, curves);
  return curves;
}

std::string write_obj(std::span<const PlacedCurve> curves, Sides sides, PatientSpace space) {
  fmt::memory_buffer out;
  fmt::format_to(fmt::appender(out), "{}", space_line("# ", space));
  for (const PlacedCurve& curve : curves) {
    for (const Point& p : curve.positions) {
      fmt::format_to(fmt::appender(out), "v {:.17g} {:.17g} {:.17g}\n", p.x(), p.y(), p.z());
    }
  }
  std::size_t first = 1;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const PlacedCurve& curve = curves[c];
    if (!sides.empty()) {
      fmt::format_to(fmt::appender(out), "g {}_{}\n", sides[c].left, sides[c].right);
    }
    out.push_back('l');
    for (std::size_t k = 0; k < curve.positions.size(); ++k) {
      fmt::format_to(fmt::appender(out), " {}", first + k);
    }
    if (curve.closed) fmt::format_to(fmt::appender(out), " {}", first);
    out.push_back('\n');
    first += curve.positions.size();
  }
  return fmt::to_string(out);
}

}  // namespace talweg::formats
