// The result table holds a few numbers of the drawing beside those of the smoothed curves.
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
  /// Without rows it is hidden.
  void show_rows(const std::vector<ResultRow>& rows);

 private:
  QLabel* cell(int row, int column);
  std::vector<QLabel*> cells_;
};

/// Three significant digits, without exponent from 1e-6 on; a dash for what is not finite.
QString three_digits(double value);
/// Of an angle: what is no more than a rounding is 0.
QString three_digits_of_degrees(double value);

}  // namespace talweg::openflipper
