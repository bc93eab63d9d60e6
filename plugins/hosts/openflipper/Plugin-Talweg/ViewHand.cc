#include "ViewHand.hh"

#include <QContextMenuEvent>
#include <QCoreApplication>

#include "HostVersion.hh"

namespace talweg::openflipper {

bool ViewHand::take(QObject* viewer, QEvent* event) {
  if (passing_) return false;
  switch (event->type()) {
    case QEvent::Wheel:
      if (holds()) return true;
      examine_(true);
      pass(viewer, *event);
      examine_(false);
      return true;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return take_press(viewer, *static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return take_move(viewer, *static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return take_release(viewer, *static_cast<QMouseEvent*>(event));
    case QEvent::ContextMenu:  // sent with the press; a click without movement sends it again
      return held_ == Qt::RightButton;
    default:
      return false;
  }
}

bool ViewHand::take_press(QObject* viewer, const QMouseEvent& event) {
  if (holds()) return true;
  const bool ours = event.button() == Qt::MiddleButton || event.button() == Qt::RightButton;
  if (!ours || event.buttons() != event.button()) return false;
  held_ = event.button();
  pressed_ = position_of(event);
  turns_ = false;
  examine_(true);
  if (held_ == Qt::MiddleButton) {
    QMouseEvent press(event);
    pass(viewer, press);
  }
  return true;
}

bool ViewHand::take_move(QObject* viewer, QMouseEvent& event) {
  if (!holds()) return false;
  if (held_ == Qt::MiddleButton) {
    pass(viewer, event);
    return true;
  }
  if (!turns_ && (position_of(event) - pressed_).manhattanLength() < 4) return true;
  if (!turns_) pass_as_left(viewer, QEvent::MouseButtonPress, event);
  turns_ = true;
  pass_as_left(viewer, QEvent::MouseMove, event);
  return true;
}

bool ViewHand::take_release(QObject* viewer, QMouseEvent& event) {
  if (!holds()) return false;
  if (event.button() != held_) return true;
  if (held_ == Qt::MiddleButton) pass(viewer, event);
  if (turns_) pass_as_left(viewer, QEvent::MouseButtonRelease, event);
  const bool clicked = held_ == Qt::RightButton && !turns_;
  held_ = Qt::NoButton;
  examine_(false);
  if (clicked) {
    QContextMenuEvent menu(QContextMenuEvent::Mouse, position_of(event), event.globalPos());
    pass(viewer, menu);
  }
  return true;
}

void ViewHand::pass(QObject* viewer, QEvent& event) {
  passing_ = true;
  QCoreApplication::sendEvent(viewer, &event);
  passing_ = false;
}

void ViewHand::pass_as_left(QObject* viewer, QEvent::Type type, const QMouseEvent& event) {
  const bool moves = type == QEvent::MouseMove;
  const bool ends = type == QEvent::MouseButtonRelease;
  QMouseEvent left(type, position_of(event), event.globalPos(),
                   moves ? Qt::NoButton : Qt::LeftButton, ends ? Qt::NoButton : Qt::LeftButton,
                   event.modifiers());
  pass(viewer, left);
}

}  // namespace talweg::openflipper
