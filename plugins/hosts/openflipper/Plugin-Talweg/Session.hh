// The drawing on one mesh of the host: its editor, the requests to its thread, and its display.
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
  /// Copies the mesh and requests its opening. Throws editing::Error.
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

  /// Makes one edit. Reports an edit that is refused, and returns false.
  bool edit(const std::function<void(editing::Editor&)>& change);
  /// Several edits as one step of undo; all of them or none.
  bool edit_together(const char* name, const std::function<void(editing::Editor&)>& change);
  /// Begins a movement of the mouse, one step of undo. `preview`: of a point, with previews of the
  /// result.
  void begin_gesture(const char* name, bool preview = false);
  void end_gesture();
  [[nodiscard]] bool in_gesture() const { return editor().history().in_gesture(); }
  bool undo();
  bool redo();
  [[nodiscard]] bool can_undo() const { return editor().history().can_undo() || now_.born_of_cut; }

  void add_selection();
  void add_face_borders(bool of_selection);  ///< from the selected faces, or from face colours
  void add_line(const PolyLine& line);

  /// The curve that the user has selected or drawn last. The selection is not a part of the
  /// drawing.
  [[nodiscard]] std::optional<std::size_t> selected() const;
  void select(std::optional<std::size_t> curve);

  // ---- Files in the library's formats. A failure is reported, and returns false.

  bool write_result(const QString& path);
  bool write_drawing(const QString& path);
  /// Adds the curves of the file; positions are moved onto the mesh.
  bool read_drawing(const QString& path);

  // ---- The host's mesh.

  /// Makes the results edges of the mesh and selects these edges and, on request, the faces inside
  /// closed curves. The drawing moves to the cut mesh, and back if the host undoes the cut.
  bool cut(bool select_inside);
  /// Makes a mesh of each part between the results.
  bool split(bool lids, std::vector<int>& parts);
  /// Adds lines at a distance from the selected result, or from all results; the drawing stays.
  bool offset(const Offset& how, std::vector<int>& lines);
  /// Opens the mesh again, repaired. The host's mesh is unchanged, and results have its indices.
  void repair();
  /// Why curves cannot be drawn on the mesh; empty if they can.
  [[nodiscard]] const QString& problem() const { return problem_; }
  /// The changes that repair() would make; empty if there is no problem, or if no repair helps.
  [[nodiscard]] const QStringList& repair_told() const { return repair_told_; }

  // ---- Results.

  /// Takes the thread's answers.
  void take();
  /// Waits for the thread, and takes all its answers. For scripts.
  void wait();
  void cancel() { requests_.cancel(); }
  /// Abandons, with a message, a faulty plugin that does not end a cancelled task.
  void abandon_endless_work();
  [[nodiscard]] editing::Progress progress() const { return requests_.progress(); }

  [[nodiscard]] const host::Results& results() const { return results_; }
  /// The index of the result of the curve with this number.
  [[nodiscard]] std::optional<std::size_t> result_of(std::uint32_t number) const;
  [[nodiscard]] double last_run_ms() const { return last_run_ms_; }
  /// Why the last edit was refused; if it was not, why the last work of the thread failed.
  [[nodiscard]] const QString& last_error() const {
    return edit_error_.isEmpty() ? work_error_ : edit_error_;
  }
  [[nodiscard]] const QString& work_error() const { return work_error_; }

  // ---- Looks.

  void colour_by(ColourBy by);
  [[nodiscard]] const Colours& colours() const { return colours_; }
  void show_comb(bool with);
  /// Marks the largest value of a quantity, in present and later results, and turns the view to it.
  void mark_largest(Mark mark);
  [[nodiscard]] const Inspection& inspection() const { return inspection_; }
  void show_points(bool with);
  [[nodiscard]] bool shows_point(std::size_t curve, std::size_t point) const {
    return drawn_.shows_point(drawing(), curve, point);
  }
  /// Shows the leg of the unfinished curve to this point; no point removes the leg.
  void reach_for(const std::optional<editing::Point>& to);
  /// The lines of a curve, smoothed and as drawn, if known. Valid until the next edit or take().
  [[nodiscard]] std::vector<const host::Curve*> lines_of(std::size_t curve) const;

  // ---- Visibility.

  /// Whether seen() can answer.
  [[nodiscard]] bool can_see() const { return sight_ != nullptr && object_.visible(); }
  /// The first point of the mesh on the ray from the eye in the direction `way`.
  [[nodiscard]] std::optional<editing::Point> seen(const ACG::Vec3d& eye,
                                                   const ACG::Vec3d& way) const;
  /// Whether the mesh lies between the point and the eye.
  [[nodiscard]] bool is_hidden(const editing::Point& point, const ACG::Vec3d& eye) const;

  // ---- Notes from the host.

  /// The mesh may have changed; if so, opens it again.
  void mesh_updated();
  /// Ids of the smoothed curves' objects.
  [[nodiscard]] std::vector<int> lines() const { return lines_.ids(); }
  [[nodiscard]] bool owns(int object_id) const {
    return object_id == line_.id() || lines_.has(object_id);
  }
  /// The user has deleted an object of this session: its curve is removed, as an edit, after the
  /// host's deletion has ended.
  void object_deleted(int object_id);
  /// The object was hidden or shown. The display of the drawing is visible with the mesh and the
  /// drawing's line.
  void visibility_changed(int object_id);

 private:
  void open();
  void select_after(std::size_t curves_before);
  void after_edit();
  void add_curves(std::vector<host::Curve> curves);
  /// Runs work; reports its exception, and returns false.
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
  void move_drawing_to_cut_mesh(const AppliedPlan& plan);
  bool go_back_to(const editing::MeshArrays& mesh);
  void begin_on_other_mesh();
  void remove_deleted();

  /// A drawing with its mesh.
  struct OnMesh {
    std::shared_ptr<const editing::MeshArrays> arrays;
    editing::Editor editor;
    bool born_of_cut = false;  // whether the mesh is the result of a cut by this session
  };

  HostCalls& host_;
  const editing::Plugins& plugins_;
  TriMeshObject& object_;
  QString name_;
  OnMesh now_;
  std::vector<OnMesh> others_;  // the drawings before and after cuts
  double diagonal_;             // of the bounding box, mesh units
  double mean_edge_;            // mesh units
  std::uint32_t selected_ = 0;  // number of a curve, which may no longer exist
  bool preview_ = false;        // whether a gesture moves a point

  Requests requests_;
  editing::Defects defects_ = editing::Defects::kRefuse;
  host::Results results_;
  std::vector<std::uint32_t> numbers_;  // numbers of the results' curves
  double last_run_ms_ = 0;
  bool log_next_ = false;  // whether the next result is logged: it is not a step of a gesture
  QString edit_error_, work_error_, problem_;
  QStringList repair_told_;
  // The search tree of the mesh; null until the thread has made it, or a query needs it.
  mutable std::shared_ptr<const editing::Sight> sight_;

  std::unique_ptr<CurveNodes> nodes_;  // null without a window
  DrawingLine line_;
  DrawnCurves drawn_;
  ResultLines lines_;
  Colours colours_;
  Inspection inspection_;
  std::vector<std::uint32_t> deleted_;  // numbers of curves whose objects were deleted
  std::vector<int> to_remove_;          // objects to be removed after the host's deletion
};

}  // namespace talweg::openflipper
