#include "Session.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>
#include <OpenFlipper/common/GlobalOptions.hh>

#include "DrawingBackup.hh"

namespace talweg::openflipper {
namespace {

const ACG::Vec4f kResult(0.15f, 1.0f, 0.35f, 1.0f), kDrawn(0.55f, 0.55f, 0.55f, 1.0f);
const ACG::Vec4f kPoint(1.0f, 0.75f, 0.1f, 1.0f), kPinned(0.9f, 0.1f, 0.1f, 1.0f);
const ACG::Vec4f kFirst(0.2f, 0.5f, 1.0f, 1.0f);

double diagonal_of(const editing::MeshArrays& mesh) {
  ACG::Vec3d least(1e300), most(-1e300);
  for (const auto& p : mesh.positions) {
    least.minimize(ACG::Vec3d(p[0], p[1], p[2]));
    most.maximize(ACG::Vec3d(p[0], p[1], p[2]));
  }
  return mesh.positions.empty() ? 1 : (most - least).norm();
}

PolyLine* line_of(int id) {
  PolyLineObject* object = PluginFunctions::polyLineObject(id);
  return object == nullptr ? nullptr : object->line();
}

QString in_words(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

Session::Session(HostCalls& host, const editing::Plugins& plugins, TriMeshObject& object,
                 const editing::Settings& settings)
    : host_(host),
      plugins_(plugins),
      object_(object),
      mesh_id_(object.id()),
      name_(object.name()),
      arrays_(arrays_of(*object.mesh())),
      diagonal_(diagonal_of(*arrays_)),
      editor_(settings) {
  first_number_ = kept_number_ = editor_.history().number();
  if (OpenFlipper::Options::gui()) {
    material_ = new ACG::SceneGraph::MaterialNode(nullptr, "Talweg: look of the drawn points");
    material_->set_point_size(8.0f);
    points_ = new ACG::SceneGraph::PointNode(material_, "Talweg: drawn points");
    points_->drawMode(ACG::SceneGraph::DrawModes::POINTS_COLORED);
    points_->enablePicking(false);
    PluginFunctions::addGlobalNode(material_);
  }
  open();
}

Session::~Session() {
  thread_.reset();
  if (material_ != nullptr) material_->delete_subtree();
}

void Session::open() {
  thread_.reset();
  HostCalls* host = &host_;
  thread_ = std::make_unique<editing::SmoothingThread>(
      plugins_, arrays_, [host] { host->wake(); }, 400, defects_);
  asked_ = {};
  sight_.reset();
  ticket_ = stale_ = 0;
  problem_.clear();
  repair_told_.clear();
}

void Session::repair() {
  defects_ = editing::Defects::kRepair;
  work_error_.clear();
  open();
  ask();
  host_.changed();
}

bool Session::owns(int object_id) const {
  return object_id == drawing_id_ ||
         std::find(lines_.begin(), lines_.end(), object_id) != lines_.end();
}

// ---- Edits

bool Session::edit(const std::function<void(editing::Editor&)>& change) {
  try {
    change(editor_);
  } catch (const editing::Error& error) {
    fail(edit_error_, in_words(error.what()));
    return false;
  }
  edit_error_.clear();
  after_edit();
  return true;
}

bool Session::edit_together(const char* name, const std::function<void(editing::Editor&)>& change) {
  end_gesture();
  const std::uint64_t before = editor_.history().number();
  begin_gesture(name);
  const bool done = edit(change);
  if (!done && editor_.history().number() != before) editor_.history().undo();
  end_gesture();
  return done;
}

void Session::fail(QString& error, const QString& sentence) {
  error = sentence;
  host_.warn(sentence);
  host_.changed();
}

void Session::begin_gesture(const char* name, bool preview) {
  editor_.history().begin_gesture(name);
  preview_ = preview;
}

void Session::end_gesture() {
  if (!in_gesture()) return;
  editor_.history().end_gesture();
  asked_ = {};  // once more, for the log
  after_edit();
}

void Session::after_edit() {
  show_drawing();
  ask();
  if (!in_gesture()) keep_backup();
  host_.changed();
}

void Session::ask() {
  const editing::Drawing& now = editor_.drawing();
  if (now == asked_) return;
  asked_ = now;
  log_next_ = log_next_ || !in_gesture();
  host::Wanted wanted;
  wanted.point_fields = colour_by_ == ColourBy::kDeviation;
  if (host_curves(now).empty()) {
    thread_->cancel();
    stale_ = ticket_;
    show_results({}, true);
    return;
  }
  const editing::Hand moving = preview_ ? editing::Hand::kDrags : editing::Hand::kSlides;
  ticket_ = thread_->smooth(now, wanted, in_gesture() ? moving : editing::Hand::kRests);
}

/// The host's list of undo gets the state that is there now. A new list begins with the one before.
void Session::keep_backup() {
  const std::uint64_t number = editor_.history().number();
  if (number == kept_number_) return;
  BaseObjectData* object = nullptr;
  if (drawing_id_ >= 0 && PluginFunctions::getObject(drawing_id_, object)) {
    const auto restore = [self = std::weak_ptr<Session*>(self_)](std::uint64_t to) {
      return [self, to] {
        if (const auto session = self.lock()) (*session)->go_to(to);
      };
    };
    if (!object->hasObjectData(OBJECT_BACKUPS)) first_number_ = kept_number_;
    BackupData& backups = backups_of(*object, restore(first_number_));
    const QString name = in_words(editor_.history().undo_name());
    backups.storeBackup(new DrawingBackup(object, name, restore(number)));
    host_.push_backup(drawing_id_, name);
  }
  kept_number_ = number;
}

void Session::go_to(std::uint64_t number) {
  if (!editor_.history().go_to(number)) {
    fail(edit_error_, "This state of the drawing is no longer there.");
    return;
  }
  kept_number_ = number;
  show_drawing();
  ask();
  host_.changed();
}

/// Numbers of states grow along the history: those before first_number_ are not on the host's list.
bool Session::undo() {
  end_gesture();
  const bool listed = drawing_id_ >= 0 && editor_.history().number() > first_number_;
  if (listed && host_.host_undo(drawing_id_)) return true;
  if (!editor_.history().can_undo() && born_of_cut_) return host_.host_undo(mesh_id_);
  if (!editor_.history().undo()) return false;
  go_to(editor_.history().number());
  return true;
}

bool Session::redo() {
  end_gesture();
  const bool listed = drawing_id_ >= 0 && editor_.history().number() >= first_number_;
  if (listed && host_.host_redo(drawing_id_)) return true;
  if (!editor_.history().redo()) return false;
  go_to(editor_.history().number());
  return true;
}

void Session::add_line(const PolyLine& line) { add_curves({positions_of(line)}); }

void Session::add_curves(std::vector<host::Curve> curves) {
  std::vector<host::Curve> positions;
  edit_together("Add curves", [&](editing::Editor& editor) {
    for (host::Curve& curve : curves) {
      editing::Curve drawn;
      drawn.closed = curve.closed;
      if (!curve.vertices.empty()) {
        drawn.points = editing::points_at(*arrays_, curve.vertices);
      } else if (!curve.faces.empty()) {
        for (std::size_t k = 0; k < curve.faces.size(); ++k) {
          drawn.points.push_back(editing::picked(curve.faces[k], curve.barycentrics.at(k)));
        }
      } else {
        positions.push_back(std::move(curve));
        continue;
      }
      for (const std::uint32_t pin : curve.pins) drawn.points.at(pin).pinned = true;
      for (std::size_t k = 0; k < curve.exact.size(); ++k) {
        drawn.points.at(k).exact = curve.exact[k];
      }
      editor.add_curve(std::move(drawn));
    }
  });
  if (!positions.empty()) thread_->place(std::move(positions));
}

// ---- What the thread has done

void Session::wait() {
  do {
    thread_->wait();
    take();
  } while (thread_->progress().busy);
}

void Session::take() {
  remove_deleted();
  while (auto outcome = thread_->take()) take(std::move(*outcome));
}

void Session::take(editing::Outcome outcome) {
  if (outcome.task != editing::Task::kSmooth) {  // those are in its report
    for (const std::string& note : outcome.notes) host_.say(in_words(note));
  }
  if (outcome.task == editing::Task::kOpen) take_opened(outcome);
  if (outcome.status == TALWEG_CANCELLED) return;
  if (outcome.status != TALWEG_OK) return fail(work_error_, in_words(outcome.sentence));
  switch (outcome.task) {
    case editing::Task::kOpen:
      return;
    case editing::Task::kPlace:
      edit_together("Add curves", [&](editing::Editor& editor) {
        for (editing::Curve& curve : outcome.placed) editor.add_curve(std::move(curve));
      });
      return;
    case editing::Task::kDistance:
      return show_mesh_colours(outcome.results);
    case editing::Task::kSmooth:
      if (outcome.ticket <= stale_) return;
      last_run_ms_ = outcome.milliseconds;
      work_error_.clear();
      show_results(std::move(outcome.results), outcome.ticket == ticket_);
      return;
    case editing::Task::kSee:
      sight_ = std::move(outcome.sight);
      return;
    case editing::Task::kDraw:
    case editing::Task::kLeg:
      return;
  }
}

void Session::take_opened(const editing::Outcome& outcome) {
  if (outcome.status == TALWEG_OK) {
    host_.say(QString("%1 is open after %2 ms.").arg(name_).arg(outcome.milliseconds, 0, 'f', 0));
    if (points_ != nullptr) thread_->see();
    return;
  }
  problem_ = in_words(outcome.sentence);
  for (const std::string& change : outcome.repair) {
    repair_told_ << in_words(change).remove("Repair: ");
  }
}

void Session::show_results(host::Results results, bool newest) {
  results_ = std::move(results);
  while (lines_.size() > results_.curves.size()) {
    const int id = lines_.back();
    lines_.pop_back();
    host_.remove_object(id);
  }
  double largest = 0;
  for (const host::Curve& curve : results_.curves) {
    for (const host::Field& field : curve.fields) {
      if (field.name != "deviation") continue;
      for (const double d : field.values) largest = std::max(largest, std::isfinite(d) ? d : 0.0);
    }
  }
  for (std::size_t c = 0; c < results_.curves.size(); ++c) {
    if (c == lines_.size()) {
      lines_.push_back(host_.add_line(QString("%1 smoothed %2").arg(name_).arg(c + 1)));
      if (PolyLineObject* made = PluginFunctions::polyLineObject(lines_.back())) {
        made->materialNode()->set_color(kResult);
        made->materialNode()->set_line_width(4.0f);
        made->materialNode()->set_point_size(1.0f);
        made->setObjectDrawMode(ACG::SceneGraph::DrawModes::WIREFRAME);
      }
    }
    PolyLine* line = line_of(lines_[c]);
    if (line == nullptr) continue;
    fill(*line, mesh(), results_.curves[c]);
    for (const host::Field& field : results_.curves[c].fields) {
      if (field.name == "deviation") colour(*line, field.values, largest);
    }
    host_.show_line(lines_[c]);
  }
  if (newest && !in_gesture() && log_next_ && !results_.curves.empty()) {
    log_next_ = false;
    host_.say(short_report(*this));
    if (colour_by_ == ColourBy::kDistance || colour_by_ == ColourBy::kPotential) {
      thread_->distance(editor_.drawing());
    }
  }
  host_.changed();
}

void Session::show_mesh_colours(const host::Results& results) {
  const char* wanted = colour_by_ == ColourBy::kPotential ? "potential" : "distance";
  for (const host::Field& field : results.fields) {
    if (field.name != wanted) continue;
    colour(mesh(), field.values);
    object_.setObjectDrawMode(ACG::SceneGraph::DrawModes::SOLID_POINTS_COLORED_SHADED);
    host_.show_colours(mesh_id_);
  }
}

void Session::colour_by(ColourBy by) {
  const ColourBy before = std::exchange(colour_by_, by);
  if (before == by) return;
  const auto on_mesh = [](ColourBy b) {
    return b == ColourBy::kDistance || b == ColourBy::kPotential;
  };
  if (on_mesh(before) && !on_mesh(by)) {
    object_.setObjectDrawMode(ACG::SceneGraph::DrawModes::SOLID_SMOOTH_SHADED);
    host_.show_colours(mesh_id_);
  }
  for (const int id : lines_) {
    if (PolyLineObject* line = PluginFunctions::polyLineObject(id)) {
      line->setObjectDrawMode(by == ColourBy::kDeviation ? ACG::SceneGraph::DrawModes::EDGES_COLORED
                                                         : ACG::SceneGraph::DrawModes::WIREFRAME);
    }
  }
  if (host_curves(editor_.drawing()).empty()) return;
  if (on_mesh(by)) thread_->distance(editor_.drawing());
  if (by == ColourBy::kDeviation) {
    asked_ = {};
    ask();
  }
  host_.changed();
}

// ---- The drawing in the scene

void Session::show_drawing() {
  show_points();
  const auto& curves = editor_.drawing().curves;
  if (drawing_id_ < 0) {
    if (curves.empty()) return;
    drawing_id_ = host_.add_line(QString("%1 drawing").arg(name_));
    if (PolyLineObject* made = PluginFunctions::polyLineObject(drawing_id_)) {
      made->materialNode()->set_color(kDrawn);
      made->materialNode()->set_line_width(1.0f);
      made->setObjectDrawMode(ACG::SceneGraph::DrawModes::WIREFRAME);
    }
  }
  PolyLine* line = line_of(drawing_id_);
  if (line == nullptr) return;
  if (curves.empty()) {
    line->clear();
  } else {
    fill(*line, mesh(), *arrays_, *curves.back());
  }
  host_.show_line(drawing_id_);
}

std::vector<ACG::Vec3d> Session::drawn_positions(std::size_t curve) const {
  std::vector<ACG::Vec3d> positions;
  for (const editing::Point& point : editor_.drawing().curves.at(curve)->points) {
    positions.push_back(vector_at(*arrays_, point));
  }
  return positions;
}

void Session::show_points() {
  if (points_ == nullptr) return;
  points_->clear();
  const editing::Drawing& now = editor_.drawing();
  for (std::size_t c = 0; c < now.curves.size(); ++c) {
    const bool drawn_now = now.unfinished && c + 1 == now.curves.size();
    bool first = drawn_now;
    for (const editing::Point& point : now.curves[c]->points) {
      points_->add_point(vector_at(*arrays_, point));
      points_->add_color(point.pinned ? kPinned : first ? kFirst : kPoint);
      first = false;
    }
  }
}

void Session::mesh_updated() {
  std::shared_ptr<const editing::MeshArrays> now;
  try {
    now = arrays_of(mesh());
  } catch (const editing::Error& error) {
    return fail(work_error_, in_words(error.what()));
  }
  if (*now == *arrays_ || go_back_to(now)) return;
  born_of_cut_ = false;
  const bool same_faces = now->triangles == arrays_->triangles;
  arrays_ = std::move(now);
  open();
  host_.warn(QString("%1 has changed and is opened again.").arg(name_));
  if (!same_faces) {
    host_.warn(QString("Its faces are others now: the drawing on it is gone."));
    edit([](editing::Editor& editor) { editor.clear(); });
    return;
  }
  after_edit();
}

void Session::object_deleted(int object_id) {
  if (object_id == drawing_id_) {  // shows the last curve
    drawing_id_ = -1;
    if (const std::size_t curves = editor_.drawing().curves.size(); curves > 0) {
      deleted_.push_back(curves - 1);
    }
  } else {
    const auto at = std::find(lines_.begin(), lines_.end(), object_id);
    if (at == lines_.end()) return;
    deleted_.push_back(static_cast<std::size_t>(at - lines_.begin()));
    lines_.erase(at);
  }
  host_.wake();
}

/// Not while the host deletes, since an edit may add objects.
void Session::remove_deleted() {
  for (const int id : std::exchange(to_remove_, {})) host_.remove_object(id);
  if (deleted_.empty()) return;
  end_gesture();
  stale_ = ticket_;
  for (const std::size_t curve : std::exchange(deleted_, {})) {
    edit([curve](editing::Editor& editor) { editor.remove_curve(curve); });
  }
}

std::optional<editing::Point> Session::seen(const ACG::Vec3d& eye, const ACG::Vec3d& way) const {
  return sight_->first({eye[0], eye[1], eye[2]}, {way[0], way[1], way[2]});
}

bool Session::is_hidden(std::size_t curve, std::size_t point, const ACG::Vec3d& eye) const {
  const editing::Point& at = editor_.drawing().curves.at(curve)->points.at(point);
  if (!object_.visible()) return false;
  if (!sight_)
    sight_ = std::make_shared<const editing::Sight>(arrays_);  // the thread is not there yet
  return sight_->is_hidden(at, {eye[0], eye[1], eye[2]});
}

bool Session::attempt(const std::function<void()>& work) {
  edit_error_.clear();
  try {
    work();
    return true;
  } catch (const std::exception& error) {
    fail(edit_error_, in_words(error.what()));
    return false;
  }
}

}  // namespace talweg::openflipper
