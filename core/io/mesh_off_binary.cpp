// Object File Format, binary, as specified in Geomview's manual: the line OFF BINARY, then numbers
// of four bytes, whole or real. Colours and normals are skipped. OpenMesh writes such files in the
// byte order of its machine, and without the number of colour components after each face.
#include <algorithm>
#include <bit>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/io/byte_cursor.hpp"
#include "talweg/core/io/line_scanner.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr std::size_t kWord = 4;  // bytes of a number

/// The layout of the words of a file.
struct OffLayout {
  bool swap = false;
  bool has_colour_counts = true;  ///< after the corners of each face
};

struct OffHeader {
  std::size_t body = 0;         ///< first byte after the header's line
  std::size_t more_floats = 0;  ///< numbers per vertex besides its coordinates
};

OffHeader read_binary_header(const MeshFile& file) {
  LineScanner lines(file);
  lines.need_line("the word OFF");
  std::string_view prefix = lines.word();
  OffHeader header;
  const auto takes = [&](std::string_view key) {
    if (!prefix.starts_with(key)) return false;
    prefix.remove_prefix(key.size());
    return true;
  };
  if (takes("ST")) header.more_floats += 2;
  if (takes("C")) header.more_floats += 4;
  if (takes("N")) header.more_floats += 3;
  if (prefix != "OFF") lines.fail("expected the word OFF at the beginning of the file.");
  header.body = lines.offset();
  return header;
}

class BinaryOffReader {
 public:
  BinaryOffReader(const MeshFile& file, const OffHeader& header, OffLayout layout)
      : file_(file), header_(header), layout_(layout), cursor_(file.bytes.substr(header.body)) {}

  /// Throws Error(kBadFile) if the bytes do not fit the layout.
  MeshLists read() {
    const std::size_t vertices = count("vertices"), faces = count("faces");
    whole("the header");  // the number of edges is not checked
    read_vertices(vertices);
    lists_.triangles.reserve(std::min(faces, cursor_.left() / kWord));
    for (std::size_t f = 0; f < faces; ++f) read_face(f, faces);
    // Some writers end the file with a line break.
    if (cursor_.left() > 2 || cursor_.rest().find_first_not_of("\r\n") != std::string_view::npos) {
      bad_file(file_.path, fmt::format("the file goes on for {} bytes after all that its header "
                                       "announces.",
                                       cursor_.left()));
    }
    return std::move(lists_);
  }
  [[nodiscard]] bool has_colours() const { return has_colours_; }

 private:
  std::int32_t whole(const std::string& where) {
    const char* at = cursor_.take(kWord);
    if (at == nullptr) bad_file(file_.path, "the file ends in " + where + ".");
    return load<std::int32_t>(at, layout_.swap);
  }
  std::size_t count(const char* what) {
    const std::int32_t n = whole("the header");
    if (n < 0) bad_file(file_.path, fmt::format("its header announces {} {}.", n, what));
    return static_cast<std::size_t>(n);
  }

  void read_vertices(std::size_t vertices) {
    const std::size_t size = kWord * (3 + header_.more_floats);
    if (vertices > cursor_.left() / size) {
      bad_file(file_.path,
               fmt::format("the file ends in vertex {} of {}.", cursor_.left() / size, vertices));
    }
    lists_.single_precision = true;
    lists_.points.reserve(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
      const char* at = cursor_.take(size);
      lists_.points.emplace_back(load<float>(at, layout_.swap), load<float>(at + 4, layout_.swap),
                                 load<float>(at + 8, layout_.swap));
    }
  }

  void read_face(std::size_t f, std::size_t faces) {
    const auto place = [&] { return fmt::format("face {} of {}", f, faces); };
    const char* at = cursor_.take(kWord);
    if (at == nullptr) bad_file(file_.path, "the file ends in " + place() + ".");
    const auto n = load<std::int32_t>(at, layout_.swap);
    if (n < 3) {
      bad_file(file_.path,
               fmt::format("face {} has {} corners, but a face needs three or more.", f, n));
    }
    at = cursor_.take(kWord * static_cast<std::size_t>(n));
    if (at == nullptr) bad_file(file_.path, "the file ends in " + place() + ".");
    corners_.clear();
    for (std::int32_t k = 0; k < n; ++k, at += kWord) {
      const auto v = load<std::int32_t>(at, layout_.swap);
      if (v < 0 || static_cast<std::size_t>(v) >= lists_.points.size()) {
        bad_file(file_.path, fmt::format("face {} refers to vertex {}, but the file has {} "
                                         "vertices.",
                                         f, v, lists_.points.size()));
      }
      corners_.push_back(static_cast<std::uint32_t>(v));
    }
    add_polygon(lists_, corners_);
    if (layout_.has_colour_counts) pass_colour(f, faces);
  }

  void pass_colour(std::size_t f, std::size_t faces) {
    const char* at = cursor_.take(kWord);
    const std::int32_t n = at == nullptr ? 0 : load<std::int32_t>(at, layout_.swap);
    if (n < 0 || n > 4) {
      bad_file(file_.path,
               fmt::format("face {} has a colour of {} components; expected 0 to 4.", f, n));
    }
    if (at == nullptr || cursor_.take(kWord * static_cast<std::size_t>(n)) == nullptr) {
      bad_file(file_.path, fmt::format("the file ends in the colour of face {} of {}.", f, faces));
    }
    has_colours_ |= n > 0;
  }

  const MeshFile& file_;
  OffHeader header_;
  OffLayout layout_;
  ByteCursor cursor_;
  MeshLists lists_;
  std::vector<std::uint32_t> corners_;
  bool has_colours_ = false;
};

MeshLists read_with(const MeshFile& file, const OffHeader& header, OffLayout layout,
                    MeshAttributes* attributes) {
  BinaryOffReader reader(file, header, layout);
  MeshLists lists = reader.read();
  if (attributes != nullptr && header.more_floats > 0) {
    attributes->left_out.emplace_back("normals or colours of vertices (OFF)");
  }
  if (attributes != nullptr && reader.has_colours()) {
    attributes->left_out.emplace_back("colours of faces (OFF)");
  }
  return lists;
}

}  // namespace

bool is_binary_off(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 64), line = head.substr(0, head.find('\n'));
  const std::size_t at = line.find("OFF");
  return at <= 4 && line.find("BINARY", at) != std::string_view::npos;
}

MeshLists read_binary_off(const MeshFile& file, MeshAttributes* attributes) {
  const OffHeader header = read_binary_header(file);
  const bool little = std::endian::native == std::endian::little;
  // The specified layout is tried first; its error is reported if no layout fits.
  try {
    return read_with(file, header, {little, true}, attributes);
  } catch (const Error& error) {
    for (const OffLayout& other : {OffLayout{little, false}, {!little, true}, {!little, false}}) {
      try {
        MeshLists lists = read_with(file, header, other, attributes);
        lists.notes.emplace_back(
            other.swap == little
                ? "The binary OFF file has no numbers of colour components, as OpenMesh writes it."
                : "The binary OFF file is little-endian, as OpenMesh writes it.");
        return lists;
      } catch (const Error&) {
        continue;
      }
    }
    throw;
  }
}

}  // namespace talweg
