#include "fuzz_target.hpp"

#include <algorithm>
#include <random>

#include "cost_limit.hpp"

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

// The medians are from docs/development/fuzzing.md.
const std::vector<Target>& targets() {
  static const std::vector<Target> kTargets = {
      {"mesh_obj", read_mesh_bytes, mesh_seeds, "m.obj", 12.4},
      {"mesh_off", read_mesh_bytes, mesh_seeds, "m.off", 8.98},
      {"mesh_ply", read_mesh_bytes, mesh_seeds, "m.ply", 7.45},
      {"mesh_stl", read_mesh_bytes, mesh_seeds, "m.stl", 12.9},
      {"mesh_om", read_mesh_bytes, mesh_seeds, "m.om", 5.57},
      {"mesh_gifti", read_mesh_bytes, mesh_seeds, "m.gii", 5},
      {"mesh_freesurfer", read_mesh_bytes, mesh_seeds, "lh.white", 5},
      {"mesh_vtk", read_mesh_bytes, mesh_seeds, "m.vtk", 9},
      {"mesh_vtp", read_mesh_bytes, mesh_seeds, "m.vtp", 6},
      {"mesh_msh", read_mesh_bytes, mesh_seeds, "m.msh", 8},
      {"mesh_gltf", read_mesh_bytes, mesh_seeds, "m.gltf", 16},
      {"mesh_3mf", read_mesh_bytes, mesh_seeds, "m.3mf", 6},
      {"curve_obj", read_curve_bytes, curve_seeds, "c.obj", 11.3},
      {"curve_ply", read_curve_bytes, curve_seeds, "c.ply", 8.53},
      {"curve_vtp", read_curve_bytes, curve_seeds, "c.vtp", 3.43},
      {"curve_vtk", read_curve_bytes, curve_seeds, "c.vtk", 7.67},
      {"curve_txt", read_curve_bytes, curve_seeds, "c.txt", 10.7},
      {"curve_json", read_curve_bytes, curve_seeds, "c.json", 16.1},
      {"curve_slicer", read_curve_bytes, curve_seeds, "c.mrk.json", 13.2},
      {"curve_border", read_curve_bytes, curve_seeds, "c.border", 4},
      {"curve_fcsv", read_curve_bytes, curve_seeds, "c.fcsv", 10},
      {"clicks", read_click_bytes, curve_seeds, "c.mrk.json", 13.2},
      {"label_annot", read_label_bytes, label_seeds, "l.annot", 6.37},
      {"label_list", read_label_bytes, label_seeds, "l.label", 10.9},
      {"label_ply", read_label_bytes, label_seeds, "l.ply", 7.18},
      {"label_vtk", read_label_bytes, label_seeds, "l.vtk", 7.41},
      {"label_vtp", read_label_bytes, label_seeds, "l.vtp", 5.98},
      {"label_gifti", read_label_bytes, label_seeds, "l.gii", 4},
      {"label_csv", read_label_bytes, label_seeds, "l.csv", 9},
      {"label_npy", read_label_bytes, label_seeds, "l.npy", 4},
      {"label_dpv", read_label_bytes, label_seeds, "l.dpv", 8},
      {"field_curv", read_field_bytes, label_seeds, "lh.curv", 4},
      {"intake", take_in, random_seeds, "", 641},
      {"straighten", straighten, random_seeds, "", 81.7},
      {"smooth", smooth, random_seeds, "", 148000}};
  return kTargets;
}

const Target* target_named(std::string_view name) {
  for (const Target& target : targets()) {
    if (target.name == name) return &target;
  }
  return nullptr;
}

std::uint64_t run(const Target& target, const std::uint8_t* data, std::size_t size) {
  const CostLimit limit(target.median, size);
  target.run(target, data, size);
  return limit.blocks();
}

}  // namespace talweg::fuzz
