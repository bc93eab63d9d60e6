// The panel in the toolbox: buttons, sliders, results. Its signals and show() are its only link to
// the drawing.
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
  double scale = 1;           ///< largest length of the sliders, mesh units
  double slack_used = -1;     ///< slack of the shown result; negative: none
  double deviation_now = -1;  ///< deviation of the shown result; negative: none
  double mean_edge = 1;       ///< of the mesh
  bool drawing_mode = false;
  bool unfinished = false;
  bool can_undo = false, can_redo = false;
  QString undo_name, redo_name;
  CurvesState curves;
  bool all_clicked = false;
  LookState look;
  std::vector<ResultRow> rows;  ///< empty: no result
  QString summary;              ///< one line on the result
  QString summary_tip;          ///< settings of the result
  QStringList notes;            ///< warnings about the result
  QString hint;                 ///< the effect of a click
  QString problem;              ///< why curves cannot be drawn on the mesh; empty: they can
  QStringList repair_told;      ///< changes that a repair would make; empty: no repair helps
};

class TalwegPanel : public QWidget {
  Q_OBJECT
 public:
  explicit TalwegPanel(QWidget* parent = nullptr);
  void show_state(const PanelState& state);
  /// The box with the curves, and its signals.
  [[nodiscard]] const CurvesBox* curves() const { return curves_; }
  /// The box for the looks of curves, and its signals.
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
