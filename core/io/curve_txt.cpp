// Plain lists of vertex ids.
#include <fmt/format.h>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg::formats {
namespace {

/// Turns a list of ids into a curve; a list that repeats its first id at its end gives a closed
/// curve.
void finish(std::vector<VertexId>& ids, std::vector<CurveInput>& curves) {
  if (ids.empty()) return;
  CurveInput curve;
  curve.closed = ids.size() > 1 && ids.front() == ids.back();
  if (curve.closed) ids.pop_back();
  curve.points = std::move(ids);
  curves.push_back(std::move(curve));
  ids.clear();
}

void read_ids(const WordScanner& scanner, std::string_view line, std::vector<VertexId>& ids) {
  constexpr std::string_view kSeparators = " \t\r\v\f,";
  for (;;) {
    const std::size_t start = line.find_first_not_of(kSeparators);
    if (start == line.npos) return;
    line.remove_prefix(start);
    const std::size_t length = std::min(line.find_first_of(kSeparators), line.size());
    constexpr const char* kExpected = "a vertex id from 0 to 4294967294";
    ids.emplace_back(scanner.count(line.substr(0, length), kExpected, VertexId::kInvalid));
    line.remove_prefix(length);
  }
}

}  // namespace

std::vector<CurveInput> read_txt(const Source& source) {
  WordScanner scanner(source.path, source.bytes);
  std::vector<CurveInput> curves;
  std::vector<VertexId> ids;
  do {
    const std::string_view line = scanner.rest_of_line();
    if (line.find_first_not_of(" \t\r\v\f") == line.npos) finish(ids, curves);
    read_ids(scanner, line.substr(0, line.find('#')), ids);
  } while (scanner.next_line());
  finish(ids, curves);
  if (curves.empty()) cannot_read(source.path, "it has no vertex ids");
  return curves;
}

std::string write_txt(const std::filesystem::path& path, std::span<const PlacedCurve> curves) {
  fmt::memory_buffer out;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (c > 0) out.push_back('\n');
    const std::vector<VertexId>& vertices = curves[c].vertices;
    const std::size_t lines = vertices.size() + (curves[c].closed ? 1 : 0);
    for (std::size_t k = 0; k < lines; ++k) {
      const VertexId vertex = vertices[k % vertices.size()];
      if (!vertex.valid()) {
        cannot_write(path, fmt::format("a .txt holds vertex ids only, and point {} of curve {} is "
                                       "not at a vertex (.json holds any point)",
                                       k, c));
      }
      fmt::format_to(fmt::appender(out), "{}\n", vertex.index());
    }
  }
  return fmt::to_string(out);
}

}  // namespace talweg::formats
