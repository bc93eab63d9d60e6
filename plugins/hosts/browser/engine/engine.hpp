// The engine does what the page asks for on one mesh (src/engine/engine.ts).
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

/// Everything throws host::Error or editing::Error, with a sentence for the person at the page.
class Engine {
 public:
  explicit Engine(const editing::Plugins& plugins) : plugins_(&plugins) {}

  /// Reads and opens a mesh file: `MeshInfo`. One that cannot be read leaves the mesh that was
  /// there. A repair welds within so many mesh units; nothing: as far as the mesh seems to ask for.
  Answer open(const std::string& name, std::string_view bytes, bool repair,
              std::optional<double> weld_within = {});
  /// The UCUM code of the mesh's unit, for the files that name one; empty: what its file says.
  Answer set_unit(const std::string& unit);
  /// What `talweg info` tells of the mesh. It takes several times as long as opening it.
  Answer words() const;
  /// A file with a mesh to begin with.
  Answer sample() const;

  /// `hand` as in engine.ts.
  Answer smooth(const editing::Drawing& drawing, const std::string& hand);
  Answer draw(const editing::Drawing& drawing);
  Answer leg(const editing::Point& from, const editing::Point& to);
  /// Teeth along a curve of the last smoothing.
  Answer comb(std::size_t curve, double spacing) const;

  /// Curves at a distance from those of the last smoothing with the hand at rest: `Offset`.
  Answer offset(const OffsetWish& wish);

  /// The pieces along the smoothed curves of a drawing, or along its last offset: `CutResult`.
  Answer cut(const editing::Drawing& drawing, bool along_offset);
  Answer keep(std::size_t part, bool lids);
  /// Borders of labels, one for each face; without any those of the mesh's file.
  Answer labels(std::optional<std::vector<double>> values) const;

  /// Files have the mesh's name. The format "drawn.json" is the drawing itself; `what` is "smooth"
  /// or "offset".
  Answer save_curves(const std::string& format, const std::string& what) const;
  Answer save_mesh(const std::string& format) const;
  /// A file for each part of the cut mesh, also where one is kept alone.
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
  std::string file_frame_;  // as its file has it
  editing::Defects defects_ = editing::Defects::kRefuse;
  double weld_within_ = 0;  // mesh units, if it is repaired
  double mean_edge_ = 0;
  std::unique_ptr<editing::Workplace> workplace_;
  std::optional<editing::Drawing> smoothed_;  // of which `results_` are, with the hand at rest
  editing::Drawing last_;
  host::Results results_;
  std::unique_ptr<Offsets> offsets_;
  std::unique_ptr<Pieces> pieces_;
  bool is_cut_ = false;
};

}  // namespace talweg::browser
