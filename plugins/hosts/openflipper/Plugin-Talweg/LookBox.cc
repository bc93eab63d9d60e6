#include "LookBox.hh"

#include <QGridLayout>

namespace talweg::openflipper {
namespace {

QComboBox* choice(QWidget* parent, const QString& name, const QStringList& texts) {
  auto* made = new QComboBox(parent);
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
                    {tr("No colours"), tr("Deviation on the curve"), tr("Distance on the mesh"),
                     tr("Potential on the mesh")});
  legend_ = new Legend(this);
  comb_ = new QCheckBox(tr("Comb"), this);
  comb_->setObjectName("talwegComb");
  comb_->setToolTip(tr("Teeth across the curves, as long as they are curved there."));
  comb_text_ = text(this, "talwegCombText");
  marks_ = choice(this, "talwegMark",
                  {tr("Mark nothing"), tr("Largest deviation"), tr("Largest curvature")});
  marks_->setToolTip(tr("Marks where it is largest, and turns the view to it."));
  mark_text_ = text(this, "talwegMarkText");
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(3);
  grid->addWidget(colours_, 0, 0, 1, 2);
  grid->addWidget(legend_, 1, 0, 1, 2);
  grid->addWidget(comb_, 2, 0);
  grid->addWidget(comb_text_, 2, 1);
  grid->addWidget(marks_, 3, 0);
  grid->addWidget(mark_text_, 3, 1);
  grid->setColumnStretch(1, 1);
  connect(colours_, QOverload<int>::of(&QComboBox::activated), this, &LookBox::colour_by);
  connect(comb_, &QCheckBox::clicked, this, &LookBox::comb);
  connect(marks_, QOverload<int>::of(&QComboBox::activated), this, &LookBox::mark);
}

void LookBox::show_state(const LookState& state) {
  colours_->setCurrentIndex(state.coloured_by);
  legend_->show_scale(state.most, state.unit);
  comb_->setChecked(state.comb);
  comb_text_->setText(state.comb_text);
  marks_->setCurrentIndex(state.mark);
  mark_text_->setText(state.mark_text);
  mark_text_->setToolTip(state.mark_text);
}

}  // namespace talweg::openflipper
