// Drawing with mouse and keys.
#include <QApplication>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>
#include <OpenFlipper/common/GlobalOptions.hh>

#include "HostVersion.hh"
#include "TalwegPlugin.hh"
#include "talweg/editing/legs.hpp"

using talweg::editing::Editor;
using talweg::openflipper::Session;
namespace editing = talweg::editing;

namespace {

bool is_drawing_key(int key) {
  return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Escape ||
         key == Qt::Key_Backspace;
}

}  // namespace

bool TalwegPlugin::in_draw_mode() const {
  return OpenFlipper::Options::gui() && PluginFunctions::pickMode() == kPickMode &&
         (view_hand_.holds() || PluginFunctions::actionMode() == Viewer::PickingMode);
}

void TalwegPlugin::drawMode(bool on) {
  if (!OpenFlipper::Options::gui()) return;
  if (on && target_session() != nullptr) {
    PluginFunctions::actionMode(Viewer::PickingMode);
    PluginFunctions::pickMode(kPickMode);
  } else {
    PluginFunctions::actionMode(Viewer::ExamineMode);
  }
  changed();
}

void TalwegPlugin::slotPickModeChanged(const std::string& /*_mode*/) {
  if (!in_draw_mode()) reach_no_more();
  changed();
}

void TalwegPlugin::slotMouseEvent(QMouseEvent* _event) {
  if (!in_draw_mode()) return;
  switch (_event->type()) {
    case QEvent::MouseButtonPress:
      if (_event->button() == Qt::LeftButton) press(*_event);
      return;
    case QEvent::MouseMove:
      return move(*_event);
    case QEvent::MouseButtonRelease:
      return release();
    case QEvent::MouseButtonDblClick:
      if (_event->button() == Qt::LeftButton) double_click(*_event);
      return;
    default:
      return;
  }
}

void TalwegPlugin::press(const QMouseEvent& event) {
  const QPoint at = talweg::openflipper::position_of(event);
  const auto handle = handle_near(at);
  Session* session = existing(current_);
  if (handle && session != nullptr) return press_point(*session, *handle, event.modifiers());
  const auto curve = curve_near(at);
  if (event.modifiers() & Qt::ControlModifier) {
    if (curve) insert_point(*session, *curve, at);
    return;
  }
  if (event.modifiers() & Qt::ShiftModifier) return;  // beside the point to remove
  pressed_at_ = at;
  pressed_curve_ = session != nullptr && session->editor().is_drawing() ? std::nullopt : curve;
  if (!pressed_curve_) begin_stroke(at);
}

void TalwegPlugin::press_point(Session& session, const Handle& handle,
                               Qt::KeyboardModifiers modifiers) {
  const auto& drawing = session.editor().drawing();
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

/// The new point can be dragged at once, which is the same step.
void TalwegPlugin::insert_point(Session& session, const CurvePlace& place, const QPoint& at) {
  Session* there = nullptr;
  editing::Point point;
  if (!pick(at, there, point) || there != &session) return;
  session.begin_gesture("Insert point", true);
  session.edit([&](Editor& e) {
    const auto& curve = *e.drawing().curves[place.curve];
    std::vector<editing::Vector> given;
    for (const editing::Point& p : curve.points) {
      given.push_back(editing::position_of(session.arrays(), p));
    }
    const std::size_t before =
        editing::leg_at(given, place.line->positions, curve.closed, place.segment);
    e.insert_point(place.curve, before, point);
    dragged_ = {place.curve, before};
  });
  session.select(place.curve);
}

void TalwegPlugin::begin_stroke(const QPoint& at) {
  Session* session = nullptr;
  editing::Point point;
  if (!pick(at, session, point)) return;
  session->begin_gesture("Draw");
  session->edit([&](Editor& e) { e.add_point(point); });
  painting_ = true;
  last_painted_ = at;
  // While the host draws its picture Qt drops all movements but the last, and with them the stroke.
  drops_moves_ = QCoreApplication::testAttribute(Qt::AA_CompressHighFrequencyEvents);
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
}

void TalwegPlugin::move(const QMouseEvent& event) {
  const QPoint at = talweg::openflipper::position_of(event);
  Session* session = nullptr;
  editing::Point point;
  if (pressed_curve_ &&
      (at - pressed_at_).manhattanLength() >= 4) {  // no click on it, but a stroke
    pressed_curve_.reset();
    begin_stroke(pressed_at_);
  }
  if (dragged_) {
    if (pick(at, session, point)) {
      session->edit([&](Editor& e) { e.move_point(dragged_->curve, dragged_->point, point); });
    }
  } else if (painting_) {
    if ((at - last_painted_).manhattanLength() < 4 || !pick(at, session, point)) return;
    session->edit([&](Editor& e) { e.paint_point(point); });
    last_painted_ = at;
  } else if (!pressed_curve_) {
    const auto handle = handle_near(at);
    hint(handle, handle ? std::nullopt : curve_near(at));
    reach(at, handle);
  }
}

/// The leg to the mouse. Where the host would have to draw its scene to tell what is there, that
/// would cost too much for every movement.
void TalwegPlugin::reach(const QPoint& at, const std::optional<Handle>& handle) {
  Session* session = existing(current_);
  if (session == nullptr || !session->editor().is_drawing()) return reach_no_more();
  const auto& curve = *session->editor().drawing().curves.back();
  if (handle && handle->point == 0 && curve.points.size() >= 3) {
    session->reach_for(curve.points.front());
  } else if (const auto picked = picked_by_us(at); picked && !handle) {
    session->reach_for(picked->point);
  } else {
    return reach_no_more();
  }
  reaching_ = true;
}

void TalwegPlugin::reach_no_more() {
  Session* session = existing(current_);
  if (reaching_ && session != nullptr) session->reach_for(std::nullopt);
  reaching_ = false;
}

void TalwegPlugin::release() {
  if (pressed_curve_) existing(current_)->select(pressed_curve_->curve);
  if (Session* session = existing(current_); session != nullptr && (dragged_ || painting_)) {
    session->end_gesture();
  }
  let_go();
}

void TalwegPlugin::let_go() {
  dragged_.reset();
  pressed_curve_.reset();
  if (painting_) QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, drops_moves_);
  painting_ = false;
}

void TalwegPlugin::double_click(const QMouseEvent& event) {
  const auto handle = handle_near(talweg::openflipper::position_of(event));
  Session* session = existing(current_);
  if (!handle || session == nullptr) return;
  const auto& point = session->editor().drawing().curves[handle->curve]->points[handle->point];
  const bool pinned = point.pinned;
  session->edit([&](Editor& e) { e.set_pinned(handle->curve, handle->point, !pinned); });
}

/// Enter, Esc and Backspace while a curve is drawn; true where the key was ours.
bool TalwegPlugin::key(int key) {
  Session* session = existing(current_);
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

/// Keys are ours only in the viewer that has the focus: dialogs and boxes have their own use for
/// them.
bool TalwegPlugin::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
    return watched == QApplication::focusWidget() && watched->inherits("QGraphicsView") &&
           key_event(event);
  }
  const bool viewer = watched->parent() != nullptr && watched->parent()->inherits("QGraphicsView");
  if (viewer && event->type() == QEvent::Leave) reach_no_more();
  return viewer && in_draw_mode() && !painting_ && !dragged_ && view_hand_.take(watched, event);
}

/// The host's shortcuts are asked first, unless the override is accepted.
bool TalwegPlugin::key_event(QEvent* event) {
  const auto& pressed = *static_cast<QKeyEvent*>(event);
  const Session* session = existing(current_);
  if (session == nullptr) return false;
  const bool again =  // the host knows Ctrl+Z, and Ctrl+Shift+Z only
      pressed.key() == Qt::Key_Y && pressed.modifiers() == Qt::ControlModifier;
  const bool drawing =
      in_draw_mode() && session->editor().is_drawing() && is_drawing_key(pressed.key());
  if (!again && !drawing) return false;
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return false;
  }
  return again ? redoEdit(current_) : key(pressed.key());
}

void TalwegPlugin::give_mouse(bool to_host) {
  if (to_host) {
    PluginFunctions::actionMode(Viewer::ExamineMode);
    return;
  }
  PluginFunctions::actionMode(Viewer::PickingMode);
  PluginFunctions::pickMode(kPickMode);
}

void TalwegPlugin::hint(const std::optional<Handle>& handle,
                        const std::optional<CurvePlace>& curve) {
  const Session* session = existing(current_);
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
  if (text == hint_) return;
  hint_ = text;
  emit showStatusMessage(text);
  emit setPickModeCursor(kPickMode,
                         QCursor(handle || curve ? Qt::PointingHandCursor : Qt::ArrowCursor));
  changed();
}
