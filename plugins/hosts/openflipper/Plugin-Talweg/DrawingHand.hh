// The drawing hand is a person's mouse and keys while curves are drawn in the host's views.
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
  /// Of a viewer.
  void mouse(QMouseEvent& event);
  /// Enter, Esc and Backspace while a curve is drawn; true where the key was ours.
  bool key(int key);
  /// Nothing is held any more, since it may be gone.
  void let_go();
  void reach_no_more();

 protected:
  /// Of the whole program.
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
  std::optional<CurvePlace> pressed_curve_;  // a click on it if the mouse moves no more
  QPoint pressed_at_;
  bool painting_ = false;
  QPoint last_painted_;
  bool reaching_ = false;    // the scene shows a leg to the mouse
  bool drops_moves_ = true;  // whether Qt does, but for a stroke
};

}  // namespace talweg::openflipper
