// talweg cut: curves become edges of the mesh, and the mesh is taken apart along them.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "drawing_file.hpp"
#include "file_plan.hpp"
#include "output_file.hpp"
#include "progress_bar.hpp"
#include "repaired_mesh.hpp"
#include "talweg/core/cutting/attribute_transfer.hpp"
#include "talweg/core/cutting/loop_filling.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/seam_opening.hpp"
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
  std::string repair;
  std::string keep;
  bool open = false;
  bool split = false;
  bool tag = false;
  std::string cap;
  double merge = CutOptions{}.merge;
  std::string mesh_units = "mm";
};

/// A mesh to be written, with the origin of its vertices and faces, and a record of what was done.
struct Part {
  MeshLists lists;
  MeshAttributes attributes;
  std::vector<std::uint32_t> vertices, faces;  // of the cut mesh
  Lids lids;
};

LidKind lid_kind(const std::string& name) {
  if (name == "auto") return LidKind::kAuto;
  if (name == "planar") return LidKind::kPlanar;
  if (name == "least-area") return LidKind::kLeastArea;
  throw Error(ErrorCode::kBadUsage,
              "--cap must be auto, planar or least-area, not \"" + name + "\".");
}

/// The part of the outputs' names before the pieces' numbers.
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
  void take_apart();
  [[nodiscard]] std::vector<bool> kept(const OpenedSeams& seams);
  [[noreturn]] void refuse_empty(const OpenedSeams& seams) const;
  void add_part(const OpenedSeams& seams, const std::vector<bool>& wanted);
  [[nodiscard]] std::string path_of(std::size_t part) const;
  [[nodiscard]] std::string map_json() const;
  [[nodiscard]] nlohmann::json vertex_json(std::uint32_t vertex) const;

  const CutCommandOptions& o_;
  Progress progress_;
  MeshAttributes attributes_;  // of the file's mesh, later of the cut mesh
  ReadMesh read_;
  SurfaceMesh mesh_;
  SnappedDrawing drawing_;
  CutMesh cut_;
  std::size_t pieces_ = 1;
  std::size_t between_ = 0;  // of those, pieces on the left of one curve and the right of another
  std::vector<Part> parts_;
  double cut_ms_ = 0;
  std::vector<std::string> left_out_;  // sentences, one for each format
};

Cutting::Cutting(const CutCommandOptions& options, Progress progress)
    : o_(options),
      progress_(std::move(progress)),
      read_(read_and_repair(options.mesh, options.repair, attributes_)),
      mesh_(SurfaceMesh::open(read_.lists)) {
  drawing_ = DrawingReader(mesh_, read_.map.get())
                 .read(o_.curves, LengthUnit::named(options.mesh_units), progress_);
  const Stopwatch watch;
  cut_ = cut_along(mesh_, drawing_.curves, {o_.merge});
  cut_.lists.single_precision = read_.lists.single_precision;
  take_apart();
  attributes_ = carried_to(cut_, mesh_.surface(), attributes_);
  for (Part& part : parts_) part.attributes = picked(attributes_, part.vertices, part.faces);
  cut_ms_ = watch.ms();
  if (!attributes_.left_out.empty()) {
    left_out_.push_back(
        fmt::format("Not carried over: {}.", fmt::join(attributes_.left_out, ", ")));
  }
}

void Cutting::take_apart() {
  if (!o_.open && !o_.split && o_.keep.empty() && o_.cap.empty()) {
    Part& part = parts_.emplace_back();
    part.lists = cut_.lists;
    for (std::uint32_t v = 0; v < cut_.lists.points.size(); ++v) part.vertices.push_back(v);
    for (std::uint32_t f = 0; f < cut_.lists.triangles.size(); ++f) part.faces.push_back(f);
    return;
  }
  const OpenedSeams seams = open_seams(cut_.lists, cut_.chains);
  pieces_ = seams.pieces;
  const std::vector<bool> wanted = kept(seams);
  if (!o_.split) return add_part(seams, wanted);
  for (std::size_t k = 0; k < seams.pieces; ++k) {
    if (!wanted[k]) continue;
    std::vector<bool> one(seams.pieces, false);
    one[k] = true;
    add_part(seams, one);
  }
}

/// The pieces on the requested side: a piece must be on that side of every curve along it. So no
/// piece is on both sides, however curves are nested.
std::vector<bool> Cutting::kept(const OpenedSeams& seams) {
  if (o_.keep.empty()) return std::vector<bool>(seams.pieces, true);
  std::vector<bool> wanted(seams.pieces, false), other(seams.pieces, false);
  for (std::size_t c = 0; c < seams.left.size(); ++c) {
    for (const std::uint32_t l : seams.left[c]) {
      for (const std::uint32_t r : seams.right[c]) {
        if (l != r) continue;
        throw Error(ErrorCode::kBadCurve,
                    fmt::format("Curve {} does not part its left from its right, so --keep {} says "
                                "nothing: the mesh hangs together around it.",
                                c, o_.keep));
      }
    }
    const bool left = o_.keep == "left";
    for (const std::uint32_t k : left ? seams.left[c] : seams.right[c]) wanted[k] = true;
    for (const std::uint32_t k : left ? seams.right[c] : seams.left[c]) other[k] = true;
  }
  for (std::size_t k = 0; k < seams.pieces; ++k) {
    if (wanted[k] && other[k]) ++between_;
    wanted[k] = wanted[k] && !other[k];
  }
  if (std::find(wanted.begin(), wanted.end(), true) == wanted.end()) refuse_empty(seams);
  return wanted;
}

void Cutting::refuse_empty(const OpenedSeams& seams) const {
  const bool left = o_.keep == "left";
  const char* const across = left ? "right" : "left";
  for (std::size_t c = 0; c < seams.left.size(); ++c) {
    for (const std::uint32_t k : left ? seams.left[c] : seams.right[c]) {
      for (std::size_t d = 0; d < seams.left.size(); ++d) {
        const auto& there = left ? seams.right[d] : seams.left[d];
        if (std::find(there.begin(), there.end(), k) == there.end()) continue;
        throw Error(ErrorCode::kBadCurve,
                    fmt::format("--keep {} leaves nothing: what lies on the {} of curve {} lies on "
                                "the {} of curve {}; turn one of them around.",
                                o_.keep, o_.keep, c, across, d));
      }
    }
  }
  const std::size_t n = seams.left.size();
  throw Error(
      ErrorCode::kBadCurve,
      fmt::format("--keep {} leaves nothing: {} no face on the {}.", o_.keep,
                  n == 1 ? "curve 0 has" : fmt::format("none of the curves 0 to {} has", n - 1),
                  o_.keep));
}

void Cutting::add_part(const OpenedSeams& seams, const std::vector<bool>& wanted) {
  Piece piece = piece_of(seams, wanted);
  Part& part = parts_.emplace_back();
  if (!o_.cap.empty()) {
    part.lids = add_lids(piece, seams, cut_.chains, lid_kind(o_.cap), progress_);
  }
  part.lists = std::move(piece.lists);
  part.faces = std::move(piece.faces);
  for (const std::uint32_t v : piece.vertices) {
    part.vertices.push_back(v == kNoVertex ? kNoVertex : seams.vertex_from[v]);
  }
}

/// With --split "out.ply" becomes "out-0.ply", "out-1.ply", ...
std::string Cutting::path_of(std::size_t part) const {
  if (!o_.split) return o_.output;
  return fmt::format("{}{}{}", split_prefix(o_), part,
                     std::filesystem::path(o_.output).extension().string());
}

/// [vertex], [a, b, part from a to b] or [a, b, c, barycentrics], in the numbers of the file.
nlohmann::json Cutting::vertex_json(std::uint32_t vertex) const {
  const Surface& surface = mesh_.surface();
  const auto number = [&](VertexId v) {
    return read_.map ? read_.map->file_vertex(v).index() : v.index();
  };
  const SurfacePoint& point = cut_.vertex_from[vertex];
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return {number(v->vertex)};
  if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    const HalfedgeId h = halfedge_of(e->edge);
    return {number(surface.tail(h)), number(surface.head(h)), e->t};
  }
  const auto& in = std::get<InFace>(point.where());
  nlohmann::json json;
  for (const VertexId v : surface.corners(in.face)) json.push_back(number(v));
  for (const double b : in.barycentric) json.push_back(b);
  return json;
}

std::string Cutting::map_json() const {
  nlohmann::json json = {{"format", "talweg-cut"}, {"version", 1}};
  nlohmann::json& parts = json["parts"] = nlohmann::json::array();
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& part = parts_[k];
    nlohmann::json vertices = nlohmann::json::array(), faces = nlohmann::json::array();
    std::vector<std::vector<std::uint32_t>> here(cut_.lists.points.size());
    for (std::uint32_t v = 0; v < part.vertices.size(); ++v) {
      if (part.vertices[v] == kNoVertex) {
        vertices.push_back(nullptr);
        continue;
      }
      vertices.push_back(vertex_json(part.vertices[v]));
      here[part.vertices[v]].push_back(v);
    }
    for (const std::uint32_t f : part.faces) {
      if (f == kNoFace) {
        faces.push_back(nullptr);
        continue;
      }
      const FaceId from{cut_.face_from[f]};
      faces.push_back(read_.map ? read_.map->file_face(from).index() : from.index());
    }
    nlohmann::json chains = nlohmann::json::array();
    for (const CutMesh::Chain& chain : cut_.chains) {
      nlohmann::json along = nlohmann::json::array();
      for (const std::uint32_t v : chain.vertices) along.push_back(here[v]);
      chains.push_back({{"closed", chain.closed}, {"vertices", std::move(along)}});
    }
    parts.push_back({{"file", path_of(k)},
                     {"vertices", std::move(vertices)},
                     {"faces", std::move(faces)},
                     {"curves", std::move(chains)}});
  }
  // A name of a file may be no UTF-8, and JSON must be.
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void Cutting::write() {
  const std::string map = o_.map.empty() ? "" : map_json();
  std::vector<std::string> left_out;  // the same for all parts
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& part = parts_[k];
    std::vector<TaggedEdge> edges;
    if (o_.tag) edges = tagged_edges(part.lists.triangles, part.vertices, cut_.chains);
    MeshBytes file = mesh_bytes(path_of(k), part.lists, part.attributes, edges);
    write_output(path_of(k), file.bytes);
    left_out = std::move(file.left_out);
  }
  if (!left_out.empty()) {
    left_out_.push_back(fmt::format("{} does not hold: {}.", o_.output, fmt::join(left_out, ", ")));
  }
  if (!o_.map.empty()) write_output(o_.map, map);
}

std::string Cutting::summary() const {
  std::string text =
      fmt::format("{} curves cut {} faces; {} vertices are new, {} of them where curves cross\n",
                  drawing_.curves.size(), cut_.cut_faces, cut_.new_vertices, cut_.crossings);
  if (cut_.merged > 0) {
    text += fmt::format(
        "{} points lay at a vertex or an edge but for rounding; moved by {:.3g} at most\n",
        cut_.merged, cut_.largest_move);
  }
  for (const std::string& change : read_.changes) text += change + "\n";
  for (const std::string& sentence : left_out_) text += sentence + "\n";
  for (const std::string& warning : reading_warnings(drawing_, read_.lists.polygon_count)) {
    text += warning + "\n";
  }
  if (o_.open || o_.split || !o_.cap.empty() || !o_.keep.empty()) {
    text += fmt::format("{} {}\n", pieces_, pieces_ == 1 ? "piece" : "pieces");
    if (between_ > 0) {
      text += fmt::format(
          "{} of them left out: on the left of one curve and on the right of another\n", between_);
    }
  }
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& part = parts_[k];
    text += fmt::format("{}: {} vertices, {} faces", path_of(k), part.lists.points.size(),
                        part.lists.triangles.size());
    if (!o_.cap.empty()) {
      text += fmt::format(", {} rims closed by {} faces, {} of them plane", part.lids.filled,
                          part.lids.triangles, part.lids.planar);
    }
    if (part.lids.with_inner > 0) {
      text += fmt::format(", {} of them with points inside", part.lids.with_inner);
    }
    if (part.lids.sunk_by > 0) {
      text += fmt::format(", moved by up to {:.3g} to clear the piece", part.lids.sunk_by);
    }
    if (part.lids.left_open > 0) {
      text += fmt::format("; {} rims stay open: slits, or they end at the old boundary",
                          part.lids.left_open);
    }
    text += "\n";
  }
  return text + fmt::format("cut in {:.1f} ms\n", cut_ms_);
}

void check(const CutCommandOptions& o) {
  if (!o.cap.empty()) lid_kind(o.cap);
  const std::string ending = lower_extension(o.output);
  if (o.tag && ending != ".ply" && ending != ".obj") {
    throw Error(ErrorCode::kBadUsage, "--tag needs an output that holds edges: .ply or .obj.");
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
                "--split writes several files, and the standard output is one.");
  } else {
    files.writes("-o", o.output, check_mesh_name);
  }
  files.writes("--map", o.map);
  files.check();
}

}  // namespace

Command add_cut(CLI::App& app, const GlobalOptions& global) {
  auto o = std::make_shared<CutCommandOptions>();
  CLI::App* command = app.add_subcommand("cut",
                                         "Make curves edges of the mesh, exactly: no vertex moves, "
                                         "new ones only on edges and in faces; "
                                         "then take it apart along them");
  command->add_option("mesh", o->mesh, "Mesh: OBJ, OFF, PLY, STL or OM")->required();
  command->add_option("--curve", o->curves, "Curves to cut along; may be given several times")
      ->required();
  command->add_option("-o,--output", o->output, "The cut mesh: .ply, .obj, .off or .stl")
      ->required();
  command->add_flag("--open", o->open, "Open a seam: either side of it has vertices of its own");
  command->add_flag("--split", o->split,
                    "A file for each piece, OUT-0.ply, OUT-1.ply, ...; without it the pieces are "
                    "components of one");
  command->add_option("--keep", o->keep,
                      "left or right: only pieces on that side of every curve along them, seen "
                      "along the curve from outside");
  command->add_flag("--cap{auto}", o->cap,
                    "Close what the cut leaves open: auto (plane where the rim is, else of least "
                    "area; the default), planar or least-area, after an equals sign; never through "
                    "the piece");
  command->add_flag("--tag", o->tag,
                    "Write the curves' edges, too: element edge of a .ply, l of an .obj");
  command->add_option("--map", o->map,
                      "JSON: where every vertex and face comes from, and the curves' vertices");
  command
      ->add_option("--merge", o->merge,
                   "Points within this part of an edge of a vertex, an edge or each other are one")
      ->capture_default_str();
  add_repair_option(*command, o->repair);
  add_unit_option(*command, o->mesh_units);
  return [o, &global] {
    check(*o);
    LengthUnit::named(o->mesh_units);
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
