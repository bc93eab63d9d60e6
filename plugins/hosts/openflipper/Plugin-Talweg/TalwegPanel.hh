// The panel is the toolbox: buttons, sliders, results. It knows the drawing only through its
// signals and show().
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QProgressBar>
#include <QStringList>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "CurvesBox.hh"
#include "LookBox.hh"
#include "NumberRow.hh"
#include "OffsetRow.hh"
#include "PanelIcons.hh"
#include "ResultTable.hh"
#include "talweg/editing/drawing.hpp"

namespace talweg::openflipper {

struct PanelState {
  QString mesh;  ///< empty: none
  editing::Settings settings;
  double scale = 1;           ///< of lengths: the largest that sliders offer, mesh units
  double slack_used = -1;     ///< in the result that is shown; negative: none
  double deviation_now = -1;  ///< likewise
  double mean_edge = 1;       ///< of the mesh
  bool drawing_mode = false;
  bool unfinished = false;
  bool can_undo = false, can_redo = false;
  QString undo_name, redo_name;
  CurvesState curves;
  bool all_clicked = false;
  LookState look;
  std::vector<ResultRow> rows;  ///< none: nothing is smoothed
  QString summary;              ///< one line on the result
  QString summary_tip;          ///< with which settings
  QStringList notes;            ///< what is to be known of it
  QString hint;                 ///< what a click would do
  QString problem;              ///< why nothing can be drawn on the mesh; empty: nothing is wrong
  QStringList repair_told;      ///< what a repair would do; empty: there is none
};

class TalwegPanel : public QWidget {
  Q_OBJECT
 public:
  explicit TalwegPanel(QWidget* parent = nullptr);
  void show_state(const PanelState& state);
  /// The part with the curves, and its signals.
  [[nodiscard]] const CurvesBox* curves() const { return curves_; }
  /// The part that says how curves look, and its signals.
  [[nodiscard]] const LookBox* look() const { return look_; }
  void show_progress(bool busy, const QString& stage, int percent);

 signals:
  void draw_toggled(bool on);
  void finish();
  void close_curve();
  void take_back();
  void discard();
  void from_selection();
  void from_face_selection();
  void from_face_colours();
  void from_lines();
  void undo();
  void redo();
  void write_result();
  void cut();
  void split(bool lids);
  void offset(double distance, const QString& side);
  void select_inside();
  void cancel();
  void repair();
  void gesture_begun(const QString& name);
  void gesture_ended();
  void tau_changed(double tau);
  void slack_changed(bool set, double slack);
  void max_deviation_changed(bool set, double bound);
  void ends_changed(int ends);
  void click_distance_changed(bool set, double distance);
  void ridges_changed(double strength);
  void ridge_kind_changed(int kind);

 private:
  using Signal = void (TalwegPanel::*)();

  QWidget* make_head();
  QGroupBox* make_draw_group();
  QGroupBox* make_shape_group();
  QGroupBox* make_result_group();
  QWidget* make_foot();
  QToolButton* button(const QString& name, Sign sign, const QString& text, const QString& tip,
                      Signal signal);
  QToolButton* from_button();
  void make_taking(QGridLayout* grid, QWidget* group);
  void make_ridges(QGridLayout* grid, QWidget* group);
  static QComboBox* choice(const QString& label, QGridLayout* grid, QWidget* group);
  void connect_number(NumberRow* row, const QString& name);
  void show_settings(const PanelState& state);
  void show_problem(const PanelState& state);
  void show_result(const PanelState& state);

  QLabel *mesh_, *problem_, *summary_, *notes_, *hint_;
  QToolButton *draw_, *finish_, *close_, *take_back_, *discard_, *undo_, *redo_, *write_result_,
      *cut_, *split_, *inside_, *cancel_, *repair_;
  QCheckBox* lids_;
  OffsetRow* offset_;
  CurvesBox* curves_;
  NumberRow *tau_, *slack_, *bound_, *clicks_, *ridges_;
  QComboBox *ends_, *ridge_kind_;
  LookBox* look_;
  ResultTable* table_;
  QProgressBar* progress_;
};

}  // namespace talweg::openflipper
