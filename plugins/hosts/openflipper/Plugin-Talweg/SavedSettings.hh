// Saved settings last from one start of the host to the next.
#pragma once

#include <QString>

#include "talweg/editing/drawing.hpp"

namespace talweg::openflipper {

/// Those of a new drawing. Without a window nothing is saved: a script says what it wants.
editing::Settings saved_settings();
void save_settings(const editing::Settings& settings);

/// Whether drawn points are shown.
bool saved_points();
void save_points(bool shown);

/// Where a person reads and writes files.
QString saved_folder();
void save_folder(const QString& folder);

}  // namespace talweg::openflipper
