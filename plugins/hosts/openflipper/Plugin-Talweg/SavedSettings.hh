// Settings that are kept when the host ends.
#pragma once

#include <QString>

#include "talweg/editing/drawing.hpp"

namespace talweg::openflipper {

/// The settings of a new drawing. Without a window nothing is saved, so that a script always begins
/// with the defaults.
editing::Settings saved_settings();
void save_settings(const editing::Settings& settings);

/// Whether drawn points are shown.
bool saved_points();
void save_points(bool shown);

/// The folder of the last file that the user read or wrote.
QString saved_folder();
void save_folder(const QString& folder);

}  // namespace talweg::openflipper
