// A session is the drawing on one mesh of the host: its editor, its thread, and the objects that
// show it.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "CurveNodes.hh"
#include "CurveTickets.hh"
#include "HostMesh.hh"
#include "ResultTable.hh"
#include "talweg/editing/comb.hpp"
#include "talweg/editing/editor.hpp"
#include "talweg/editing/sight.hpp"
#include "talweg/editing/smoothing_thread.hpp"

namespace talweg {
struct AppliedPlan;
}

namespace talweg::openflipper {

/// What a session asks of the host; all of it on the GUI's thread.
class HostCalls {
 public:
  virtual ~HostCalls() = default;
  virtual int add_line(const QString& name) = 0;
  virtual void show_line(int id) = 0;     ///< its points have changed
  virtual void show_colours(int id) = 0;  ///< its colours have changed
  virtual void show_selection(int id) = 0;
  virtual void show_mesh(int id) = 0;  ///< all of it may have changed
  virtual int add_mesh(const QString& name, TriMesh&& mesh) = 0;
  virtual void remove_object(int id) = 0;
  virtual void push_backup(int id, const QString& name) = 0;
  virtual bool host_undo(int id) = 0;  ///< false where the host has nothing to undo
  virtual bool host_redo(int id) = 0;
  virtual void say(const QString& sentence) = 0;   ///< to the log
  virtual void warn(const QString& sentence) = 0;  ///< to the log and the status bar
  virtual void changed() = 0;                      ///< drawing, results or state: show them
  /// Turns the view to a place, as seen from outside along the normal there.
  virtual void look_at(const ACG::Vec3d& place, const ACG::Vec3d& normal) = 0;
  virtual void redraw() = 0;  ///< only the scene has changed
  virtual void wake() = 0;    ///< from any thread: look at the sessions soon
};

enum class ColourBy { kNothing, kDeviation, kDistance, kPotential };
/// What is marked where it is largest.
enum class Mark { kNothing, kDeviation, kCurvature };

class Session {
 public:
  /// Copies the mesh and begins to open it. Throws editing::Error.
  Session(HostCalls& host, const editing::Plugins& plugins, TriMeshObject& object,
          const editing::Settings& settings);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  [[nodiscard]] int mesh_id() const { return mesh_id_; }
  [[nodiscard]] const editing::Editor& editor() const { return editor_; }
  [[nodiscard]] const editing::MeshArrays& arrays() const { return *arrays_; }
  [[nodiscard]] TriMesh& mesh() const { return *object_.mesh(); }
  [[nodiscard]] const QString& name() const { return name_; }
  [[nodiscard]] double diagonal() const { return diagonal_; }
  [[nodiscard]] double mean_edge() const { return mean_edge_; }

  /// One edit; one that cannot be done is told, and false.
  bool edit(const std::function<void(editing::Editor&)>& change);
  /// Several edits as one step of undo; all of them or none.
  bool edit_together(const char* name, const std::function<void(editing::Editor&)>& change);
  /// A movement of the hand: one step of undo. `preview`: of a point, shown by previews.
  void begin_gesture(const char* name, bool preview = false);
  void end_gesture();
  [[nodiscard]] bool in_gesture() const { return editor_.history().in_gesture(); }
  bool undo();
  bool redo();

  void add_selection();
  void add_face_borders(bool of_selection);  ///< of the selected faces, or of face colours
  void add_line(const PolyLine& line);
  void add_curves(std::vector<host::Curve> curves);  ///< snapped where they are positions
  void colour_by(ColourBy by);
  [[nodiscard]] ColourBy coloured_by() const { return colour_by_; }
  struct Scale {
    double most = 0;  ///< what the last colour stands for; the first for 0
    QString unit;
  };
  [[nodiscard]] Scale scale() const;
  void show_comb(bool with);
  [[nodiscard]] bool with_comb() const { return with_comb_; }
  /// Of the tooth that is longest, 1 / mesh unit; 0: there is no comb.
  [[nodiscard]] double longest_tooth() const { return most_curved_.curvature; }
  /// Marks the place where that is largest, now and in results to come, and turns the view to it.
  void mark_largest(Mark mark);
  [[nodiscard]] Mark mark() const { return mark_; }
  struct Marked {
    std::optional<ACG::Vec3d> at;  ///< none: nothing is marked
    double value = 0;              ///< mesh units, or 1 / mesh unit
    std::uint32_t curve = 0;       ///< its number
  };
  [[nodiscard]] const Marked& marked() const { return marked_; }

  /// Makes the results edges of the mesh, and selects them and, if asked, the faces inside closed
  /// ones. The drawing goes with the mesh, also when the host takes the cut back.
  bool cut(bool select_inside);
  /// Makes a mesh of each part that the results leave.
  bool split(bool lids, std::vector<int>& parts);
  [[nodiscard]] bool can_undo() const { return editor_.history().can_undo() || born_of_cut_; }

  /// Takes in what the thread has done.
  void take();
  /// The same when all of it is done. For scripts.
  void wait();
  void cancel();
  /// A faulty plugin may not end a task that was cancelled: it is left to itself, and named.
  void leave_what_never_ends();
  /// Whether newer results than results() are on their way.
  [[nodiscard]] bool smooths() const { return done_ < ticket_; }
  /// Does what may fail with an exception, such as reading a file; a failure is told, and false.
  bool attempt(const std::function<void()>& work);
  [[nodiscard]] editing::Progress progress() const { return thread_->progress(); }

  [[nodiscard]] const host::Results& results() const { return results_; }
  [[nodiscard]] double last_run_ms() const { return last_run_ms_; }
  /// Why the last edit was refused or, where it was not, the last work in the thread failed.
  [[nodiscard]] const QString& last_error() const {
    return edit_error_.isEmpty() ? work_error_ : edit_error_;
  }
  [[nodiscard]] const QString& work_error() const { return work_error_; }
  /// Why nothing can be drawn on the mesh as it is; empty where it can.
  [[nodiscard]] const QString& problem() const { return problem_; }
  /// What repair() would do; empty where there is no problem, or no repair helps.
  [[nodiscard]] const QStringList& repair_told() const { return repair_told_; }
  /// Opens the mesh again, repaired. The host's mesh stays as it is, and results have its numbers.
  void repair();
  [[nodiscard]] std::vector<int> lines() const;
  /// Which of the results is of the curve with that number.
  [[nodiscard]] std::optional<std::size_t> result_of(std::uint32_t number) const;

  /// The curve that a person has chosen, or has drawn last. No part of the drawing.
  [[nodiscard]] std::optional<std::size_t> selected() const;
  void select(std::optional<std::size_t> curve);
  [[nodiscard]] int drawing_id() const { return drawing_id_; }
  [[nodiscard]] bool owns(int object_id) const;

  /// The host's mesh may have changed: opens it again if it has.
  void mesh_updated();
  /// An object of ours that a person has deleted: its curve goes, which is an edit, as soon as the
  /// host is done.
  void object_deleted(int object_id);
  /// The mesh or the drawing's line was hidden or shown: what was drawn goes with both.
  void visibility_changed() { show_nodes(); }

  void show_points(bool with);
  [[nodiscard]] bool shows_point(std::size_t curve, std::size_t point) const;
  /// Shows how the curve that is being drawn would go on to that point, or no more.
  void reach_for(const std::optional<editing::Point>& to);

  [[nodiscard]] std::vector<ACG::Vec3d> drawn_positions(std::size_t curve) const;
  /// Whether seen() and is_hidden() can tell already.
  [[nodiscard]] bool can_see() const { return sight_ != nullptr && object_.visible(); }
  /// What of the mesh lies first on the way from the eye.
  [[nodiscard]] std::optional<editing::Point> seen(const ACG::Vec3d& eye,
                                                   const ACG::Vec3d& way) const;
  /// Whether the mesh lies between that point and the eye.
  [[nodiscard]] bool is_hidden(const editing::Point& point, const ACG::Vec3d& eye) const;
  /// A curve as it is smoothed and as it was drawn, as far as that is known. Until the next edit or
  /// take().
  [[nodiscard]] std::vector<const host::Curve*> lines_of(std::size_t curve) const;

 private:
  void open();
  void select_after(std::size_t curves_before);
  void after_edit();
  void ask();
  void show_drawing();
  void fill_drawing_line();
  void show_nodes();
  [[nodiscard]] std::vector<PointLook> point_looks() const;
  [[nodiscard]] std::vector<LineLook> line_looks() const;
  void ask_for_lines();
  void take_drawn(editing::Outcome& outcome);
  void take_leg(const editing::Outcome& outcome);
  void ask_to_smooth();
  void show_results(host::Results results, std::vector<std::uint32_t> numbers, bool newest);
  void keep_lines(const std::vector<std::uint32_t>& numbers);
  [[nodiscard]] QString name_of_line(std::uint32_t number) const;
  int add_result_line(const QString& name, std::uint32_t number);
  void show_widths() const;
  void show_mesh_colours(const host::Results& results);
  void ask_again();
  [[nodiscard]] bool wants_fields() const;
  void measure_combs();
  void show_combs();
  [[nodiscard]] std::optional<ACG::Vec3d> place_of_largest() const;
  void find_mark();
  [[nodiscard]] ACG::Vec3d normal_at(std::uint32_t face) const;
  void keep_backup();
  void go_to(std::uint64_t number);
  void take(editing::Outcome outcome);
  void take_opened(const editing::Outcome& outcome);
  void remove_deleted();
  void require_results() const;
  void go_over(const AppliedPlan& plan);
  bool go_back_to(const std::shared_ptr<const editing::MeshArrays>& now);
  void history_begins_with(editing::Editor editor,
                           std::shared_ptr<const editing::MeshArrays> arrays);
  void fail(QString& error, const QString& sentence);

  // What the host's list of undo knows us by: the line with that list may outlive this object.
  std::shared_ptr<Session*> self_ = std::make_shared<Session*>(this);
  HostCalls& host_;
  const editing::Plugins& plugins_;
  TriMeshObject& object_;
  int mesh_id_;
  QString name_;
  std::shared_ptr<const editing::MeshArrays> arrays_;
  double diagonal_;   // of the bounding box, mesh units
  double mean_edge_;  // mesh units
  editing::Editor editor_;
  std::unique_ptr<editing::SmoothingThread> thread_;
  // Of arrays_; null until the thread has made it, or it is needed before.
  mutable std::shared_ptr<const editing::Sight> sight_;

  editing::Drawing asked_;          // what was asked to be smoothed last
  std::uint64_t ticket_ = 0;        // of that
  std::uint64_t done_ = 0;          // the last one that was smoothed, or is not any more
  std::uint64_t stale_ = 0;         // results up to this ticket come too late
  std::uint64_t first_number_ = 0;  // the state with which the host's list begins
  std::uint64_t kept_number_ = 0;   // the state that the host's list has last
  struct ResultLine {
    int id;                // of the host's object
    std::uint32_t number;  // of the curve that it shows
    QString name;          // as it was given
  };
  std::vector<ResultLine> lines_;  // one for each smoothed curve
  std::uint32_t selected_ = 0;     // the number of a curve, which may be gone
  int drawing_id_ = -1;            // the line with the points of the curve edited last
  host::Results results_;
  double last_run_ms_ = 0;
  QString edit_error_, work_error_, problem_;
  QStringList repair_told_;
  editing::Defects defects_ = editing::Defects::kRefuse;
  std::vector<std::uint32_t> deleted_;  // numbers of the curves whose objects are gone
  std::vector<int> to_remove_;          // objects that go when the host is done
  struct OtherMesh {                    // what the mesh was before a cut, or after one
    std::shared_ptr<const editing::MeshArrays> arrays;
    editing::Editor editor;
    bool born_of_cut;
  };
  std::vector<OtherMesh> others_;
  bool born_of_cut_ = false;  // the mesh is as a cut of ours has left it
  bool preview_ = false;      // in a gesture that moves a point
  bool log_next_ = false;     // a result that is no step of a gesture
  ColourBy colour_by_ = ColourBy::kNothing;
  std::unique_ptr<CurveNodes> nodes_;  // null without a window
  CurveTickets tickets_;
  std::map<std::uint32_t, host::Curve> drawn_;  // curves as they lie on the mesh, by number
  std::vector<std::shared_ptr<const editing::Curve>> lines_asked_;  // those that were asked last
  std::uint64_t leg_ticket_ = 0;                                    // 0: no leg is wanted
  bool with_points_ = true;
  double line_largest_ = 0, mesh_largest_ = 0;  // what the last colour stands for
  bool with_comb_ = false;
  std::vector<std::vector<editing::Tooth>> combs_;  // of the results, where they are wanted
  editing::Tooth most_curved_ = {};                 // of those
  Mark mark_ = Mark::kNothing;
  Marked marked_;
  bool turn_to_mark_ = false;
};

/// As the panel writes it.
QString length_unit();
QString curvature_unit();
/// A line for the log.
QString short_report(const Session& session);
/// What the panel shows of the results: the numbers, a line, with which settings, and the warnings.
std::vector<ResultRow> result_rows(const Session& session);
QString result_summary(const Session& session);
QString result_settings(const Session& session);
QStringList result_notes(const Session& session);
/// Everything that was measured, "key = value" or "curve.key = value", one a line.
QString whole_report(const Session& session);

}  // namespace talweg::openflipper
