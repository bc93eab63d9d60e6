// Names of edits in the language of the panel.
#pragma once

#include <QString>
#include <string>

namespace talweg::openflipper {

/// The translated name; an unknown name is returned unchanged.
QString name_of_edit(const std::string& name);

}  // namespace talweg::openflipper
