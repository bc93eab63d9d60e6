// The offset row makes curves at a distance from smoothed ones: a button, the distance, the side.
#pragma once

#include <QComboBox>
#include <QToolButton>
#include <QWidget>

#include "NumberRow.hh"

namespace talweg::openflipper {

class OffsetRow : public QWidget {
  Q_OBJECT
 public:
  explicit OffsetRow(QWidget* parent = nullptr);
  /// A distance that nobody has typed is three of the mesh's edges.
  void show_state(bool enabled, double mean_edge);

 signals:
  void offset(double distance, const QString& side);

 private:
  QToolButton* button_;
  SignificantBox* distance_;
  QComboBox* side_;
  double shown_ = 0;  // the distance that is of the mesh
};

}  // namespace talweg::openflipper
