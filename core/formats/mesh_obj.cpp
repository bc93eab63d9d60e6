// Wavefront OBJ: the polygons of `v` and `f` statements; everything else is passed over.
#include <algorithm>
#include <vector>

#include "talweg/core/formats/line_scanner.hpp"
#include "talweg/core/formats/text_scanner.hpp"

namespace talweg {
namespace {

constexpr const char* kCoordinate = "a coordinate";

/// "7", "7/1", "7//3", "7/1/3"; negative numbers count back from the newest vertex.
/// Vertices may follow the faces that use them, so the upper bound is checked at the end.
std::uint32_t corner_of(const LineScanner& lines, std::string_view word, std::size_t vertices) {
  std::int64_t index = 0;
  const std::string_view number = word.substr(0, word.find('/'));
  if (!LineScanner::parse(number, index) || index == 0) {
    lines.fail("expected the number of a vertex, counted from 1, found " + quoted(number) + ".");
  }
  if (index < 0) index += static_cast<std::int64_t>(vertices) + 1;
  if (index < 1 || index > 0xFFFFFFFFLL) {
    lines.fail("a corner refers to vertex " + formats::shown(number) + ", but there are " +
               std::to_string(vertices) + " vertices so far.");
  }
  return static_cast<std::uint32_t>(index - 1);
}

void read_face(LineScanner& lines, std::vector<std::uint32_t>& corners, MeshLists& lists) {
  corners.clear();
  for (std::string_view word = lines.word(); !word.empty(); word = lines.word()) {
    if (word == "\\") {
      lines.join_next();
      continue;
    }
    const bool goes_on = word.back() == '\\';
    if (goes_on) word.remove_suffix(1);
    corners.push_back(corner_of(lines, word, lists.points.size()));
    if (goes_on) lines.join_next();
  }
  if (corners.size() < 3) {
    lines.fail("a face needs three corners or more, this one has " +
               std::to_string(corners.size()) + ".");
  }
  add_polygon(lists, corners);
}

}  // namespace

MeshLists read_obj(const MeshFile& file) {
  MeshLists lists;
  std::vector<std::uint32_t> corners;
  // The largest vertex that any face names, and on which line.
  std::uint32_t largest = 0;
  std::size_t largest_line = 0;
  LineScanner lines(file, '#');
  while (lines.next_line()) {
    const std::string_view keyword = lines.word();
    if (keyword == "v") {
      Point p;
      for (double& coordinate : p) coordinate = lines.number(kCoordinate);
      lists.points.push_back(p);
    } else if (keyword == "f" || keyword == "fo") {
      read_face(lines, corners, lists);
      const std::uint32_t last = *std::max_element(corners.begin(), corners.end());
      if (last >= lists.points.size() && last >= largest) {
        largest = last;
        largest_line = lines.line();
      }
    }
  }
  if (largest_line > 0 && largest >= lists.points.size()) {
    bad_line(file.path, largest_line,
             "a face refers to vertex " + std::to_string(std::size_t{largest} + 1) +
                 " (counted from 1), but the file has " + std::to_string(lists.points.size()) +
                 " vertices.");
  }
  return lists;
}

}  // namespace talweg
