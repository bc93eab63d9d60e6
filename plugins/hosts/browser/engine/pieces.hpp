// The pieces of a mesh between curves.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh_files.hpp"

namespace talweg::browser {

class Pieces {
 public:
  /// `weld_within` is the tolerance of a repair's welding, mesh units.
  Pieces(const editing::Plugins& plugins, FileMesh mesh, editing::Defects defects,
         double weld_within);

  /// All pieces along the curves. Throws host::Error.
  void cut(const std::vector<host::Curve>& curves);
  /// Keeps one piece, on request with lids on its boundary loops. Throws editing::Error if there is
  /// no such piece.
  void keep(std::size_t part, bool lids);

  /// The result of the last cut() or keep(), with the plugin's warnings.
  [[nodiscard]] const std::vector<host::Mesh>& meshes() const { return meshes_; }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  /// The result as one mesh, with its attributes.
  [[nodiscard]] FileMesh together() const;
  /// Each piece as a mesh. The result of the last cut() or keep() stays.
  [[nodiscard]] std::vector<FileMesh> each(bool lids);

 private:
  struct Piece {
    host::Mesh mesh;
    std::vector<host::Attribute> attributes;
  };
  void run(bool lids);
  std::vector<Piece> made(bool lids);

  std::vector<std::string> notes_;
  host::Services services_;
  host::Instance instance_;
  std::vector<host::Mesh> meshes_;
  std::vector<std::vector<host::Attribute>> attributes_;
};

}  // namespace talweg::browser
