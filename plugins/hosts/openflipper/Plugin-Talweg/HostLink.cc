#include "TalwegPlugin.hh"

#include <QAction>
#include <QApplication>
#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <algorithm>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>
#include <OpenFlipper/common/GlobalOptions.hh>

#include "CurveRows.hh"
#include "DrawingBackup.hh"
#include "EditNames.hh"
#include "HostVersion.hh"
#include "talweg/editing/curve_files.hpp"

using talweg::editing::Editor;
using talweg::openflipper::ColourBy;
using talweg::openflipper::PanelState;
using talweg::openflipper::Session;
using talweg::openflipper::TalwegPanel;
namespace editing = talweg::editing;

namespace {

const char* const kJob = "Talweg";

void show_results_of(const Session& session, PanelState& state) {
  const talweg::host::Results& results = session.results();
  state.rows = talweg::openflipper::result_rows(session);
  state.summary = talweg::openflipper::result_summary(session);
  state.summary_tip = talweg::openflipper::result_settings(session);
  state.notes = talweg::openflipper::result_notes(session);
  if (results.curves.empty()) return;
  state.slack_used = results.number("slack");
  state.deviation_now = results.number("deviation_to_drawn_max", -1, -1);
}

double now_ms() { return static_cast<double>(QDateTime::currentMSecsSinceEpoch()); }

}  // namespace

TalwegPlugin::~TalwegPlugin() = default;

// ---- Start and end

void TalwegPlugin::initializePlugin() {
  plugins_ = std::make_unique<editing::Plugins>();
  speak_the_hosts_language();
  if (!OpenFlipper::Options::gui()) return;
  show_points_ = OpenFlipperSettings().value("Plugin-Talweg/points", true).toBool();
  make_panel();
}

void TalwegPlugin::speak_the_hosts_language() {
  const QString set = OpenFlipperSettings().value("Core/Language/Translation", "en_US").toString();
  const QLocale language = set == "locale" ? QLocale::system() : QLocale(set);
  if (translator_.load(language, "Plugin-Talweg", "_", ":/talweg")) {
    QCoreApplication::installTranslator(&translator_);
  }
}

void TalwegPlugin::pluginsInitialized() {
  describe_slots();
  if (!OpenFlipper::Options::gui()) return;
  emit addHiddenPickMode(TalwegPlugin::kPickMode);
  emit setPickModeMouseTracking(TalwegPlugin::kPickMode, true);
  emit setPickModeCursor(TalwegPlugin::kPickMode, QCursor(Qt::ArrowCursor));
  make_menus();
  qApp->installEventFilter(this);
  connect(&timer_, &QTimer::timeout, this, &TalwegPlugin::look_at_progress);
  timer_.setInterval(100);
}

void TalwegPlugin::exit() {
  sessions_.clear();
  plugins_.reset();  // waits for threads, not for ever: the host may never delete this object
}

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
  connect_curves();
  connect_look();
  emit addToolbox(tr("Talweg"), panel_, icon);
}

void TalwegPlugin::connect_panel() {
  connect(panel_, &TalwegPanel::draw_toggled, this, &TalwegPlugin::drawMode);
  connect(panel_, &TalwegPanel::finish, this, [this] { key(Qt::Key_Return); });
  connect(panel_, &TalwegPanel::close_curve, this,
          [this] { edit_now([](Editor& e) { e.close_curve(); }); });
  connect(panel_, &TalwegPanel::take_back, this, [this] { key(Qt::Key_Backspace); });
  connect(panel_, &TalwegPanel::discard, this, [this] { key(Qt::Key_Escape); });
  connect(panel_, &TalwegPanel::from_selection, this, [this] {
    if (Session* session = target_session()) session->add_selection();
  });
  const auto from_faces = [this](bool selected) {
    if (Session* session = target_session()) session->add_face_borders(selected);
  };
  connect(panel_, &TalwegPanel::from_face_selection, this, [from_faces] { from_faces(true); });
  connect(panel_, &TalwegPanel::from_face_colours, this, [from_faces] { from_faces(false); });
  connect(panel_, &TalwegPanel::from_lines, this, &TalwegPlugin::from_lines);
  connect(panel_, &TalwegPanel::cut, this, [this] { use([](Session& s) { s.cut(false); }); });
  connect(panel_, &TalwegPanel::select_inside, this,
          [this] { use([](Session& s) { s.cut(true); }); });
  connect(panel_, &TalwegPanel::split, this, [this](bool lids) {
    use([lids](Session& s) {
      std::vector<int> parts;
      s.split(lids, parts);
    });
  });
  connect(panel_, &TalwegPanel::undo, this, [this] { undoEdit(current_); });
  connect(panel_, &TalwegPanel::redo, this, [this] { redoEdit(current_); });
  connect(panel_, &TalwegPanel::write_result, this, [this] { ask_for_file(true, true); });
  connect(panel_, &TalwegPanel::cancel, this, [this] { canceledJob(kJob); });
  connect(panel_, &TalwegPanel::gesture_begun, this, &TalwegPlugin::begin_gesture);
  connect(panel_, &TalwegPanel::gesture_ended, this, &TalwegPlugin::end_gesture);
  connect(panel_, &TalwegPanel::tau_changed, this, [this](double tau) {
    if (existing(current_) == nullptr) return save_settings({tau, {}, {}});
    edit_now([tau](Editor& e) { e.set_tau(tau); });
  });
  connect(panel_, &TalwegPanel::repair, this, [this] {
    if (Session* session = existing(current_)) session->repair();
  });
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
  connect(panel_, &TalwegPanel::click_distance_changed, this,
          [this, optional](bool set, double value) {
            edit_now([&](Editor& e) { e.set_click_distance(optional(set, value)); });
          });
  connect(panel_, &TalwegPanel::ends_changed, this, [this](int ends) {
    edit_now([&](Editor& e) { e.set_ends(static_cast<editing::Ends>(ends)); });
  });
}

void TalwegPlugin::make_menus() {
  mesh_menu_ = new QMenu(tr("Talweg"));
  draw_action_ = mesh_menu_->addAction(tr("Draw on this mesh"));
  selection_action_ = mesh_menu_->addAction(tr("Curves from its selection"));
  line_menu_ = new QMenu(tr("Talweg"));
  line_action_ = line_menu_->addAction(tr("Smooth this line on the target mesh"));
  connect(draw_action_, &QAction::triggered, this, [this] {
    BaseObjectData* mesh = nullptr;
    if (session_of(menu_object_) == nullptr) return;
    if (PluginFunctions::getObject(menu_object_, mesh)) mesh->target(true);
    drawMode(true);
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
    session->show_points(show_points_);
    if (panel_ != nullptr) timer_.start();
  }
  current_ = mesh_id;
  return session;
}

Session* TalwegPlugin::target_session() {
  if (existing(current_) != nullptr && is_target(current_)) return existing(current_);
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
    let_go();
    changed();
    return;
  }
  for (auto& [mesh, session] : sessions_) {
    if (!session->owns(_id)) continue;
    let_go();
    return session->object_deleted(_id);
  }
}

void TalwegPlugin::slotObjectUpdated(int _identifier, const UpdateType& _type) {
  if (updating_) return;
  if (!_type.contains(UPDATE_GEOMETRY) && !_type.contains(UPDATE_TOPOLOGY)) return;
  if (Session* session = existing(_identifier)) session->mesh_updated();
}

void TalwegPlugin::slotVisibilityChanged(int _identifier) {
  for (auto& [mesh, session] : sessions_) {
    if (mesh == _identifier || session->drawing_id() == _identifier) session->visibility_changed();
  }
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

void TalwegPlugin::show_selection(int id) {
  updating_ = true;
  emit updatedObject(id, UPDATE_SELECTION);
  updating_ = false;
}

void TalwegPlugin::show_mesh(int id) {
  updating_ = true;
  emit updatedObject(id, UPDATE_ALL);
  updating_ = false;
}

int TalwegPlugin::add_mesh(const QString& name, TriMesh&& mesh) {
  int id = -1;
  emit addEmptyObject(DATA_TRIANGLE_MESH, id);
  TriMeshObject* object = nullptr;
  if (!PluginFunctions::getObject(id, object)) return -1;
  *object->mesh() = std::move(mesh);
  object->setName(name);
  show_mesh(id);
  return id;
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
  state.settings = saved_settings();
  if (const Session* session = existing(current_)) {
    const editing::History& history = session->editor().history();
    state.mesh = session->name();
    state.settings = session->editor().drawing().settings;
    state.scale = session->diagonal() / 10;
    state.mean_edge = session->mean_edge();
    state.unfinished = session->editor().is_drawing();
    state.can_undo = session->can_undo();
    state.can_redo = history.can_redo();
    state.undo_name = talweg::openflipper::name_of_edit(history.undo_name());
    state.redo_name = talweg::openflipper::name_of_edit(history.redo_name());
    state.curves = talweg::openflipper::curves_state(*session);
    state.all_clicked = editing::all_clicked(session->editor().drawing());
    state.look = look_state(*session);
    show_results_of(*session, state);
    state.problem = session->problem();
    state.repair_told = session->repair_told();
    save_settings(state.settings);
  }
  state.look.points = show_points_;
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
  for (auto& [mesh, session] : sessions_) session->leave_what_never_ends();
  const Session* session = existing(current_);
  editing::Progress progress = session == nullptr ? editing::Progress() : session->progress();
  if (progress.task == editing::Task::kLeg) progress.busy = false;  // one after another
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

/// What takes a moment and is waited for.
void TalwegPlugin::use(const std::function<void(Session&)>& work) {
  Session* session = existing(current_);
  if (session == nullptr) return;
  QApplication::setOverrideCursor(Qt::WaitCursor);
  work(*session);
  QApplication::restoreOverrideCursor();
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
  const QString folder = OpenFlipperSettings().value("Plugin-Talweg/folder").toString();
  QString path = write ? QFileDialog::getSaveFileName(panel_, tr("Write curves"), folder, kinds)
                       : QFileDialog::getOpenFileName(panel_, tr("Read curves"), folder, kinds);
  if (path.isEmpty()) return;
  OpenFlipperSettings().setValue("Plugin-Talweg/folder", QFileInfo(path).absolutePath());
  if (write && QFileInfo(path).suffix().isEmpty()) path += ".json";
  if (!write) {
    readDrawing(session->mesh_id(), path);
  } else if (result) {
    writeResult(session->mesh_id(), path);
  } else {
    writeDrawing(session->mesh_id(), path);
  }
}
