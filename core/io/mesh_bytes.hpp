// Each mesh format has its own writer behind mesh_writer.hpp: a mesh to the bytes of a file.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/io/mesh_writer.hpp"

namespace talweg::formats {

/// The input of a writer, and descriptions of the parts that the format cannot hold. Readers and
/// writers of meshes and labels take one pass, O(bytes).
struct MeshContent {
  const MeshLists& lists;
  const MeshAttributes& attributes;
  std::span<const TaggedEdge> edges;
  std::vector<std::string> left_out;
  const FaceOutlines* outlines = nullptr;  ///< the faces to write; null: the triangles

  [[nodiscard]] std::size_t face_count() const {
    return outlines == nullptr ? lists.triangles.size() : outlines->size();
  }
  /// The corners of a face to write; `own` is the storage for the corners of a triangle.
  std::span<const PolygonCorner> face(std::size_t f, std::array<PolygonCorner, 3>& own) const {
    if (outlines != nullptr) return outlines->face(f);
    for (std::uint32_t k = 0; k < 3; ++k) own[k] = {static_cast<std::uint32_t>(f), k};
    return own;
  }
  [[nodiscard]] std::uint32_t vertex(const PolygonCorner& at) const {
    return lists.triangles[at.triangle][at.corner];
  }
};

std::string obj_bytes(MeshContent& content);
std::string off_bytes(MeshContent& content);
std::string ply_bytes(MeshContent& content);
std::string stl_bytes(MeshContent& content);
std::string vtk_bytes(MeshContent& content);
std::string vtp_bytes(MeshContent& content);

/// Appends a number's bytes in little-endian order.
template <class T>
void put(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

}  // namespace talweg::formats
