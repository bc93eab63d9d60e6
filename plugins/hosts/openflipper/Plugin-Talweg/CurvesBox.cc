#include "CurvesBox.hh"

#include "PanelParts.hh"

namespace talweg::openflipper {

CurvesBox::CurvesBox(QWidget* parent) : QGroupBox(tr("Curves"), parent) {
  auto* read =
      make_button(this, "ReadDrawing", Sign::kRead, tr("Read"), tr("Adds the curves of a file."));
  write_ = make_button(this, "WriteDrawing", Sign::kWrite, tr("Write"),
                       tr("Writes the drawn points; .json keeps which were clicked and pinned."));
  table_ = new CurveTable(this);
  remove_ = make_button(this, "Remove", Sign::kCross, tr("Remove"),
                        tr("Removes the selected curve (Del)."));
  clear_ = make_button(this, "Clear", Sign::kBin, tr("Remove all"),
                       tr("Removes all curves of this mesh."));
  pin_ = make_button(this, "Pin", Sign::kPin, tr("Pin"),
                     tr("Pins or unpins all points of the selected curve."));
  closed_ = make_button(this, "Closed", Sign::kLoop, tr("Closed"),
                        tr("Closes the selected curve, or opens it."));
  go_on_ = make_button(this, "Continue", Sign::kPencil, tr("Go on"),
                       tr("Continues the selected curve at its end."));
  pin_->setCheckable(true);
  closed_->setCheckable(true);
  auto* numbers = new QGridLayout;
  make_numbers(numbers);
  auto* all = tight(this);
  all->addLayout(row_of({read, write_, clear_}));
  all->addWidget(table_);
  all->addLayout(row_of({remove_, pin_, closed_, go_on_}));
  all->addLayout(numbers);
  connect(read, &QToolButton::clicked, this, &CurvesBox::read);
  connect(write_, &QToolButton::clicked, this, &CurvesBox::write);
  connect(clear_, &QToolButton::clicked, this, &CurvesBox::clear);
  connect(remove_, &QToolButton::clicked, this, &CurvesBox::remove);
  connect(pin_, &QToolButton::clicked, this, &CurvesBox::pin);
  connect(closed_, &QToolButton::clicked, this, &CurvesBox::set_closed);
  connect(go_on_, &QToolButton::clicked, this, &CurvesBox::go_on);
  connect(table_, &CurveTable::selected, this, &CurvesBox::selected);
  connect(table_, &CurveTable::renamed, this, &CurvesBox::renamed);
  connect(table_, &CurveTable::remove, this, &CurvesBox::remove);
}

void CurvesBox::make_numbers(QGridLayout* grid) {
  grid->setVerticalSpacing(3);
  grid->setColumnStretch(1, 1);
  tau_ = new NumberRow(
      {"talwegOwnTau", tr("Own tau"),
       tr("Tau of the selected curve alone. Unticked: the tau of all curves."), QString()},
      16, true, grid, this);
  tolerance_ = new NumberRow({"talwegTolerance", tr("Tolerance"),
                              tr("How far the selected curve may pass from its clicked points, and "
                                 "how exact its strokes are. Unticked: clicked points are exact."),
                              tr("units")},
                             1, true, grid, this);
  connect(tau_, &NumberRow::begun, this, [this] { emit gesture_begun("Tau of curve"); });
  connect(tolerance_, &NumberRow::begun, this,
          [this] { emit gesture_begun("Tolerance of curve"); });
  connect(tau_, &NumberRow::ended, this, &CurvesBox::gesture_ended);
  connect(tolerance_, &NumberRow::ended, this, &CurvesBox::gesture_ended);
  connect(tau_, &NumberRow::changed, this, &CurvesBox::tau_changed);
  connect(tolerance_, &NumberRow::changed, this, &CurvesBox::tolerance_changed);
}

void CurvesBox::show_state(const CurvesState& state) {
  const bool one = state.selected != 0;
  table_->show_rows(state.rows, state.selected);
  write_->setEnabled(!state.rows.empty());
  clear_->setEnabled(!state.rows.empty());
  remove_->setEnabled(one);
  pin_->setEnabled(one);
  pin_->setChecked(one && state.pinned);
  closed_->setEnabled(one && !state.unfinished);
  closed_->setChecked(one && state.closed);
  go_on_->setEnabled(one && !state.unfinished && !state.closed);
  tau_->show_value(state.tau, state.general_tau);
  tolerance_->show_value(state.tolerance, state.general_tolerance, state.most);
  const QString none = one ? QString() : tr("Select a curve in the list or in the scene.");
  tau_->show_use(none);
  tolerance_->show_use(none);
}

}  // namespace talweg::openflipper
