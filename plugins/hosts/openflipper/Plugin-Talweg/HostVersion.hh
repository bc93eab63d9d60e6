// The only code that depends on the version of OpenFlipper: 4.x with Qt 5, 5.x with Qt 6.
#pragma once

#include <QMouseEvent>
#include <QPoint>
#include <QString>
#include <QtGlobal>

#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
#define TALWEG_OPENFLIPPER_5
#endif

namespace talweg::openflipper {

inline QPoint position_of(const QMouseEvent& event) {
#ifdef TALWEG_OPENFLIPPER_5
  return event.position().toPoint();
#else
  return event.pos();
#endif
}

}  // namespace talweg::openflipper
