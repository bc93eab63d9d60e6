// A repaired mesh is read from a file and, on request, repaired.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {

struct ReadMesh {
  MeshLists lists;
  std::shared_ptr<const RepairMap> map;  ///< to the file's numbers; null if nothing was repaired
  std::vector<std::string> changes;      ///< sentences: the file's notes, then the repairs
  std::vector<Polygon> polygons;         ///< of the file, in its numbers
};

/// The kinds of files that a mesh argument accepts, for --help.
std::string mesh_help();

/// Adds --repair[=LIST]; `list` stays empty without it.
void add_repair_option(CLI::App& app, std::string& list);

/// Adds --mesh-units UNIT; `unit` stays empty without it.
void add_unit_option(CLI::App& app, std::string& unit);
/// Throws Error(kBadUsage) if `unit` is neither empty nor a unit.
void check_unit(const std::string& unit);
/// The frame of a mesh in this unit, unless it is empty. Throws as check_unit().
CoordinateFrame with_unit(CoordinateFrame frame, const std::string& unit);

/// Reads a mesh, and repairs it unless `list` is empty. Throws Error as read_mesh(), repair_steps()
/// and repair() do, and Error(kBadMesh) if the repaired mesh cannot be used.
ReadMesh read_and_repair(const std::string& path, const std::string& list);
/// Also reads the attributes, and converts them to the repaired mesh. A sentence in the changes
/// says how many vertices lost their attributes by welding.
ReadMesh read_and_repair(const std::string& path, const std::string& list,
                         MeshAttributes& attributes);

/// The option that weld_hint() recommends.
inline constexpr const char* kRepairOption = "--repair=";

/// Rethrows the error, with the hint if a curve was rejected.
[[noreturn]] void rethrow_with_weld_hint(const Error& error, const MeshLists& mesh);

/// Only checks the list of steps.
void check_repair(const std::string& list);

/// Converts a curve on the mesh to the numbers of its file.
PlacedCurve in_file_numbers(const RepairMap* map, PlacedCurve curve);

}  // namespace talweg::driver
