// FreeSurfer's surfaces and values per vertex: binary, big-endian.
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/io/byte_cursor.hpp"
#include "talweg/core/io/field_formats.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/mesh_file.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kTriangles = 0xFFFFFE;  // magic numbers, three bytes
constexpr std::uint32_t kQuads = 0xFFFFFF;
constexpr std::uint32_t kFloatQuads = 0xFFFFFD;

/// Reads big-endian numbers. A missing number is an error.
class BigEndianBytes {
 public:
  BigEndianBytes(const std::filesystem::path& path, std::string_view bytes)
      : path_(path), cursor_(bytes) {}

  template <class T>
  T number(const char* what) {
    return load<T>(take(sizeof(T), what), std::endian::native == std::endian::little);
  }
  std::uint32_t three_bytes(const char* what) {
    const char* at = take(3, what);
    std::uint32_t value = 0;
    for (int k = 0; k < 3; ++k) value = value << 8U | static_cast<unsigned char>(at[k]);
    return value;
  }
  /// Skips a line and its end.
  void line(const char* what) {
    const std::size_t end = cursor_.rest().find('\n');
    if (end == std::string_view::npos) fail(fmt::format("it ends in {}", what));
    cursor_.take(end + 1);
  }
  /// Throws unless `count` elements of `size` bytes follow.
  void need(std::int64_t count, std::size_t size, const char* what) const {
    if (count >= 0 && static_cast<std::uint64_t>(count) <= cursor_.left() / size) return;
    fail(fmt::format("it announces {} {}, but has bytes for {} at most", count, what,
                     cursor_.left() / size));
  }
  [[nodiscard]] std::size_t left() const { return cursor_.left(); }
  [[noreturn]] void fail(const std::string& what) const { cannot_read(path_, what); }

 private:
  const char* take(std::size_t size, const char* what) {
    const char* at = cursor_.take(size);
    if (at == nullptr) fail(fmt::format("it ends where {} should be", what));
    return at;
  }

  const std::filesystem::path& path_;
  ByteCursor cursor_;
};

std::uint32_t checked(const BigEndianBytes& bytes, std::int64_t vertex, std::size_t face,
                      const MeshLists& lists) {
  if (vertex < 0 || static_cast<std::size_t>(vertex) >= lists.points.size()) {
    bytes.fail(fmt::format("face {} refers to vertex {}, but there are {}", face, vertex,
                           lists.points.size()));
  }
  return static_cast<std::uint32_t>(vertex);
}

void read_triangles(BigEndianBytes& bytes, MeshLists& lists) {
  bytes.line("its first line");
  bytes.line("its second line");
  const std::int64_t vertices = bytes.number<std::int32_t>("the number of vertices");
  const std::int64_t faces = bytes.number<std::int32_t>("the number of faces");
  bytes.need(vertices, 12, "vertices");
  lists.points.resize(static_cast<std::size_t>(vertices));
  for (Point& p : lists.points) {
    for (double& x : p) x = bytes.number<float>("a coordinate");
  }
  bytes.need(faces, 12, "faces");
  lists.triangles.resize(static_cast<std::size_t>(faces));
  for (std::size_t f = 0; f < lists.triangles.size(); ++f) {
    for (std::uint32_t& corner : lists.triangles[f]) {
      corner = checked(bytes, bytes.number<std::int32_t>("a corner"), f, lists);
    }
  }
}

/// Reads quads and divides them as in FreeSurfer, by the parity of the first corner's
/// number.
void read_quads(BigEndianBytes& bytes, bool floats, MeshLists& lists) {
  const std::int64_t vertices = bytes.three_bytes("the number of vertices");
  const std::int64_t quads = bytes.three_bytes("the number of faces");
  bytes.need(vertices, floats ? 12 : 6, "vertices");
  lists.points.resize(static_cast<std::size_t>(vertices));
  for (Point& p : lists.points) {
    for (double& x : p) {
      x = floats ? double{bytes.number<float>("a coordinate")}
                 : bytes.number<std::int16_t>("a coordinate") / 100.0;
    }
  }
  bytes.need(quads, 12, "faces");
  const auto count = static_cast<std::size_t>(quads);
  lists.triangles.reserve(2 * count);  // add_polygon() would make fans from the first corner
  for (std::size_t f = 0; f < count; ++f) {
    std::array<std::uint32_t, 4> q{};
    for (std::uint32_t& corner : q)
      corner = checked(bytes, bytes.three_bytes("a corner"), f, lists);
    if (q[0] % 2 == 0) {
      lists.triangles.push_back({q[0], q[1], q[3]});
      lists.triangles.push_back({q[2], q[3], q[1]});
    } else {
      lists.triangles.push_back({q[0], q[1], q[2]});
      lists.triangles.push_back({q[0], q[2], q[3]});
    }
  }
}

}  // namespace

MeshLists read_freesurfer_mesh(const MeshFile& file, MeshAttributes* attributes) {
  BigEndianBytes bytes(file.path, file.bytes);
  const std::uint32_t magic = bytes.three_bytes("the magic number");
  MeshLists lists;
  lists.unit = LengthUnit::named("mm");
  lists.single_precision = magic != kQuads;
  if (magic == kTriangles) {
    read_triangles(bytes, lists);
  } else if (magic == kQuads || magic == kFloatQuads) {
    read_quads(bytes, magic == kFloatQuads, lists);
  } else {
    bytes.fail(fmt::format(
        "the file is not a surface of FreeSurfer: expected it to begin with FFFFFE (triangles), "
        "FFFFFF or FFFFFD (quads), found {:06X}",
        magic));
  }
  if (attributes != nullptr && bytes.left() > 0) {
    attributes->left_out.emplace_back("the geometry of the volume (FreeSurfer)");
  }
  return lists;
}

namespace formats {

std::vector<double> read_curv(const Source& source) {
  BigEndianBytes bytes(source.path, source.bytes);
  const std::uint32_t magic = bytes.three_bytes("the magic number");
  std::vector<double> values;
  if (magic != kQuads) {  // the first number of the old format is the number of values
    bytes.three_bytes("the number of faces");
    bytes.need(magic, 2, "values");
    for (std::uint32_t k = 0; k < magic; ++k) {
      values.push_back(bytes.number<std::int16_t>("a value") / 100.0);
    }
    // The old format has no magic number, so the size must fit.
    if (bytes.left() > 0) {
      bytes.fail(
          fmt::format("{} bytes follow the {} values that it announces", bytes.left(), magic));
    }
  } else {
    const std::int64_t count = bytes.number<std::int32_t>("the number of vertices");
    bytes.number<std::int32_t>("the number of faces");
    const std::int32_t each = bytes.number<std::int32_t>("the number of values per vertex");
    if (each != 1) bytes.fail(fmt::format("it has {} values per vertex; expected 1", each));
    bytes.need(count, 4, "values");
    for (std::int64_t k = 0; k < count; ++k) values.push_back(bytes.number<float>("a value"));
  }
  return values;
}

}  // namespace formats
}  // namespace talweg
