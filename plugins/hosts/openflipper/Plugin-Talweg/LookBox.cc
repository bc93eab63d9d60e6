#include "LookBox.hh"

#include <QGridLayout>

#include "PanelParts.hh"

namespace talweg::openflipper {
namespace {

QComboBox* choice(QWidget* parent, const QString& name, const QStringList& texts) {
  auto* made = new QComboBox(parent);
  made->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // two boxes share the width
  made->setObjectName(name);
  made->addItems(texts);
  return made;
}

QLabel* text(QWidget* parent, const QString& name) {
  auto* made = new QLabel(parent);
  made->setObjectName(name);
  made->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  return made;
}

}  // namespace

LookBox::LookBox(QWidget* parent) : QWidget(parent) {
  colours_ = choice(this, "talwegColours",
                    {tr("No colours"), tr("Deviation"), tr("Distance"), tr("Potential")});
  colours_->setToolTip(
      tr("Deviation from the drawing along the curves; distance to the drawing or "
         "potential on the mesh."));
  legend_ = new Legend(this);
  points_ = new QCheckBox(tr("Points"), this);
  points_->setObjectName("talwegPoints");
  points_->setToolTip(tr("Hidden points cannot be moved; curves show as before."));
  comb_ = new QCheckBox(tr("Comb"), this);
  comb_->setObjectName("talwegComb");
  comb_->setToolTip(tr("Teeth across the curves; longer teeth mean larger curvature."));
  comb_text_ = text(this, "talwegCombText");
  marks_ = choice(this, "talwegMark",
                  {tr("Mark nothing"), tr("Largest deviation"), tr("Largest curvature")});
  marks_->setToolTip(tr("Marks the place of the largest value, and turns the view to it."));
  mark_text_ = text(this, "talwegMarkText");
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(3);
  grid->addLayout(row_of({colours_, marks_}), 0, 0, 1, 3);
  grid->addWidget(mark_text_, 1, 0, 1, 3);
  grid->addWidget(legend_, 2, 0, 1, 3);
  grid->addWidget(points_, 3, 0);
  grid->addWidget(comb_, 3, 1);
  grid->addWidget(comb_text_, 3, 2);
  grid->setColumnStretch(2, 1);
  connect(points_, &QCheckBox::clicked, this, &LookBox::points);
  connect(colours_, QOverload<int>::of(&QComboBox::activated), this, &LookBox::colour_by);
  connect(comb_, &QCheckBox::clicked, this, &LookBox::comb);
  connect(marks_, QOverload<int>::of(&QComboBox::activated), this, &LookBox::mark);
}

void LookBox::show_state(const LookState& state) {
  colours_->setCurrentIndex(state.coloured_by);
  legend_->show_scale(state.most, state.unit);
  points_->setChecked(state.points);
  comb_->setChecked(state.comb);
  comb_text_->setText(state.comb_text);
  marks_->setCurrentIndex(state.mark);
  mark_text_->setVisible(!state.mark_text.isEmpty());
  mark_text_->setText(state.mark_text);
  mark_text_->setToolTip(state.mark_text);
}

}  // namespace talweg::openflipper
