// Triangle strips hold the faces in PLY files of the Stanford archive.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "talweg/core/io/mesh_file.hpp"

namespace talweg {

/// Adds the triangles of strips: every index after the first two makes a triangle with the two
/// before it, with every second triangle turned; −1 ends a strip. Repeated indices only continue
/// the strip and make no face.
class TriangleStrips {
 public:
  TriangleStrips(const MeshFile& file, std::size_t vertices, MeshLists& lists)
      : file_(file), vertices_(static_cast<std::int64_t>(vertices)), lists_(lists) {}

  /// Throws Error(kBadFile) for an index that is neither −1 nor a vertex.
  void add(std::int64_t index) {
    if (index == -1) {
      end();
      return;
    }
    if (index < 0 || index >= vertices_) {
      bad_file(file_.path, "a triangle strip refers to vertex " + std::to_string(index) +
                               ", but the file has " + std::to_string(vertices_) + " vertices.");
    }
    const auto c = static_cast<std::uint32_t>(index);
    const auto [a, b] = last_;
    if (count_ >= 2 && a != b && b != c && c != a) {
      lists_.triangles.push_back(count_ % 2 == 0 ? Triangle{a, b, c} : Triangle{b, a, c});
    }
    last_ = {b, c};
    ++count_;
  }
  void end() { count_ = 0; }

 private:
  const MeshFile& file_;
  std::int64_t vertices_;
  MeshLists& lists_;
  std::size_t count_ = 0;  // length of the current strip
  std::array<std::uint32_t, 2> last_{};
};

}  // namespace talweg
