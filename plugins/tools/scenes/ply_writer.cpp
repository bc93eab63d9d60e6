#include "tools/scenes/ply_writer.hpp"

#include <bit>
#include <cstdint>

#include "talweg/core/io/file_bytes.hpp"

namespace talweg::scenes {
namespace {

void append(std::string& bytes, std::uint32_t word) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<char>((word >> shift) & 0xFFU));
  }
}

}  // namespace

std::string ply_bytes(const MeshLists& mesh) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(mesh.points.size()) +
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty list uchar int vertex_indices\nend_header\n";
  bytes.reserve(bytes.size() + 12 * mesh.points.size() + 13 * mesh.triangles.size());
  for (const Point& p : mesh.points) {
    for (int k = 0; k < 3; ++k) {
      append(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(p[k])));
    }
  }
  for (const Triangle& t : mesh.triangles) {
    bytes.push_back(3);
    for (const std::uint32_t v : t) append(bytes, v);
  }
  return bytes;
}

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  write_file(path, bytes);
}

}  // namespace talweg::scenes
