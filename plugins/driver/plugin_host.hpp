// The driver as a host of plugins: loading them, and converting their errors and results.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/measure/report.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/loader/talweg_loader.h"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::driver {

/// All plugins that were found. A plugin is loaded when first needed, and kept until the program
/// ends.
const talweg_loader* plugin_loader();
/// Throws Error(kBadFile) that names the searched folders.
const talweg_plugin& plugin_named(const std::string& id);

/// Converts a plugin's error: to an Error, or to std::runtime_error for the plugin's own faults.
[[noreturn]] void rethrow(const host::Error& error);

host::Curve host_curve(const PlacedCurve& curve);
host::Curve host_curve(const CurveInput& curve);
PlacedCurve placed_curve(const host::Curve& curve);
/// The report on one curve, or on all curves (-1).
std::vector<ReportEntry> entries_of(const host::Results& results, std::int64_t curve);

/// Gives the mesh of a file to a plugin, which copies it.
void set_mesh(host::Instance& instance, std::span<const Point> points,
              std::span<const Triangle> triangles);
/// The same for a mesh of a file; coordinates that the file stores as 32-bit floats are given as
/// floats.
void set_mesh(host::Instance& instance, const MeshLists& lists);

}  // namespace talweg::driver
