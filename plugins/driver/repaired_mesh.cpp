#include "repaired_mesh.hpp"

#include <utility>

#include <fmt/format.h>

#include "talweg/core/cutting/attribute_transfer.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/repair/weld_hint.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {

std::string mesh_help() { return "Mesh: " + readable_meshes(); }

void add_repair_option(CLI::App& app, std::string& list) {
  app.add_flag("--repair{all}", list,
               "Make the mesh a surface first: weld, drop, orient, split, or all (the default), "
               "separated by commas after an equals sign; weld=TOLERANCE welds vertices within "
               "this distance; results have the file's numbers");
}

void add_unit_option(CLI::App& app, std::string& unit) {
  app.add_option("--mesh-units", unit,
                 "The unit of the mesh's coordinates, to which curves of .mrk.json and .fcsv files "
                 "are converted: pm, nm, um, mm, cm, dm, m, km, in or ft (default: the unit in the "
                 "mesh's file, or mm)");
}

void check_unit(const std::string& unit) {
  if (!unit.empty()) LengthUnit::named(unit);
}

CoordinateFrame with_unit(CoordinateFrame frame, const std::string& unit) {
  if (!unit.empty()) frame.unit = LengthUnit::named(unit);
  return frame;
}

void check_repair(const std::string& list) {
  if (!list.empty()) repair_steps(list);
}

namespace {

/// Adds the file's name, which the library's message does not have.
void check_range(const std::string& path, const MeshLists& lists) {
  const std::string reason = out_of_range(lists);
  if (!reason.empty()) throw Error(ErrorCode::kBadMesh, path + ": " + reason);
}

ReadMesh repaired(MeshLists lists, const std::string& list) {
  ReadMesh mesh;
  mesh.lists = std::move(lists);
  mesh.polygons = std::move(mesh.lists.polygons);
  mesh.changes = mesh.lists.notes;
  if (list.empty()) return mesh;
  RepairedMesh repaired = repair_to_surface(mesh.lists, repair_steps(list));
  const std::vector<std::string> changes = sentences(repaired.changes);
  mesh.changes.insert(mesh.changes.end(), changes.begin(), changes.end());
  repaired.lists.unit = mesh.lists.unit;
  repaired.lists.space = mesh.lists.space;
  mesh.lists = std::move(repaired.lists);
  mesh.map = std::make_shared<const RepairMap>(std::move(repaired.map));
  return mesh;
}

}  // namespace

ReadMesh read_and_repair(const std::string& path, const std::string& list) {
  check_repair(list);
  MeshLists lists = read_mesh(path);
  check_range(path, lists);
  return repaired(std::move(lists), list);
}

ReadMesh read_and_repair(const std::string& path, const std::string& list,
                         MeshAttributes& attributes) {
  check_repair(list);
  MeshLists lists = read_mesh(path, attributes);
  check_range(path, lists);
  ReadMesh mesh = repaired(std::move(lists), list);
  if (!mesh.map) return mesh;
  std::size_t differing = 0;
  attributes = of_repaired(attributes, *mesh.map, differing);
  if (differing > 0) {
    mesh.changes.push_back(fmt::format(
        "{} vertices were welded onto vertices with other attributes; the attributes of the latter "
        "were kept.",
        differing));
  }
  return mesh;
}

void rethrow_with_weld_hint(const Error& error, const MeshLists& mesh) {
  if (error.code() != ErrorCode::kBadCurve) throw Error(error);
  throw Error(error.code(), error.what() + weld_hint(mesh, kRepairOption));
}

PlacedCurve in_file_numbers(const RepairMap* map, PlacedCurve curve) {
  return map == nullptr ? curve : map->to_file(std::move(curve));
}

}  // namespace talweg::driver
