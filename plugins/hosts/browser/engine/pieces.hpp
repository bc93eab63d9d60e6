// Pieces are what curves take a mesh apart into.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh_files.hpp"

namespace talweg::browser {

class Pieces {
 public:
  /// A mesh that is repaired may be welded within a tolerance, in mesh units.
  Pieces(const editing::Plugins& plugins, FileMesh mesh, editing::Defects defects,
         double weld_within);

  /// All pieces along the curves. Throws host::Error.
  void cut(const std::vector<host::Curve>& curves);
  /// One of them, its rims closed by lids if asked. Throws editing::Error for one that is not
  /// there.
  void keep(std::size_t part, bool lids);

  /// What cut() or keep() gave last, with what the plugin had to say.
  [[nodiscard]] const std::vector<host::Mesh>& meshes() const { return meshes_; }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  /// The same as one mesh, with its attributes.
  [[nodiscard]] FileMesh together() const;
  /// Each piece alone. What cut() or keep() gave last stays.
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
