// Turns, moves and zooms the view while a curve is drawn and the host passes the mouse to the
// plugin: as the host does, except that the right button turns.
#pragma once

#include <QEvent>
#include <QMouseEvent>
#include <QObject>
#include <QPoint>
#include <functional>

namespace talweg::openflipper {

class ViewHand {
 public:
  /// `examine` passes the mouse to the host's own navigation (true), or back to the plugin (false).
  explicit ViewHand(std::function<void(bool)> examine) : examine_(std::move(examine)) {}

  /// Must get every event of a viewer while curves are drawn; true if the event was used.
  bool take(QObject* viewer, QEvent* event);
  /// Whether the host has the mouse.
  [[nodiscard]] bool holds() const { return held_ != Qt::NoButton; }

 private:
  bool take_press(QObject* viewer, const QMouseEvent& event);
  bool take_move(QObject* viewer, QMouseEvent& event);
  bool take_release(QObject* viewer, QMouseEvent& event);
  void pass(QObject* viewer, QEvent& event);
  void pass_as_left(QObject* viewer, QEvent::Type type, const QMouseEvent& event);

  std::function<void(bool)> examine_;
  Qt::MouseButton held_ = Qt::NoButton;
  QPoint pressed_;
  bool turns_ = false;    // whether the mouse has moved with the right button pressed
  bool passing_ = false;  // whether the event was sent by this object
};

}  // namespace talweg::openflipper
