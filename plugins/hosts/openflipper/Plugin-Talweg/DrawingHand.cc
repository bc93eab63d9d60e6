#include "DrawingHand.hh"

#include <QApplication>
#include <QKeyEvent>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>
#include <OpenFlipper/common/GlobalOptions.hh>

#include "HostVersion.hh"
#include "talweg/editing/legs.hpp"

namespace talweg::openflipper {

using editing::Editor;

namespace {

bool is_drawing_key(int key) {
  return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Escape ||
         key == Qt::Key_Backspace;
}

}  // namespace

bool DrawingHand::draws() const {
  return OpenFlipper::Options::gui() && PluginFunctions::pickMode() == kPickMode &&
         (view_hand_.holds() || PluginFunctions::actionMode() == Viewer::PickingMode);
}

void DrawingHand::set_draws(bool on) {
  if (!OpenFlipper::Options::gui()) return;
  give_mouse(!on || sessions_.target() == nullptr);
  host_.changed();
}

void DrawingHand::give_mouse(bool to_host) {
  if (to_host) {
    PluginFunctions::actionMode(Viewer::ExamineMode);
    return;
  }
  PluginFunctions::actionMode(Viewer::PickingMode);
  PluginFunctions::pickMode(kPickMode);
}

void DrawingHand::mouse(QMouseEvent& event) {
  if (!draws()) return;
  switch (event.type()) {
    case QEvent::MouseButtonPress:
      if (event.button() == Qt::LeftButton) press(event);
      return;
    case QEvent::MouseMove:
      return move(event);
    case QEvent::MouseButtonRelease:
      return release();
    case QEvent::MouseButtonDblClick:
      if (event.button() == Qt::LeftButton) double_click(event);
      return;
    default:
      return;
  }
}

void DrawingHand::press(const QMouseEvent& event) {
  const QPoint at = position_of(event);
  const auto handle = under_mouse_.handle(at);
  Session* session = sessions_.now();
  if (handle && session != nullptr) return press_point(*session, *handle, event.modifiers());
  const auto curve = under_mouse_.curve(at);
  if (event.modifiers() & Qt::ControlModifier) {
    if (curve) insert_point(*session, *curve, at);
    return;
  }
  if (event.modifiers() & Qt::ShiftModifier) return;  // the click missed the point to be removed
  pressed_at_ = at;
  pressed_curve_ = session != nullptr && session->editor().is_drawing() ? std::nullopt : curve;
  if (!pressed_curve_) begin_stroke(at);
}

void DrawingHand::press_point(Session& session, const Handle& handle,
                              Qt::KeyboardModifiers modifiers) {
  const auto& drawing = session.drawing();
  const bool on_first = handle.point == 0 && handle.curve + 1 == drawing.curves.size() &&
                        drawing.unfinished && drawing.curves.back()->points.size() >= 3;
  if (on_first) {
    session.edit([](Editor& e) { e.close_curve(); });
  } else if (modifiers & Qt::ShiftModifier) {
    session.edit([&](Editor& e) { e.remove_point(handle.curve, handle.point); });
  } else {
    session.select(handle.curve);
    dragged_ = handle;
    session.begin_gesture("Move point", true);
  }
}

/// The new point can be dragged at once; insertion and drag are one step of undo.
void DrawingHand::insert_point(Session& session, const CurvePlace& place, const QPoint& at) {
  const auto there = picked(at);
  if (!there || there->session != &session) return;
  session.begin_gesture("Insert point", true);
  session.edit([&](Editor& e) {
    const auto& curve = *e.drawing().curves[place.curve];
    std::vector<editing::Vector> given;
    for (const editing::Point& p : curve.points) {
      given.push_back(editing::position_of(session.arrays(), p));
    }
    const std::size_t before =
        editing::leg_at(given, place.line->positions, curve.closed, place.segment);
    e.insert_point(place.curve, before, *there->point);
    dragged_ = {place.curve, before};
  });
  session.select(place.curve);
}

void DrawingHand::begin_stroke(const QPoint& at) {
  const auto there = picked(at);
  if (!there) return;
  there->session->begin_gesture("Draw");
  there->session->edit([&](Editor& e) { e.add_point(*there->point); });
  painting_ = true;
  last_painted_ = at;
  // While the host draws its picture, Qt drops all movements of the mouse except the last, and so
  // most of a stroke.
  drops_moves_ = QCoreApplication::testAttribute(Qt::AA_CompressHighFrequencyEvents);
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
}

void DrawingHand::move(const QMouseEvent& event) {
  const QPoint at = position_of(event);
  if (pressed_curve_ && (at - pressed_at_).manhattanLength() >= 4) {  // a stroke that starts on the
                                                                      // curve, and no click on it
    pressed_curve_.reset();
    begin_stroke(pressed_at_);
  }
  if (dragged_) {
    const auto there = picked(at);
    if (!there) return;
    there->session->edit(
        [&](Editor& e) { e.move_point(dragged_->curve, dragged_->point, *there->point); });
  } else if (painting_) {
    if ((at - last_painted_).manhattanLength() < 4) return;
    const auto there = picked(at);
    if (!there) return;
    there->session->edit([&](Editor& e) { e.paint_point(*there->point); });
    last_painted_ = at;
  } else if (!pressed_curve_) {
    const auto handle = under_mouse_.handle(at);
    hint(handle, handle ? std::nullopt : under_mouse_.curve(at));
    reach(at, handle);
  }
}

/// Shows the leg to the mouse. If the host would have to draw its scene to find the place under the
/// mouse, no leg is shown, since every movement would take too long.
void DrawingHand::reach(const QPoint& at, const std::optional<Handle>& handle) {
  Session* session = sessions_.now();
  if (session == nullptr || !session->editor().is_drawing()) return reach_no_more();
  const auto& curve = *session->drawing().curves.back();
  if (handle && handle->point == 0 && curve.points.size() >= 3) {
    session->reach_for(curve.points.front());
  } else if (const auto there = under_mouse_.picked_by_us(at); there && !handle) {
    session->reach_for(there->point);
  } else {
    return reach_no_more();
  }
  reaching_ = true;
}

void DrawingHand::reach_no_more() {
  Session* session = sessions_.now();
  if (reaching_ && session != nullptr) session->reach_for(std::nullopt);
  reaching_ = false;
}

void DrawingHand::release() {
  if (pressed_curve_) sessions_.now()->select(pressed_curve_->curve);
  if (Session* session = sessions_.now(); session != nullptr && (dragged_ || painting_)) {
    session->end_gesture();
  }
  let_go();
}

void DrawingHand::let_go() {
  dragged_.reset();
  pressed_curve_.reset();
  if (painting_) QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, drops_moves_);
  painting_ = false;
}

void DrawingHand::double_click(const QMouseEvent& event) {
  const auto handle = under_mouse_.handle(position_of(event));
  Session* session = sessions_.now();
  if (!handle || session == nullptr) return;
  const auto& point = session->drawing().curves[handle->curve]->points[handle->point];
  const bool pinned = point.pinned;
  session->edit([&](Editor& e) { e.set_pinned(handle->curve, handle->point, !pinned); });
}

bool DrawingHand::key(int key) {
  Session* session = sessions_.now();
  if (session == nullptr || !session->editor().is_drawing() || !is_drawing_key(key)) return false;
  if (session->in_gesture()) release();
  if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    session->edit([](Editor& e) { e.finish_curve(); });
  } else if (key == Qt::Key_Escape) {
    session->edit([](Editor& e) { e.drop_curve(); });
  } else {
    session->edit([](Editor& e) { e.take_back_point(); });
  }
  return true;
}

/// Keys count only in the viewer with the focus: dialogs and boxes use the same keys for other
/// commands.
bool DrawingHand::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
    return watched == QApplication::focusWidget() && watched->inherits("QGraphicsView") &&
           key_event(event);
  }
  const bool viewer = watched->parent() != nullptr && watched->parent()->inherits("QGraphicsView");
  if (viewer && event->type() == QEvent::Leave) reach_no_more();
  return viewer && draws() && !painting_ && !dragged_ && view_hand_.take(watched, event);
}

/// Without an accepted override, the host's shortcuts would get the key first.
bool DrawingHand::key_event(QEvent* event) {
  const auto& pressed = *static_cast<QKeyEvent*>(event);
  const Session* session = sessions_.now();
  if (session == nullptr) return false;
  const bool again =  // the host knows only Ctrl+Z and Ctrl+Shift+Z
      pressed.key() == Qt::Key_Y && pressed.modifiers() == Qt::ControlModifier;
  const bool drawing = draws() && session->editor().is_drawing() && is_drawing_key(pressed.key());
  if (!again && !drawing) return false;
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return false;
  }
  return again ? sessions_.now()->redo() : key(pressed.key());
}

void DrawingHand::hint(const std::optional<Handle>& handle,
                       const std::optional<CurvePlace>& curve) {
  const Session* session = sessions_.now();
  const bool drawing = session != nullptr && session->editor().is_drawing();
  QString text = drawing
                     ? tr("Click or paint; Enter ends, the first point closes, Backspace takes "
                          "back, Esc discards. The wheel zooms, the middle button moves, the "
                          "right one turns.")
                     : tr("Click or paint on the target mesh to draw. The wheel zooms, the middle "
                          "button moves, the right one turns.");
  if (handle && drawing && handle->point == 0) {
    text = tr("Click to close the curve.");
  } else if (handle) {
    text = tr("Drag to move, double click to pin, Shift-click to remove.");
  } else if (curve && drawing) {
    text = tr("Ctrl-click to insert a point.");
  } else if (curve) {
    text = tr("Click to select the curve, Ctrl-click to insert a point; paint to draw.");
  }
  host_.hint(text, handle || curve);
}

}  // namespace talweg::openflipper
