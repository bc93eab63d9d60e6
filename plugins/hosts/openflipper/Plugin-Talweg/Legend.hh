// The legend of the colours in the scene.
#pragma once

#include <QString>
#include <QWidget>

namespace talweg::openflipper {

class Legend : public QWidget {
  Q_OBJECT
 public:
  explicit Legend(QWidget* parent);
  /// Shows colours for 0 to `most`; hides the legend unless `most` is above 0.
  void show_scale(double most, const QString& unit);
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double most_ = 0;
  QString unit_;
};

}  // namespace talweg::openflipper
