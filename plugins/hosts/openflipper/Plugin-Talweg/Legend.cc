#include "Legend.hh"

#include <QPainter>
#include <vector>

#include "HostMesh.hh"
#include "ResultTable.hh"

namespace talweg::openflipper {
namespace {

constexpr int kBar = 9;  // pixels

QLinearGradient gradient(int width) {
  constexpr int kSteps = 32;
  std::vector<double> values;
  for (int k = 0; k <= kSteps; ++k) values.push_back(static_cast<double>(k) / kSteps);
  const std::vector<ACG::Vec4f> colours = colours_of(values);
  QLinearGradient result(0, 0, width, 0);
  for (std::size_t k = 0; k < values.size(); ++k) {
    result.setColorAt(values[k], QColor::fromRgbF(colours[k][0], colours[k][1], colours[k][2]));
  }
  return result;
}

}  // namespace

Legend::Legend(QWidget* parent) : QWidget(parent) {
  setObjectName("talwegLegend");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setVisible(false);
}

QSize Legend::sizeHint() const { return {100, kBar + fontMetrics().height() + 3}; }

void Legend::show_scale(double most, const QString& unit) {
  most_ = most;
  unit_ = unit;
  setVisible(most > 0);
  update();
}

void Legend::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(0, 0, width(), kBar, gradient(width()));
  const QRect text(0, kBar + 1, width(), fontMetrics().height());
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(text, Qt::AlignLeft, three_digits(0));
  painter.drawText(text, Qt::AlignHCenter, three_digits(most_ / 2));
  painter.drawText(text, Qt::AlignRight, three_digits(most_) + " " + unit_);
}

}  // namespace talweg::openflipper
