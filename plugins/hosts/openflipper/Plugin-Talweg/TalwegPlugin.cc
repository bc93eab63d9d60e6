#include "TalwegPlugin.hh"

#include <QAction>
#include <QApplication>
#include <QDateTime>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <cstring>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>
#include <OpenFlipper/common/GlobalOptions.hh>

#include "DrawingBackup.hh"
#include "HostVersion.hh"
#include "talweg/editing/curve_files.hpp"

using talweg::editing::Editor;
using talweg::openflipper::ColourBy;
using talweg::openflipper::PanelState;
using talweg::openflipper::Session;
using talweg::openflipper::TalwegPanel;
namespace editing = talweg::editing;

namespace {

const char* const kPickMode = "Talweg: draw";
const char* const kJob = "Talweg";

double now_ms() { return static_cast<double>(QDateTime::currentMSecsSinceEpoch()); }

}  // namespace

TalwegPlugin::~TalwegPlugin() = default;

// ---- Start and end

void TalwegPlugin::initializePlugin() {
  plugins_ = std::make_unique<editing::Plugins>();
  if (OpenFlipper::Options::gui()) make_panel();
}

void TalwegPlugin::pluginsInitialized() {
  describe_slots();
  if (!OpenFlipper::Options::gui()) return;
  emit addHiddenPickMode(kPickMode);
  emit setPickModeMouseTracking(kPickMode, true);
  emit setPickModeCursor(kPickMode, QCursor(Qt::ArrowCursor));
  make_menus();
  qApp->installEventFilter(this);
  connect(&timer_, &QTimer::timeout, this, &TalwegPlugin::look_at_progress);
  timer_.setInterval(100);
}

void TalwegPlugin::exit() { sessions_.clear(); }

void TalwegPlugin::slotAllCleared() {
  sessions_.clear();
  current_ = -1;
  changed();
}

void TalwegPlugin::make_panel() {
  panel_ = new TalwegPanel;
  panel_->setObjectName("talwegPanel");
  auto* icon = new QIcon(":/talweg/talweg.png");
  connect_panel();
  emit addToolbox(tr("Talweg"), panel_, icon);
}

void TalwegPlugin::connect_panel() {
  connect(panel_, &TalwegPanel::draw_toggled, this, &TalwegPlugin::drawMode);
  connect(panel_, &TalwegPanel::finish, this, [this] { key(Qt::Key_Return); });
  connect(panel_, &TalwegPanel::close_curve, this,
          [this] { edit_now([](Editor& e) { e.close_curve(); }); });
  connect(panel_, &TalwegPanel::take_back, this, [this] { key(Qt::Key_Backspace); });
  connect(panel_, &TalwegPanel::drop, this, [this] { key(Qt::Key_Escape); });
  connect(panel_, &TalwegPanel::from_selection, this, [this] {
    if (Session* session = target_session()) session->add_selection();
  });
  connect(panel_, &TalwegPanel::from_lines, this, &TalwegPlugin::from_lines);
  connect(panel_, &TalwegPanel::remove_last, this,
          [this] { edit_now([](Editor& e) { e.remove_curve(e.drawing().curves.size() - 1); }); });
  connect(panel_, &TalwegPanel::clear, this, [this] { edit_now([](Editor& e) { e.clear(); }); });
  connect(panel_, &TalwegPanel::undo, this, [this] { undoEdit(current_); });
  connect(panel_, &TalwegPanel::redo, this, [this] { redoEdit(current_); });
  connect(panel_, &TalwegPanel::write_result, this, [this] { ask_for_file(true, true); });
  connect(panel_, &TalwegPanel::write_drawing, this, [this] { ask_for_file(true, false); });
  connect(panel_, &TalwegPanel::read_drawing, this, [this] { ask_for_file(false, false); });
  connect(panel_, &TalwegPanel::cancel, this, [this] { canceledJob(kJob); });
  connect(panel_, &TalwegPanel::gesture_begun, this, [this](const QString& name) {
    if (Session* session = existing(current_)) session->begin_gesture(name.toUtf8().constData());
  });
  connect(panel_, &TalwegPanel::gesture_ended, this, [this] {
    if (Session* session = existing(current_)) session->end_gesture();
  });
  connect(panel_, &TalwegPanel::tau_changed, this,
          [this](double tau) { edit_now([tau](Editor& e) { e.set_tau(tau); }); });
  const auto optional = [](bool set, double value) {
    return set ? std::optional<double>(value) : std::nullopt;
  };
  connect(panel_, &TalwegPanel::slack_changed, this, [this, optional](bool set, double value) {
    edit_now([&](Editor& e) { e.set_slack(optional(set, value)); });
  });
  connect(panel_, &TalwegPanel::max_deviation_changed, this,
          [this, optional](bool set, double value) {
            edit_now([&](Editor& e) { e.set_max_deviation(optional(set, value)); });
          });
  connect(panel_, &TalwegPanel::colour_by, this, [this](int what) {
    if (Session* session = existing(current_)) session->colour_by(static_cast<ColourBy>(what));
  });
}

void TalwegPlugin::make_menus() {
  mesh_menu_ = new QMenu(tr("Talweg"));
  draw_action_ = mesh_menu_->addAction(tr("Draw on this mesh"));
  selection_action_ = mesh_menu_->addAction(tr("Curves from its selection"));
  line_menu_ = new QMenu(tr("Talweg"));
  line_action_ = line_menu_->addAction(tr("Smooth this line on the target mesh"));
  connect(draw_action_, &QAction::triggered, this, [this] {
    if (session_of(menu_object_) != nullptr) drawMode(true);
  });
  connect(selection_action_, &QAction::triggered, this, [this] { fromSelection(menu_object_); });
  connect(line_action_, &QAction::triggered, this, [this] {
    Session* session = target_session();
    PolyLineObject* line = PluginFunctions::polyLineObject(menu_object_);
    if (session != nullptr && line != nullptr) session->add_line(*line->line());
  });
  emit addContextMenuItem(mesh_menu_->menuAction(), DATA_TRIANGLE_MESH, CONTEXTOBJECTMENU);
  emit addContextMenuItem(line_menu_->menuAction(), DATA_POLY_LINE, CONTEXTOBJECTMENU);
}

void TalwegPlugin::slotUpdateContextMenu(int _objectId) { menu_object_ = _objectId; }

// ---- Sessions

Session* TalwegPlugin::existing(int mesh_id) {
  const auto found = sessions_.find(mesh_id);
  return found == sessions_.end() ? nullptr : found->second.get();
}

Session* TalwegPlugin::session_of(int mesh_id) {
  Session* session = existing(mesh_id);
  if (session == nullptr) {
    TriMeshObject* object = nullptr;
    if (!PluginFunctions::getObject(mesh_id, object) || object == nullptr) {
      warn(tr("There is no triangle mesh with the id %1.").arg(mesh_id));
      return nullptr;
    }
    try {
      std::unique_ptr<Session> made(
          new Session(*this, *plugins_, *object, saved_settings()));  // a private base
      session = sessions_.emplace(mesh_id, std::move(made)).first->second.get();
    } catch (const std::exception& error) {
      warn(QString::fromStdString(error.what()));
      return nullptr;
    }
    if (panel_ != nullptr) timer_.start();
  }
  current_ = mesh_id;
  return session;
}

Session* TalwegPlugin::target_session() {
  BaseObjectData* shown = nullptr;
  if (existing(current_) != nullptr && PluginFunctions::getObject(current_, shown) &&
      shown->target()) {
    return existing(current_);
  }
  for (PluginFunctions::ObjectIterator it(PluginFunctions::TARGET_OBJECTS, DATA_TRIANGLE_MESH);
       it != PluginFunctions::objectsEnd(); ++it) {
    return session_of(it->id());
  }
  warn(tr("Make a triangle mesh the target first."));
  return nullptr;
}

void TalwegPlugin::objectDeleted(int _id) {
  if (sessions_.erase(_id) > 0) {
    if (current_ == _id) current_ = -1;
    dragged_.reset();
    painting_ = false;
    changed();
    return;
  }
  for (auto& [mesh, session] : sessions_) {
    if (session->owns(_id)) return session->object_deleted(_id);
  }
}

void TalwegPlugin::slotObjectUpdated(int _identifier, const UpdateType& _type) {
  if (updating_) return;
  if (!_type.contains(UPDATE_GEOMETRY) && !_type.contains(UPDATE_TOPOLOGY)) return;
  if (Session* session = existing(_identifier)) session->mesh_updated();
}

// ---- What sessions ask for

int TalwegPlugin::add_line(const QString& name) {
  int id = -1;
  emit addEmptyObject(DATA_POLY_LINE, id);
  BaseObjectData* object = nullptr;
  if (!PluginFunctions::getObject(id, object)) return -1;
  object->setName(name);
  object->target(false);
  return id;
}

void TalwegPlugin::show_line(int id) {
  updating_ = true;
  emit updatedObject(id, UPDATE_GEOMETRY | UPDATE_TOPOLOGY);
  updating_ = false;
}

void TalwegPlugin::show_colours(int id) {
  updating_ = true;
  emit updatedObject(id, UPDATE_COLOR);
  updating_ = false;
}

void TalwegPlugin::remove_object(int id) { emit deleteObject(id); }

void TalwegPlugin::push_backup(int id, const QString& name) {
  if (OpenFlipper::Options::gui()) emit createBackup(id, name, UPDATE_ALL);
}

namespace {

BackupData* backups_of_object(int id) {
  BaseObjectData* object = nullptr;
  if (!PluginFunctions::getObject(id, object) || !object->hasObjectData(OBJECT_BACKUPS)) {
    return nullptr;
  }
  return dynamic_cast<BackupData*>(object->objectData(OBJECT_BACKUPS));
}

}  // namespace

bool TalwegPlugin::host_undo(int id) {
  BackupData* backups = backups_of_object(id);
  if (!OpenFlipper::Options::gui() || backups == nullptr || !backups->undoAvailable()) return false;
  emit undo(id);
  return true;
}

bool TalwegPlugin::host_redo(int id) {
  BackupData* backups = backups_of_object(id);
  if (!OpenFlipper::Options::gui() || backups == nullptr || !backups->redoAvailable()) return false;
  emit redo(id);
  return true;
}

void TalwegPlugin::say(const QString& sentence) { emit log(LOGINFO, sentence); }

void TalwegPlugin::warn(const QString& sentence) {
  emit log(LOGWARN, sentence);
  if (OpenFlipper::Options::gui()) emit showStatusMessage(sentence, 6000);
}

void TalwegPlugin::wake() {
  QMetaObject::invokeMethod(this, "look_at_sessions", Qt::QueuedConnection);
}

void TalwegPlugin::look_at_sessions() {
  for (auto& [mesh, session] : sessions_) session->take();
}

void TalwegPlugin::changed() {
  if (panel_ == nullptr) return;
  PanelState state;
  state.drawing_mode = in_draw_mode();
  state.hint = hint_;
  if (const Session* session = existing(current_)) {
    const editing::History& history = session->editor().history();
    state.mesh = session->name();
    state.settings = session->editor().drawing().settings;
    state.scale = session->diagonal() / 10;
    state.unfinished = session->editor().is_drawing();
    state.can_undo = history.can_undo();
    state.can_redo = history.can_redo();
    state.undo_name = QString::fromStdString(history.undo_name());
    state.redo_name = QString::fromStdString(history.redo_name());
    state.curves = static_cast<int>(session->editor().drawing().curves.size());
    state.all_clicked = editing::all_clicked(session->editor().drawing());
    state.coloured_by = static_cast<int>(session->coloured_by());
    state.report = short_report(*session);
    save_settings(state.settings);
  }
  panel_->show_state(state);
  emit updateView();
}

editing::Settings TalwegPlugin::saved_settings() const {
  editing::Settings settings;
  if (!OpenFlipper::Options::gui()) return settings;  // a script says what it wants
  settings.tau = std::max(0.0, OpenFlipperSettings().value("Plugin-Talweg/tau", 1.0).toDouble());
  return settings;
}

void TalwegPlugin::save_settings(const editing::Settings& settings) const {
  OpenFlipperSettings().setValue("Plugin-Talweg/tau", settings.tau);
}

// ---- Progress

void TalwegPlugin::look_at_progress() {
  const Session* session = existing(current_);
  const editing::Progress progress = session == nullptr ? editing::Progress() : session->progress();
  if (!progress.busy) busy_since_ = 0;
  if (progress.busy && busy_since_ == 0) busy_since_ = now_ms();
  const double busy_ms = progress.busy ? now_ms() - busy_since_ : 0;
  const int percent = static_cast<int>(100 * progress.fraction);
  panel_->show_progress(busy_ms > 300, QString::fromStdString(progress.stage), percent);
  if (busy_ms > 1500 && !job_shown_) {
    job_shown_ = true;
    emit startJob(kJob, tr("Talweg on %1").arg(session->name()), 0, 100, false);
  }
  if (job_shown_ && progress.busy) emit setJobState(kJob, percent);
  if (job_shown_ && !progress.busy) {
    job_shown_ = false;
    emit finishJob(kJob);
  }
}

void TalwegPlugin::canceledJob(QString _job) {
  if (_job != kJob) return;
  for (auto& [mesh, session] : sessions_) session->cancel();
  say(tr("Cancelled."));
}

// ---- Edits from panel and script

bool TalwegPlugin::edit(int mesh_id, const std::function<void(Editor&)>& change) {
  Session* session = session_of(mesh_id);
  return session != nullptr && session->edit(change);
}

bool TalwegPlugin::edit_now(const std::function<void(Editor&)>& change) {
  Session* session = existing(current_);
  return session != nullptr && session->edit(change);
}

void TalwegPlugin::from_lines() {
  Session* session = target_session();
  if (session == nullptr) return;
  bool found = false;
  for (PluginFunctions::ObjectIterator it(PluginFunctions::TARGET_OBJECTS, DATA_POLY_LINE);
       it != PluginFunctions::objectsEnd(); ++it) {
    if (session->owns(it->id())) continue;
    session->add_line(*PluginFunctions::polyLine(*it));
    found = true;
  }
  if (!found) warn(tr("Make a polyline the target first."));
}

void TalwegPlugin::ask_for_file(bool write, bool result) {
  Session* session = write ? existing(current_) : target_session();
  if (session == nullptr) return;
  const QString kinds = tr("Curves (*.json *.vtp *.vtk *.obj *.ply *.mrk.json *.txt)");
  const QString path = write ? QFileDialog::getSaveFileName(panel_, tr("Write curves"), "", kinds)
                             : QFileDialog::getOpenFileName(panel_, tr("Read curves"), "", kinds);
  if (path.isEmpty()) return;
  if (!write) {
    readDrawing(session->mesh_id(), path);
  } else if (result) {
    writeResult(session->mesh_id(), path);
  } else {
    writeDrawing(session->mesh_id(), path);
  }
}

// ---- The mouse

bool TalwegPlugin::in_draw_mode() const {
  return OpenFlipper::Options::gui() && PluginFunctions::pickMode() == kPickMode &&
         PluginFunctions::actionMode() == Viewer::PickingMode;
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

void TalwegPlugin::slotPickModeChanged(const std::string& /*_mode*/) { changed(); }

/// The point under the mouse, on the mesh that is drawn on or, where nothing is drawn now, on any
/// target.
bool TalwegPlugin::pick(const QPoint& at, Session*& session, editing::Point& point) {
  size_t node = 0, face = 0;
  ACG::Vec3d hit;
  BaseObjectData* object = nullptr;
  if (!PluginFunctions::scenegraphPick(ACG::SceneGraph::PICK_FACE, at, node, face, &hit) ||
      !PluginFunctions::getPickedObject(node, object) || !object->dataType(DATA_TRIANGLE_MESH)) {
    return false;
  }
  const Session* now = existing(current_);
  const bool bound = now != nullptr && (now->editor().is_drawing() || dragged_ || painting_);
  if (bound && object->id() != current_) return false;
  if (!bound && !object->target()) {
    emit showStatusMessage(tr("Make this mesh the target to draw on it."), 3000);
    return false;
  }
  session = session_of(object->id());
  if (session == nullptr || face >= session->arrays().triangles.size()) return false;
  try {
    point = talweg::openflipper::picked_on(session->mesh(), static_cast<unsigned>(face), hit);
  } catch (const editing::Error&) {
    return false;
  }
  return true;
}

/// The drawn point within a few pixels of the mouse, the nearest one.
std::optional<TalwegPlugin::Handle> TalwegPlugin::handle_near(const QPoint& at) const {
  const auto found = sessions_.find(current_);
  if (found == sessions_.end()) return std::nullopt;
  auto& view =
      PluginFunctions::viewerProperties(static_cast<int>(PluginFunctions::activeExaminer()));
  std::optional<Handle> nearest;
  double least = 8;  // pixels
  const auto& curves = found->second->editor().drawing().curves;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::vector<ACG::Vec3d> positions = found->second->drawn_positions(c);
    for (std::size_t p = 0; p < positions.size(); ++p) {
      const ACG::Vec3d s = view.glState().project(positions[p]);
      const double away =
          std::hypot(s[0] - at.x(), view.glState().context_height() - s[1] - at.y());
      if (away > least) continue;
      least = away;
      nearest = Handle{c, p};
    }
  }
  return nearest;
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
  editing::Point point;
  if (!pick(at, session, point)) return;
  session->begin_gesture("Draw");
  session->edit([&](Editor& e) { e.add_point(point); });
  painting_ = true;
  last_painted_ = at;
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
    if ((at - last_painted_).manhattanLength() < 6 || !pick(at, session, point)) return;
    session->edit([&](Editor& e) { e.paint_point(point); });
    last_painted_ = at;
  } else {
    hint(at);
  }
}

void TalwegPlugin::release() {
  if (Session* session = existing(current_); session != nullptr && (dragged_ || painting_)) {
    session->end_gesture();
  }
  dragged_.reset();
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
  if (session == nullptr || !session->editor().is_drawing()) return false;
  if (session->in_gesture()) release();
  if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    session->edit([](Editor& e) { e.finish_curve(); });
  } else if (key == Qt::Key_Escape) {
    session->edit([](Editor& e) { e.drop_curve(); });
  } else if (key == Qt::Key_Backspace) {
    session->edit([](Editor& e) { e.take_back_point(); });
  } else {
    return false;
  }
  return true;
}

bool TalwegPlugin::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress || !in_draw_mode()) return false;
  const bool writing = watched->inherits("QAbstractSpinBox") || watched->inherits("QLineEdit") ||
                       watched->inherits("QTextEdit") || watched->inherits("QPlainTextEdit");
  return !writing && key(static_cast<QKeyEvent*>(event)->key());
}

void TalwegPlugin::hint(const QPoint& at) {
  const auto handle = handle_near(at);
  const Session* session = existing(current_);
  const bool drawing = session != nullptr && session->editor().is_drawing();
  QString text = drawing ? tr("Click or paint; Enter ends, the first point closes, Backspace takes "
                              "back, Esc drops.")
                         : tr("Click or paint on the target mesh to draw.");
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
