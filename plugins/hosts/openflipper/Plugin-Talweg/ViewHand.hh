// The view hand turns, moves and zooms the view while a curve is drawn, when the host gives the
// mouse to the plugin: as the host itself does, but turning is on the right button.
#pragma once

#include <QEvent>
#include <QMouseEvent>
#include <QObject>
#include <QPoint>
#include <functional>

namespace talweg::openflipper {

class ViewHand {
 public:
  /// `examine` gives the mouse to the host's own navigation (true), or back to the plugin.
  explicit ViewHand(std::function<void(bool)> examine) : examine_(std::move(examine)) {}

  /// To be asked of every event of a viewer while curves are drawn; true where the event was taken.
  bool take(QObject* viewer, QEvent* event);
  /// Whether the host has the mouse now.
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
  bool turns_ = false;    // the right button has moved
  bool passing_ = false;  // the event is sent by this object
};

}  // namespace talweg::openflipper
