#include "talweg/core/io/mesh_file.hpp"

#include <algorithm>

#include "talweg/intrinsic/error.hpp"

namespace talweg {

void bad_file(const std::filesystem::path& path, const std::string& what) {
  throw Error(ErrorCode::kBadFile, "Cannot read " + path.string() + ": " + what);
}

void bad_line(const std::filesystem::path& path, std::size_t line, const std::string& what) {
  throw Error(ErrorCode::kBadFile,
              "Cannot read " + path.string() + ", line " + std::to_string(line) + ": " + what);
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

void add_polygon(MeshLists& lists, std::span<const std::uint32_t> corners) {
  if (corners.size() > 3) {
    ++lists.polygon_count;
    lists.polygons.push_back({static_cast<std::uint32_t>(lists.triangles.size()),
                              static_cast<std::uint32_t>(corners.size())});
  }
  for (std::size_t k = 2; k < corners.size(); ++k) {
    lists.triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }
}

}  // namespace talweg
