// Results that are used on the host's mesh, and a drawing that goes with the mesh through cut, undo
// and redo.
#include <utility>

#include "MeshUse.hh"
#include "Session.hh"

namespace talweg::openflipper {

void Session::require_results() const {
  if (editor_.is_drawing()) throw editing::Error("First end the curve that is being drawn.");
  if (smooths()) throw editing::Error("The curves are still being smoothed.");
  if (results_.curves.empty()) throw editing::Error("There is no smoothed curve to cut along.");
}

bool Session::cut(bool select_inside) {
  return attempt([&] {
    require_results();
    const host::Results results = results_;
    const AppliedPlan plan = cut_mesh(plugins_, mesh(), *arrays_, results.curves);
    for (const auto& chain : plan.chains) {
      for (const auto h : chain) mesh().status(mesh().edge_handle(h)).set_selected(true);
    }
    go_over(plan);
    host_.show_mesh(mesh_id_);
    host_.push_backup(mesh_id_, "Cut");
    host_.say(QString("%1 is cut: %2 new vertices, %3 new faces.")
                  .arg(name_)
                  .arg(plan.vertices.size())
                  .arg(plan.faces.size()));
    if (!select_inside) return;
    const auto inside = faces_inside(mesh(), plan, results.curves);
    for (const auto f : inside) mesh().status(f).set_selected(true);
    host_.show_selection(mesh_id_);
    host_.push_backup(mesh_id_, "Select inside");
    host_.say(QString("%1 faces are inside.").arg(inside.size()));
  });
}

/// The drawing as it is on the mesh after a cut. Its history begins anew: states before belong to
/// the mesh before, and come back with it.
void Session::go_over(const AppliedPlan& plan) {
  editing::Drawing drawing = editor_.drawing();
  for (auto& curve : drawing.curves) {
    auto there = std::make_shared<editing::Curve>(*curve);
    for (editing::Point& point : there->points) point = moved(*arrays_, mesh(), plan, point);
    curve = std::move(there);
  }
  others_.push_back({arrays_, std::move(editor_), born_of_cut_});
  if (others_.size() > 4) others_.erase(others_.begin());
  history_begins_with(editing::Editor(std::move(drawing)), arrays_of(mesh()));
  born_of_cut_ = true;
  open();
  after_edit();
}

/// Goes back to the drawing on the mesh as it is now, if there was one.
bool Session::go_back_to(const std::shared_ptr<const editing::MeshArrays>& now) {
  for (OtherMesh& other : others_) {
    if (*other.arrays != *now) continue;
    OtherMesh before{arrays_, std::move(editor_), born_of_cut_};
    history_begins_with(std::move(other.editor), other.arrays);
    born_of_cut_ = other.born_of_cut;
    other = std::move(before);
    open();
    after_edit();
    return true;
  }
  return false;
}

/// The host's list of undo belongs to the line with the drawing, so that begins anew, too.
void Session::history_begins_with(editing::Editor editor,
                                  std::shared_ptr<const editing::MeshArrays> arrays) {
  editor_ = std::move(editor);
  arrays_ = std::move(arrays);
  self_ = std::make_shared<Session*>(this);
  first_number_ = kept_number_ = editor_.history().number();
  if (drawing_id_ >= 0) to_remove_.push_back(std::exchange(drawing_id_, -1));
  host_.wake();
}

bool Session::split(bool lids, std::vector<int>& parts) {
  return attempt([&] {
    require_results();
    const auto say = [this](const QString& sentence) { host_.say(sentence); };
    for (TriMesh& part : parts_of_mesh(plugins_, mesh(), results_.curves, lids, say)) {
      const QString name = QString("%1 part %2").arg(name_).arg(parts.size() + 1);
      parts.push_back(host_.add_mesh(name, std::move(part)));
    }
    host_.say(QString("%1 has %2 parts now; itself it is as it was.").arg(name_).arg(parts.size()));
  });
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
    add_all(editor, *arrays_, ordered_selection(mesh(), *arrays_));
  });
}

void Session::add_face_borders(bool of_selection) {
  edit_together("Curves from faces", [&](editing::Editor& editor) {
    add_all(editor, *arrays_,
            of_selection ? border_of_selection(mesh()) : borders_of_colours(mesh()));
  });
}

}  // namespace talweg::openflipper
