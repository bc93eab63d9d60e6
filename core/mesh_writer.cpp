#include "talweg/core/mesh_writer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "talweg/core/formats/file_bytes.hpp"
#include "talweg/core/formats/mesh_file.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// Appends a number's bytes, little end first.
template <class T>
void put(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

std::string obj_bytes(const MeshLists& lists) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const Point& p : lists.points) fmt::format_to(out, "v {} {} {}\n", p.x(), p.y(), p.z());
  for (const Triangle& t : lists.triangles) {
    fmt::format_to(out, "f {} {} {}\n", std::uint64_t{t[0]} + 1, std::uint64_t{t[1]} + 1,
                   std::uint64_t{t[2]} + 1);
  }
  return text;
}

std::string off_bytes(const MeshLists& lists) {
  std::string text = fmt::format("OFF\n{} {} 0\n", lists.points.size(), lists.triangles.size());
  const auto out = std::back_inserter(text);
  for (const Point& p : lists.points) fmt::format_to(out, "{} {} {}\n", p.x(), p.y(), p.z());
  for (const Triangle& t : lists.triangles) {
    fmt::format_to(out, "3 {} {} {}\n", t[0], t[1], t[2]);
  }
  return text;
}

std::string ply_bytes(const MeshLists& lists) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\n"
      "property list uchar {} vertex_indices\nend_header\n",
      lists.points.size(), lists.triangles.size(),
      lists.points.size() <= 0x80000000U ? "int" : "uint");  // not every reader knows uint
  bytes.reserve(bytes.size() + 24 * lists.points.size() + 13 * lists.triangles.size());
  for (const Point& p : lists.points) {
    for (const double x : p) put(bytes, x);
  }
  for (const Triangle& t : lists.triangles) {
    put(bytes, std::uint8_t{3});
    for (const std::uint32_t v : t) put(bytes, v);
  }
  return bytes;
}

std::string stl_bytes(const MeshLists& lists) {
  std::string bytes(80, ' ');
  bytes.reserve(84 + 50 * lists.triangles.size());
  put(bytes, static_cast<std::uint32_t>(lists.triangles.size()));
  const auto put_point = [&](const Point& p) {
    for (const double x : p) put(bytes, static_cast<float>(x));
  };
  for (const Triangle& t : lists.triangles) {
    const Point& a = lists.points[t[0]];
    const Point& b = lists.points[t[1]];
    const Point& c = lists.points[t[2]];
    put_point((b - a).cross(c - a).stableNormalized());
    for (const Point* p : {&a, &b, &c}) put_point(*p);
    put(bytes, std::uint16_t{0});
  }
  return bytes;
}

void check_indices(const MeshLists& lists) {
  for (std::size_t f = 0; f < lists.triangles.size(); ++f) {
    for (const std::uint32_t v : lists.triangles[f]) {
      if (v < lists.points.size()) continue;
      throw Error(ErrorCode::kBadMesh,
                  fmt::format("Face {} refers to vertex {}, but there are only {} vertices.", f, v,
                              lists.points.size()));
    }
  }
}

}  // namespace

void write_mesh(const std::filesystem::path& path, const MeshLists& lists) {
  using Bytes = std::string (*)(const MeshLists&);
  const std::string extension = lower_extension(path);
  Bytes bytes = nullptr;
  if (extension == ".obj") bytes = &obj_bytes;
  if (extension == ".off") bytes = &off_bytes;
  if (extension == ".ply") bytes = &ply_bytes;
  if (extension == ".stl") bytes = &stl_bytes;
  if (bytes == nullptr) {
    cannot_write(path, "its name does not end in .obj, .off, .ply or .stl");
  }
  check_indices(lists);
  write_file(path, bytes(lists));
}

}  // namespace talweg
