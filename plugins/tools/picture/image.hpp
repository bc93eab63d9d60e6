// A picture in memory, and its file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace talweg::picture {

/// 8-bit sRGB, row by row from the top left, three bytes per pixel.
struct Image {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> rgb;

  [[nodiscard]] const std::uint8_t* pixel(std::size_t x, std::size_t y) const {
    return &rgb[3 * (y * width + x)];
  }
  [[nodiscard]] std::uint8_t* pixel(std::size_t x, std::size_t y) {
    return &rgb[3 * (y * width + x)];
  }
};

/// The bytes of a PNG file. Throws Error(kBadFile) when there are too many.
std::string png_bytes(const Image& image);

/// Writes a PNG file. Throws Error(kBadFile) when the file cannot be written.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace talweg::picture
