#include "Session.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>
#include <OpenFlipper/common/GlobalOptions.hh>

#include "CurveColours.hh"
#include "DrawingBackup.hh"

namespace talweg::openflipper {
namespace {

constexpr double kPatienceMs = 2000;  // with a task that was cancelled

double diagonal_of(const editing::MeshArrays& mesh) {
  ACG::Vec3d least(1e300), most(-1e300);
  for (const auto& p : mesh.positions) {
    least.minimize(ACG::Vec3d(p[0], p[1], p[2]));
    most.maximize(ACG::Vec3d(p[0], p[1], p[2]));
  }
  return mesh.positions.empty() ? 1 : (most - least).norm();
}

double mean_edge_of(const editing::MeshArrays& mesh) {
  double sum = 0;
  for (const auto& corners : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &from = mesh.positions[corners[k]], &to = mesh.positions[corners[(k + 1) % 3]];
      sum += std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    }
  }
  return mesh.triangles.empty() ? 1 : sum / (3 * static_cast<double>(mesh.triangles.size()));
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
      mean_edge_(mean_edge_of(*arrays_)),
      editor_(settings) {
  first_number_ = kept_number_ = editor_.history().number();
  if (OpenFlipper::Options::gui()) nodes_ = std::make_unique<CurveNodes>();
  open();
}

Session::~Session() = default;

void Session::open() {
  thread_.reset();
  HostCalls* host = &host_;
  thread_ = std::make_unique<editing::SmoothingThread>(
      plugins_, arrays_, [host] { host->wake(); }, 400, defects_);
  asked_ = {};
  sight_.reset();
  ticket_ = done_ = stale_ = leg_ticket_ = 0;
  tickets_.clear();
  lines_asked_.clear();
  problem_.clear();
  repair_told_.clear();
}

void Session::cancel() {
  thread_->cancel();
  done_ = ticket_;
  lines_asked_.clear();
  if (nodes_ && !sight_) thread_->see();
}

void Session::leave_what_never_ends() {
  const editing::Progress progress = thread_->progress();
  if (progress.cancelled_ms < kPatienceMs) return;
  fail(work_error_,
       QString("The plugin %1 has not ended two seconds after it was cancelled, and is "
               "given up; the mesh is opened again.")
           .arg(editing::plugin_of(progress.task)));
  open();
  asked_ = editor_.drawing();  // what never ended is not begun again by itself
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
         std::any_of(lines_.begin(), lines_.end(),
                     [object_id](const ResultLine& line) { return line.id == object_id; });
}

// ---- Edits

/// A curve that has come is the selected one, and the last one is where that has gone.
void Session::select_after(std::size_t curves_before) {
  const auto& curves = editor_.drawing().curves;
  const bool gone = selected_ != 0 && !selected();
  if (curves.empty() || (curves.size() <= curves_before && !gone)) return;
  selected_ = curves.back()->number;
}

bool Session::edit(const std::function<void(editing::Editor&)>& change) {
  const std::size_t before = editor_.drawing().curves.size();
  try {
    change(editor_);
  } catch (const editing::Error& error) {
    fail(edit_error_, in_words(error.what()));
    return false;
  }
  edit_error_.clear();
  select_after(before);
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
  ask_to_smooth();
  ask_for_lines();
}

void Session::ask_to_smooth() {
  const editing::Drawing& now = editor_.drawing();
  if (now == asked_) return;
  asked_ = now;
  log_next_ = log_next_ || !in_gesture();
  host::Wanted wanted;
  wanted.point_fields = wants_fields();
  if (host_curves(now).empty()) {
    if (smooths()) cancel();
    stale_ = ticket_;
    show_results({}, {}, true);
    return;
  }
  const editing::Hand moving = preview_ ? editing::Hand::kDrags : editing::Hand::kSlides;
  ticket_ = thread_->smooth(now, wanted, in_gesture() ? moving : editing::Hand::kRests);
  tickets_.asked(ticket_, now);
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
  const std::size_t before = editor_.drawing().curves.size();
  if (!editor_.history().go_to(number)) {
    fail(edit_error_, "This state of the drawing is no longer there.");
    return;
  }
  kept_number_ = number;
  select_after(before);
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
  const bool smoothed = outcome.task == editing::Task::kSmooth;
  const bool drawn = outcome.task == editing::Task::kDraw || outcome.task == editing::Task::kLeg;
  if (smoothed) done_ = outcome.ticket;
  if (!smoothed && !drawn) {  // those are in the report
    for (const std::string& note : outcome.notes) host_.say(in_words(note));
  }
  if (outcome.task == editing::Task::kOpen) take_opened(outcome);
  if (outcome.status == TALWEG_CANCELLED) return;
  if (outcome.status != TALWEG_OK) {
    if (!drawn) fail(work_error_, in_words(outcome.sentence));  // smoothing says the same
    return;
  }
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
      show_results(std::move(outcome.results), tickets_.take(outcome.ticket),
                   outcome.ticket == ticket_);
      return;
    case editing::Task::kSee:
      sight_ = std::move(outcome.sight);
      return;
    case editing::Task::kDraw:
      return take_drawn(outcome);
    case editing::Task::kLeg:
      return take_leg(outcome);
  }
}

void Session::take_opened(const editing::Outcome& outcome) {
  if (outcome.status == TALWEG_OK) {
    host_.say(QString("%1 is open after %2 ms.").arg(name_).arg(outcome.milliseconds, 0, 'f', 0));
    if (nodes_) thread_->see();
    return;
  }
  problem_ = in_words(outcome.sentence);
  for (const std::string& change : outcome.repair) {
    repair_told_ << in_words(change).remove("Repair: ");
  }
}

// ---- The host's objects

std::vector<ACG::Vec3d> Session::drawn_positions(std::size_t curve) const {
  std::vector<ACG::Vec3d> positions;
  for (const editing::Point& point : editor_.drawing().curves.at(curve)->points) {
    positions.push_back(vector_at(*arrays_, point));
  }
  return positions;
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
    const auto& curves = editor_.drawing().curves;
    if (!curves.empty()) deleted_.push_back(curves.back()->number);
  } else {
    const auto at = std::find_if(lines_.begin(), lines_.end(), [object_id](const ResultLine& line) {
      return line.id == object_id;
    });
    if (at == lines_.end()) return;
    deleted_.push_back(at->number);
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
  for (const std::uint32_t number : std::exchange(deleted_, {})) {
    if (const auto curve = index_of(editor_.drawing(), number)) {
      edit([curve](editing::Editor& editor) { editor.remove_curve(*curve); });
    }
  }
}

std::optional<editing::Point> Session::seen(const ACG::Vec3d& eye, const ACG::Vec3d& way) const {
  return sight_->first({eye[0], eye[1], eye[2]}, {way[0], way[1], way[2]});
}

bool Session::is_hidden(const editing::Point& point, const ACG::Vec3d& eye) const {
  if (!object_.visible()) return false;
  if (!sight_)
    sight_ = std::make_shared<const editing::Sight>(arrays_);  // the thread is not there yet
  return sight_->is_hidden(point, {eye[0], eye[1], eye[2]});
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
