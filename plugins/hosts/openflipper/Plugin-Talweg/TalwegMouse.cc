// Drawing with mouse and keys.
#include <QApplication>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>
#include <OpenFlipper/common/GlobalOptions.hh>

#include "HostVersion.hh"
#include "TalwegPlugin.hh"

using talweg::editing::Editor;
using talweg::openflipper::Session;
namespace editing = talweg::editing;

namespace {

constexpr double kReach = 8;  // pixels

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

bool TalwegPlugin::is_target(int id) {
  BaseObjectData* object = nullptr;
  return PluginFunctions::getObject(id, object) && object->target();
}

/// The session whose mesh is the only thing that the mouse can meet, so that its own tree of
/// triangles says what it meets. The host draws its whole scene for that.
Session* TalwegPlugin::alone() {
  Session* session = existing(current_);
  if (session == nullptr || !session->can_see() || !is_target(current_)) return nullptr;
  for (PluginFunctions::ObjectIterator it(PluginFunctions::ALL_OBJECTS);
       it != PluginFunctions::objectsEnd(); ++it) {
    if (!it->visible() || it->id() == current_ || it->dataType(DATA_POLY_LINE)) continue;
    if (it->dataType(typeId("Light")) || it->dataType(typeId("Camera"))) continue;
    return nullptr;
  }
  return session;
}

std::optional<TalwegPlugin::Picked> TalwegPlugin::picked_by_us(const QPoint& at) {
  Session* session = alone();
  if (session == nullptr) return std::nullopt;
  auto& state =
      PluginFunctions::viewerProperties(static_cast<int>(PluginFunctions::activeExaminer()))
          .glState();
  const double y = state.context_height() - at.y();
  const ACG::Vec3d eye = state.unproject(ACG::Vec3d(at.x(), y, 0));
  const ACG::Vec3d far = state.unproject(ACG::Vec3d(at.x(), y, 1));
  return Picked{session, session->seen(eye, far - eye)};
}

std::optional<TalwegPlugin::Picked> TalwegPlugin::picked_by_host(const QPoint& at) {
  size_t node = 0, face = 0;
  ACG::Vec3d hit;
  BaseObjectData* object = nullptr;
  if (!PluginFunctions::scenegraphPick(ACG::SceneGraph::PICK_FACE, at, node, face, &hit) ||
      !PluginFunctions::getPickedObject(node, object) || !object->dataType(DATA_TRIANGLE_MESH)) {
    return std::nullopt;
  }
  const Session* now = existing(current_);
  const bool bound = now != nullptr && (now->editor().is_drawing() || dragged_ || painting_);
  if (bound && object->id() != current_) return std::nullopt;
  if (!bound && !object->target()) {
    emit showStatusMessage(tr("Make this mesh the target to draw on it."), 3000);
    return std::nullopt;
  }
  Session* session = session_of(object->id());
  if (session == nullptr || face >= session->arrays().triangles.size()) return std::nullopt;
  return Picked{session,
                talweg::openflipper::picked_on(session->mesh(), static_cast<unsigned>(face), hit)};
}

/// The point under the mouse, on the mesh that is drawn on or, where nothing is drawn now, on any
/// target.
bool TalwegPlugin::pick(const QPoint& at, Session*& session, editing::Point& point) {
  try {
    auto picked = picked_by_us(at);
    if (!picked) picked = picked_by_host(at);
    if (!picked || !picked->point) return false;
    session = picked->session;
    point = *picked->point;
    return true;
  } catch (const editing::Error&) {
    return false;
  }
}

/// The drawn point within a few pixels of the mouse, the nearest one that can be seen.
std::optional<TalwegPlugin::Handle> TalwegPlugin::handle_near(const QPoint& at) const {
  const auto found = sessions_.find(current_);
  if (found == sessions_.end()) return std::nullopt;
  auto& view =
      PluginFunctions::viewerProperties(static_cast<int>(PluginFunctions::activeExaminer()));
  struct Candidate {
    double away;
    Handle handle;
    ACG::Vec3d eye;  // where one looks from, on the near plane
  };
  std::vector<Candidate> candidates;
  const Session& session = *found->second;
  const auto& curves = session.editor().drawing().curves;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::vector<ACG::Vec3d> positions = session.drawn_positions(c);
    for (std::size_t p = 0; p < positions.size(); ++p) {
      if (!session.shows_point(c, p)) continue;
      const ACG::Vec3d s = view.glState().project(positions[p]);
      const double away =
          std::hypot(s[0] - at.x(), view.glState().context_height() - s[1] - at.y());
      if (away > kReach) continue;
      candidates.push_back({away, {c, p}, view.glState().unproject(ACG::Vec3d(s[0], s[1], 0))});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.away < b.away; });
  for (const Candidate& candidate : candidates) {
    const auto [c, p] = candidate.handle;
    if (!session.is_hidden(c, p, candidate.eye)) return candidate.handle;
  }
  return std::nullopt;
}

void TalwegPlugin::slotMouseEvent(QMouseEvent* _event) {
  if (!in_draw_mode() || (_event->modifiers() & Qt::ControlModifier)) return;
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
  if (handle && session != nullptr) {
    const auto& drawing = session->editor().drawing();
    const bool on_first = handle->point == 0 && handle->curve + 1 == drawing.curves.size() &&
                          drawing.unfinished && drawing.curves.back()->points.size() >= 3;
    if (on_first) {
      session->edit([](Editor& e) { e.close_curve(); });
    } else if (event.modifiers() & Qt::ShiftModifier) {
      session->edit([&](Editor& e) { e.remove_point(handle->curve, handle->point); });
    } else {
      dragged_ = handle;
      session->begin_gesture("Move point", true);
    }
    return;
  }
  if (event.modifiers() & Qt::ShiftModifier) return;  // beside the point to remove
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
  if (dragged_) {
    if (pick(at, session, point)) {
      session->edit([&](Editor& e) { e.move_point(dragged_->curve, dragged_->point, point); });
    }
  } else if (painting_) {
    if ((at - last_painted_).manhattanLength() < 4 || !pick(at, session, point)) return;
    session->edit([&](Editor& e) { e.paint_point(point); });
    last_painted_ = at;
  } else {
    const auto handle = handle_near(at);
    hint(handle);
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
  if (Session* session = existing(current_); session != nullptr && (dragged_ || painting_)) {
    session->end_gesture();
  }
  let_go();
}

void TalwegPlugin::let_go() {
  dragged_.reset();
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

void TalwegPlugin::hint(const std::optional<Handle>& handle) {
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
  }
  if (text == hint_) return;
  hint_ = text;
  emit showStatusMessage(text);
  emit setPickModeCursor(kPickMode, QCursor(handle ? Qt::PointingHandCursor : Qt::ArrowCursor));
  changed();
}
