// Names of objects and materials become names of faces, as OBJ files have them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "talweg/core/io/text_words.hpp"
#include "talweg/core/mesh/mesh_attributes.hpp"

namespace talweg::formats {

/// Collects the names of faces in their order.
class FaceNaming {
 public:
  explicit FaceNaming(const char* keyword) { names_.keyword = keyword; }

  /// Names all faces up to `faces` that have no name yet; "" stands for no name.
  void add(const std::string& name, std::size_t faces) {
    const std::string shown = printable(name);
    const auto next = static_cast<std::uint32_t>(names_.names.size());
    const auto [place, fresh] = places_.emplace(shown, next);
    if (fresh) names_.names.push_back(shown);
    names_.of_face.resize(faces, place->second);
  }
  /// Moves the names to the attributes of a mesh, if any face has a name.
  void give(MeshAttributes& to) {
    if (names_.names.size() > 1) to.names.push_back(std::move(names_));
  }

 private:
  FaceNames names_;
  std::map<std::string, std::uint32_t> places_{{"", 0}};
};

}  // namespace talweg::formats
