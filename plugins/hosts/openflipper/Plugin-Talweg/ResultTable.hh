// A table of a few measures, before and after smoothing.
#pragma once

#include <QLabel>
#include <QString>
#include <QWidget>
#include <vector>

namespace talweg::openflipper {

struct ResultRow {
  QString what, drawn, smoothed, unit, tip;
};

class ResultTable : public QWidget {
  Q_OBJECT
 public:
  explicit ResultTable(QWidget* parent);
  /// Shows the rows; without rows the table is hidden.
  void show_rows(const std::vector<ResultRow>& rows);

 private:
  QLabel* cell(int row, int column);
  std::vector<QLabel*> cells_;
};

/// Three significant digits, without an exponent from 1e-6 on; a dash for a value that is not
/// finite.
QString three_digits(double value);
/// The same for an angle; an angle within rounding errors is 0.
QString three_digits_of_degrees(double value);

}  // namespace talweg::openflipper
