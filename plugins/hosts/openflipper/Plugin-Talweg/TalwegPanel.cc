#include "TalwegPanel.hh"

#include <QAction>
#include <QHBoxLayout>
#include <QMenu>
#include <algorithm>

#include "PanelParts.hh"

namespace talweg::openflipper {
namespace {

QLabel* wrapped(const QString& name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace

TalwegPanel::TalwegPanel(QWidget* parent) : QWidget(parent) {
  auto* all = tight(this);
  all->addWidget(make_head());
  all->addWidget(make_draw_group());
  curves_ = new CurvesBox(this);
  all->addWidget(curves_);
  all->addWidget(make_shape_group());
  all->addWidget(make_result_group());
  all->addWidget(make_foot());
  all->addStretch(1);
  show_state({});
}

QToolButton* TalwegPanel::button(const QString& name, Sign sign, const QString& text,
                                 const QString& tip, Signal signal) {
  QToolButton* made = make_button(this, name, sign, text, tip);
  if (signal != nullptr) connect(made, &QToolButton::clicked, this, signal);
  return made;
}

QWidget* TalwegPanel::make_head() {
  auto* head = new QWidget(this);
  mesh_ = new QLabel(head);
  mesh_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // long names are cut off
  problem_ = wrapped("talwegProblem", head);
  problem_->setStyleSheet("color: #b00000");
  repair_ = button("Repair", Sign::kTool, tr("Repair"),
                   tr("Draws on the mesh as if it was repaired; the mesh itself is unchanged."),
                   &TalwegPanel::repair);
  undo_ = button("Undo", Sign::kBack, tr("Undo"), {}, &TalwegPanel::undo);
  redo_ = button("Redo", Sign::kForward, tr("Redo"), {}, &TalwegPanel::redo);
  auto* all = tight(head);
  all->setContentsMargins(0, 0, 0, 0);
  auto* row = row_of({undo_, redo_});
  row->insertWidget(0, mesh_, 2);
  all->addLayout(row);
  all->addWidget(problem_);
  all->addWidget(repair_);
  return head;
}

QGroupBox* TalwegPanel::make_draw_group() {
  auto* group = new QGroupBox(tr("Draw"), this);
  draw_ = button("Draw", Sign::kPencil, tr("Draw"),
                 tr("Draw on the target mesh: click points or paint."), nullptr);
  draw_->setCheckable(true);
  connect(draw_, &QToolButton::clicked, this, &TalwegPanel::draw_toggled);
  finish_ = button("Finish", Sign::kTick, tr("Finish"), tr("Ends the curve, open (Enter)."),
                   &TalwegPanel::finish);
  close_ = button("Close", Sign::kLoop, tr("Close"),
                  tr("Closes the curve (click its first point)."), &TalwegPanel::close_curve);
  take_back_ =
      button("TakeBack", Sign::kBack, tr("Take back"),
             tr("Removes the last point of the curve (Backspace)."), &TalwegPanel::take_back);
  discard_ = button("Discard", Sign::kCross, tr("Discard"),
                    tr("Removes the curve that is being drawn (Esc)."), &TalwegPanel::discard);
  auto* all = tight(group);
  all->addLayout(row_of({draw_, finish_, close_}));
  all->addLayout(row_of({from_button(), take_back_, discard_}));
  return group;
}

QToolButton* TalwegPanel::from_button() {
  QToolButton* from =
      button("From", Sign::kFrom, tr("From"),
             tr("Curves from a selection, from face colours or from polylines."), nullptr);
  auto* menu = new QMenu(from);
  const auto add = [&](const QString& text, Signal signal) {
    connect(menu->addAction(text), &QAction::triggered, this, signal);
  };
  add(tr("Selected vertices or edges"), &TalwegPanel::from_selection);
  add(tr("Border of the selected faces"), &TalwegPanel::from_face_selection);
  add(tr("Borders between face colours"), &TalwegPanel::from_face_colours);
  add(tr("Target polylines"), &TalwegPanel::from_lines);
  from->setMenu(menu);
  from->setPopupMode(QToolButton::InstantPopup);
  return from;
}

QGroupBox* TalwegPanel::make_shape_group() {
  auto* group = new QGroupBox(tr("Shape"), this);
  auto* grid = new QGridLayout(group);
  grid->setContentsMargins(3, 2, 3, 3);
  grid->setVerticalSpacing(3);
  grid->setColumnStretch(1, 1);
  tau_ = new NumberRow({"talwegTau", tr("Tau"),
                        tr("0: straight lines; higher values keep closer to the drawing, and are "
                           "tighter between clicks."),
                        QString()},
                       16, false, grid, group);
  slack_ = new NumberRow({"talwegSlack", tr("Slack"),
                          tr("How exact the drawing is, in mesh units. Unticked: the width of the "
                             "hand's tremor."),
                          tr("units")},
                         1, true, grid, group);
  bound_ =
      new NumberRow({"talwegBound", tr("Within"),
                     tr("The smoothest curve that stays within this distance of the drawing, "
                        "in mesh units; chooses tau and slack. Unticked: the present distance."),
                     tr("units")},
                    1, true, grid, group);
  make_taking(grid, group);
  make_ridges(grid, group);
  connect_number(tau_, "Tau");
  connect_number(slack_, "Slack");
  connect_number(bound_, "Largest deviation");
  connect(tau_, &NumberRow::changed, this, [this](bool, double v) { emit tau_changed(v); });
  connect(slack_, &NumberRow::changed, this, &TalwegPanel::slack_changed);
  connect(bound_, &NumberRow::changed, this, &TalwegPanel::max_deviation_changed);
  return group;
}

/// Rows for the interpretation of the drawing as clicks or strokes.
void TalwegPanel::make_taking(QGridLayout* grid, QWidget* group) {
  clicks_ = new NumberRow({"talwegClicks", tr("One click"),
                           tr("Successive clicks within this distance are merged, in mesh units. "
                              "Unticked: an edge of the mesh."),
                           tr("units")},
                          1, true, grid, group);
  ends_ = choice(tr("Ends"), grid, group);
  ends_->setObjectName("talwegEnds");
  ends_->addItems(
      {tr("Returning strokes are loops"), tr("All curves are loops"), tr("Open curves stay open")});
  ends_->setToolTip(tr("The treatment of the ends of curves that are not closed."));
  connect_number(clicks_, "Click distance");
  connect(clicks_, &NumberRow::changed, this, &TalwegPanel::click_distance_changed);
  connect(ends_, QOverload<int>::of(&QComboBox::activated), this, &TalwegPanel::ends_changed);
}

/// Rows for the strength and the kind of the ridges that attract the drawing.
void TalwegPanel::make_ridges(QGridLayout* grid, QWidget* group) {
  ridges_ = new NumberRow({"talwegRidges", tr("Ridges"),
                           tr("How strongly ridges and valleys beside the drawing attract it: 0 "
                              "not at all, 0.3 sharp edges only, 1 weak ones, too."),
                           QString(), 1},
                          1, false, grid, group);
  ridge_kind_ = choice(tr("Snap to"), grid, group);
  ridge_kind_->setObjectName("talwegRidgeKind");
  ridge_kind_->addItems({tr("Ridges and valleys"), tr("Ridges, which stand out"), tr("Valleys")});
  ridge_kind_->setToolTip(tr("The kind of ridges that attract the drawing."));
  connect_number(ridges_, "Snap to ridges");
  connect(ridges_, &NumberRow::changed, this, [this](bool, double v) { emit ridges_changed(v); });
  connect(ridge_kind_, QOverload<int>::of(&QComboBox::activated), this,
          &TalwegPanel::ridge_kind_changed);
}

/// A box with choices, in a row of its own.
QComboBox* TalwegPanel::choice(const QString& label, QGridLayout* grid, QWidget* group) {
  auto* box = new QComboBox(group);
  box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  const int row = grid->rowCount();
  grid->addWidget(new QLabel(label, group), row, 0);
  grid->addWidget(box, row, 1, 1, 3);
  return box;
}

void TalwegPanel::connect_number(NumberRow* row, const QString& name) {
  connect(row, &NumberRow::begun, this, [this, name] { emit gesture_begun(name); });
  connect(row, &NumberRow::ended, this, &TalwegPanel::gesture_ended);
}

QGroupBox* TalwegPanel::make_result_group() {
  auto* group = new QGroupBox(tr("Result"), this);
  table_ = new ResultTable(group);
  summary_ = wrapped("talwegSummary", group);
  notes_ = wrapped("talwegNotes", group);
  look_ = new LookBox(group);
  cut_ = button("Cut", Sign::kScissors, tr("Cut"),
                tr("Makes the smoothed curves edges of the mesh, and selects them."),
                &TalwegPanel::cut);
  split_ = button("Split", Sign::kParts, tr("Split"),
                  tr("Makes a mesh of each part between the smoothed curves."), nullptr);
  lids_ = new QCheckBox(tr("with lids"), group);
  lids_->setObjectName("talwegLids");
  lids_->setToolTip(tr("Split closes the parts where they were cut."));
  connect(split_, &QToolButton::clicked, this, [this] { emit split(lids_->isChecked()); });
  inside_ = button("Inside", Sign::kInside, tr("Select inside"),
                   tr("Cuts, and selects the faces inside the closed curves: the smaller side."),
                   &TalwegPanel::select_inside);
  write_result_ = button("WriteResult", Sign::kWrite, tr("Write result"),
                         tr("Writes the smoothed curves: .json, .vtp, .vtk, .obj, .ply, .mrk.json"),
                         &TalwegPanel::write_result);
  offset_ = new OffsetRow(group);
  connect(offset_, &OffsetRow::offset, this, &TalwegPanel::offset);
  auto* all = tight(group);
  all->addWidget(table_);
  all->addLayout(row_of({summary_, write_result_}));
  all->addWidget(notes_);
  all->addWidget(look_);
  all->addLayout(row_of({cut_, split_, lids_, inside_}));
  all->addWidget(offset_);
  return group;
}

QWidget* TalwegPanel::make_foot() {
  auto* foot = new QWidget(this);
  progress_ = new QProgressBar(foot);
  cancel_ = button("Cancel", Sign::kCross, tr("Cancel"), tr("Stops the computation."),
                   &TalwegPanel::cancel);
  cancel_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  hint_ = wrapped("talwegHint", foot);
  auto* row = new QHBoxLayout;
  row->addWidget(progress_, 1);
  row->addWidget(cancel_);
  auto* all = tight(foot);
  all->setContentsMargins(0, 0, 0, 0);
  all->addLayout(row);
  all->addWidget(hint_);
  show_progress(false, {}, 0);
  return foot;
}

void TalwegPanel::show_state(const PanelState& state) {
  mesh_->setText(state.mesh.isEmpty() ? tr("No drawing yet.") : state.mesh);
  mesh_->setToolTip(mesh_->text());
  draw_->setChecked(state.drawing_mode);
  for (QToolButton* while_drawing : {finish_, close_, take_back_, discard_}) {
    while_drawing->setEnabled(state.unfinished);
  }
  const bool rests = !state.unfinished;
  curves_->show_state(state.curves);
  for (QToolButton* of_results : {write_result_, cut_, split_, inside_}) {
    of_results->setEnabled(rests && !state.rows.empty());
  }
  lids_->setEnabled(split_->isEnabled());
  offset_->show_state(rests && !state.rows.empty(), state.mean_edge);
  undo_->setEnabled(state.can_undo);
  redo_->setEnabled(state.can_redo);
  undo_->setToolTip(tr("Takes the last edit back (Ctrl+Z): %1").arg(state.undo_name));
  redo_->setToolTip(tr("Repeats the edit that was taken back (Ctrl+Y): %1").arg(state.redo_name));
  show_settings(state);
  show_problem(state);
  show_result(state);
  hint_->setText(state.hint);
}

void TalwegPanel::show_settings(const PanelState& state) {
  const double most = state.scale / 4;
  tau_->show_value(state.settings.tau, 0);
  slack_->show_value(state.settings.slack, state.slack_used >= 0 ? state.slack_used : most / 9,
                     most);
  bound_->show_value(state.settings.max_deviation,
                     state.deviation_now > 0 ? state.deviation_now : most / 9, most);
  clicks_->show_value(state.settings.click_distance, state.mean_edge,
                      std::max(most, 2 * state.mean_edge));
  ends_->setCurrentIndex(static_cast<int>(state.settings.ends));
  ridges_->show_value(state.settings.ridges, 0);
  ridge_kind_->setCurrentIndex(static_cast<int>(state.settings.ridge_kind));
  ridge_kind_->setEnabled(state.settings.ridges > 0);
  const QString no_stroke =
      state.all_clicked
          ? tr("The curve is free between clicked points; this value is for painted strokes.")
          : QString();
  slack_->show_use(no_stroke);
  bound_->show_use(no_stroke);
  tau_->show_use(state.settings.max_deviation && !state.all_clicked ? tr("\"Within\" chooses it.")
                                                                    : QString());
}

void TalwegPanel::show_problem(const PanelState& state) {
  problem_->setVisible(!state.problem.isEmpty());
  repair_->setVisible(!state.repair_told.isEmpty());
  problem_->setText(state.repair_told.isEmpty()
                        ? state.problem
                        : tr("%1\nA repair for drawing would do this: %2")
                              .arg(state.problem, state.repair_told.join(' ')));
}

void TalwegPanel::show_result(const PanelState& state) {
  table_->show_rows(state.rows);
  summary_->setText(state.summary);
  summary_->setToolTip(state.summary_tip);
  notes_->setText(state.notes.join('\n'));
  notes_->setVisible(!state.notes.isEmpty());
  look_->show_state(state.look);
}

void TalwegPanel::show_progress(bool busy, const QString& stage, int percent) {
  progress_->setVisible(busy);
  cancel_->setVisible(busy);
  progress_->setFormat(stage + " %p%");
  progress_->setValue(percent);
}

}  // namespace talweg::openflipper
