#include "CurveTable.hh"

#include <QHeaderView>
#include <QKeyEvent>
#include <QPixmap>
#include <QSignalBlocker>

namespace talweg::openflipper {
namespace {

enum Column { kName, kLength, kDeviation, kTurning };

QIcon swatch(const QColor& colour) {
  QPixmap pixmap(12, 12);
  pixmap.fill(colour);
  return QIcon(pixmap);
}

}  // namespace

CurveTable::CurveTable(QWidget* parent) : QTreeWidget(parent) {
  setObjectName("talwegCurves");
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setSelectionMode(SingleSelection);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setEditTriggers(DoubleClicked | EditKeyPressed);
  setHeaderLabels({tr("Curve"), tr("Length"), tr("Deviation"), tr("Turning")});
  headerItem()->setToolTip(kName, tr("Double click a name to change it."));
  headerItem()->setToolTip(kLength, tr("Length of the smoothed curve, in mesh units."));
  headerItem()->setToolTip(
      kDeviation,
      tr("The largest distance between result and drawing, in either direction, in mesh units."));
  headerItem()->setToolTip(kTurning, tr("The sum of all turns of the smoothed curve."));
  header()->setStretchLastSection(false);
  header()->setMinimumSectionSize(20);
  header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(kName, QHeaderView::Stretch);
  for (const int column : {kLength, kDeviation, kTurning}) {
    headerItem()->setTextAlignment(column, Qt::AlignRight);
  }
  setFixedHeight(5 * fontMetrics().height() + 14);  // the header and three rows
  connect(this, &QTreeWidget::itemSelectionChanged, this, [this] {
    const QTreeWidgetItem* item = selectedItems().isEmpty() ? nullptr : selectedItems().first();
    emit selected(item == nullptr ? 0U : item->data(kName, Qt::UserRole).toUInt());
  });
  connect(this, &QTreeWidget::itemChanged, this, &CurveTable::name_edited);
}

void CurveTable::show_rows(const std::vector<CurveRow>& rows, std::uint32_t selected) {
  const QSignalBlocker quiet(this);
  if (rows.size() != rows_.size()) clear();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const int at = static_cast<int>(k);
    const bool is_new = at >= topLevelItemCount();
    if (is_new) addTopLevelItem(new QTreeWidgetItem);
    QTreeWidgetItem* item = topLevelItem(at);
    if (is_new || !(rows[k] == rows_[k])) show_row(*item, rows[k]);
    if (rows[k].number == selected && !item->isSelected()) setCurrentItem(item);
    item->setSelected(rows[k].number == selected);
  }
  rows_ = rows;
}

void CurveTable::show_row(QTreeWidgetItem& item, const CurveRow& row) const {
  const bool edited = state() == EditingState && currentItem() == &item;
  item.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable);
  item.setData(kName, Qt::UserRole, row.number);
  item.setIcon(kName, swatch(row.colour));
  if (!edited) item.setText(kName, row.name.isEmpty() ? row.title : row.name);
  item.setText(kLength, row.length);
  item.setText(kDeviation, row.deviation);
  item.setText(kTurning, row.turning);
  if (!row.warning.isEmpty()) item.setText(kDeviation, QString::fromUtf8("⚠ ") + row.deviation);
  for (const int column : {kName, kDeviation}) item.setToolTip(column, row.warning);
  for (const int column : {kLength, kDeviation, kTurning}) {
    item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
}

void CurveTable::name_edited(QTreeWidgetItem* item, int column) {
  const auto at = static_cast<std::size_t>(indexOfTopLevelItem(item));
  if (column != kName || at >= rows_.size()) return;
  const CurveRow row = rows_[at];
  const QString text = item->text(kName).trimmed();
  const QString name = text == row.title ? QString() : text;
  if (name == row.name) return;
  emit renamed(row.number, name);
}

void CurveTable::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Delete) return QTreeWidget::keyPressEvent(event);
  emit remove();
}

}  // namespace talweg::openflipper
