// Widgets and layouts that the panel's parts share.
#pragma once

#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <initializer_list>

#include "PanelIcons.hh"

namespace talweg::openflipper {

/// A button with an icon and a text, as wide as the layout allows.
QToolButton* make_button(QWidget* parent, const QString& name, Sign sign, const QString& text,
                         const QString& tip);
/// Buttons side by side, of equal width.
QHBoxLayout* row_of(std::initializer_list<QWidget*> widgets);
/// A column with small gaps.
QVBoxLayout* tight(QWidget* parent);

}  // namespace talweg::openflipper
