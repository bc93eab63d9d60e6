// The library's mesh files are offered to hosts here (talweg_mesh_files.h).
#pragma once

#include "talweg/plugin/talweg_mesh_files.h"

namespace talweg::plugins {

/// A constant that stays valid as long as the module.
const talweg_mesh_files* mesh_files();

}  // namespace talweg::plugins
