#include "talweg/core/io/mesh_file.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "talweg/core/io/line_scanner.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kUnused = 0xFFFFFFFFU;

}  // namespace

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

void StrayVertices::add(std::size_t vertex, std::size_t line, std::string_view word) {
  if (!all_.empty() && all_.back().vertex == vertex) all_.pop_back();
  all_.push_back({vertex, line, word});
}

void StrayVertices::check(const MeshFile& file, const MeshLists& lists) const {
  if (all_.empty()) return;
  std::vector<std::uint32_t> face_of(lists.points.size(), kUnused);
  for (std::size_t f = lists.triangles.size(); f > 0; --f) {
    for (const std::uint32_t v : lists.triangles[f - 1]) {
      if (v < face_of.size()) face_of[v] = static_cast<std::uint32_t>(f - 1);
    }
  }
  for (const Stray& stray : all_) {
    if (face_of[stray.vertex] == kUnused) continue;
    bad_line(file.path, stray.line,
             fmt::format("a coordinate is {}, which is not a finite number, and face {} uses this "
                         "vertex ({}).",
                         quoted(stray.word), face_of[stray.vertex], stray.vertex));
  }
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
