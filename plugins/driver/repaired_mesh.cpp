#include "repaired_mesh.hpp"

#include <utility>

#include "talweg/core/mesh_inspection.hpp"
#include "talweg/core/mesh_reader.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {

void add_repair_option(CLI::App& app, std::string& list) {
  app.add_flag("--repair{all}", list,
               "Make the mesh a surface first: weld, drop, orient, split, or all (the default), "
               "separated by commas after an equals sign; results have the file's numbers");
}

void check_repair(const std::string& list) {
  if (!list.empty()) repair_steps(list);
}

ReadMesh read_and_repair(const std::string& path, const std::string& list) {
  check_repair(list);
  ReadMesh mesh;
  mesh.lists = read_mesh(path);
  if (list.empty()) return mesh;
  RepairedMesh repaired = repair(mesh.lists, repair_steps(list));
  const MeshInspection after = inspect(repaired.lists);
  if (after.verdict != MeshVerdict::kUsable) {
    throw Error(ErrorCode::kBadMesh,
                "The repaired mesh cannot be used, either (its own numbers): " + after.reason);
  }
  mesh.changes = sentences(repaired.changes);
  mesh.lists = std::move(repaired.lists);
  mesh.map = std::make_shared<const RepairMap>(std::move(repaired.map));
  return mesh;
}

PlacedCurve in_file_numbers(const RepairMap* map, PlacedCurve curve) {
  return map == nullptr ? curve : map->to_file(std::move(curve));
}

}  // namespace talweg::driver
