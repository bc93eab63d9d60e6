// Panel parts are made alike everywhere in the panel.
#pragma once

#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <initializer_list>

#include "PanelIcons.hh"

namespace talweg::openflipper {

/// An icon with its text, as wide as there is room.
QToolButton* make_button(QWidget* parent, const QString& name, Sign sign, const QString& text,
                         const QString& tip);
/// Buttons side by side, equally wide.
QHBoxLayout* row_of(std::initializer_list<QWidget*> widgets);
/// A column with small gaps.
QVBoxLayout* tight(QWidget* parent);

}  // namespace talweg::openflipper
