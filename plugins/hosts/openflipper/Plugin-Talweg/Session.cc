#include "Session.hh"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include <OpenFlipper/common/GlobalOptions.hh>

#include "MeshUse.hh"
#include "Report.hh"
#include "talweg/editing/curve_files.hpp"

namespace talweg::openflipper {
namespace {

constexpr double kPatienceMs = 2000;  // time for a cancelled task to end

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Session)
};

QString in_words(const std::string& text) { return QString::fromStdString(text); }

/// The length, or 1 instead of 0, since sliders need a length.
double or_one(double length) { return length > 0 ? length : 1; }

}  // namespace

Session::Session(HostCalls& host, const editing::Plugins& plugins, TriMeshObject& object,
                 const editing::Settings& settings)
    : host_(host),
      plugins_(plugins),
      object_(object),
      name_(object.name()),
      now_{arrays_of(*object.mesh()), editing::Editor(settings)},
      diagonal_(or_one(editing::diagonal_of(arrays()))),
      mean_edge_(or_one(editing::mean_edge_of(arrays()))),
      requests_(
          plugins, [&host] { host.wake(); }, OpenFlipper::Options::gui()),
      nodes_(OpenFlipper::Options::gui() ? std::make_unique<CurveNodes>() : nullptr),
      line_(host, name_, editor().history(), [this](std::uint64_t number) { go_to(number); }),
      drawn_(nodes_.get()),
      lines_(host, name_),
      colours_(host, object, lines_),
      inspection_(host, nodes_.get(), diagonal_) {
  open();
}

Session::~Session() = default;

void Session::open() {
  requests_.open(now_.arrays, defects_);
  sight_.reset();
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

// ---- Edits

/// Selects a curve that an edit has added. After an edit that has removed curves, selects the last
/// curve if the selected one is gone.
void Session::select_after(std::size_t curves_before) {
  const auto& curves = drawing().curves;
  const bool gone = selected_ != 0 && !selected();
  if (curves.empty() || (curves.size() <= curves_before && !gone)) return;
  selected_ = curves.back()->number;
  lines_.select(selected_);
}

bool Session::edit(const std::function<void(editing::Editor&)>& change) {
  const std::size_t before = drawing().curves.size();
  try {
    change(now_.editor);
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
  const std::uint64_t before = editor().history().number();
  begin_gesture(name);
  const bool done = edit(change);
  if (!done && editor().history().number() != before) now_.editor.history().undo();
  end_gesture();
  return done;
}

void Session::fail(QString& error, const QString& sentence) {
  error = sentence;
  host_.warn(sentence);
  host_.changed();
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

void Session::begin_gesture(const char* name, bool preview) {
  now_.editor.history().begin_gesture(name);
  preview_ = preview;
}

void Session::end_gesture() {
  if (!in_gesture()) return;
  now_.editor.history().end_gesture();
  requests_.asked_already({});  // smooth again, so that the log gets the result
  after_edit();
}

void Session::after_edit() {
  show_drawing();
  ask();
  if (!in_gesture()) line_.keep(editor().history());
  host_.changed();
}

void Session::go_to(std::uint64_t number) {
  const std::size_t before = drawing().curves.size();
  if (!now_.editor.history().go_to(number)) {
    fail(edit_error_, "This state is no longer in the history of the drawing.");
    return;
  }
  line_.is_at(number);
  select_after(before);
  show_drawing();
  ask();
  host_.changed();
}

bool Session::undo() {
  end_gesture();
  if (line_.undo(editor().history())) return true;
  if (!editor().history().can_undo() && now_.born_of_cut) return host_.host_undo(object_.id());
  if (!now_.editor.history().undo()) return false;
  go_to(editor().history().number());
  return true;
}

bool Session::redo() {
  end_gesture();
  if (line_.redo(editor().history())) return true;
  if (!now_.editor.history().redo()) return false;
  go_to(editor().history().number());
  return true;
}

void Session::add_line(const PolyLine& line) { add_curves({positions_of(line)}); }

namespace {

/// The curve as vertices or points of faces; nothing for a curve of positions only.
std::optional<editing::Curve> curve_on(const editing::MeshArrays& mesh, const host::Curve& given) {
  editing::Curve curve;
  curve.closed = given.closed;
  if (!given.vertices.empty()) {
    curve.points = editing::points_at(mesh, given.vertices);
  } else if (!given.faces.empty()) {
    for (std::size_t k = 0; k < given.faces.size(); ++k) {
      curve.points.push_back(editing::picked(given.faces[k], given.barycentrics.at(k)));
    }
  } else {
    return std::nullopt;
  }
  for (const std::uint32_t pin : given.pins) curve.points.at(pin).pinned = true;
  for (std::size_t k = 0; k < given.exact.size(); ++k) curve.points.at(k).exact = given.exact[k];
  return curve;
}

}  // namespace

void Session::add_curves(std::vector<host::Curve> curves) {
  std::vector<host::Curve> positions;
  edit_together("Add curves", [&](editing::Editor& editor) {
    for (host::Curve& curve : curves) {
      if (auto drawn = curve_on(arrays(), curve)) {
        editor.add_curve(std::move(*drawn));
      } else {
        positions.push_back(std::move(curve));
      }
    }
  });
  if (!positions.empty()) requests_.place(std::move(positions));
}

namespace {

void add_all(editing::Editor& editor, const editing::MeshArrays& arrays,
             const std::vector<editing::OrderedVertices>& curves) {
  for (const editing::OrderedVertices& ordered : curves) {
    editor.add_curve({editing::points_at(arrays, ordered.vertices), ordered.closed});
  }
}

}  // namespace

void Session::add_selection() {
  edit_together("Curves from selection", [&](editing::Editor& editor) {
    add_all(editor, arrays(), ordered_selection(mesh(), arrays()));
  });
}

void Session::add_face_borders(bool of_selection) {
  edit_together("Curves from faces", [&](editing::Editor& editor) {
    add_all(editor, arrays(),
            of_selection ? border_of_selection(mesh()) : borders_of_colours(mesh()));
  });
}

std::optional<std::size_t> Session::selected() const { return index_of(drawing(), selected_); }

void Session::select(std::optional<std::size_t> curve) {
  const std::uint32_t before = selected_;
  selected_ = curve ? drawing().curves.at(*curve)->number : 0;
  if (selected_ == before) return;
  lines_.select(selected_);
  host_.changed();
}

// ---- Files

bool Session::write_result(const QString& path) {
  return attempt([&] {
    editing::write_curves(plugins_, path.toStdString(), arrays(), results_.curves);
    host_.say(Words::tr("Wrote %1.").arg(path));
  });
}

bool Session::write_drawing(const QString& path) {
  return attempt([&] {
    editing::write_curves(plugins_, path.toStdString(), arrays(),
                          drawn_curves(arrays(), drawing()));
    host_.say(Words::tr("Wrote %1.").arg(path));
  });
}

bool Session::read_drawing(const QString& path) {
  return attempt([&] { add_curves(editing::read_curves(plugins_, path.toStdString(), arrays())); });
}

// ---- The thread

void Session::ask() {
  host::Wanted wanted;
  wanted.point_fields = colours_.by() == ColourBy::kDeviation || inspection_.wants_fields();
  const editing::Hand moving = preview_ ? editing::Hand::kDrags : editing::Hand::kSlides;
  const auto asked =
      requests_.smooth(drawing(), wanted, in_gesture() ? moving : editing::Hand::kRests);
  if (asked != Requests::Asked::kAsAlready) log_next_ = log_next_ || !in_gesture();
  if (asked == Requests::Asked::kWithoutCurves) show_results({}, {}, true);
  if (nodes_) requests_.draw(drawing());
}

void Session::ask_again() {
  requests_.asked_already({});
  ask();
}

void Session::wait() {
  do {
    requests_.wait();
    take();
  } while (requests_.progress().busy);
}

void Session::take() {
  remove_deleted();
  while (auto answer = requests_.take()) take(std::move(*answer));
}

void Session::take(Answer answer) {
  editing::Outcome& outcome = answer.outcome;
  const bool drawn = outcome.task == editing::Task::kDraw || outcome.task == editing::Task::kLeg;
  if (outcome.task != editing::Task::kSmooth && !drawn) {  // others report them
    for (const std::string& note : outcome.notes) host_.say(in_words(note));
  }
  if (outcome.task == editing::Task::kOpen) take_opened(outcome);
  if (outcome.status == TALWEG_CANCELLED) return;
  if (outcome.status != TALWEG_OK) {
    if (!drawn) fail(work_error_, in_words(outcome.sentence));  // smoothing reports the same error
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
      colours_.show(outcome.results);
      return host_.changed();
    case editing::Task::kSmooth:
      last_run_ms_ = outcome.milliseconds;
      work_error_.clear();
      return show_results(std::move(outcome.results), std::move(answer.numbers), answer.newest);
    case editing::Task::kSee:
      sight_ = std::move(outcome.sight);
      return;
    case editing::Task::kDraw:
      drawn_.take(std::move(outcome.results.curves), answer.numbers, drawing());
      return host_.redraw();
    case editing::Task::kLeg:
      if (outcome.results.curves.empty()) return;
      drawn_.show_leg(outcome.results.curves[0], drawing().curves.back()->number);
      return host_.redraw();
  }
}

void Session::take_opened(const editing::Outcome& outcome) {
  if (outcome.status == TALWEG_OK) {
    host_.say(QString("%1 is open after %2 ms.").arg(name_).arg(outcome.milliseconds, 0, 'f', 0));
    return;
  }
  problem_ = in_words(outcome.sentence);
  for (const std::string& change : outcome.repair) {
    repair_told_ << in_words(change).remove("Repair: ");
  }
}

void Session::abandon_endless_work() {
  const editing::Progress progress = requests_.progress();
  if (progress.cancelled_ms < kPatienceMs) return;
  fail(work_error_,
       QString("The plugin %1 has not ended two seconds after it was cancelled. Its work was "
               "abandoned, and the mesh is opened again.")
           .arg(editing::plugin_of(progress.task)));
  open();
  requests_.asked_already(drawing());  // a task that did not end is not started again without a new
                                       // edit
}

// ---- Display

void Session::show_results(host::Results results, std::vector<std::uint32_t> numbers, bool newest) {
  results_ = std::move(results);
  numbers_ = std::move(numbers);
  numbers_.resize(results_.curves.size());
  lines_.show(mesh(), results_.curves, numbers_, drawing());
  inspection_.show(inspected());
  if (newest && !in_gesture() && log_next_ && !results_.curves.empty()) {
    log_next_ = false;
    host_.say(short_report(*this));
    if (colours_.on_mesh()) requests_.distance(drawing());
  }
  host_.changed();
}

std::optional<std::size_t> Session::result_of(std::uint32_t number) const {
  const auto at = std::find(numbers_.begin(), numbers_.end(), number);
  if (at == numbers_.end()) return std::nullopt;
  return static_cast<std::size_t>(at - numbers_.begin());
}

Inspected Session::inspected() const { return {arrays(), results_, numbers_, requests_.smooths()}; }

void Session::colour_by(ColourBy by) {
  if (by == colours_.by()) return;
  colours_.choose(by);
  if (host_curves(drawing()).empty()) return;
  if (colours_.on_mesh()) requests_.distance(drawing());
  if (by == ColourBy::kDeviation) ask_again();
  host_.changed();
}

void Session::show_comb(bool with) {
  if (with == inspection_.with_combs()) return;
  inspection_.show_combs(with);
  if (with) ask_again();
  host_.changed();
}

void Session::mark_largest(Mark mark) {
  inspection_.set_mark(mark);
  if (mark == Mark::kCurvature && !inspection_.has_combs()) {
    ask_again();
  } else {
    inspection_.find_mark(inspected());
  }
  host_.changed();
}

void Session::show_drawing() {
  requests_.no_leg();
  line_.show(drawing(), mesh(), arrays());
  show_drawn();
}

void Session::show_drawn() {
  if (nodes_) nodes_->set_visible(object_.visible() && !line_.is_hidden());
  drawn_.show(drawing(), arrays());
}

void Session::show_points(bool with) {
  drawn_.set_with_points(with);
  show_drawn();
}

void Session::reach_for(const std::optional<editing::Point>& to) {
  if (!nodes_) return;
  if (editor().is_drawing() && to) {
    requests_.leg(drawing().curves.back()->points.back(), *to);
    return;
  }
  requests_.no_leg();
  drawn_.hide_leg();
  host_.redraw();
}

std::vector<const host::Curve*> Session::lines_of(std::size_t curve) const {
  std::vector<const host::Curve*> lines;
  const std::uint32_t number = drawing().curves.at(curve)->number;
  if (const auto result = result_of(number)) lines.push_back(&results_.curves[*result]);
  if (const host::Curve* drawn = drawn_.line_of(number)) lines.push_back(drawn);
  return lines;
}

std::optional<editing::Point> Session::seen(const ACG::Vec3d& eye, const ACG::Vec3d& way) const {
  return sight_->first({eye[0], eye[1], eye[2]}, {way[0], way[1], way[2]});
}

bool Session::is_hidden(const editing::Point& point, const ACG::Vec3d& eye) const {
  if (!object_.visible()) return false;
  // The thread may not have made it yet.
  if (!sight_) sight_ = std::make_shared<const editing::Sight>(now_.arrays);
  return sight_->is_hidden(point, {eye[0], eye[1], eye[2]});
}

// ---- The host's mesh

void Session::require_results() const {
  if (editor().is_drawing()) throw editing::Error("First end the curve that is being drawn.");
  if (requests_.smooths()) throw editing::Error("The curves are still being smoothed.");
  if (results_.curves.empty()) throw editing::Error("There is no smoothed curve yet.");
}

bool Session::cut(bool select_inside) {
  return attempt([&] {
    require_results();
    const host::Results results = results_;
    const AppliedPlan plan = cut_mesh(plugins_, mesh(), arrays(), results.curves);
    for (const auto& chain : plan.chains) {
      for (const auto h : chain) mesh().status(mesh().edge_handle(h)).set_selected(true);
    }
    move_drawing_to_cut_mesh(plan);
    host_.show_mesh(object_.id());
    host_.push_backup(object_.id(), "Cut");
    host_.say(QString("%1 is cut: %2 new vertices, %3 new faces.")
                  .arg(name_)
                  .arg(plan.vertices.size())
                  .arg(plan.faces.size()));
    if (!select_inside) return;
    const auto inside = faces_inside(mesh(), plan, results.curves);
    for (const auto f : inside) mesh().status(f).set_selected(true);
    host_.show_selection(object_.id());
    host_.push_backup(object_.id(), "Select inside");
    host_.say(QString("%1 faces are inside.").arg(inside.size()));
  });
}

bool Session::split(bool lids, std::vector<int>& parts) {
  return attempt([&] {
    require_results();
    const auto say = [this](const QString& sentence) { host_.say(sentence); };
    for (TriMesh& part : parts_of_mesh(plugins_, mesh(), results_.curves, lids, say)) {
      const QString name = QString("%1 part %2").arg(name_).arg(parts.size() + 1);
      parts.push_back(host_.add_mesh(name, std::move(part)));
    }
    host_.say(QString("Parts of %1 as new meshes: %2; %1 itself is unchanged.")
                  .arg(name_)
                  .arg(parts.size()));
  });
}

bool Session::offset(const Offset& how, std::vector<int>& lines) {
  return attempt([&] {
    require_results();
    std::vector<host::Curve> chosen = results_.curves;
    if (const auto result = result_of(selected_)) chosen = {results_.curves[*result]};
    const auto say = [this](const QString& sentence) { host_.say(sentence); };
    lines =
        add_lines(host_, name_, mesh(), offset_of(plugins_, arrays(), defects_, chosen, how, say));
    host_.say(
        QString("%1 offset curve(s) of %2 at %3.").arg(lines.size()).arg(name_).arg(how.distance));
  });
}

/// Moves the drawing to the cut mesh. The history begins anew: earlier states belong to the mesh
/// before the cut, and are restored with that mesh.
void Session::move_drawing_to_cut_mesh(const AppliedPlan& plan) {
  editing::Drawing there = drawing();
  for (auto& curve : there.curves) {
    auto moving = std::make_shared<editing::Curve>(*curve);
    for (editing::Point& point : moving->points) point = moved(arrays(), mesh(), plan, point);
    curve = std::move(moving);
  }
  others_.push_back(std::move(now_));
  if (others_.size() > 4) others_.erase(others_.begin());
  now_ = {arrays_of(mesh()), editing::Editor(std::move(there)), true};
  begin_on_other_mesh();
}

/// Restores the drawing of this mesh, if there was one.
bool Session::go_back_to(const editing::MeshArrays& mesh) {
  const auto other = std::find_if(others_.begin(), others_.end(),
                                  [&mesh](const OnMesh& other) { return *other.arrays == mesh; });
  if (other == others_.end()) return false;
  std::swap(now_, *other);
  begin_on_other_mesh();
  return true;
}

/// Replaces the drawing's line, which has the host's list for undo, so that the list begins anew,
/// too.
void Session::begin_on_other_mesh() {
  const int before = line_.begin_anew(editor().history());
  if (before >= 0) to_remove_.push_back(before);
  host_.wake();
  open();
  after_edit();
}

void Session::mesh_updated() {
  std::shared_ptr<const editing::MeshArrays> arrays;
  try {
    arrays = arrays_of(mesh());
  } catch (const editing::Error& error) {
    return fail(work_error_, in_words(error.what()));
  }
  if (*arrays == *now_.arrays || go_back_to(*arrays)) return;
  now_.born_of_cut = false;
  const bool same_faces = arrays->triangles == now_.arrays->triangles;
  now_.arrays = std::move(arrays);
  open();
  host_.warn(QString("%1 has changed and is opened again.").arg(name_));
  if (!same_faces) {
    host_.warn(QString("The drawing on %1 was removed, because the mesh has other faces now: draw "
                       "again.")
                   .arg(name_));
    edit([](editing::Editor& editor) { editor.clear(); });
    return;
  }
  after_edit();
}

void Session::object_deleted(int object_id) {
  if (line_.was_deleted(object_id)) {  // the line shows the last curve
    if (!drawing().curves.empty()) deleted_.push_back(drawing().curves.back()->number);
  } else if (const auto number = lines_.was_deleted(object_id)) {
    deleted_.push_back(*number);
  } else {
    return;
  }
  host_.wake();
}

/// Removes objects after the host's own deletion has ended, since an edit may add objects.
void Session::remove_deleted() {
  for (const int id : std::exchange(to_remove_, {})) host_.remove_object(id);
  if (deleted_.empty()) return;
  end_gesture();
  requests_.drop();
  for (const std::uint32_t number : std::exchange(deleted_, {})) {
    if (const auto curve = index_of(drawing(), number)) {
      edit([curve](editing::Editor& editor) { editor.remove_curve(*curve); });
    }
  }
}

void Session::visibility_changed(int object_id) {
  if (object_id == object_.id() || object_id == line_.id()) show_drawn();
}

}  // namespace talweg::openflipper
