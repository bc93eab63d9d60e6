#include "fuzz_target.hpp"

#include <algorithm>
#include <random>

namespace talweg::fuzz {

std::vector<std::string> random_seeds(const Target& /*target*/) {
  std::mt19937 random(1);
  std::vector<std::string> seeds;
  for (const std::size_t length : {16U, 32U, 64U, 64U, 128U, 128U, 200U, 300U}) {
    std::string bytes(length, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    seeds.push_back(bytes);
  }
  return seeds;
}

const std::vector<Target>& targets() {
  static const std::vector<Target> kTargets = {
      {"mesh_obj", read_mesh_bytes, mesh_seeds, "m.obj"},
      {"mesh_off", read_mesh_bytes, mesh_seeds, "m.off"},
      {"mesh_ply", read_mesh_bytes, mesh_seeds, "m.ply"},
      {"mesh_stl", read_mesh_bytes, mesh_seeds, "m.stl"},
      {"mesh_om", read_mesh_bytes, mesh_seeds, "m.om"},
      {"curve_obj", read_curve_bytes, curve_seeds, "c.obj"},
      {"curve_ply", read_curve_bytes, curve_seeds, "c.ply"},
      {"curve_vtp", read_curve_bytes, curve_seeds, "c.vtp"},
      {"curve_vtk", read_curve_bytes, curve_seeds, "c.vtk"},
      {"curve_txt", read_curve_bytes, curve_seeds, "c.txt"},
      {"curve_json", read_curve_bytes, curve_seeds, "c.json"},
      {"curve_slicer", read_curve_bytes, curve_seeds, "c.mrk.json"},
      {"label_annot", read_label_bytes, label_seeds, "l.annot"},
      {"label_list", read_label_bytes, label_seeds, "l.label"},
      {"label_ply", read_label_bytes, label_seeds, "l.ply"},
      {"label_vtk", read_label_bytes, label_seeds, "l.vtk"},
      {"label_vtp", read_label_bytes, label_seeds, "l.vtp"},
      {"intake", take_in, random_seeds, ""},
      {"straighten", straighten, random_seeds, ""},
      {"smooth", smooth, random_seeds, ""}};
  return kTargets;
}

const Target* target_named(std::string_view name) {
  for (const Target& target : targets()) {
    if (target.name == name) return &target;
  }
  return nullptr;
}

}  // namespace talweg::fuzz
