// A z-buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::picture {

/// The object nearest to the viewer for every sample of a raster. Coordinates are the output of a
/// Camera: x right, y down, z towards the viewer, all in samples; sample (i, j) lies at (i + 0.5, j
/// + 0.5).
class SampleBuffer {
 public:
  static constexpr std::uint32_t kNothing = 0xFFFFFFFFU;

  SampleBuffer(std::size_t width, std::size_t height)
      : width_(width),
        height_(height),
        depth_(width * height, -std::numeric_limits<float>::infinity()),
        id_(width * height, kNothing) {}

  [[nodiscard]] std::size_t width() const { return width_; }
  [[nodiscard]] std::size_t height() const { return height_; }
  [[nodiscard]] float depth(std::size_t x, std::size_t y) const { return depth_[y * width_ + x]; }
  [[nodiscard]] std::uint32_t id(std::size_t x, std::size_t y) const { return id_[y * width_ + x]; }

  /// A triangle of either orientation.
  void draw_triangle(std::uint32_t id, const Point& a, const Point& b, const Point& c);

  /// A tube of this radius with round ends, moved by `lift` towards the viewer. The id of a sample
  /// is `id` + the inclination there, from 0 (seen edge-on) to 255 (facing the viewer).
  void draw_tube(std::uint32_t id, const Point& a, const Point& b, double radius, double lift);

 private:
  void put(std::size_t x, std::size_t y, double z, std::uint32_t id) {
    const std::size_t i = y * width_ + x;
    const auto depth = static_cast<float>(z);
    if (depth > depth_[i]) {
      depth_[i] = depth;
      id_[i] = id;
    }
  }

  std::size_t width_, height_;
  std::vector<float> depth_;
  std::vector<std::uint32_t> id_;
};

}  // namespace talweg::picture
