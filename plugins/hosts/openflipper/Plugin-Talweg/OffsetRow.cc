#include "OffsetRow.hh"

#include <QHBoxLayout>

#include "PanelParts.hh"

namespace talweg::openflipper {

OffsetRow::OffsetRow(QWidget* parent) : QWidget(parent) {
  button_ = make_button(this, "Offset", Sign::kOffset, tr("Offset"),
                        tr("Makes curves at this distance along the surface from the selected "
                           "smoothed curve, or from all."));
  distance_ = new SignificantBox(this);
  distance_->setObjectName("talwegOffsetDistance");
  distance_->setToolTip(tr("The distance along the surface, in mesh units."));
  side_ = new QComboBox(this);
  side_->setObjectName("talwegOffsetSide");
  side_->addItem(tr("Both sides"), "both");
  side_->addItem(tr("Left"), "left");
  side_->addItem(tr("Right"), "right");
  side_->setToolTip(
      tr("The side as seen along the curve from outside; offsets on one side have no caps."));
  auto* row = row_of({button_, distance_, side_});
  row->setContentsMargins(0, 0, 0, 0);
  setLayout(row);
  connect(button_, &QToolButton::clicked, this,
          [this] { emit offset(distance_->value(), side_->currentData().toString()); });
}

void OffsetRow::show_state(bool enabled, double mean_edge) {
  for (QWidget* part : {static_cast<QWidget*>(button_), static_cast<QWidget*>(distance_),
                        static_cast<QWidget*>(side_)}) {
    part->setEnabled(enabled);
  }
  if (distance_->value() != shown_) return;
  distance_->setValue(3 * mean_edge);
  shown_ = distance_->value();
}

}  // namespace talweg::openflipper
