// Many vessels, each with a drawing, for runs over whole data sets.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/scenes/scenes.hpp"

namespace talweg::scenes {

/// Vessels of ten resolutions, 5,000 to 50,000 faces, each bent and dented differently, with its
/// own drawing. Equal numbers give equal vessels.
class Patients {
 public:
  /// Makes the ten meshes; takes seconds.
  Patients();
  /// The name is "vessel" and the number in five digits.
  [[nodiscard]] DemoScene scene(std::size_t number) const;

 private:
  std::vector<MeshLists> meshes_;
};

}  // namespace talweg::scenes
