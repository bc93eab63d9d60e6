// The curve table lists the curves of a drawing: a row each, with its colour, name and numbers.
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
  QString name;   ///< given by a person; empty: none
  QString title;  ///< shown where it has no name
  QString length, deviation, turning;
  QString warning;  ///< sentences by which the result may be of no use; empty: none

  bool operator==(const CurveRow&) const = default;
};

class CurveTable : public QTreeWidget {
  Q_OBJECT
 public:
  explicit CurveTable(QWidget* parent);
  /// `selected`: a number, or 0. A name that is being edited stays.
  void show_rows(const std::vector<CurveRow>& rows, std::uint32_t selected);

 signals:
  void selected(unsigned number);  ///< by the person; 0: none
  void renamed(unsigned number, const QString& name);
  void remove();  ///< the key Delete

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void show_row(QTreeWidgetItem& item, const CurveRow& row) const;
  void name_edited(QTreeWidgetItem* item, int column);

  std::vector<CurveRow> rows_;
};

}  // namespace talweg::openflipper
