// The library's curve files are offered to hosts here (talweg_curve_files.h).
#pragma once

#include "talweg/plugin/talweg_curve_files.h"

namespace talweg::plugins {

/// A constant that stays valid as long as the module.
const talweg_curve_files* curve_files();
const talweg_curve_files_2* curve_files_2();
const talweg_curve_files_3* curve_files_3();

}  // namespace talweg::plugins
