// talweg cut: curves become edges of the mesh, and the mesh is taken apart along them.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"
#include "cut_map.hpp"
#include "drawing_file.hpp"
#include "file_plan.hpp"
#include "methods/curve_choices.hpp"
#include "output_file.hpp"
#include "plugin_meshes.hpp"
#include "plugin_options.hpp"
#include "progress_bar.hpp"
#include "repaired_mesh.hpp"
#include "talweg/core/cutting/cut_report.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/cutting/part_polygons.hpp"
#include "talweg/core/cutting/tagged_edges.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg::driver {
namespace {

struct CutCommandOptions {
  std::string mesh;
  std::vector<std::string> curves;
  std::string output;
  std::string map;
  std::string report;
  std::string repair;
  std::string keep;
  bool open = false;
  bool split = false;
  bool tag = false;
  bool polygons = false;
  std::string cap;
  double merge = CutOptions{}.merge;
  std::string ends = "auto";
  std::string border = "snap";
  std::string mesh_units;
};

LidKind lid_kind(const std::string& name) {
  if (name == "auto") return LidKind::kAuto;
  if (name == "planar") return LidKind::kPlanar;
  if (name == "least-area") return LidKind::kLeastArea;
  throw Error(ErrorCode::kBadUsage,
              "--cap must be auto, planar or least-area, not \"" + name + "\".");
}

PartOptions part_options(const CutCommandOptions& o) {
  PartOptions parts;
  parts.open = o.open;
  parts.split = o.split;
  if (o.keep == "left") parts.keep = KeptSide::kLeft;
  if (o.keep == "right") parts.keep = KeptSide::kRight;
  if (!o.cap.empty()) parts.lids = lid_kind(o.cap);
  return parts;
}

/// Ends are extended to the border only where a seam is opened: a curve that only becomes edges may
/// end anywhere.
std::optional<ExtendedCurves> extended_curves(const CutCommandOptions& o) {
  const bool snap = border_ends(o.border) == BorderEnds::kSnap;
  return snap && part_options(o).opens() ? std::optional(ExtendedCurves::kAll) : std::nullopt;
}

/// The part of the outputs' names before the numbers of the pieces.
std::string split_prefix(const CutCommandOptions& o) {
  const std::filesystem::path path(o.output);
  return (path.parent_path() / (path.stem().string() + "-")).string();
}

class Cutting {
 public:
  Cutting(const CutCommandOptions& options, Progress progress);
  void write();
  [[nodiscard]] std::string summary() const;
  [[nodiscard]] const SnappedDrawing& drawing() const { return drawing_; }

 private:
  [[nodiscard]] std::string path_of(std::size_t part) const;
  [[nodiscard]] std::vector<PartOrigins> origins() const;
  std::vector<FaceOutlines> outlines(std::vector<PartOrigins>& origins) const;
  [[nodiscard]] std::string map_json(const std::vector<PartOrigins>& origins) const;
  [[nodiscard]] std::vector<std::string> warnings() const;
  [[nodiscard]] std::size_t split_polygons() const {
    return o_.polygons ? 0 : read_.lists.polygon_count;
  }

  const CutCommandOptions& o_;
  Progress progress_;
  MeshAttributes attributes_;  // the attributes of the file's mesh
  ReadMesh read_;
  SurfaceMesh mesh_;
  SnappedDrawing drawing_;
  CutMesh cut_;  // without its lists, which take_apart() has moved to the parts
  MeshParts made_;
  double cut_ms_ = 0;
  std::vector<std::size_t> faces_;     // number of written faces, per part
  std::vector<std::string> left_out_;  // sentences on attributes, one per format
};

Cutting::Cutting(const CutCommandOptions& options, Progress progress)
    : o_(options),
      progress_(std::move(progress)),
      read_(read_and_repair(options.mesh, options.repair, attributes_)),
      mesh_(SurfaceMesh::open(read_.lists)) {
  DrawingReader reader(mesh_, read_.map.get());
  reader.set_ends(curve_ends(options.ends), extended_curves(options));
  drawing_ = reader.read(o_.curves, with_unit(read_.lists.frame(), options.mesh_units), progress_);
  const Stopwatch watch;
  cut_ = cut_along(mesh_, drawing_.curves, {o_.merge}, progress_);
  cut_.lists.single_precision = read_.lists.single_precision;
  made_ = take_apart(mesh_, std::move(cut_), attributes_, part_options(o_), progress_);
  for (MeshPart& part : made_.parts) part.lists.space = read_.lists.space;
  attributes_ = {};  // the parts have copies
  cut_ms_ = watch.ms();
  if (!made_.left_out.empty()) {
    left_out_.push_back(fmt::format("Not carried over: {}.", fmt::join(made_.left_out, ", ")));
  }
}

/// The outputs' names: with --split, "out.ply" becomes "out-0.ply", "out-1.ply", ...
std::string Cutting::path_of(std::size_t part) const {
  if (!o_.split) return o_.output;
  return fmt::format("{}{}{}", split_prefix(o_), part,
                     std::filesystem::path(o_.output).extension().string());
}

std::vector<PartOrigins> Cutting::origins() const {
  std::vector<PartOrigins> origins;
  if (o_.map.empty() && !o_.tag && !o_.polygons) return origins;
  for (const MeshPart& part : made_.parts) {
    origins.push_back(origins_of(part, cut_, mesh_.surface(), read_.map.get()));
  }
  return origins;
}

std::string Cutting::map_json(const std::vector<PartOrigins>& origins) const {
  std::vector<std::string> files;
  for (std::size_t k = 0; k < origins.size(); ++k) files.push_back(path_of(k));
  return cut_map_json(origins, files);
}

/// The origins of the written faces. With --polygons, a face has the origin of its first triangle.
std::vector<FaceOutlines> Cutting::outlines(std::vector<PartOrigins>& origins) const {
  std::vector<FaceOutlines> all;
  for (std::size_t k = 0; k < made_.parts.size() && o_.polygons; ++k) {
    all.push_back(polygons_of(made_.parts[k], origins[k], read_.polygons));
    std::vector<std::uint32_t> faces;
    for (std::size_t f = 0; f < all.back().size(); ++f) {
      faces.push_back(origins[k].faces[all.back().face(f).front().triangle]);
    }
    origins[k].faces = std::move(faces);
  }
  return all;
}

void Cutting::write() {
  std::vector<PartOrigins> origins = this->origins();
  const std::vector<FaceOutlines> outlines = this->outlines(origins);
  const std::string map = o_.map.empty() ? "" : map_json(origins);
  std::vector<std::string> left_out;  // the same for all parts
  for (std::size_t k = 0; k < made_.parts.size(); ++k) {
    const MeshPart& part = made_.parts[k];
    std::vector<TaggedEdge> edges;
    if (o_.tag) edges = tagged_edges(part.lists.triangles, origins[k].curves);
    const FaceOutlines* faces = o_.polygons ? &outlines[k] : nullptr;
    MeshBytes file = mesh_bytes(path_of(k), part.lists, part.attributes, edges, faces);
    faces_.push_back(faces == nullptr ? part.lists.triangles.size() : faces->size());
    write_output(path_of(k), file.bytes);
    left_out = std::move(file.left_out);
  }
  if (!left_out.empty()) {
    left_out_.push_back(fmt::format("{} does not hold: {}.", o_.output, fmt::join(left_out, ", ")));
  }
  if (!o_.map.empty()) write_output(o_.map, map);
  if (!o_.report.empty()) {
    write_output(o_.report, to_json(entries_of(mesh_, cut_, made_, warnings(), cut_ms_), {}));
  }
}

std::vector<std::string> Cutting::warnings() const {
  std::vector<std::string> warnings = reading_warnings(drawing_, split_polygons());
  warnings.insert(warnings.end(), read_.changes.begin(), read_.changes.end());
  return warnings;
}

std::string Cutting::summary() const {
  const std::size_t curves = drawing_.curves.size();
  std::string text = fmt::format(
      "{} {} {} {}; {} new, {} of them where curves cross\n", curves,
      curves == 1 ? "curve cuts" : "curves cut", cut_.cut_faces,
      cut_.cut_faces == 1 ? "face" : "faces",
      cut_.new_vertices == 1 ? "1 vertex is" : fmt::format("{} vertices are", cut_.new_vertices),
      cut_.crossings);
  if (cut_.merged > 0) {
    text += fmt::format(
        "{} {} within --merge of a vertex or an edge {} moved onto it, by {:.3g} at most\n",
        cut_.merged, cut_.merged == 1 ? "point" : "points", cut_.merged == 1 ? "was" : "were",
        cut_.largest_move);
  }
  for (const std::string& change : read_.changes) text += change + "\n";
  for (const std::string& sentence : left_out_) text += sentence + "\n";
  for (const std::string& warning : reading_warnings(drawing_, split_polygons())) {
    text += warning + "\n";
  }
  if (part_options(o_).opens()) {
    text += fmt::format("{} {}\n", made_.pieces, made_.pieces == 1 ? "piece" : "pieces");
    if (made_.between > 0) {
      text += fmt::format(
          "{} of them left out, because they lie on the left of one curve and on the "
          "right of another\n",
          made_.between);
    }
    for (const std::string& sentence : made_.notes) text += sentence + "\n";
  }
  for (std::size_t k = 0; k < made_.parts.size(); ++k) {
    const MeshPart& part = made_.parts[k];
    text +=
        fmt::format("{}: {} vertices, {} faces", path_of(k), part.lists.points.size(), faces_[k]);
    if (!o_.cap.empty()) {
      text += fmt::format(", {} rims closed by {} faces, {} of them planar", part.lids.filled,
                          part.lids.triangles, part.lids.planar);
    }
    if (part.lids.with_inner > 0) {
      text += fmt::format(", {} of them with points inside", part.lids.with_inner);
    }
    if (part.lids.sunk_by > 0) {
      text += fmt::format(", moved by up to {:.3g} to clear the piece", part.lids.sunk_by);
    }
    if (part.lids.left_open > 0) {
      text += fmt::format("; {} rims stay open: they are slits, or end at the old boundary",
                          part.lids.left_open);
    }
    text += "\n";
  }
  return text + fmt::format("cut in {:.1f} ms\n", cut_ms_);
}

void check(const CutCommandOptions& o) {
  if (!o.cap.empty()) lid_kind(o.cap);
  if (o.tag) check_tag(o.output);
  const std::string extension = lower_extension(o.output);
  if (o.polygons && (extension == ".stl" || extension == ".vtk" || extension == ".vtp")) {
    throw Error(ErrorCode::kBadUsage,
                "--polygons needs an output that holds polygons: .ply, .obj or .off.");
  }
  if (!o.keep.empty() && o.keep != "left" && o.keep != "right") {
    throw Error(ErrorCode::kBadUsage, "--keep must be left or right, not \"" + o.keep + "\".");
  }
}

void check_files(const CutCommandOptions& o) {
  FilePlan files;
  files.reads("the mesh", o.mesh);
  files.reads("--curve", o.curves);
  if (o.split && !is_standard_output(o.output)) {
    const std::string ending = std::filesystem::path(o.output).extension().string();
    files.writes_numbered("-o", split_prefix(o), ending, check_mesh_name);
  } else if (o.split) {
    throw Error(ErrorCode::kBadUsage,
                "--split writes several files, but the standard output is a single file.");
  } else {
    files.writes("-o", o.output, check_mesh_name);
  }
  files.writes("--map", o.map);
  files.writes("--report", o.report);
  files.check();
}

}  // namespace

Command add_cut(CLI::App& app, const GlobalOptions& global) {
  auto o = std::make_shared<CutCommandOptions>();
  CLI::App* command = app.add_subcommand(
      "cut",
      "Make curves edges of the mesh, exactly: no vertex moves, new vertices lie on edges and in "
      "faces only; then take the mesh apart along the curves");
  command->add_option("mesh", o->mesh, mesh_help())->required();
  command->add_option("--curve", o->curves, "Curves to cut along; may be given several times")
      ->required();
  command
      ->add_option("-o,--output", o->output, "The cut mesh: .ply, .obj, .off, .stl, .vtk or .vtp")
      ->required();
  command->add_flag("--open", o->open,
                    "Open a seam along the curves: either side has vertices of its own");
  command->add_flag("--split", o->split,
                    "A file for each piece, OUT-0.ply, OUT-1.ply, ...; otherwise the pieces are "
                    "components of one mesh");
  command->add_option("--keep", o->keep,
                      "left or right: only pieces that lie on this side of every curve on their "
                      "border, seen along the curve from outside");
  command->add_flag(
      "--cap{auto}", o->cap,
      "Close with lids the openings that the cut leaves: auto (planar if the rim is planar, else "
      "of least area; the default), planar or least-area, after an equals sign; a lid never goes "
      "through the piece");
  command->add_flag("--tag", o->tag,
                    "Also write the curves' edges: element edge of a .ply, l of an .obj, lines of "
                    "a .vtk or .vtp");
  command->add_flag("--polygons", o->polygons,
                    "Write polygons of the mesh as polygons (.ply, .obj or .off): those that no "
                    "curve cuts, and the parts of planar ones");
  command->add_option("--map", o->map,
                      "JSON: where every vertex and face comes from, and the curves' vertices");
  command->add_option("--report", o->report, "Numbers of the cut, and of each part, as JSON");
  command
      ->add_option("--merge", o->merge,
                   "Points closer than this fraction of an edge to a vertex, an edge or each other "
                   "become one point")
      ->capture_default_str();
  add_choice(*command, plugins::ends_choice(), o->ends);
  command->add_flag_callback(
      "--closed", [o] { o->ends = "closed"; }, "The same as --ends closed");
  command
      ->add_option("--border", o->border,
                   "snap: where a seam is opened, ends of open curves within two edges of the "
                   "mesh's border are extended straight to the border; leave: they stay")
      ->check(CLI::IsMember({"snap", "leave"}))
      ->capture_default_str();
  add_repair_option(*command, o->repair);
  add_unit_option(*command, o->mesh_units);
  return [o, &global] {
    check(*o);
    check_unit(o->mesh_units);
    check_files(*o);
    Cutting cutting(*o, progress_bar(global.quiet));
    clear_progress_bar();
    lead_with_far_move(cutting.drawing(), global.quiet);
    cutting.write();
    if (!global.quiet) std::fputs(cutting.summary().c_str(), text_stream());
    return static_cast<int>(kDone);
  };
}

}  // namespace talweg::driver
