#include "HostLink.hh"

#include <QAction>
#include <QApplication>
#include <QDateTime>
#include <QLocale>
#include <QMenu>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>
#include <OpenFlipper/BasePlugin/PluginFunctionsViewControls.hh>
#include <OpenFlipper/common/BackupData.hh>
#include <OpenFlipper/common/GlobalOptions.hh>

namespace talweg::openflipper {
namespace {

const char* const kJob = "Talweg";

double now_ms() { return static_cast<double>(QDateTime::currentMSecsSinceEpoch()); }

}  // namespace

// ---- Start and end

void HostLink::initializePlugin() {
  sessions_.begin();
  speak_the_hosts_language();
  if (!OpenFlipper::Options::gui()) return;
  panel_ = new PanelLink(sessions_, hand_, *this);
  panel_->setParent(this);
  connect(panel_, &PanelLink::cancel, this, [this] { canceledJob(kJob); });
  emit addToolbox(tr("Talweg"), panel_->panel(), new QIcon(":/talweg/talweg.png"));
}

void HostLink::speak_the_hosts_language() {
  const QString set = OpenFlipperSettings().value("Core/Language/Translation", "en_US").toString();
  const QLocale language = set == "locale" ? QLocale::system() : QLocale(set);
  if (translator_.load(language, "Plugin-Talweg", "_", ":/talweg")) {
    QCoreApplication::installTranslator(&translator_);
  }
}

void HostLink::pluginsInitialized() {
  if (!OpenFlipper::Options::gui()) return;
  emit addHiddenPickMode(DrawingHand::kPickMode);
  emit setPickModeMouseTracking(DrawingHand::kPickMode, true);
  emit setPickModeCursor(DrawingHand::kPickMode, QCursor(Qt::ArrowCursor));
  make_menus();
  qApp->installEventFilter(&hand_);
  connect(&timer_, &QTimer::timeout, this, &HostLink::look_at_progress);
  timer_.start(100);
}

/// The host may never delete this object, so everything ends here.
void HostLink::exit() {
  timer_.stop();
  sessions_.end();
}

void HostLink::make_menus() {
  mesh_menu_ = new QMenu(tr("Talweg"));
  draw_action_ = mesh_menu_->addAction(tr("Draw on this mesh"));
  selection_action_ = mesh_menu_->addAction(tr("Curves from its selection"));
  line_menu_ = new QMenu(tr("Talweg"));
  line_action_ = line_menu_->addAction(tr("Smooth this line on the target mesh"));
  connect(draw_action_, &QAction::triggered, this, [this] {
    BaseObjectData* mesh = nullptr;
    if (sessions_.of(menu_object_) == nullptr) return;
    if (PluginFunctions::getObject(menu_object_, mesh)) mesh->target(true);
    hand_.set_draws(true);
  });
  connect(selection_action_, &QAction::triggered, this, [this] {
    if (Session* session = sessions_.of(menu_object_)) session->add_selection();
  });
  connect(line_action_, &QAction::triggered, this, [this] {
    Session* session = sessions_.target();
    PolyLineObject* line = PluginFunctions::polyLineObject(menu_object_);
    if (session != nullptr && line != nullptr) session->add_line(*line->line());
  });
  emit addContextMenuItem(mesh_menu_->menuAction(), DATA_TRIANGLE_MESH, CONTEXTOBJECTMENU);
  emit addContextMenuItem(line_menu_->menuAction(), DATA_POLY_LINE, CONTEXTOBJECTMENU);
}

void HostLink::slotUpdateContextMenu(int _objectId) { menu_object_ = _objectId; }

// ---- Calls from the host

void HostLink::slotAllCleared() {
  sessions_.clear();
  changed();
}

void HostLink::objectDeleted(int _id) {
  if (!sessions_.object_deleted(_id)) return;
  hand_.let_go();
  changed();
}

void HostLink::slotObjectUpdated(int _identifier, const UpdateType& _type) {
  if (updating_) return;
  if (!_type.contains(UPDATE_GEOMETRY) && !_type.contains(UPDATE_TOPOLOGY)) return;
  if (Session* session = sessions_.existing(_identifier)) session->mesh_updated();
}

void HostLink::slotVisibilityChanged(int _identifier) {
  for (const auto& [mesh, session] : sessions_.all()) session->visibility_changed(_identifier);
}

void HostLink::slotMouseEvent(QMouseEvent* _event) { hand_.mouse(*_event); }

void HostLink::slotPickModeChanged(const std::string& /*_mode*/) {
  if (!hand_.draws()) hand_.reach_no_more();
  changed();
}

// ---- Calls to the host

int HostLink::add_line(const QString& name) {
  int id = -1;
  emit addEmptyObject(DATA_POLY_LINE, id);
  BaseObjectData* object = nullptr;
  if (!PluginFunctions::getObject(id, object)) return -1;
  object->setName(name);
  object->target(false);
  return id;
}

void HostLink::tell_updated(int id, const UpdateType& type) {
  updating_ = true;
  emit updatedObject(id, type);
  updating_ = false;
}

void HostLink::show_line(int id) { tell_updated(id, UPDATE_GEOMETRY | UPDATE_TOPOLOGY); }
void HostLink::show_colours(int id) { tell_updated(id, UPDATE_COLOR); }
void HostLink::show_selection(int id) { tell_updated(id, UPDATE_SELECTION); }
void HostLink::show_mesh(int id) { tell_updated(id, UPDATE_ALL); }

int HostLink::add_mesh(const QString& name, TriMesh&& mesh) {
  int id = -1;
  emit addEmptyObject(DATA_TRIANGLE_MESH, id);
  TriMeshObject* object = nullptr;
  if (!PluginFunctions::getObject(id, object)) return -1;
  *object->mesh() = std::move(mesh);
  object->setName(name);
  show_mesh(id);
  return id;
}

void HostLink::remove_object(int id) { emit deleteObject(id); }

void HostLink::push_backup(int id, const QString& name) {
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

bool HostLink::host_undo(int id) {
  BackupData* backups = backups_of_object(id);
  if (!OpenFlipper::Options::gui() || backups == nullptr || !backups->undoAvailable()) return false;
  emit undo(id);
  return true;
}

bool HostLink::host_redo(int id) {
  BackupData* backups = backups_of_object(id);
  if (!OpenFlipper::Options::gui() || backups == nullptr || !backups->redoAvailable()) return false;
  emit redo(id);
  return true;
}

void HostLink::say(const QString& sentence) { emit log(LOGINFO, sentence); }

void HostLink::warn(const QString& sentence) {
  emit log(LOGWARN, sentence);
  if (OpenFlipper::Options::gui()) emit showStatusMessage(sentence, 6000);
}

void HostLink::wake() { QMetaObject::invokeMethod(this, "look_at_sessions", Qt::QueuedConnection); }

void HostLink::look_at_sessions() {
  for (const auto& [mesh, session] : sessions_.all()) session->take();
}

void HostLink::hint(const QString& sentence, bool on_something) {
  if (sentence == hint_) return;
  hint_ = sentence;
  emit showStatusMessage(sentence);
  emit setPickModeCursor(DrawingHand::kPickMode,
                         QCursor(on_something ? Qt::PointingHandCursor : Qt::ArrowCursor));
  changed();
}

void HostLink::changed() {
  if (panel_ == nullptr) return;
  panel_->show(hint_);
  emit updateView();
}

/// Keeps the distance of the view, with the place in the middle.
void HostLink::look_at(const ACG::Vec3d& place, const ACG::Vec3d& normal) {
  if (!OpenFlipper::Options::gui()) return;
  const int viewer = static_cast<int>(PluginFunctions::activeExaminer());
  const double away =
      (PluginFunctions::eyePos(viewer) - PluginFunctions::sceneCenter(viewer)).norm();
  ACG::Vec3d up = PluginFunctions::upVector(viewer);
  if ((up % normal).norm() < 0.1) up = ACG::Vec3d(normal[1], normal[2], normal[0]);
  PluginFunctions::lookAt(place + normal * away, place, up, viewer);
}

// ---- Progress

void HostLink::look_at_progress() {
  for (const auto& [mesh, session] : sessions_.all()) session->abandon_endless_work();
  const Session* session = sessions_.now();
  editing::Progress progress = session == nullptr ? editing::Progress() : session->progress();
  if (progress.task == editing::Task::kLeg)
    progress.busy = false;  // legs follow each other
                            // without a pause
  if (!progress.busy) busy_since_ = 0;
  if (progress.busy && busy_since_ == 0) busy_since_ = now_ms();
  const double busy_ms = progress.busy ? now_ms() - busy_since_ : 0;
  const int percent = static_cast<int>(100 * progress.fraction);
  panel_->panel()->show_progress(busy_ms > 300, QString::fromStdString(progress.stage), percent);
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

void HostLink::canceledJob(QString _job) {
  if (_job != kJob) return;
  for (const auto& [mesh, session] : sessions_.all()) session->cancel();
  say(tr("Cancelled."));
}

}  // namespace talweg::openflipper
