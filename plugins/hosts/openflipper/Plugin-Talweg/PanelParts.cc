#include "PanelParts.hh"

namespace talweg::openflipper {

QToolButton* make_button(QWidget* parent, const QString& name, Sign sign, const QString& text,
                         const QString& tip) {
  auto* made = new QToolButton(parent);
  made->setObjectName("talweg" + name);
  made->setText(text);
  made->setIcon(icon_of(sign));
  made->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  made->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  made->setToolTip(tip);
  return made;
}

QHBoxLayout* row_of(std::initializer_list<QWidget*> widgets) {
  auto* row = new QHBoxLayout;
  row->setSpacing(3);
  for (QWidget* widget : widgets) row->addWidget(widget, 1);
  return row;
}

QVBoxLayout* tight(QWidget* parent) {
  auto* all = new QVBoxLayout(parent);
  all->setContentsMargins(3, 2, 3, 3);
  all->setSpacing(3);
  return all;
}

}  // namespace talweg::openflipper
