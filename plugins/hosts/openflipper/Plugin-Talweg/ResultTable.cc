#include "ResultTable.hh"

#include <QGridLayout>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace talweg::openflipper {
namespace {

constexpr int kColumns = 4;

}  // namespace

QString three_digits(double value) {
  if (!std::isfinite(value)) return QString::fromUtf8("–");
  if (value == 0) return QLocale().toString(0);
  const int digits = 2 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  constexpr int kMostDigits = 8;  // a longer number would not fit into its column
  if (digits > kMostDigits) return QLocale().toString(value, 'g', 3);
  return QLocale().toString(value, 'f', std::max(digits, 0));
}

QString three_digits_of_degrees(double value) {
  constexpr double kRounding = 1e-6;
  return three_digits(std::abs(value) < kRounding ? 0 : value);
}

ResultTable::ResultTable(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(1);
  grid->setColumnStretch(0, 1);
  setObjectName("talwegTable");
  cell(0, 1)->setText(tr("drawn"));
  cell(0, 2)->setText(tr("smoothed"));
  show_rows({});
}

QLabel* ResultTable::cell(int row, int column) {
  const auto at = static_cast<std::size_t>(row * kColumns + column);
  while (cells_.size() <= at) {
    const int next = static_cast<int>(cells_.size());
    auto* made = new QLabel(this);
    const bool number = next % kColumns == 1 || next % kColumns == 2;
    made->setAlignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    static_cast<QGridLayout*>(layout())->addWidget(made, next / kColumns, next % kColumns);
    cells_.push_back(made);
  }
  return cells_[at];
}

void ResultTable::show_rows(const std::vector<ResultRow>& rows) {
  setVisible(!rows.empty());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const QString* texts[kColumns] = {&rows[r].what, &rows[r].drawn, &rows[r].smoothed,
                                      &rows[r].unit};
    for (int column = 0; column < kColumns; ++column) {
      QLabel* label = cell(static_cast<int>(r) + 1, column);
      label->setText(*texts[column]);
      label->setToolTip(rows[r].tip);
    }
  }
}

}  // namespace talweg::openflipper
