// Object File Format, text (binary: mesh_off_binary.cpp): vertices and polygons. Normals and
// colours are skipped.
#include <algorithm>
#include <vector>

#include "talweg/core/io/line_scanner.hpp"

namespace talweg {
namespace {

struct Counts {
  std::size_t vertices = 0;
  std::size_t faces = 0;
};

Counts read_header(LineScanner& lines) {
  lines.need_line("the word OFF");
  const std::string_view magic = lines.word();
  if (magic != "OFF" && magic != "COFF" && magic != "NOFF" && magic != "CNOFF" &&
      magic != "STOFF" && magic != "STNOFF" && magic != "STCOFF" && magic != "STCNOFF") {
    lines.fail("expected the word OFF at the beginning of the file.");
  }
  std::string_view word = lines.word();
  if (word.empty()) {
    lines.need_line("the numbers of vertices and faces");
    word = lines.word();
  }
  std::int64_t vertices = 0;
  if (!parse(word, vertices)) lines.fail("expected the number of vertices.");
  const std::int64_t faces = lines.integer("the number of faces");
  if (vertices < 0 || faces < 0) lines.fail("a number of elements is negative.");
  return {static_cast<std::size_t>(vertices), static_cast<std::size_t>(faces)};
}

std::string missing(const char* kind, std::size_t index, std::size_t count) {
  return std::string(kind) + " " + std::to_string(index) + " of " + std::to_string(count);
}

}  // namespace

MeshLists read_off(const MeshFile& file, MeshAttributes* attributes) {
  if (is_binary_off(file.bytes)) return read_binary_off(file, attributes);
  LineScanner lines(file, '#');
  bool more_of_vertices = false, more_of_faces = false;
  const Counts counts = read_header(lines);
  MeshLists lists;
  StrayVertices strays;
  // A line has at least six bytes, so no more memory is reserved than the file can fill.
  lists.points.reserve(std::min(counts.vertices, file.bytes.size() / 6));
  lists.triangles.reserve(std::min(counts.faces, file.bytes.size() / 6));
  for (std::size_t v = 0; v < counts.vertices; ++v) {
    if (!lines.next_line()) lines.need_line(missing("vertex", v, counts.vertices));
    Point p;
    std::string_view odd;
    for (double& coordinate : p) coordinate = lines.coordinate(odd);
    if (!odd.empty()) strays.add(v, lines.line(), odd);
    lists.points.push_back(p);
    if (attributes != nullptr) more_of_vertices |= !lines.word().empty();
  }
  std::vector<std::uint32_t> corners;
  for (std::size_t f = 0; f < counts.faces; ++f) {
    if (!lines.next_line()) lines.need_line(missing("face", f, counts.faces));
    const std::int64_t n = lines.integer("the number of the face's corners");
    if (n < 3) {
      lines.fail("face " + std::to_string(f) + " has " + std::to_string(n) +
                 " corners, but a face needs three or more.");
    }
    corners.clear();
    for (std::int64_t k = 0; k < n; ++k) {
      const std::int64_t v = lines.integer("the index of a vertex");
      if (v < 0 || v >= static_cast<std::int64_t>(counts.vertices)) {
        lines.fail("face " + std::to_string(f) + " refers to vertex " + std::to_string(v) +
                   ", but the file has " + std::to_string(counts.vertices) + " vertices.");
      }
      corners.push_back(static_cast<std::uint32_t>(v));
    }
    add_polygon(lists, corners);
    if (attributes != nullptr) more_of_faces |= !lines.word().empty();
  }
  if (more_of_vertices) attributes->left_out.emplace_back("normals or colours of vertices (OFF)");
  if (more_of_faces) attributes->left_out.emplace_back("colours of faces (OFF)");
  strays.check(file, lists);
  if (lines.next_line()) {
    lines.fail("the file goes on after the " + std::to_string(counts.vertices) + " vertices and " +
               std::to_string(counts.faces) + " faces that its header announces.");
  }
  return lists;
}

}  // namespace talweg
