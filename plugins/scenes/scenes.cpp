#include "scenes/scenes.hpp"

namespace talweg::scenes {

std::vector<DemoScene> demo_scenes() { return {vessel_scene(), figure_scene(), terrain_scene()}; }

}  // namespace talweg::scenes
