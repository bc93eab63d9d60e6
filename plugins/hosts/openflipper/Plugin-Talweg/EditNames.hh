// Edit names are those of the editing model, in the language of the panel.
#pragma once

#include <QString>
#include <string>

namespace talweg::openflipper {

/// A name that is not known is given back as it is.
QString name_of_edit(const std::string& name);

}  // namespace talweg::openflipper
