// Checks a scene before it is drawn.
#pragma once

#include "tools/picture/render.hpp"

namespace talweg::picture {

/// Throws the errors that render() names.
void check_scene(const Scene& scene);

}  // namespace talweg::picture
