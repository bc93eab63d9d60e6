// talweg-scenes: meshes and jagged curves for the demo.
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "talweg/talweg.hpp"
#include "tools/scenes/hands.hpp"
#include "tools/scenes/patients.hpp"
#include "tools/scenes/ply_writer.hpp"
#include "tools/scenes/scenes.hpp"

namespace talweg::scenes {
namespace {

void write_scenes(const std::filesystem::path& folder, const std::vector<DemoScene>& scenes) {
  std::filesystem::create_directories(folder);
  for (const DemoScene& scene : scenes) {
    write_bytes(folder / (scene.name + ".ply"), ply_bytes(scene.mesh));
    if (scene.through.vertices.empty()) {
      std::string labels;
      for (const int label : cortex_parcels(scene.mesh)) labels += std::to_string(label) + "\n";
      write_bytes(folder / (scene.name + ".labels"), labels);
    } else {
      write_bytes(folder / (scene.name + ".through"), draw_arguments(scene.through) + "\n");
    }
    std::printf("%-8s %7zu faces\n", scene.name.c_str(), scene.mesh.triangles.size());
  }
}

/// Writes NAME.ply, NAME.json with the drawing, and cases.csv with a line for each patient.
void write_patients(const std::filesystem::path& folder, std::size_t count) {
  std::filesystem::create_directories(folder);
  const Patients patients;
  std::string cases = "mesh,curve,patient\n";
  for (std::size_t i = 0; i < count; ++i) {
    const DemoScene scene = patients.scene(i);
    const SurfaceMesh mesh = SurfaceMesh::open(scene.mesh);
    std::vector<SurfacePoint> clicks;
    for (const std::uint32_t v : scene.through.vertices) {
      clicks.push_back(SurfacePoint::at_vertex(mesh.surface(), VertexId{v}));
    }
    const Drawing drawing = draw(mesh.surface(), clicks, {.closed = true});
    write_bytes(folder / (scene.name + ".ply"), ply_bytes(scene.mesh));
    const std::vector<PlacedCurve> curves = {place(mesh, drawing.curve)};
    write_curves(folder / (scene.name + ".json"), curves);
    const std::string path = (folder / scene.name).string();
    cases += fmt::format("{0}.ply,{0}.json,{1}\n", path, scene.name);
  }
  write_bytes(folder / "cases.csv", cases);
}

/// Way-points on the file's mesh, or on its repaired copy if it needs one; in the file's indices.
Waypoints waypoints_on(const std::string& path) {
  const MeshLists lists = read_mesh(path);
  if (inspect(lists).verdict == MeshVerdict::kUsable) return waypoints_across(lists);
  const RepairedMesh repaired = repair(lists);
  Waypoints through = waypoints_across(repaired.lists);
  for (std::uint32_t& v : through.vertices) {
    v = static_cast<std::uint32_t>(repaired.map.file_vertex(VertexId{v}).index());
  }
  return through;
}

void write_hand(const std::string& mesh, const std::string& file, std::uint64_t seed) {
  const HandStroke stroke(SurfaceMesh::open(read_mesh(mesh)), {}, seed);
  if (!stroke.is_drawn()) {
    throw Error(ErrorCode::kBadMesh, mesh + ": there is no room for a stroke of 60 edges.");
  }
  std::string text, line = "l";
  std::size_t count = 0;
  for (const Point& p : stroke.sampled({})) {
    text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x(), p.y(), p.z());
    line += fmt::format(" {}", ++count);
  }
  write_bytes(file, text + line + "\n");
}

int run(int argc, char** argv) {
  CLI::App app("Generates the demo's meshes, and jagged curves to draw on them.", "talweg-scenes");
  std::string folder, mesh;
  CLI::Option* out = app.add_option(
      "OUTDIR", folder,
      "Where to write NAME.ply and NAME.through (arguments for talweg draw) of every scene");
  bool gallery = false;
  app.add_flag("--gallery", gallery,
               "The scenes of ./run gallery instead; the cortex has NAME.labels and no curve");
  std::size_t patients = 0;
  app.add_option("--patients", patients,
                 "Write this number of vessels instead, of 5,000 to 50,000 faces, each with a "
                 "drawing, and cases.csv for talweg smooth --batch")
      ->check(CLI::Range(1, 100000));
  app.add_option("--through-for", mesh, "Print arguments for talweg draw on this mesh instead")
      ->excludes(out);
  std::vector<std::string> hand;
  std::uint64_t seed = 1;
  app.add_option(
         "--hand", hand,
         "MESH STROKE.obj: write a stroke on this mesh instead, of a trembling hand, with ten "
         "samples of a tablet per edge")
      ->expected(2)
      ->excludes(out);
  app.add_option("--seed", seed, "Seed of the hand")->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    throw Error(ErrorCode::kBadUsage, error.what());
  }
  if (!mesh.empty()) {
    std::printf("%s\n", draw_arguments(waypoints_on(mesh)).c_str());
  } else if (!hand.empty()) {
    write_hand(hand[0], hand[1], seed);
  } else if (!folder.empty() && patients > 0) {
    write_patients(folder, patients);
  } else if (!folder.empty()) {
    write_scenes(folder, gallery ? gallery_scenes() : demo_scenes());
  } else {
    throw Error(ErrorCode::kBadUsage,
                "a folder OUTDIR, --through-for MESH or --hand MESH STROKE.obj is needed");
  }
  return 0;
}

}  // namespace
}  // namespace talweg::scenes

int main(int argc, char** argv) {
  try {
    return talweg::scenes::run(argc, argv);
  } catch (const talweg::Error& error) {
    std::fprintf(stderr, "talweg-scenes: %s\n", error.what());
    return error.code() == talweg::ErrorCode::kBadUsage ? 1 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "talweg-scenes: %s\n", error.what());
    return 5;
  }
}
