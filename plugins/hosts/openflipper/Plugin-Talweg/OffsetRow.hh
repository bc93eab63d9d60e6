// The row of the panel for offset curves: a button, the distance, and the side.
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
  /// A distance that the user has not typed is three mean edges of the mesh.
  void show_state(bool enabled, double mean_edge);

 signals:
  void offset(double distance, const QString& side);

 private:
  QToolButton* button_;
  SignificantBox* distance_;
  QComboBox* side_;
  double shown_ = 0;  // the distance that was set from the mesh
};

}  // namespace talweg::openflipper
