#include "TalwegPanel.hh"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace talweg::openflipper {
namespace {

constexpr int kSteps = 1000;

}  // namespace

SignificantBox::SignificantBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setDecimals(12);
  setRange(0, 1e9);
  setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  setKeyboardTracking(false);
  setMaximumWidth(90);
}

QString SignificantBox::textFromValue(double value) const {
  if (!(value > 0)) return locale().toString(0);
  const int digits = 3 - static_cast<int>(std::floor(std::log10(value)));
  QLocale plain = locale();
  plain.setNumberOptions(QLocale::OmitGroupSeparator);
  QString text = plain.toString(value, 'f', std::clamp(digits, 0, decimals()));
  if (!text.contains(plain.decimalPoint())) return text;
  while (text.endsWith(plain.zeroDigit())) text.chop(1);
  if (text.endsWith(plain.decimalPoint())) text.chop(1);
  return text;
}

NumberRow::NumberRow(const QString& name, const QString& label, const QString& tip, double largest,
                     bool optional, QWidget* parent)
    : QWidget(parent),
      slider_(new QSlider(Qt::Horizontal, this)),
      box_(new SignificantBox(this)),
      tip_(tip),
      largest_(largest) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  if (optional) {
    tick_ = new QCheckBox(label, this);
    tick_->setObjectName(name + "Tick");
    row->addWidget(tick_);
  } else {
    row->addWidget(new QLabel(label, this));
  }
  slider_->setObjectName(name + "Slider");
  slider_->setRange(0, kSteps);
  slider_->setValue(optional ? kSteps / 3 : 0);
  box_->setObjectName(name + "Box");
  row->addWidget(slider_, 1);
  row->addWidget(box_);
  setToolTip(tip);
  connect(slider_, &QSlider::sliderPressed, this, &NumberRow::begun);
  connect(slider_, &QSlider::sliderReleased, this, &NumberRow::ended);
  connect(slider_, &QSlider::valueChanged, this, &NumberRow::moved);
  connect(box_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double value) { emit changed(true, value); });
  if (tick_ != nullptr) {
    connect(tick_, &QCheckBox::toggled, this,
            [this](bool on) { emit changed(on, value_at(slider_->value())); });
  }
}

double NumberRow::value_at(int position) const {
  const double t = static_cast<double>(position) / kSteps;
  return largest_ * t * t;
}

int NumberRow::position_of(double value) const {
  const double t = largest_ > 0 ? std::sqrt(std::max(value, 0.0) / largest_) : 0;
  return static_cast<int>(std::lround(std::min(t, 1.0) * kSteps));
}

void NumberRow::moved(int position) { emit changed(true, value_at(position)); }

void NumberRow::show_value(std::optional<double> value, double largest) {
  const QSignalBlocker no_slider(slider_), no_box(box_);
  if (largest > 0) largest_ = largest;
  if (tick_ != nullptr) {
    const QSignalBlocker no_tick(tick_);
    tick_->setChecked(value.has_value());
    slider_->setEnabled(value.has_value());
    box_->setEnabled(value.has_value());
  }
  if (!value) return;
  if (!slider_->isSliderDown()) slider_->setValue(position_of(*value));
  box_->setValue(*value);
}

void NumberRow::show_use(const QString& why_not) {
  setEnabled(why_not.isEmpty());
  setToolTip(why_not.isEmpty() ? tip_ : why_not);
}

QPushButton* TalwegPanel::button(const QString& name, const QString& text, const QString& tip) {
  auto* made = new QPushButton(text, this);
  made->setObjectName("talweg" + name);
  made->setToolTip(tip);
  return made;
}

TalwegPanel::TalwegPanel(QWidget* parent) : QWidget(parent) {
  mesh_ = new QLabel(this);
  problem_ = new QLabel(this);
  problem_->setObjectName("talwegProblem");
  problem_->setWordWrap(true);
  problem_->setStyleSheet("color: #b00000");
  repair_ = button("Repair", tr("Repair"),
                   tr("Draws on the mesh as if it was repaired; the mesh itself stays."));
  hint_ = new QLabel(this);
  hint_->setWordWrap(true);
  draw_ = button("Draw", tr("Draw"), tr("Draw on the target mesh: click points or paint."));
  draw_->setCheckable(true);
  finish_ = button("Finish", tr("Finish"), tr("Ends the curve, open (Enter)."));
  close_ = button("Close", tr("Close"), tr("Closes the curve (click its first point)."));
  take_back_ = button("TakeBack", tr("Back"), tr("Takes the last point back (Backspace)."));
  drop_ = button("Drop", tr("Drop"), tr("Drops the curve that is being drawn (Esc)."));
  selection_ = button("Selection", tr("From selection"),
                      tr("Curves through the selected vertices or edges, ordered along the mesh."));
  lines_ = button("Lines", tr("From lines"), tr("Curves from the target polylines, put onto it."));
  remove_ = button("Remove", tr("Remove last"), tr("Removes the last curve."));
  clear_ = button("Clear", tr("Remove all"), tr("Removes all curves of this mesh."));
  undo_ = button("Undo", tr("Undo"), tr("Takes the last edit back."));
  redo_ = button("Redo", tr("Redo"), tr("Does it again."));
  write_result_ =
      button("WriteResult", tr("Write result"),
             tr("Writes the smoothed curves: .json, .vtp, .vtk, .obj, .ply, .mrk.json"));
  write_drawing_ = button("WriteDrawing", tr("Write drawing"), tr("Writes the drawn points."));
  read_drawing_ = button("ReadDrawing", tr("Read"), tr("Reads curves from a file."));
  cancel_ = button("Cancel", tr("Cancel"), tr("Stops what is being computed."));
  tau_ = new NumberRow(
      "talwegTau", tr("Tau"),
      tr("0: straight lines; more keeps closer to the drawing, and is tighter between clicks."), 16,
      false, this);
  slack_ = new NumberRow(
      "talwegSlack", tr("Slack"),
      tr("How exact the drawing is, in mesh units; unticked: from its segments."), 1, true, this);
  bound_ = new NumberRow("talwegBound", tr("At most"),
                         tr("The smoothest curve that stays so near to the drawing, in mesh units; "
                            "chooses tau and slack."),
                         1, true, this);
  colours_ = new QComboBox(this);
  colours_->setObjectName("talwegColours");
  colours_->addItems({tr("No colours"), tr("Deviation on the curve"), tr("Distance on the mesh"),
                      tr("Potential on the mesh")});
  report_ = new QPlainTextEdit(this);
  report_->setObjectName("talwegReport");
  report_->setReadOnly(true);
  report_->setMinimumHeight(110);
  progress_ = new QProgressBar(this);
  progress_->setVisible(false);
  cancel_->setVisible(false);

  auto* grid = new QGridLayout;
  grid->addWidget(draw_, 0, 0);
  grid->addWidget(finish_, 0, 1);
  grid->addWidget(close_, 0, 2);
  grid->addWidget(take_back_, 1, 0);
  grid->addWidget(drop_, 1, 1);
  grid->addWidget(remove_, 1, 2);
  grid->addWidget(selection_, 2, 0);
  grid->addWidget(lines_, 2, 1);
  grid->addWidget(clear_, 2, 2);
  grid->addWidget(undo_, 3, 0);
  grid->addWidget(redo_, 3, 1);
  grid->addWidget(read_drawing_, 3, 2);
  grid->addWidget(write_result_, 4, 0);
  grid->addWidget(write_drawing_, 4, 1);
  grid->addWidget(cancel_, 4, 2);
  auto* all = new QVBoxLayout(this);
  all->addWidget(mesh_);
  all->addWidget(problem_);
  all->addWidget(repair_);
  all->addLayout(grid);
  all->addWidget(tau_);
  all->addWidget(slack_);
  all->addWidget(bound_);
  all->addWidget(colours_);
  all->addWidget(hint_);
  all->addWidget(progress_);
  all->addWidget(report_, 1);

  connect(draw_, &QPushButton::clicked, this, &TalwegPanel::draw_toggled);
  connect(finish_, &QPushButton::clicked, this, &TalwegPanel::finish);
  connect(close_, &QPushButton::clicked, this, &TalwegPanel::close_curve);
  connect(take_back_, &QPushButton::clicked, this, &TalwegPanel::take_back);
  connect(drop_, &QPushButton::clicked, this, &TalwegPanel::drop);
  connect(selection_, &QPushButton::clicked, this, &TalwegPanel::from_selection);
  connect(lines_, &QPushButton::clicked, this, &TalwegPanel::from_lines);
  connect(remove_, &QPushButton::clicked, this, &TalwegPanel::remove_last);
  connect(clear_, &QPushButton::clicked, this, &TalwegPanel::clear);
  connect(undo_, &QPushButton::clicked, this, &TalwegPanel::undo);
  connect(redo_, &QPushButton::clicked, this, &TalwegPanel::redo);
  connect(write_result_, &QPushButton::clicked, this, &TalwegPanel::write_result);
  connect(write_drawing_, &QPushButton::clicked, this, &TalwegPanel::write_drawing);
  connect(read_drawing_, &QPushButton::clicked, this, &TalwegPanel::read_drawing);
  connect(cancel_, &QPushButton::clicked, this, &TalwegPanel::cancel);
  connect(repair_, &QPushButton::clicked, this, &TalwegPanel::repair);
  connect(colours_, QOverload<int>::of(&QComboBox::activated), this, &TalwegPanel::colour_by);
  const auto held = [this](NumberRow* row, const QString& name) {
    connect(row, &NumberRow::begun, this, [this, name] { emit gesture_begun(name); });
    connect(row, &NumberRow::ended, this, &TalwegPanel::gesture_ended);
  };
  held(tau_, "Tau");
  held(slack_, "Slack");
  held(bound_, "Largest deviation");
  connect(tau_, &NumberRow::changed, this, [this](bool, double v) { emit tau_changed(v); });
  connect(slack_, &NumberRow::changed, this, &TalwegPanel::slack_changed);
  connect(bound_, &NumberRow::changed, this, &TalwegPanel::max_deviation_changed);
  show_state({});
}

void TalwegPanel::show_state(const PanelState& state) {
  mesh_->setText(state.mesh.isEmpty() ? tr("No drawing yet.")
                                      : tr("On %1, %2 curve(s)").arg(state.mesh).arg(state.curves));
  draw_->setChecked(state.drawing_mode);
  for (QPushButton* while_drawing : {finish_, close_, take_back_, drop_}) {
    while_drawing->setEnabled(state.unfinished);
  }
  remove_->setEnabled(state.curves > 0 && !state.unfinished);
  clear_->setEnabled(state.curves > 0);
  write_result_->setEnabled(state.curves > 0);
  write_drawing_->setEnabled(state.curves > 0);
  undo_->setEnabled(state.can_undo);
  redo_->setEnabled(state.can_redo);
  undo_->setToolTip(tr("Takes the last edit back: %1").arg(state.undo_name));
  redo_->setToolTip(tr("Does it again: %1").arg(state.redo_name));
  tau_->show_value(state.settings.tau);
  slack_->show_value(state.settings.slack, state.scale / 4);
  bound_->show_value(state.settings.max_deviation, state.scale / 4);
  const QString no_stroke =
      state.all_clicked ? tr("Between clicked points the curve is free; this is for painted ones.")
                        : QString();
  slack_->show_use(no_stroke);
  bound_->show_use(no_stroke);
  tau_->show_use(state.settings.max_deviation && !state.all_clicked ? tr("\"At most\" chooses it.")
                                                                    : QString());
  show_problem(state);
  colours_->setCurrentIndex(state.coloured_by);
  if (report_->toPlainText() != state.report) report_->setPlainText(state.report);
  hint_->setText(state.hint);
}

void TalwegPanel::show_problem(const PanelState& state) {
  problem_->setVisible(!state.problem.isEmpty());
  repair_->setVisible(!state.repair_told.isEmpty());
  problem_->setText(state.repair_told.isEmpty()
                        ? state.problem
                        : tr("%1\nA repair for drawing would do this: %2")
                              .arg(state.problem, state.repair_told.join(' ')));
}

void TalwegPanel::show_progress(bool busy, const QString& stage, int percent) {
  progress_->setVisible(busy);
  cancel_->setVisible(busy);
  progress_->setFormat(stage + " %p%");
  progress_->setValue(percent);
}

}  // namespace talweg::openflipper
