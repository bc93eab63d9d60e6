// The list of the curves of a drawing: a row for each curve, with its colour, name and numbers.
#pragma once

#include <QColor>
#include <QString>
#include <QTreeWidget>
#include <cstdint>
#include <vector>

namespace talweg::openflipper {

struct CurveRow {
  std::uint32_t number = 0;
  QColor colour;
  QString name;   ///< the user's name; empty: none
  QString title;  ///< shown without a name
  QString length, deviation, turning;
  QString warning;  ///< decisive warnings, by which the result may be of no use; empty: none

  bool operator==(const CurveRow&) const = default;
};

class CurveTable : public QTreeWidget {
  Q_OBJECT
 public:
  explicit CurveTable(QWidget* parent);
  /// `selected` is the number of a curve, or 0. A name that is being edited stays.
  void show_rows(const std::vector<CurveRow>& rows, std::uint32_t selected);

 signals:
  void selected(unsigned number);  ///< by the user; 0: no curve
  void renamed(unsigned number, const QString& name);
  void remove();  ///< the Delete key

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void show_row(QTreeWidgetItem& item, const CurveRow& row) const;
  void name_edited(QTreeWidgetItem* item, int column);

  std::vector<CurveRow> rows_;
};

}  // namespace talweg::openflipper
