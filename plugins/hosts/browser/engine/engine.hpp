// The engine does the page's work on one mesh (src/engine/engine.ts).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "answer.hpp"
#include "mesh_files.hpp"
#include "offsets.hpp"
#include "pieces.hpp"

namespace talweg::browser {

/// All methods throw host::Error or editing::Error, with a sentence for the user of the page.
class Engine {
 public:
  explicit Engine(const editing::Plugins& plugins) : plugins_(&plugins) {}

  /// Reads and opens a mesh file: `MeshInfo`. If the file cannot be read, the earlier mesh stays.
  /// `weld_within` is the tolerance of a repair's welding, mesh units; nothing: a tolerance chosen
  /// from the mesh.
  Answer open(const std::string& name, std::string_view bytes, bool repair,
              std::optional<double> weld_within = {});
  /// The UCUM code of the mesh's unit, for files that name a unit; empty: the unit of the mesh's
  /// file.
  Answer set_unit(const std::string& unit);
  /// Sizes and defects of the mesh as a text (mesh_words.hpp). It takes several times as long as
  /// opening the mesh.
  Answer words() const;
  /// A mesh file for a first try.
  Answer sample() const;

  /// `hand` as in engine.ts.
  Answer smooth(const editing::Drawing& drawing, const std::string& hand);
  Answer draw(const editing::Drawing& drawing);
  Answer leg(const editing::Point& from, const editing::Point& to);
  /// The comb of a curve of the last smoothing.
  Answer comb(std::size_t curve, double spacing) const;

  /// Curves at a distance from the last curves that were smoothed with the hand at rest: `Offset`.
  Answer offset(const OffsetWish& wish);

  /// The pieces along the smoothed curves of a drawing, or along its last offset: `CutResult`.
  Answer cut(const editing::Drawing& drawing, bool along_offset);
  Answer keep(std::size_t part, bool lids);
  /// Borders of labels, one label for each face; without values, of the labels in the mesh's file.
  Answer labels(std::optional<std::vector<double>> values) const;

  /// Files have the mesh's name. The format "drawn.json" is the drawing itself; `what` is "smooth"
  /// or "offset".
  Answer save_curves(const std::string& format, const std::string& what) const;
  Answer save_mesh(const std::string& format) const;
  /// A file for each part of the cut mesh, even if one part is kept alone.
  Answer save_parts(const std::string& format, bool lids);
  Answer read_curves(const std::string& name, std::string_view bytes);

 private:
  void need_mesh() const;
  void forget_offsets() {
    if (offsets_) offsets_->clear();
  }
  editing::Outcome work(editing::Request request);
  Answer pieces() const;

  const editing::Plugins* plugins_;
  std::string stem_;
  FileMesh mesh_;
  std::string file_frame_;  // frame of the mesh's file
  editing::Defects defects_ = editing::Defects::kRefuse;
  double weld_within_ = 0;  // mesh units, for a repaired mesh
  double mean_edge_ = 0;
  std::unique_ptr<editing::Workplace> workplace_;
  std::optional<editing::Drawing> smoothed_;  // the drawing of `results_`, with the hand at rest
  editing::Drawing last_;
  host::Results results_;
  std::unique_ptr<Offsets> offsets_;
  std::unique_ptr<Pieces> pieces_;
  bool is_cut_ = false;
};

}  // namespace talweg::browser
