#include "SavedSettings.hh"

#include <algorithm>

#include <OpenFlipper/common/GlobalOptions.hh>

namespace talweg::openflipper {

editing::Settings saved_settings() {
  editing::Settings settings;
  if (!OpenFlipper::Options::gui()) return settings;
  settings.tau = std::max(0.0, OpenFlipperSettings().value("Plugin-Talweg/tau", 1.0).toDouble());
  return settings;
}

void save_settings(const editing::Settings& settings) {
  OpenFlipperSettings().setValue("Plugin-Talweg/tau", settings.tau);
}

bool saved_points() {
  return !OpenFlipper::Options::gui() ||
         OpenFlipperSettings().value("Plugin-Talweg/points", true).toBool();
}

void save_points(bool shown) { OpenFlipperSettings().setValue("Plugin-Talweg/points", shown); }

QString saved_folder() { return OpenFlipperSettings().value("Plugin-Talweg/folder").toString(); }

void save_folder(const QString& folder) {
  OpenFlipperSettings().setValue("Plugin-Talweg/folder", folder);
}

}  // namespace talweg::openflipper
