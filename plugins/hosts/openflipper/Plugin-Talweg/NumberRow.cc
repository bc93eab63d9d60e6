#include "NumberRow.hh"

#include <QLocale>
#include <QSignalBlocker>
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
  setMaximumWidth(78);
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

NumberRow::NumberRow(const Texts& texts, double largest, bool optional, QGridLayout* grid,
                     QWidget* parent)
    : QObject(parent),
      slider_(new QSlider(Qt::Horizontal, parent)),
      box_(new SignificantBox(parent)),
      unit_(new QLabel(texts.unit, parent)),
      tip_(texts.tip),
      largest_(largest) {
  if (optional) {
    head_ = tick_ = new QCheckBox(texts.label, parent);
    tick_->setObjectName(texts.name + "Tick");
    connect(tick_, &QCheckBox::toggled, this, [this](bool on) { emit changed(on, shown_); });
  } else {
    head_ = new QLabel(texts.label, parent);
  }
  slider_->setObjectName(texts.name + "Slider");
  slider_->setRange(0, kSteps);
  slider_->setMinimumWidth(60);
  box_->setObjectName(texts.name + "Box");
  box_->setMaximum(texts.most);
  const int row = grid->rowCount();
  grid->addWidget(head_, row, 0);
  grid->addWidget(slider_, row, 1);
  grid->addWidget(box_, row, 2);
  grid->addWidget(unit_, row, 3);
  connect(slider_, &QSlider::sliderPressed, this, &NumberRow::begun);
  connect(slider_, &QSlider::sliderReleased, this, &NumberRow::ended);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int position) { emit changed(true, value_at(position)); });
  connect(box_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double value) { emit changed(true, value); });
  show_use({});
}

double NumberRow::value_at(int position) const {
  const double t = static_cast<double>(position) / kSteps;
  return largest_ * t * t;
}

int NumberRow::position_of(double value) const {
  const double t = largest_ > 0 ? std::sqrt(std::max(value, 0.0) / largest_) : 0;
  return static_cast<int>(std::lround(std::min(t, 1.0) * kSteps));
}

void NumberRow::show_value(std::optional<double> value, double otherwise, double largest) {
  const QSignalBlocker no_slider(slider_), no_box(box_);
  if (largest > 0) largest_ = largest;
  if (tick_ != nullptr) {
    const QSignalBlocker no_tick(tick_);
    set_ = value.has_value();
    tick_->setChecked(set_);
    enable();
  }
  shown_ = value.value_or(otherwise);
  if (!slider_->isSliderDown()) slider_->setValue(position_of(shown_));
  box_->setValue(shown_);
}

void NumberRow::show_use(const QString& why_not) {
  usable_ = why_not.isEmpty();
  enable();
  for (QWidget* part : {head_, static_cast<QWidget*>(slider_), static_cast<QWidget*>(box_)}) {
    part->setToolTip(usable_ ? tip_ : why_not);
  }
}

void NumberRow::enable() {
  head_->setEnabled(usable_);
  slider_->setEnabled(usable_ && set_);
  box_->setEnabled(usable_ && set_);
  unit_->setEnabled(usable_ && set_);
}

}  // namespace talweg::openflipper
