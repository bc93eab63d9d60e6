// talweg-quality: measures smoothness, closeness and steadiness of results on real meshes.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/intrinsic/error.hpp"
#include "tools/quality/bounded_runs.hpp"
#include "tools/quality/clicked_runs.hpp"
#include "tools/quality/gallery.hpp"
#include "tools/quality/goals.hpp"
#include "tools/quality/hand_runs.hpp"
#include "tools/quality/rough_runs.hpp"
#include "tools/quality/runs.hpp"
#include "tools/quality/tables.hpp"
#include "tools/scenes/scenes.hpp"

namespace talweg::quality {
namespace {

struct Options {
  std::filesystem::path out, meshes, curves;
  std::vector<std::string> names;
  std::vector<std::string> parts{"hands", "runs",  "paper",       "bound",  "clicks",
                                 "rough", "sweep", "subdivision", "gallery"};
  std::size_t hands = 6;
  std::uint64_t seed = 1;
  CurveOptions curve_options;
};

void write(const std::filesystem::path& file, const std::string& text) { write_file(file, text); }

std::vector<std::filesystem::path> mesh_files(const Options& options) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(options.meshes)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(options.meshes)) {
    const std::string extension = entry.path().extension().string();
    const std::string name = entry.path().stem().string();
    const bool wanted =
        options.names.empty() ||
        std::find(options.names.begin(), options.names.end(), name) != options.names.end();
    if ((extension == ".ply" || extension == ".off" || extension == ".obj") && wanted) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

Subject subject_of(std::string name, MeshLists lists, const Options& options) {
  Subject subject{std::move(name), std::move(lists), nullptr, {}};
  subject.mesh = OpenedMesh::open(subject.lists);
  subject.drawings = stored_drawings(options.curves, subject.name);
  for (NamedPath& drawing : generated_drawings(*subject.mesh, options.seed)) {
    subject.drawings.push_back(std::move(drawing));
  }
  return subject;
}

bool wants(const Options& options, const char* part) {
  return std::find(options.parts.begin(), options.parts.end(), part) != options.parts.end();
}

/// The longest open and the longest closed drawing.
std::vector<NamedPath> longest_of_each(const Subject& subject) {
  std::vector<NamedPath> result;
  for (const bool closed : {false, true}) {
    const NamedPath* longest = nullptr;
    for (const NamedPath& drawing : subject.drawings) {
      if (drawing.closed != closed) continue;
      if (longest == nullptr || drawing.path.size() > longest->path.size()) longest = &drawing;
    }
    if (longest != nullptr) result.push_back(*longest);
  }
  return result;
}

struct Measured {
  std::vector<Run> runs, paper, relaxed;
  std::vector<BoundedRun> bounded;
  std::vector<ClickedRun> clicked;
  std::vector<HandRun> hands;
  std::vector<RoughRun> rough;
  std::vector<Sweep> sweeps;
  std::vector<Subdivision> subdivisions;
};

template <typename T>
void append(std::vector<T>& all, std::vector<T> more) {
  for (T& one : more) all.push_back(std::move(one));
}

void measure_runs(const Subject& subject, const Options& options, Measured& measured) {
  constexpr std::size_t kPaper = 200'000;  // faces: the paper's distance is computed on the whole
                                           // mesh
  constexpr int kPaperRelaxes = 5;         // rounds, as in the paper
  const std::size_t faces = subject.lists.triangles.size();
  const std::vector<Run> runs = default_runs(subject, options.curve_options);
  append(measured.runs, runs);
  if (options.curve_options.method == Method::kPaper) return;
  if (wants(options, "bound")) {
    append(measured.bounded, bounded_runs(subject, runs, options.curve_options));
  }
  if (wants(options, "paper") && faces <= kPaper) {
    CurveOptions paper = options.curve_options;
    paper.method = Method::kPaper;
    append(measured.paper, default_runs(subject, paper));
    append(measured.relaxed, default_runs(subject, paper, kPaperRelaxes));
  }
}

/// Writes the drawings, so that a user can smooth and view the drawing of any line of the tables.
void write_drawings(const Subject& subject, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const NamedPath& drawing : subject.drawings) {
    const SurfaceCurve curve = drawing.curve(subject.mesh->surface());
    std::string name = subject.name + "_" + drawing.name + ".json";
    std::replace(name.begin(), name.end(), ' ', '_');
    write_curves(folder / name, subject.mesh->mesh(), std::span(&curve, 1));
  }
}

/// A picture of each drawing of the gallery; names are numbered from the second on.
void draw_gallery(const Subject& subject, const std::filesystem::path& folder) {
  std::string name = "quality_" + subject.name;
  int number = 1;
  for (const NamedPath& drawing : gallery_drawings(subject)) {
    write_gallery_picture(subject, drawing, folder / (name + ".png"));
    name = "quality_" + subject.name + "_" + std::to_string(++number);
  }
}

void measure(const Subject& subject, const Options& options, Measured& measured) {
  constexpr std::size_t kSubdivided = 120'000;  // faces; two divisions give 16 times as many
  std::printf("%s: %zu drawings\n", subject.name.c_str(), subject.drawings.size());
  std::fflush(stdout);
  if (subject.drawings.empty()) return;
  write_drawings(subject, options.out / "drawings");
  if (wants(options, "hands") && options.curve_options.method == Method::kCorridor) {
    append(measured.hands, hand_runs(subject, options.hands, options.seed));
  }
  if (wants(options, "runs")) measure_runs(subject, options, measured);
  if (wants(options, "clicks") && options.curve_options.method == Method::kCorridor) {
    append(measured.clicked, clicked_runs(subject));
  }
  if (wants(options, "rough") && subject.lists.triangles.size() < kSubdivided) {
    append(measured.rough, rough_runs(subject, longest_of_each(subject)));
  }
  for (const NamedPath& drawing : longest_of_each(subject)) {
    if (wants(options, "sweep"))
      measured.sweeps.push_back(sweep(subject, drawing, options.curve_options));
    if (wants(options, "subdivision") && subject.lists.triangles.size() < kSubdivided) {
      measured.subdivisions.push_back(subdivision(subject, drawing, 2, options.curve_options));
    }
  }
  if (wants(options, "gallery")) draw_gallery(subject, options.out);
}

std::string text_of(const Options& options, const Measured& measured) {
  std::string text;
  const auto add = [&](const char* title, const std::string& table) {
    text += "## ";
    text += title;
    text += "\n\n";
    text += table;
    text += "\n";
  };
  const std::vector<Goal> reached = goals(measured.runs, measured.sweeps, measured.subdivisions,
                                          measured.clicked, measured.hands);
  if (!reached.empty()) add("Goals", tables(reached));
  if (!measured.hands.empty()) add("Hands, τ = 1", tables(measured.hands));
  if (!measured.runs.empty()) add("Default settings, τ = 0.5, 1, 2, 4", tables(measured.runs));
  if (!measured.paper.empty()) {
    add("Beside the paper's potential",
        side_by_side(measured.runs, measured.paper, measured.relaxed));
  }
  if (wants(options, "bound") && !measured.runs.empty()) {
    add("A bound on the deviation", tables(measured.bounded));
  }
  if (!measured.clicked.empty()) {
    add("Through every 25th vertex, as clicks, τ = 1", tables(measured.clicked));
  }
  if (!measured.rough.empty()) {
    add("Through every 25th vertex of rough meshes, beside the smooth one", tables(measured.rough));
  }
  if (!measured.sweeps.empty()) {
    add("τ from 0.25 to 4 in steps of 1 %", tables(measured.sweeps));
  }
  if (!measured.subdivisions.empty()) {
    add("The same shape on finer meshes, τ = 2", tables(measured.subdivisions));
  }
  return text;
}

void write_results(const Options& options, const Measured& measured) {
  if (!measured.runs.empty()) write(options.out / "runs.csv", csv(measured.runs));
  if (!measured.hands.empty()) write(options.out / "hands.csv", csv(measured.hands));
  if (!measured.rough.empty()) write(options.out / "rough.csv", csv(measured.rough));
  if (!measured.paper.empty()) write(options.out / "paper_runs.csv", csv(measured.paper));
  if (!measured.relaxed.empty()) {
    write(options.out / "paper_relaxed_runs.csv", csv(measured.relaxed));
  }
  const std::string text = text_of(options, measured);
  write(options.out / "results.md", text);
  std::fputs(text.c_str(), stdout);
}

int run(int argc, char** argv) {
  CLI::App app("Measures smoothness, closeness and steadiness of results on real meshes.",
               "talweg-quality");
  Options options;
  app.add_option("OUTDIR", options.out, "Where results.md, every run as CSV, and pictures go")
      ->required();
  app.add_option("--meshes", options.meshes, "Folder of meshes; generated ones if it is absent");
  app.add_option("--curves", options.curves, "Folder of drawings MESH.txt (vertex numbers)");
  app.add_option("--only", options.names, "Names of meshes")->delimiter(',');
  app.add_option("--parts", options.parts, "What to measure; paper and bound need runs")
      ->delimiter(',')
      ->check(CLI::IsMember(options.parts))
      ->capture_default_str();
  app.add_option("--hands", options.hands, "How many hands draw on each mesh")
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the generated drawings")->capture_default_str();
  app.add_option("--potential", options.curve_options.method, "corridor or paper")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Method>{
          {"corridor", Method::kCorridor}, {"paper", Method::kPaper}}));
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    throw Error(ErrorCode::kBadUsage, error.what());
  }
  std::filesystem::create_directories(options.out);
  Measured measured;
  const std::vector<std::filesystem::path> files = mesh_files(options);
  for (const auto& file : files) {
    try {
      measure(subject_of(file.stem().string(), read_mesh(file), options), options, measured);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::kBadMesh) throw;
      std::printf("%s: left out. %s\n", file.stem().c_str(), error.what());
    }
  }
  if (files.empty()) {
    for (const scenes::DemoScene& scene : scenes::demo_scenes()) {
      measure(subject_of(scene.name, scene.mesh, options), options, measured);
    }
  }
  write_results(options, measured);
  return 0;
}

}  // namespace
}  // namespace talweg::quality

int main(int argc, char** argv) {
  try {
    return talweg::quality::run(argc, argv);
  } catch (const talweg::Error& error) {
    std::fprintf(stderr, "talweg-quality: %s\n", error.what());
    return error.code() == talweg::ErrorCode::kBadUsage ? 1 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "talweg-quality: %s\n", error.what());
    return 5;
  }
}
