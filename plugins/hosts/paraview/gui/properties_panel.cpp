#include "properties_panel.hpp"

#include <QMetaObject>
#include <QWidget>

void apply_panel_of(QWidget& widget) {
  QWidget* panel = widget.parentWidget();
  while (panel != nullptr && !panel->inherits("pqPropertiesPanel")) panel = panel->parentWidget();
  if (panel != nullptr) QMetaObject::invokeMethod(panel, "apply");
}
