// Wavefront OBJ: the polygons of `v` and `f` statements; on request texture coordinates, normals,
// colours and names of faces.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/io/line_scanner.hpp"
#include "talweg/core/io/space_note.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg {
namespace {

/// Parses a corner: "7", "7/1", "7//3", "7/1/3"; negative numbers count back from the newest
/// vertex. Vertices may follow the faces that use them, so the upper bound is checked at the end.
std::uint32_t corner_of(const LineScanner& lines, std::string_view word, std::size_t vertices) {
  std::int64_t index = 0;
  const std::string_view number = word.substr(0, word.find('/'));
  if (!parse(number, index) || index == 0) {
    lines.fail("expected the number of a vertex, counted from 1, found " + quoted(number) + ".");
  }
  if (index < 0) index += static_cast<std::int64_t>(vertices) + 1;
  if (index < 1 || index > 0xFFFFFFFFLL) {
    lines.fail("a corner refers to vertex " + printable(number) + ", but there are " +
               std::to_string(vertices) + " vertices so far.");
  }
  return static_cast<std::uint32_t>(index - 1);
}

/// The rest of a line, with single blanks between words.
std::string words(LineScanner& lines) {
  std::string all;
  for (std::string_view word = lines.word(); !word.empty(); word = lines.word()) {
    if (!all.empty()) all += ' ';
    all += word;
  }
  return all;
}

/// Collects everything in a file besides vertices and corners.
class ObjAttributes {
 public:
  ObjAttributes(const MeshFile& file, MeshAttributes& into) : file_(file), into_(into) {}

  /// Reads the rest of a vertex after its three coordinates: nothing, a weight, or a colour.
  void vertex(LineScanner& lines, std::size_t vertices);
  /// Reads one number of a texture coordinate or normal.
  void corner(const LineScanner& lines, std::string_view word);
  void face(std::size_t triangles);
  /// Reads a statement that is neither a vertex nor a face.
  void statement(std::string_view keyword, LineScanner& lines);
  void end(std::size_t vertices, std::size_t triangles);

 private:
  using Wedge = std::array<std::uint32_t, 2>;  // texture coordinate, normal
  void leave_out(std::string what);
  void name(std::string_view keyword, std::string_view given, std::size_t triangles);
  static std::uint32_t number(const LineScanner& lines, std::string_view word,
                              const CornerAttribute& of, const char* what);
  void check(const CornerAttribute& attribute, const char* what) const;

  const MeshFile& file_;
  MeshAttributes& into_;
  std::vector<Wedge> wedges_;  // of the current face
  std::size_t triangles_ = 0;
};

void ObjAttributes::leave_out(std::string what) {
  const auto& all = into_.left_out;
  if (all.size() < 16 && std::find(all.begin(), all.end(), what) == all.end()) {
    into_.left_out.push_back(std::move(what));
  }
}

void ObjAttributes::vertex(LineScanner& lines, std::size_t vertices) {
  std::vector<double> more;
  for (std::string_view word = lines.word(); !word.empty(); word = lines.word()) {
    double value = 0;
    if (!parse(word, value)) {
      lines.fail("expected a number after the coordinates, found " + quoted(word) + ".");
    }
    more.push_back(value);
  }
  if (more.size() != 3 && !more.empty()) leave_out("weights of vertices (v)");
  if (more.size() != 3 && into_.vertices.empty()) return;
  if (into_.vertices.empty()) {
    for (const char* name : {"red", "green", "blue"}) {
      into_.vertices.push_back({name, NumberType::kFloat32, std::vector<double>(vertices, 1)});
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    into_.vertices[k].values.push_back(more.size() == 3 ? more[k] : 1);
  }
}

std::uint32_t ObjAttributes::number(const LineScanner& lines, std::string_view word,
                                    const CornerAttribute& of, const char* what) {
  if (word.empty()) return CornerAttribute::kNone;
  std::int64_t index = 0;
  if (!parse(word, index) || index == 0) {
    lines.fail("expected the number of a " + std::string(what) + ", found " + quoted(word) + ".");
  }
  const std::size_t so_far = of.dimension == 0 ? 0 : of.values.size() / of.dimension;
  if (index < 0) index += static_cast<std::int64_t>(so_far) + 1;
  if (index < 1 || index >= std::int64_t{CornerAttribute::kNone}) {
    lines.fail("a corner refers to " + std::string(what) + " " + printable(word) +
               ", but there are " + std::to_string(so_far) + " so far.");
  }
  return static_cast<std::uint32_t>(index - 1);
}

void ObjAttributes::corner(const LineScanner& lines, std::string_view word) {
  const auto part = [&word] {  // the text up to the next slash
    const std::size_t slash = word.find('/');
    const std::string_view found = word.substr(0, slash);
    word.remove_prefix(slash == word.npos ? word.size() : slash + 1);
    return found;
  };
  part();  // the vertex
  const std::uint32_t texture = number(lines, part(), into_.texture, "texture coordinate");
  wedges_.push_back({texture, number(lines, part(), into_.normals, "normal")});
}

void ObjAttributes::face(std::size_t triangles) {
  for (std::size_t a = 0; a < 2; ++a) {
    CornerAttribute& to = a == 0 ? into_.texture : into_.normals;
    const auto some = std::any_of(wedges_.begin(), wedges_.end(),
                                  [&](const Wedge& w) { return w[a] != CornerAttribute::kNone; });
    if (!some && to.corners.empty()) continue;
    constexpr std::uint32_t kNone = CornerAttribute::kNone;
    to.corners.resize(triangles_, {kNone, kNone, kNone});
    for (std::size_t k = 2; k < wedges_.size(); ++k) {
      to.corners.push_back({wedges_[0][a], wedges_[k - 1][a], wedges_[k][a]});
    }
  }
  wedges_.clear();
  triangles_ = triangles;
}

void ObjAttributes::name(std::string_view keyword, std::string_view given, std::size_t triangles) {
  auto at = std::find_if(into_.names.begin(), into_.names.end(),
                         [&](const FaceNames& n) { return n.keyword == keyword; });
  if (at == into_.names.end()) {
    into_.names.push_back({std::string(keyword), {""}, {}});
    at = into_.names.end() - 1;
  }
  const auto last = static_cast<std::uint32_t>(at->names.size() - 1);
  at->of_face.resize(triangles, last);
  at->names.emplace_back(given);
}

void ObjAttributes::statement(std::string_view keyword, LineScanner& lines) {
  if (keyword == "vt" || keyword == "vn") {
    CornerAttribute& to = keyword == "vt" ? into_.texture : into_.normals;
    to.dimension = keyword == "vt" ? 2 : 3;
    const char* what = keyword == "vt" ? "a texture coordinate" : "a normal";
    to.values.push_back(lines.number(what));
    if (keyword == "vt") {  // the second number may be missing
      const std::string_view word = lines.word();
      double value = 0;
      if (!word.empty() && !parse(word, value)) {
        lines.fail("expected a texture coordinate, found " + quoted(word) + ".");
      }
      to.values.push_back(value);
      return;
    }
    for (int k = 0; k < 2; ++k) to.values.push_back(lines.number(what));
  } else if (keyword == "o" || keyword == "g" || keyword == "usemtl" || keyword == "s") {
    name(keyword, words(lines), triangles_);
  } else if (keyword == "mtllib") {
    into_.references.push_back(fmt::format("mtllib {}", words(lines)));
  } else {
    leave_out(fmt::format("statement '{}'", printable(keyword)));
  }
}

void ObjAttributes::check(const CornerAttribute& attribute, const char* what) const {
  const std::size_t count =
      attribute.dimension == 0 ? 0 : attribute.values.size() / attribute.dimension;
  for (std::size_t f = 0; f < attribute.corners.size(); ++f) {
    for (const std::uint32_t c : attribute.corners[f]) {
      if (c == CornerAttribute::kNone || c < count) continue;
      bad_file(file_.path, "triangle " + std::to_string(f) + " refers to " + what + " " +
                               std::to_string(std::size_t{c} + 1) + ", but the file has " +
                               std::to_string(count) + ".");
    }
  }
}

void ObjAttributes::end(std::size_t vertices, std::size_t triangles) {
  constexpr std::uint32_t kNone = CornerAttribute::kNone;
  for (CornerAttribute* attribute : {&into_.texture, &into_.normals}) {
    check(*attribute, attribute == &into_.texture ? "texture coordinate" : "normal");
    if (attribute->corners.empty()) {
      *attribute = {};  // no face uses it
    } else {
      attribute->corners.resize(triangles, {kNone, kNone, kNone});
    }
  }
  for (FaceNames& names : into_.names) {
    names.of_face.resize(triangles, static_cast<std::uint32_t>(names.names.size() - 1));
  }
  for (AttributeColumn& column : into_.vertices) column.values.resize(vertices, 1);
}

void read_face(LineScanner& lines, std::vector<std::uint32_t>& corners, MeshLists& lists,
               ObjAttributes* attributes) {
  corners.clear();
  for (std::string_view word = lines.word(); !word.empty(); word = lines.word()) {
    if (word == "\\") {
      lines.join_next();
      continue;
    }
    const bool goes_on = word.back() == '\\';
    if (goes_on) word.remove_suffix(1);
    corners.push_back(corner_of(lines, word, lists.points.size()));
    if (attributes != nullptr) attributes->corner(lines, word);
    if (goes_on) lines.join_next();
  }
  if (corners.size() < 3) {
    lines.fail("a face needs three corners or more, this one has " +
               std::to_string(corners.size()) + ".");
  }
  add_polygon(lists, corners);
  if (attributes != nullptr) attributes->face(lists.triangles.size());
}

}  // namespace

MeshLists read_obj(const MeshFile& file, MeshAttributes* attributes) {
  MeshLists lists;
  std::optional<ObjAttributes> more;
  if (attributes != nullptr) more.emplace(file, *attributes);
  ObjAttributes* const beside = more ? &*more : nullptr;
  std::vector<std::uint32_t> corners;
  // The largest vertex index of any face, and its line.
  std::uint32_t largest = 0;
  std::size_t largest_line = 0;
  StrayVertices strays;
  LineScanner lines(file, '#');
  while (lines.next_line()) {
    const std::string_view keyword = lines.word();
    if (keyword == "v") {
      Point p;
      std::string_view odd;
      for (double& coordinate : p) coordinate = lines.coordinate(odd);
      if (!odd.empty()) strays.add(lists.points.size(), lines.line(), odd);
      if (beside != nullptr) beside->vertex(lines, lists.points.size());
      lists.points.push_back(p);
    } else if (keyword == "f" || keyword == "fo") {
      read_face(lines, corners, lists, beside);
      const std::uint32_t last = *std::max_element(corners.begin(), corners.end());
      if (last >= lists.points.size() && last >= largest) {
        largest = last;
        largest_line = lines.line();
      }
    } else if (beside != nullptr) {
      beside->statement(keyword, lines);
    }
  }
  if (largest_line > 0 && largest >= lists.points.size()) {
    bad_line(file.path, largest_line,
             "a face refers to vertex " + std::to_string(std::size_t{largest} + 1) +
                 " (counted from 1), but the file has " + std::to_string(lists.points.size()) +
                 " vertices.");
  }
  strays.check(file, lists);
  if (beside != nullptr) beside->end(lists.points.size(), lists.triangles.size());
  lists.space = formats::space_in_comments(file.bytes);
  return lists;
}

}  // namespace talweg
