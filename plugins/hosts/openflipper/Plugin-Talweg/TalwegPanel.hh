// The panel is the toolbox: buttons, sliders, report. It knows the drawing only through its signals
// and show().
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QStringList>
#include <QWidget>

#include "talweg/editing/drawing.hpp"

namespace talweg::openflipper {

/// A number with four significant digits, and no exponent.
class SignificantBox : public QDoubleSpinBox {
 public:
  explicit SignificantBox(QWidget* parent);
  [[nodiscard]] QString textFromValue(double value) const override;
};

/// A number with a slider, a box and, where it may be absent, a tick.
class NumberRow : public QWidget {
  Q_OBJECT
 public:
  /// Slider positions are spaced by the square, so that small values have room.
  NumberRow(const QString& name, const QString& label, const QString& tip, double largest,
            bool optional, QWidget* parent);
  /// Without signals. `largest` > 0 sets the slider's range too.
  void show_value(std::optional<double> value, double largest = 0);
  /// Can be used unless there is a sentence on why not, which is then the tip.
  void show_use(const QString& why_not);
  [[nodiscard]] QSlider* slider() { return slider_; }

 signals:
  void begun();  ///< the slider is held
  void ended();  ///< and let go
  void changed(bool set, double value);

 private:
  void moved(int position);
  [[nodiscard]] double value_at(int position) const;
  [[nodiscard]] int position_of(double value) const;

  QCheckBox* tick_ = nullptr;
  QSlider* slider_;
  QDoubleSpinBox* box_;
  QString tip_;
  double largest_;
};

struct PanelState {
  QString mesh;  ///< empty: none
  editing::Settings settings;
  double scale = 1;  ///< of lengths: the largest that sliders offer, mesh units
  bool drawing_mode = false;
  bool unfinished = false;
  bool can_undo = false, can_redo = false;
  QString undo_name, redo_name;
  int curves = 0;
  bool all_clicked = false;
  int coloured_by = 0;
  QString report;
  QString hint;
  QString problem;          ///< why nothing can be drawn on the mesh; empty: nothing is wrong
  QStringList repair_told;  ///< what a repair would do; empty: there is none
};

class TalwegPanel : public QWidget {
  Q_OBJECT
 public:
  explicit TalwegPanel(QWidget* parent = nullptr);
  void show_state(const PanelState& state);
  void show_progress(bool busy, const QString& stage, int percent);

 signals:
  void draw_toggled(bool on);
  void finish();
  void close_curve();
  void take_back();
  void drop();
  void from_selection();
  void from_lines();
  void remove_last();
  void clear();
  void undo();
  void redo();
  void write_result();
  void write_drawing();
  void read_drawing();
  void cancel();
  void repair();
  void gesture_begun(const QString& name);
  void gesture_ended();
  void tau_changed(double tau);
  void slack_changed(bool set, double slack);
  void max_deviation_changed(bool set, double bound);
  void colour_by(int what);

 private:
  void show_problem(const PanelState& state);
  QPushButton* button(const QString& name, const QString& text, const QString& tip);

  QLabel *mesh_, *problem_, *hint_;
  QPushButton *draw_, *finish_, *close_, *take_back_, *drop_, *selection_, *lines_, *remove_,
      *clear_, *undo_, *redo_, *write_result_, *write_drawing_, *read_drawing_, *cancel_, *repair_;
  NumberRow *tau_, *slack_, *bound_;
  QComboBox* colours_;
  QPlainTextEdit* report_;
  QProgressBar* progress_;
};

}  // namespace talweg::openflipper
