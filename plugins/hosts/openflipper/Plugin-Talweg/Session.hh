// A session is the drawing on one mesh of the host: its editor, what is asked of its thread, and
// what shows it.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "Colours.hh"
#include "DrawingLine.hh"
#include "DrawnCurves.hh"
#include "HostMesh.hh"
#include "Inspection.hh"
#include "OffsetCurves.hh"
#include "Requests.hh"
#include "ResultLines.hh"
#include "talweg/editing/editor.hpp"
#include "talweg/editing/sight.hpp"

namespace talweg {
struct AppliedPlan;
}

namespace talweg::openflipper {

class Session {
 public:
  /// Copies the mesh and begins to open it. Throws editing::Error.
  Session(HostCalls& host, const editing::Plugins& plugins, TriMeshObject& object,
          const editing::Settings& settings);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  [[nodiscard]] const editing::Editor& editor() const { return now_.editor; }
  [[nodiscard]] const editing::Drawing& drawing() const { return now_.editor.drawing(); }
  [[nodiscard]] const editing::MeshArrays& arrays() const { return *now_.arrays; }
  [[nodiscard]] TriMesh& mesh() const { return *object_.mesh(); }
  [[nodiscard]] const QString& name() const { return name_; }
  [[nodiscard]] double diagonal() const { return diagonal_; }
  [[nodiscard]] double mean_edge() const { return mean_edge_; }

  // ---- Edits.

  /// One edit; one that cannot be done is told, and false.
  bool edit(const std::function<void(editing::Editor&)>& change);
  /// Several edits as one step of undo; all of them or none.
  bool edit_together(const char* name, const std::function<void(editing::Editor&)>& change);
  /// A movement of the hand: one step of undo. `preview`: of a point, shown by previews.
  void begin_gesture(const char* name, bool preview = false);
  void end_gesture();
  [[nodiscard]] bool in_gesture() const { return editor().history().in_gesture(); }
  bool undo();
  bool redo();
  [[nodiscard]] bool can_undo() const { return editor().history().can_undo() || now_.born_of_cut; }

  void add_selection();
  void add_face_borders(bool of_selection);  ///< of the selected faces, or of face colours
  void add_line(const PolyLine& line);

  /// The curve that a person has chosen, or has drawn last. No part of the drawing.
  [[nodiscard]] std::optional<std::size_t> selected() const;
  void select(std::optional<std::size_t> curve);

  // ---- Files, in the library's formats. False, and told, where it fails.

  bool write_result(const QString& path);
  bool write_drawing(const QString& path);
  /// Adds the curves of the file, snapped where they are positions.
  bool read_drawing(const QString& path);

  // ---- The host's mesh.

  /// Makes the results edges of the mesh, and selects them and, if asked, the faces inside closed
  /// ones. The drawing goes with the mesh, also when the host takes the cut back.
  bool cut(bool select_inside);
  /// Makes a mesh of each part that the results leave.
  bool split(bool lids, std::vector<int>& parts);
  /// Adds lines at a distance from the selected result, or from all; the drawing stays.
  bool offset(const Offset& how, std::vector<int>& lines);
  /// Opens the mesh again, repaired. The host's mesh stays as it is, and results have its numbers.
  void repair();
  /// Why nothing can be drawn on the mesh as it is; empty where it can.
  [[nodiscard]] const QString& problem() const { return problem_; }
  /// What repair() would do; empty where there is no problem, or no repair helps.
  [[nodiscard]] const QStringList& repair_told() const { return repair_told_; }

  // ---- Results.

  /// Takes in what the thread has done.
  void take();
  /// The same when all of it is done. For scripts.
  void wait();
  void cancel() { requests_.cancel(); }
  /// A faulty plugin may not end a task that was cancelled: it is left to itself, and named.
  void leave_what_never_ends();
  [[nodiscard]] editing::Progress progress() const { return requests_.progress(); }

  [[nodiscard]] const host::Results& results() const { return results_; }
  /// Which of the results is of the curve with that number.
  [[nodiscard]] std::optional<std::size_t> result_of(std::uint32_t number) const;
  [[nodiscard]] double last_run_ms() const { return last_run_ms_; }
  /// Why the last edit was refused or, where it was not, the last work in the thread failed.
  [[nodiscard]] const QString& last_error() const {
    return edit_error_.isEmpty() ? work_error_ : edit_error_;
  }
  [[nodiscard]] const QString& work_error() const { return work_error_; }

  // ---- How it looks.

  void colour_by(ColourBy by);
  [[nodiscard]] const Colours& colours() const { return colours_; }
  void show_comb(bool with);
  /// Marks the place where that is largest, now and in results to come, and turns the view to it.
  void mark_largest(Mark mark);
  [[nodiscard]] const Inspection& inspection() const { return inspection_; }
  void show_points(bool with);
  [[nodiscard]] bool shows_point(std::size_t curve, std::size_t point) const {
    return drawn_.shows_point(drawing(), curve, point);
  }
  /// Shows how the curve that is being drawn would go on to that point, or no more.
  void reach_for(const std::optional<editing::Point>& to);
  /// A curve as it is smoothed and as it was drawn, as far as that is known. Until the next edit or
  /// take().
  [[nodiscard]] std::vector<const host::Curve*> lines_of(std::size_t curve) const;

  // ---- What is seen of the mesh.

  /// Whether seen() can tell already.
  [[nodiscard]] bool can_see() const { return sight_ != nullptr && object_.visible(); }
  /// What of the mesh lies first on the way from the eye.
  [[nodiscard]] std::optional<editing::Point> seen(const ACG::Vec3d& eye,
                                                   const ACG::Vec3d& way) const;
  /// Whether the mesh lies between that point and the eye.
  [[nodiscard]] bool is_hidden(const editing::Point& point, const ACG::Vec3d& eye) const;

  // ---- What the host tells.

  /// Its mesh may have changed: opens it again if it has.
  void mesh_updated();
  /// Ids of the smoothed curves' objects.
  [[nodiscard]] std::vector<int> lines() const { return lines_.ids(); }
  [[nodiscard]] bool owns(int object_id) const {
    return object_id == line_.id() || lines_.has(object_id);
  }
  /// An object of ours that a person has deleted: its curve goes, which is an edit, as soon as the
  /// host is done.
  void object_deleted(int object_id);
  /// That object was hidden or shown. What was drawn goes with the mesh and the drawing's line.
  void visibility_changed(int object_id);

 private:
  void open();
  void select_after(std::size_t curves_before);
  void after_edit();
  void add_curves(std::vector<host::Curve> curves);
  /// Does what may fail with an exception; a failure is told, and false.
  bool attempt(const std::function<void()>& work);
  void fail(QString& error, const QString& sentence);
  void go_to(std::uint64_t number);
  void ask();
  void ask_again();
  void take(Answer answer);
  void take_opened(const editing::Outcome& outcome);
  void show_results(host::Results results, std::vector<std::uint32_t> numbers, bool newest);
  [[nodiscard]] Inspected inspected() const;
  void show_drawing();
  void show_drawn();
  void require_results() const;
  void go_over(const AppliedPlan& plan);
  bool go_back_to(const editing::MeshArrays& mesh);
  void mesh_is_another();
  void remove_deleted();

  /// A drawing and the mesh that it is on.
  struct OnMesh {
    std::shared_ptr<const editing::MeshArrays> arrays;
    editing::Editor editor;
    bool born_of_cut = false;  // the mesh is as a cut of ours has left it
  };

  HostCalls& host_;
  const editing::Plugins& plugins_;
  TriMeshObject& object_;
  QString name_;
  OnMesh now_;
  std::vector<OnMesh> others_;  // what it was before a cut, or after one
  double diagonal_;             // of the bounding box, mesh units
  double mean_edge_;            // mesh units
  std::uint32_t selected_ = 0;  // the number of a curve, which may be gone
  bool preview_ = false;        // in a gesture that moves a point

  Requests requests_;
  editing::Defects defects_ = editing::Defects::kRefuse;
  host::Results results_;
  std::vector<std::uint32_t> numbers_;  // of their curves
  double last_run_ms_ = 0;
  bool log_next_ = false;  // a result that is no step of a gesture
  QString edit_error_, work_error_, problem_;
  QStringList repair_told_;
  // Of the mesh; null until the thread has made it, or it is needed before.
  mutable std::shared_ptr<const editing::Sight> sight_;

  std::unique_ptr<CurveNodes> nodes_;  // null without a window
  DrawingLine line_;
  DrawnCurves drawn_;
  ResultLines lines_;
  Colours colours_;
  Inspection inspection_;
  std::vector<std::uint32_t> deleted_;  // numbers of the curves whose objects are gone
  std::vector<int> to_remove_;          // objects that go when the host is done
};

}  // namespace talweg::openflipper
