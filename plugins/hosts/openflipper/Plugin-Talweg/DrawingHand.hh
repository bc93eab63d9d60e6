// Turns the user's mouse and keys in the host's views into edits while curves are drawn.
#pragma once

#include <QMouseEvent>
#include <QObject>
#include <QPoint>
#include <optional>

#include "UnderMouse.hh"
#include "ViewHand.hh"

namespace talweg::openflipper {

class DrawingHand : public QObject {
  Q_OBJECT
 public:
  /// The host's pick mode.
  static constexpr const char* kPickMode = "Talweg: draw";

  DrawingHand(Sessions& sessions, HostCalls& host)
      : sessions_(sessions), host_(host), under_mouse_(sessions, host) {}

  /// Whether the mouse draws.
  [[nodiscard]] bool draws() const;
  void set_draws(bool on);
  /// A mouse event of a viewer.
  void mouse(QMouseEvent& event);
  /// Handles Enter, Esc and Backspace while a curve is drawn; true if the key was used.
  bool key(int key);
  /// Releases the held point or curve, since it may no longer exist.
  void let_go();
  void reach_no_more();

 protected:
  /// Filters events of the whole program.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void press(const QMouseEvent& event);
  void press_point(Session& session, const Handle& handle, Qt::KeyboardModifiers modifiers);
  void insert_point(Session& session, const CurvePlace& place, const QPoint& at);
  void begin_stroke(const QPoint& at);
  void move(const QMouseEvent& event);
  void release();
  void double_click(const QMouseEvent& event);
  bool key_event(QEvent* event);
  void give_mouse(bool to_host);
  std::optional<Picked> picked(const QPoint& at) {
    return under_mouse_.picked(at, dragged_ || painting_);
  }
  void hint(const std::optional<Handle>& handle, const std::optional<CurvePlace>& curve);
  void reach(const QPoint& at, const std::optional<Handle>& handle);

  Sessions& sessions_;
  HostCalls& host_;
  UnderMouse under_mouse_;
  ViewHand view_hand_{[this](bool host) { give_mouse(host); }};
  std::optional<Handle> dragged_;
  std::optional<CurvePlace> pressed_curve_;  // becomes a click on the curve if the mouse does not
                                             // move
  QPoint pressed_at_;
  bool painting_ = false;
  QPoint last_painted_;
  bool reaching_ = false;    // whether the scene shows a leg to the mouse
  bool drops_moves_ = true;  // Qt's setting outside strokes
};

}  // namespace talweg::openflipper
