// STL, text (keywords in either case) and binary. STL stores triangles without vertex ids: corners
// at equal positions become one vertex.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/io/byte_cursor.hpp"
#include "talweg/core/io/line_scanner.hpp"
#include "talweg/core/io/space_note.hpp"

namespace talweg {
namespace {

constexpr std::size_t kText = 80;      // bytes of text
constexpr std::size_t kHeader = 84;    // the text and the number of triangles
constexpr std::size_t kTriangle = 50;  // normal, three corners, two bytes of attributes

/// Numbers positions by first appearance, in a hash table with open addressing on their bits.
class CornerWelder {
 public:
  /// The table grows if there are more vertices than half the triangles, the ratio of a closed
  /// surface.
  CornerWelder(std::vector<Point>& points, std::size_t triangles)
      : points_(points), slots_(std::bit_ceil(triangles + 1024), kEmpty) {}

  std::uint32_t id(Point p) {
    p += Point::Zero();  // -0 becomes 0
    if (2 * points_.size() >= slots_.size()) grow();
    const std::size_t slot = find(p);
    if (slots_[slot] == kEmpty) {
      slots_[slot] = static_cast<std::uint32_t>(points_.size());
      points_.push_back(p);
    }
    return slots_[slot];
  }

 private:
  static constexpr std::uint32_t kEmpty = 0xFFFFFFFFU;
  using Bits = std::array<std::uint64_t, 3>;

  static Bits bits(const Point& p) {
    Bits bits;
    std::memcpy(bits.data(), p.data(), sizeof bits);
    return bits;
  }
  [[nodiscard]] std::size_t find(const Point& p) const {
    std::uint64_t hash = 0;
    for (const std::uint64_t b : bits(p)) {
      hash = (hash ^ b) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 32U;
    }
    std::size_t slot = static_cast<std::size_t>(hash) & (slots_.size() - 1);
    while (slots_[slot] != kEmpty && bits(points_[slots_[slot]]) != bits(p)) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }
  void grow() {
    slots_.assign(2 * slots_.size(), kEmpty);
    for (std::size_t v = 0; v < points_.size(); ++v) {
      slots_[find(points_[v])] = static_cast<std::uint32_t>(v);
    }
  }

  std::vector<Point>& points_;
  std::vector<std::uint32_t> slots_;
};

MeshLists read_binary(const MeshFile& file, std::size_t triangles, MeshAttributes* attributes) {
  const bool swap = std::endian::native == std::endian::big;
  MeshLists lists;
  lists.single_precision = true;
  lists.space = formats::space_in(file.bytes.substr(0, kText));
  lists.triangles.resize(triangles);
  CornerWelder welder(lists.points, triangles);
  bool has_attributes = false;
  for (std::size_t f = 0; f < triangles; ++f) {
    const char* at = file.bytes.data() + kHeader + kTriangle * f + 12;
    for (std::uint32_t& corner : lists.triangles[f]) {
      corner =
          welder.id({load<float>(at, swap), load<float>(at + 4, swap), load<float>(at + 8, swap)});
      at += 12;
    }
    has_attributes |= at[0] != 0 || at[1] != 0;
  }
  if (attributes != nullptr && has_attributes) {
    attributes->left_out.emplace_back("attribute bytes of faces (STL)");
  }
  const std::size_t rest = file.bytes.size() - kHeader - kTriangle * triangles;
  if (rest > 0) {
    lists.notes.push_back(fmt::format(
        "{} bytes after the {} triangles of the STL file were ignored.", rest, triangles));
  }
  return lists;
}

/// Compares without regard to case; `lower` must be in lower case.
bool is_word(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), [](char a, char b) {
    return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b);
  });
}

void need_word(LineScanner& lines, std::string_view expected, std::size_t facet) {
  const bool found = lines.next_line();
  if (found && is_word(lines.word(), expected)) return;
  const std::string what = quoted(expected) + " of facet " + std::to_string(facet);
  if (!found) lines.need_line(what);
  lines.fail("expected " + what + ".");
}

MeshLists read_text(const MeshFile& file) {
  MeshLists lists;
  lists.space = formats::space_in(file.bytes.substr(0, file.bytes.find('\n')));
  CornerWelder welder(lists.points, 0);
  LineScanner lines(file);
  bool inside = false;
  while (lines.next_line()) {
    const std::string_view keyword = lines.word();
    if (is_word(keyword, "solid") && !inside) {
      inside = true;
    } else if (is_word(keyword, "endsolid") && inside) {
      inside = false;
    } else if (is_word(keyword, "facet") && inside) {
      const std::size_t facet = lists.triangles.size();
      need_word(lines, "outer", facet);
      Triangle triangle{};
      for (std::uint32_t& corner : triangle) {
        need_word(lines, "vertex", facet);
        Point p;
        for (double& coordinate : p) coordinate = lines.number("a coordinate");
        corner = welder.id(p);
      }
      need_word(lines, "endloop", facet);
      need_word(lines, "endfacet", facet);
      lists.triangles.push_back(triangle);
    } else {
      lines.fail(inside ? "expected 'facet' or 'endsolid'." : "expected 'solid'.");
    }
  }
  if (inside) bad_file(file.path, "the file ends where 'facet' or 'endsolid' should follow.");
  return lists;
}

}  // namespace

MeshLists read_stl(const MeshFile& file, MeshAttributes* attributes) {
  const std::size_t size = file.bytes.size();
  std::size_t announced = 0;
  if (size >= kHeader) {
    announced =
        load<std::uint32_t>(file.bytes.data() + 80, std::endian::native == std::endian::big);
    // Some binary files also begin with the word solid, so the size decides: four bytes of text
    // would announce more triangles than the largest file can hold. Bytes may follow.
    if (size >= kHeader + kTriangle * announced) return read_binary(file, announced, attributes);
  }
  const std::string_view head = file.bytes.substr(0, 1024);
  const std::size_t mark = head.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  const std::size_t first = head.find_first_not_of(" \t\r\n", mark);
  if (first != std::string_view::npos && is_word(head.substr(first, 5), "solid") &&
      head.find('\0') == std::string_view::npos) {
    return read_text(file);
  }
  if (size < kHeader) bad_file(file.path, "the file ends in the STL header.");
  bad_file(file.path, "its STL header announces " + std::to_string(announced) +
                          " triangles, which take " +
                          std::to_string(kHeader + kTriangle * announced) + " bytes, but it has " +
                          std::to_string(size) + ".");
}

}  // namespace talweg
