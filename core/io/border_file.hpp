// A border file is a curve file with the labels on both sides of each curve.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/space/coordinate_frame.hpp"

namespace talweg {

/// The labels on the two sides of a curve.
struct SideLabels {
  std::int64_t left = 0, right = 0;
};

/// Like write_curves(), with the labels beside each curve if the format has a place for them:
/// `.vtp` and `.vtk` as cell data `left` and `right`, `.json` as `left` and `right` of each curve,
/// `.obj` as a group `left_right`. Other formats leave the labels out. Throws as write_curves()
/// does, and Error(kBadUsage) if `sides` and `curves` differ in size.
void write_borders(const std::filesystem::path& path, std::span<const PlacedCurve> curves,
                   std::span<const SideLabels> sides, const CoordinateFrame& frame = {});

/// The bytes that write_borders() would write to a file of this name. Throws as it does.
std::string border_bytes(const std::filesystem::path& name, std::span<const PlacedCurve> curves,
                         std::span<const SideLabels> sides, const CoordinateFrame& frame = {});

}  // namespace talweg
